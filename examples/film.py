# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsens a foam and films it: a movie and a time series.

    pvpython examples/film.py [--bubbles 400] [--frames 200] [--output output/film]
"""
from foam_plugin import *


def main():
    options = read_options(__doc__, "output/film", bubbles=400, frames=200)
    foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=options.bubbles))
    coarsen = FoamCoarsen(Input=foam, NumberOfFrames=options.frames)
    bubbles = result(coarsen, 1)

    view = view_of(coarsen, 720)
    title = PythonAnnotation(Input=OutputPort(coarsen, 1), ArrayAssociation="Cell Data",
                             Expression="'t = %.2f s,  %d bubbles' % (t_value, len(Area))")
    Show(title, view, Color=[0.1, 0.14, 0.19], FontSize=18, WindowLocation="Upper Center")
    ResetCamera(view)
    view.CameraParallelScale = 0.56 * (bubbles.GetBounds()[3] - bubbles.GetBounds()[2])

    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    SaveAnimation(str(options.output / "film.ogv"), view, scene, FrameRate=25)
    SaveScreenshot(str(options.output / "last.png"), view)
    SaveData(str(options.output / "films.pvd"), proxy=OutputPort(coarsen, 0), WriteTimeSteps=1)

    left = result(coarsen, 1, coarsen.TimestepValues[-1]).GetNumberOfCells()
    print(f"Filmed {options.frames + 1} frames, {bubbles.GetNumberOfCells()} bubbles at first and {left} in the end: "
          f"{options.output / 'film.ogv'}, and {options.output / 'films.pvd'} to open in ParaView or to continue")


if __name__ == "__main__":
    run(main)

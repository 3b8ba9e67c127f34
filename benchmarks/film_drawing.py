# SPDX-License-Identifier: GPL-3.0-or-later
"""Time to draw a frame: Foam Films beside ParaView's own lines, of the same films in the same run.

    FOAM_PLUGIN=…/Foam.so pvpython benchmarks/film_drawing.py [BUBBLES]

The camera moves from frame to frame; the first frame, which uploads the films, is stated apart.
"""

import os
import sys
import time

from paraview import simple

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())
simple._DisableFirstRenderCameraReset()

WIDTH = 2  # of films and lines, pixels
FRAMES = 5


def render(view):
    """Renders, and returns how long it took (s)."""
    begin = time.perf_counter()
    simple.Render(view)
    return time.perf_counter() - begin


def measure(view, centre, height):
    """The first frame and the fastest of those that follow (s)."""
    times = []
    for k in range(FRAMES + 1):
        x, y = centre[0] + 0.01 * height * k, centre[1]
        view.CameraPosition = [x, y, 10 * height]
        view.CameraFocalPoint = [x, y, 0]
        times.append(render(view))
    return times[0], min(times[1:])


def main():
    bubbles = int(sys.argv[1]) if len(sys.argv) > 1 else 100000
    foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=bubbles))
    foam.UpdatePipeline()
    data = foam.GetDataInformation()
    x0, x1, y0, y1 = data.GetBounds()[:4]
    print(f"{data.GetNumberOfCells()} films, sampled to {data.GetNumberOfPoints()} points")

    view = simple.CreateRenderView(ViewSize=[1000, 1000], InteractionMode="2D",
                                   CameraParallelProjection=1, CameraViewUp=[0, 1, 0])
    display = simple.Show(foam, view, FilmWidth=WIDTH, LineWidth=WIDTH)
    for zoom in (1, 10, 1000):
        height = 1.05 * (y1 - y0) / zoom
        view.CameraParallelScale = height / 2
        for representation in ("Wireframe", "Foam Films"):
            display.Representation = representation
            first, then = measure(view, ((x0 + x1) / 2, (y0 + y1) / 2), height)
            print(f"{zoom:5d}×  {representation:10s}  first {first:.3f} s, then {then:.3f} s", flush=True)
    simple.Disconnect()


if __name__ == "__main__":
    main()

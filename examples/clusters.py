# SPDX-License-Identifier: GPL-3.0-or-later
"""A double bubble, made by hand film by film, and clusters of equal bubbles: how long are their films?

    pvpython examples/clusters.py [--sizes 3 4 5 6 7] [--output output/clusters]

Lengths are in units of the root of a bubble's area.
"""
from math import cos, pi, sin, sqrt

from foam_plugin import *
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def double_bubble():
    """Three films from junction 0 up to junction 1, outer ones as half circles: positive half-angles bulge right."""
    films, points, lines = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.InsertNextPoint(0, -0.5, 0)
    points.InsertNextPoint(0, 0.5, 0)
    for _ in range(3):
        lines.InsertNextCell(2, [0, 1])
    films.SetPoints(points)
    films.SetLines(lines)
    zero = ("TimeValue", "Boundary", "Converged", "Iterations", "MaxAngleError", "MaxAreaError", "T1Count", "T2Count",
            "T3Count")
    for attributes, given in (
            (films.GetPointData(), {"JunctionId": [0, 1]}),
            (films.GetCellData(), {"LeftBubble": [-1, 0, 1], "RightBubble": [0, 1, -1],
                                   "HalfAngle": [-pi / 2, 0, pi / 2]}),
            (films.GetFieldData(), {"BubbleId": [0, 1], "BubblePressure": [0, 0], "BubbleTargetArea": [1, 1],
                                    "SurfaceTension": [0.5], "PeriodicBounds": [0, 0, 0, 0], "FormatVersion": [2],
                                    **{name: [0] for name in zero}})):
        add_arrays(attributes, given)
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(films)
    return FoamCoarsen(Input=source, Permeability=0, NumberOfFrames=1, TimeStep=1)  # its frame 1 is in equilibrium


def cluster(size):
    """A bubble with up to six neighbours: five and six surround it, fewer sit side by side."""
    around = [2 * pi * k / max(6 if size < 6 else size - 1, 5) for k in range(size - 1)]
    points = PolyLineSource(Points=[0, 0, 0] + [x for a in around for x in (cos(a), sin(a), 0)])
    return FoamFromPoints(Input=points, TargetAreas="Uniform", SurfaceTension=0.5)


def main():
    options = read_options(__doc__, "output/clusters", sizes=[3, 4, 5, 6, 7])
    rows = []
    for foam, time in [(double_bubble(), 1.0), *((cluster(size), None) for size in options.sizes)]:
        state = arrays(result(foam, 0, time).GetFieldData())
        length = state["Energy"][0] / sqrt(state["BubbleTargetArea"][0])  # the films pull with 2 x 0.5 N/cm
        rows.append({"Bubbles": len(state["BubbleId"]), "Length": length, "MaxAngleError": state["MaxAngleError"][0]})
        print("{Bubbles} bubbles: length {Length:.12f}, angles to {MaxAngleError:.0e} rad".format(**rows[-1]))
    # Circular arcs that meet at 120°: radius r, area r²(2π/3 + √3/4) = 1 on either side of a straight film r√3 long.
    print(f"Two bubbles exactly: {(8 * pi / 3 + sqrt(3)) / sqrt(2 * pi / 3 + sqrt(3) / 4):.12f}")
    write_table(options.output / "clusters.csv", rows)


if __name__ == "__main__":
    run(main)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Foam in the outline of a heart: a picture of it, and the films as .vtp.

    pvpython examples/foam_in_outline.py [--bubbles 250] [--output output/outline]

Films meet the outline at 90° and slide along it; FoamCoarsen lets the foam grow old in it.
"""
from foam_plugin import *


def heart(corners):
    """Its outline, counter-clockwise, between -17 and 17 cm."""
    turns = np.linspace(0, 2 * np.pi, corners, endpoint=False)[::-1]
    return np.column_stack((16 * np.sin(turns) ** 3, 13 * np.cos(turns) - 5 * np.cos(2 * turns) - 2 * np.cos(3 * turns)
                            - np.cos(4 * turns)))


def inside(polygon, points):
    """Whether points lie in a polygon: by how often a line from each of them to the right crosses it."""
    ends = np.roll(polygon, -1, axis=0)
    crossings = np.zeros(len(points), int)
    for (x0, y0), (x1, y1) in zip(polygon, ends):
        between = (points[:, 1] < y0) != (points[:, 1] < y1)
        with np.errstate(divide="ignore", invalid="ignore"):
            right = points[:, 0] < x0 + (points[:, 1] - y0) * (x1 - x0) / (y1 - y0)
        crossings += between & right
    return crossings % 2 == 1


def source(points):
    """Points of the plane, or a closed polyline through them, for filters."""
    return np.column_stack((points, np.zeros(len(points)))).ravel()


def main():
    options = read_options(__doc__, "output/outline", bubbles=250)
    walls = heart(120)
    area = 0.5 * np.abs(np.cross(walls, np.roll(walls, -1, axis=0)).sum())
    spacing = math.sqrt(area / options.bubbles)
    grid = np.arange(-17, 17, spacing)
    cells = np.array([(x, y) for x in grid for y in grid])
    points = cells + np.random.default_rng(1).uniform(0.1, 0.9, cells.shape) * spacing
    foam = FoamFromPoints(Input=PolyLineSource(Points=source(points[inside(walls, points)])), Boundary="Container",
                          Container="Outline", Walls=PolyLineSource(Points=source(walls), Closed=1))
    bubbles = result(foam, 1)

    view = view_of(foam, 900)
    ResetCamera(view)
    SaveScreenshot(str(options.output / "outline.png"), view)
    SaveData(str(options.output / "outline.vtp"), proxy=OutputPort(foam, 0))
    print(f"{bubbles.GetNumberOfCells()} bubbles in {options.output / 'outline.png'}")


if __name__ == "__main__":
    run(main)

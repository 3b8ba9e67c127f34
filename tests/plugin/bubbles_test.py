# SPDX-License-Identifier: GPL-3.0-or-later
"""The representation of bubbles, measured in its pictures: polygons with a notch, that no fan of triangles fills."""

import os
import sys
import unittest
from pathlib import Path

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

sys.path.insert(0, str(Path(__file__).parent))
from pictures import (Messages, add_cell_arrays, distance_to_arc, picture, pixel_centres, pixel_size, source_of,
                      view_of)

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())

# A cup and what fills it, sharing points, and a cup of its own upside down.
POINTS = np.array([(-1, -1), (0.5, -1), (0.5, 1), (0, 1), (0, -0.5), (-0.5, -0.5), (-0.5, 1), (-1, 1),
                   (0.6, -1), (0.8, -1), (0.8, 0.7), (1, 0.7), (1, -1), (1.2, -1), (1.2, 1), (0.6, 1)])
POLYGONS = [[0, 1, 2, 3, 4, 5, 6, 7], [6, 5, 4, 3], [8, 9, 10, 11, 12, 13, 14, 15]]
COLOURS = {3: (1, 0, 0), 6: (0, 1, 0), 9: (0, 0, 1)}
BLACK = [0, 0, 0]


def tearDownModule():
    simple.Disconnect()  # closes the views before Python ends


def polygons():
    data, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    for x, y in POINTS:
        points.InsertNextPoint(x, y, 0)
    for corners in POLYGONS:
        cells.InsertNextCell(len(corners))
        for corner in corners:
            cells.InsertCellPoint(corner)
    data.SetPoints(points)
    data.SetPolys(cells)
    add_cell_arrays(data, {"Sides": list(map(float, COLOURS))})
    return data


def edges(corners):
    return [(POINTS[a], POINTS[b]) for a, b in zip(corners, corners[1:] + corners[:1])]


def inside(x, y, corners):
    """Whether places are in a polygon: a ray to the right crosses an odd number of its edges."""
    crossings = np.zeros(x.shape, int)
    for (ax, ay), (bx, by) in edges(corners):
        if ay != by:
            crossings += ((ay > y) != (by > y)) & (x < ax + (y - ay) * (bx - ax) / (by - ay))
    return crossings % 2 == 1


class Bubbles(unittest.TestCase):
    def setUp(self):
        self.addCleanup(simple.ResetSession)
        self.view = view_of(scale=1.3)
        self.source = source_of(polygons())
        with Messages() as messages:
            self.display = simple.Show(self.source, self.view, "FoamBubblesRepresentation",
                                       EdgeColor=BLACK, AmbientColor=BLACK, Ambient=1, Diffuse=0)
        self.assertEqual(messages.text(), "")
        self.display.LookupTable.ColorSpace = "RGB"
        self.display.LookupTable.RGBPoints = [x for sides, colour in COLOURS.items() for x in (sides, *colour)]
        self.x, self.y = pixel_centres(self.view)

    def picture(self):
        """What the view shows, without a word of VTK's."""
        with Messages() as messages:
            seen = picture(self.view)
        self.assertEqual(messages.text(), "")
        return seen

    def to_edge(self, a, b):
        """Distance (pixels) of each pixel from an edge."""
        return distance_to_arc(self.x, self.y, a, b, 0) / pixel_size(self.view)

    def to_edges(self, *numbers):
        """Distance (pixels) of each pixel from the edges of polygons."""
        return np.min([self.to_edge(a, b) for number in numbers for a, b in edges(POLYGONS[number])], axis=0)

    def check_filled(self, seen, where):
        expected = np.ones_like(seen)
        for corners, colour in zip(POLYGONS, COLOURS.values()):
            expected[inside(self.x, self.y, corners)] = colour
        np.testing.assert_allclose(seen[where], expected[where], atol=0.01)

    def test_surface(self):
        self.check_filled(self.picture(), self.to_edges(0, 1, 2) > 1)

    def test_surface_with_edges(self):
        self.display.LineWidth = 4
        self.display.Representation = "Surface With Edges"
        seen = self.picture()
        self.check_filled(seen, self.to_edges(0, 1, 2) > 4)
        black = seen.max(axis=2) < 0.5
        for corners in POLYGONS:
            for a, b in edges(corners):
                length = np.abs(b - a).max() / pixel_size(self.view)
                self.assertGreater((black & (self.to_edge(a, b) < 3)).sum(), length, (a, b))

    def test_wireframe(self):
        self.display.LineWidth = 3
        self.display.Representation = "Wireframe"
        seen = self.picture()
        np.testing.assert_array_equal(seen[self.to_edges(0, 1, 2) > 4], 1)
        to_corners = np.min([np.hypot(self.x - x, self.y - y) for x, y in POINTS], axis=0) / pixel_size(self.view)
        for number, colour in enumerate(COLOURS.values()):
            others = self.to_edges(*{0, 1, 2} - {number})
            here = (self.to_edges(number) < 1) & (others > 4) & (to_corners > 4)
            self.assertGreater(here.sum(), 50)
            self.assertLess(np.abs(seen[here] - colour).max(), 0.01)

    def test_from_another_representation_and_back(self):
        before = self.picture()
        for other in ("Outline", "Points", "Soap Films", "Wireframe"):
            self.display.Representation = other
            self.assertGreater(np.abs(self.picture() - before).max(), 0.5, other)
            self.display.Representation = "Surface"
            np.testing.assert_array_equal(self.picture(), before)

    def test_picking(self):
        """Wherever a polygon is picked, it is the polygon: its number in the data, not a triangle's."""
        self.picture()
        for corners, sides in zip(POLYGONS, COLOURS):
            rows, columns = np.nonzero(inside(self.x, self.y, corners) & (self.to_edges(0, 1, 2) > 5))
            for k in np.linspace(0, len(rows) - 1, 4).astype(int):
                pixel = [int(columns[k]), int(rows[k])]
                simple.SelectSurfaceCells(Rectangle=pixel + pixel, View=self.view)
                chosen = self.source.SMProxy.GetSelectionOutput(0)
                chosen.UpdatePipeline()
                cells = chosen.GetClientSideObject().GetOutputDataObject(0).GetCellData()
                self.assertEqual(list(vtk_to_numpy(cells.GetArray("Sides"))), [sides], pixel)
                simple.ClearSelection(self.source)

    def test_selected_polygons_are_outlined(self):
        self.picture()
        simple.SelectSurfaceCells(Rectangle=[200, 80, 200, 80], View=self.view)
        self.display.Opacity = 0
        seen = self.picture()
        drawn = seen.min(axis=2) < 0.5
        self.assertGreater(drawn.sum(), 500)
        self.assertLess(self.to_edges(0)[drawn].max(), 4)


if __name__ == "__main__":
    unittest.main()

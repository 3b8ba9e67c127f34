# SPDX-License-Identifier: GPL-3.0-or-later
"""Foams of polygons, and of pictures in which bubbles are numbered."""

import unittest
from collections import Counter

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkUnstructuredGrid
from vtkmodules.vtkFiltersCore import vtkAppendFilter

from foam.vtkFoamFilters import vtkFoamFromLabels, vtkFoamFromPolygons, vtkFoamPoints
from foam_testing import (Messages, coarsening_of, column, foam_of_points, go_to, outlines, points_of, set_properties,
                          single)

REPORT = ("Holes", "SplitLabels", "Pockets", "LeftOut", "FourFoldPoints")
HEXAGONS = [(2, 0), (1, 1.75), (-1, 1.75), (-2, 0), (-1, -1.75), (1, -1.75)]


def neighbours(films):
    """Who is beside whom, how often."""
    sides = zip(column(films.GetCellData(), "LeftBubble"), column(films.GetCellData(), "RightBubble"))
    return Counter(tuple(sorted(map(int, pair))) for pair in sides)


def made(filter_class, data, **properties):
    """The filter's outputs, and its messages."""
    foam = filter_class()
    foam.SetInputDataObject(data)
    set_properties(foam, properties)
    messages = Messages(foam)
    foam.Update()
    return foam.GetOutput(0), foam.GetOutput(1), messages


def polygons(points, *cells):
    data = points_of(points)
    array = vtkCellArray()
    for cell in cells:
        array.InsertNextCell(len(cell), cell)
    data.SetPolys(array)
    return data


def image_of(rows, times=6, name="labels", cells=False, **where):
    """A picture of digits, rows from above, each pixel so many times."""
    labels = numpy.array([[int(c) for c in row] for row in reversed(rows)], dtype=numpy.int32)
    labels = numpy.kron(labels, numpy.ones((times, times), dtype=numpy.int32))
    image = vtkImageData()
    height, width = labels.shape
    image.SetDimensions(width + cells, height + cells, 1)
    image.SetSpacing(*where.get("spacing", (1, 1)), 1)
    image.SetOrigin(*where.get("origin", (0, 0)), 0)
    array = numpy_to_vtk(labels.ravel(), deep=True)
    array.SetName(name)
    (image.GetCellData() if cells else image.GetPointData()).SetScalars(array)
    return image


class Polygons(unittest.TestCase):
    def test_bubbles_are_polygons(self):
        source = foam_of_points(ChordError=0.001)
        source.Update()
        films, bubbles, messages = made(vtkFoamFromPolygons, source.GetOutput(1), ChordError=0.001, Tolerance=1e-12)
        self.assertEqual(messages.errors + messages.warnings, [])
        self.assertEqual(neighbours(films), neighbours(source.GetOutput(0)))
        self.assertEqual(single(films, "Converged"), 1)
        self.assertEqual(single(films, "FourFoldPoints"), 0)
        self.assertLess(column(films.GetCellData(), "ArcMisfit").max(), 0.01)
        self.assertAlmostEqual(single(films, "Energy") / single(source.GetOutput(0), "Energy"), 1, delta=1e-3)
        # Chords leave out up to 0.001 cm along a perimeter of about 4√A.
        area = column(source.GetOutput(1).GetCellData(), "Area")
        self.assertTrue((abs(column(bubbles.GetCellData(), "Area") - area) < 0.004 * numpy.sqrt(area)).all())

    def test_other_data_sets_and_containers(self):
        square = [(x, y) for y in range(4) for x in range(4)]
        cells = [(4 * y + x, 4 * y + x + 1, 4 * y + x + 5, 4 * y + x + 4) for y in range(3) for x in range(3)]
        data = polygons(square, *cells)
        append = vtkAppendFilter()
        append.AddInputData(data)
        append.Update()
        grid = append.GetOutput()
        self.assertIsInstance(grid, vtkUnstructuredGrid)
        for boundary in (vtkFoamFromPolygons.Free, vtkFoamFromPolygons.Container):
            films, bubbles, messages = made(vtkFoamFromPolygons, grid, Boundary=boundary, SurfaceTension=0.5)
            self.assertEqual(messages.errors + messages.warnings, [])
            self.assertEqual(single(films, "Converged"), 1)
            self.assertEqual(single(films, "FourFoldPoints"), 4)
            self.assertEqual(single(films, "SurfaceTension"), 0.5)
            self.assertEqual(single(films, "Boundary"), 3 if boundary else 0)
            self.assertAlmostEqual(column(bubbles.GetCellData(), "Area").sum(), 9, delta=1e-8)

    def test_errors_name_cells(self):
        hexagon = [(0, 0), *HEXAGONS]
        thirds = ((0, 1, 2, 3), (0, 3, 4, 5), (0, 5, 6, 1))
        for data, told in ((polygons(hexagon, *thirds, (0, 1, 2)), "cell 0 and cell 3 overlap"),
                           (polygons(hexagon, *thirds, (1, 2, 1)), "cell 3 encloses no area"),
                           (outlines(HEXAGONS), "no polygons, but 1 other cells"),
                           (polygons([(x, y, x) for x, y in HEXAGONS], (0, 1, 2)), "plane of constant z"),
                           (vtkImageData(), "a vtkImageData; what is wanted")):
            films, bubbles, messages = made(vtkFoamFromPolygons, data)
            self.assertEqual(len(messages.errors), 1)
            self.assertRegex(messages.errors[0], told)
            self.assertEqual(films.GetNumberOfCells() + bubbles.GetNumberOfCells(), 0)


class Labels(unittest.TestCase):
    ROWS = ("000000", "011220", "015220", "035540", "033440", "000000")

    def test_points_and_cells(self):
        where = {"origin": (2, -1), "spacing": (0.5, 0.25)}
        for cells in (False, True):
            image = image_of(self.ROWS, cells=cells, **where)
            films, bubbles, messages = made(vtkFoamFromLabels, image, Equilibrate=False)
            self.assertEqual(messages.errors + messages.warnings, [])
            self.assertEqual([single(films, name) for name in REPORT[:4]], [0] * 4)
            ids = column(bubbles.GetCellData(), "BubbleId")
            self.assertEqual(list(ids), [1, 2, 3, 4, 5])
            pixels = [sum(row.count(str(label)) for row in self.ROWS) * 36 for label in ids]
            numpy.testing.assert_allclose(column(bubbles.GetCellData(), "Area"), numpy.multiply(pixels, 0.125), rtol=0.02)
            # The foam is in the middle of the picture.
            xmin, xmax, ymin, ymax = films.GetBounds()[:4]
            shift = 0 if cells else 0.5
            self.assertAlmostEqual((xmin + xmax) / 2, 2 + (18 - shift) * 0.5, delta=1)
            self.assertAlmostEqual((ymin + ymax) / 2, -1 + (18 - shift) * 0.25, delta=0.5)

    def test_relaxes_and_goes_on(self):
        whole = [row[1:-1] for row in self.ROWS[1:-1]]
        for boundary, rows in ((vtkFoamFromLabels.Free, self.ROWS), (vtkFoamFromLabels.Periodic, whole)):
            films, bubbles, messages = made(vtkFoamFromLabels, image_of(rows), Boundary=boundary)
            self.assertEqual(messages.errors, [])
            self.assertEqual(single(films, "Converged"), 1)
            self.assertAlmostEqual(column(bubbles.GetCellData(), "Area").sum(), 16 * 36, delta=0.1)
            coarsen = coarsening_of(films, NumberOfFrames=2)
            self.assertEqual(single(go_to(coarsen, 1)[0], "Converged"), 1)

    def test_borders(self):
        rows = [row[1:-1] for row in self.ROWS[1:-1]]
        wall, _, messages = made(vtkFoamFromLabels, image_of(rows), Boundary=vtkFoamFromLabels.Container)
        self.assertEqual((messages.errors, single(wall, "Boundary"), single(wall, "Converged")), ([], 3, 1))
        _, _, messages = made(vtkFoamFromLabels, image_of(self.ROWS), Boundary=vtkFoamFromLabels.Container)
        self.assertRegex(messages.errors[0], "background beside it")
        inner = image_of(("11111", "12231", "14451", "14431", "11111"))
        films, bubbles, messages = made(vtkFoamFromLabels, inner, Boundary=vtkFoamFromLabels.Inner)
        self.assertEqual(messages.errors, [])
        self.assertEqual(set(column(bubbles.GetCellData(), "BubbleId")) & {1}, set())

    def test_what_is_no_bubble_is_told(self):
        rows = ("00000000", "01111220", "01411200", "01110220", "01111220", "03333330", "00000000")
        films, bubbles, messages = made(vtkFoamFromLabels, image_of(rows), Equilibrate=False)
        self.assertEqual(messages.errors, [])
        self.assertEqual([single(films, name) for name in REPORT[:4]], [1, 0, 1, 0])
        self.assertEqual(len(messages.warnings), 1)
        self.assertRegex(messages.warnings[0], "Holes 1, Pockets 1")
        self.assertEqual(list(column(bubbles.GetCellData(), "BubbleId")), [1, 2, 3, 5])

    def test_errors_name_the_cause(self):
        image = image_of(self.ROWS)
        stack = vtkImageData()
        stack.SetDimensions(3, 3, 3)
        stack.GetPointData().SetScalars(numpy_to_vtk(numpy.ones(27, dtype=int), deep=True))
        halves = image_of(self.ROWS)
        halves.GetPointData().SetScalars(numpy_to_vtk(numpy.full(36 * 36, 0.5), deep=True))
        coloured = image_of(self.ROWS)
        coloured.GetPointData().SetScalars(numpy_to_vtk(numpy.ones((36 * 36, 3)), deep=True))
        points = vtkFoamPoints()
        points.Update()
        for data, properties, told in ((image, {"LabelArray": "none"}, "LabelArray 'none' is no numeric array"),
                                       (vtkImageData(), {}, "no active scalars"), (stack, {}, "3 x 3 x 3 points"),
                                       (halves, {}, "whole numbers, but one is 0.5"), (coloured, {}, "3 components"),
                                       (image, {"SurfaceTension": 0}, "surface tension must be positive"),
                                       (image_of(["00", "00"]), {}, "shows no bubbles"),
                                       (points.GetOutput(), {}, "a vtkPolyData; what is wanted is an image")):
            films, bubbles, messages = made(vtkFoamFromLabels, data, **properties)
            self.assertEqual(len(messages.errors), 1, told)
            self.assertRegex(messages.errors[0], told)
            self.assertEqual(films.GetNumberOfCells() + bubbles.GetNumberOfCells(), 0)


if __name__ == "__main__":
    unittest.main()

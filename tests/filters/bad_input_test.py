# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input gives one error that names the cause and the value, and an empty output."""

import math
import random
import tempfile
import unittest
from pathlib import Path

from vtkmodules.vtkCommonCore import (vtkDoubleArray, vtkFloatArray, vtkIdTypeArray, vtkPoints,
                                      vtkStringArray)
from vtkmodules.vtkCommonDataModel import (vtkCellArray, vtkImageData, vtkMultiBlockDataSet,
                                           vtkPartitionedDataSetCollection, vtkPolyData, vtkTable, vtkUnstructuredGrid)
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersSources import vtkLineSource, vtkSphereSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

from foam.vtkFoamFilters import (vtkFoamCoarsen, vtkFoamEnsembleStatistics, vtkFoamFromPoints, vtkFoamPoints,
                                 vtkFoamStatistics)
from foam_testing import (Messages, array_of, column, copy, foam_of_points, points_of, set_properties, write)

NAN = math.nan
SQUARE = [(0, 0), (1, 0.1), (0.2, 1.1), (1.3, 1.2), (2.2, 0.3)]


def size(data):
    """Everything that a data set or table holds."""
    if data.IsA("vtkTable"):
        return data.GetNumberOfRows() + data.GetNumberOfColumns()
    return (data.GetNumberOfPoints() + data.GetNumberOfCells() +
            data.GetFieldData().GetNumberOfArrays() + data.GetPointData().GetNumberOfArrays() +
            data.GetCellData().GetNumberOfArrays())


class Rejecting(unittest.TestCase):
    def rejects(self, algorithm, *parts, time=None):
        """The algorithm gives one error that has all the parts, and nothing else."""
        messages = Messages(algorithm)
        if time is None:
            algorithm.Update()
        else:
            algorithm.UpdateTimeStep(time)
        self.assertEqual(len(messages.errors), 1, messages.errors)
        for part in parts:
            self.assertIn(part, messages.errors[0])
        self.assertEqual(messages.warnings, [])
        for port in range(algorithm.GetNumberOfOutputPorts()):
            self.assertEqual(size(algorithm.GetOutputDataObject(port)), 0)

    def accepts(self, algorithm):
        messages = Messages(algorithm)
        algorithm.Update()
        self.assertEqual(messages.errors, [])
        self.assertGreater(size(algorithm.GetOutputDataObject(0)), 0)


class Source(Rejecting):
    def test_properties(self):
        for name, value, text in [("NumberOfPoints", 0, "0"), ("NumberOfPoints", -3, "-3"),
                                  ("Spacing", 0, "0"), ("Spacing", -1.5, "-1.5"),
                                  ("Spacing", NAN, "nan"), ("Jitter", 1.5, "1.5"),
                                  ("Jitter", -0.5, "-0.5"), ("Jitter", NAN, "nan")]:
            with self.subTest(name=name, value=value):
                source = vtkFoamPoints()
                set_properties(source, {name: value})
                self.rejects(source, text)


class Points(Rejecting):
    BOUNDARIES = (vtkFoamFromPoints.Free, vtkFoamFromPoints.Periodic, vtkFoamFromPoints.Fixed)

    def rejects_points(self, points, *parts, boundaries=BOUNDARIES, **properties):
        foam = vtkFoamFromPoints()
        foam.SetInputData(points)
        for boundary in boundaries:
            with self.subTest(boundary=boundary):
                foam.SetBoundary(boundary)
                set_properties(foam, properties)
                self.rejects(foam, *parts)

    def test_recovery(self):
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of(SQUARE[:2]))
        self.rejects(foam, "2")
        foam.SetInputData(points_of(SQUARE))
        self.accepts(foam)

    def test_too_few(self):
        for count in range(3):
            self.rejects_points(points_of(SQUARE[:count]), str(count))
        self.rejects_points(vtkPolyData(), "0")
        self.rejects_points(vtkUnstructuredGrid(), "0")

    def test_duplicates(self):
        self.rejects_points(points_of(SQUARE + [SQUARE[3]]), "1.3")

    def test_on_a_line(self):
        line = points_of([(k, 2.0 * k) for k in range(6)])
        self.rejects_points(line, "line")

    def test_not_finite(self):
        for value in (NAN, math.inf, -math.inf):
            self.rejects_points(points_of(SQUARE + [(value, 1)]), str(value).lstrip("-"))
            self.rejects_points(points_of(SQUARE + [(1, value)]), str(value).lstrip("-"))

    def test_off_the_plane(self):
        flat = [(x, y, 2.0) for x, y in SQUARE]
        self.rejects_points(points_of(flat + [(3, 3, 2.5)]), "point 5", "2.5")
        self.rejects_points(points_of(flat + [(3, 3, NAN)]), "point 5", "nan")
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of(flat + [(3, 3, 2.0 + 1e-12)]))
        self.accepts(foam)

    def test_surface_tension(self):
        for value, text in [(0, "0"), (-0.25, "-0.25"), (NAN, "nan"), (math.inf, "inf")]:
            self.rejects_points(points_of(SQUARE), "surface tension", text, SurfaceTension=value)

    def test_chord_error(self):
        for value, text in [(-0.25, "-0.25"), (NAN, "nan"), (math.inf, "inf")]:
            self.rejects_points(points_of(SQUARE), "ChordError", text, ChordError=value,
                                Equilibrate=False)

    def test_equilibrator(self):
        for name, value, text in [("Tolerance", 0, "0"), ("Tolerance", -1, "-1"),
                                  ("Tolerance", NAN, "nan"), ("MaximumIterations", 0, "0"),
                                  ("MaximumIterations", -5, "-5")]:
            self.rejects_points(points_of(SQUARE), name, text, **{name: value})

    def test_periodic_bounds(self):
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of(SQUARE))
        foam.SetBoundary(vtkFoamFromPoints.Periodic)
        foam.SetPeriodicBounds(0, NAN, 0, 2)
        self.rejects(foam, "PeriodicBounds", "nan")
        foam.SetPeriodicBounds(0, math.inf, 0, 2)
        self.rejects(foam, "PeriodicBounds", "inf")


    def test_period_vectors(self):
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of(SQUARE))
        foam.SetBoundary(vtkFoamFromPoints.Periodic)
        for periods, *parts in [((3, NAN, 0, 2), "PeriodVectors", "nan"), ((3, 0, math.inf, 2), "PeriodVectors", "inf"),
                                ((0, 2, 3, 0), "periods (0, 2) and (3, 0) are clockwise"),
                                ((3, 1, 6, 2), "periods (3, 1) and (6, 2)", "enclose no area"),
                                ((3, 0, 0, 0), "periods (3, 0) and (0, 0)", "enclose no area")]:
            foam.SetPeriodVectors(*periods)
            self.rejects(foam, *parts)
        foam.SetPeriodVectors(3, 0, 1, 2)
        self.accepts(foam)


class TargetAreas(Rejecting):
    def foam(self, areas, name="Wanted", boundary=vtkFoamFromPoints.Free):
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of(SQUARE, Wanted=areas))
        foam.SetBoundary(boundary)
        foam.SetTargetAreas(vtkFoamFromPoints.Array)
        foam.SetTargetAreaArray(name)
        return foam

    def test_good(self):
        self.accepts(self.foam([1.0] * 5))

    def test_no_such_array(self):
        self.rejects(self.foam([1.0] * 5, "Other"), "Other")
        self.rejects(self.foam([1.0] * 5, ""), "TargetAreaArray")

    def test_wrong_length(self):
        self.rejects(self.foam([1.0] * 4), "Wanted", "4", "5")
        self.rejects(self.foam([1.0] * 6), "Wanted", "6", "5")

    def test_values(self):
        for value, text in [(0, "0"), (-0.5, "-0.5"), (NAN, "nan"), (math.inf, "inf")]:
            with self.subTest(value=value):
                self.rejects(self.foam([1.0, 1.0, value, 1.0, 1.0]), text)

    def test_not_numeric(self):
        foam = self.foam([1.0] * 5, "Names")
        names = vtkStringArray()
        names.SetName("Names")
        names.SetNumberOfValues(5)
        foam.GetInput().GetPointData().AddArray(names)
        self.rejects(foam, "Names", "numeric")

    def test_components(self):
        foam = self.foam([1.0] * 5, "Vector")
        vector = vtkDoubleArray()
        vector.SetName("Vector")
        vector.SetNumberOfComponents(2)
        vector.SetNumberOfTuples(5)
        foam.GetInput().GetPointData().AddArray(vector)
        self.rejects(foam, "Vector", "2 components")

    def test_sum_on_a_torus(self):
        foam = self.foam([1.0] * 5, boundary=vtkFoamFromPoints.Periodic)
        foam.SetPeriodicBounds(0, 3, 0, 2)
        self.rejects(foam, "5", "6")
        foam.SetPeriodicBounds(0, 2.5, 0, 2)
        self.accepts(foam)


class Coarsening(Rejecting):
    @classmethod
    def setUpClass(cls):
        foam = foam_of_points(20)
        foam.Update()
        cls.films = copy(foam.GetOutput(0))

    def test_properties(self):
        cases = [("TimeStep", -0.5), ("TimeStep", NAN), ("TimeStep", math.inf),
                 ("Permeability", -0.25), ("Permeability", NAN), ("Permeability", math.inf),
                 ("T1Length", -0.5), ("T1Length", NAN), ("T2Area", -0.5), ("T2Area", NAN),
                 ("KeyframeInterval", 0), ("KeyframeInterval", -2), ("NumberOfFrames", -1),
                 ("KeyframeMemory", -1), ("TimeStep", -1e-9), ("Permeability", -1e-8),
                 ("Tolerance", 0), ("Tolerance", NAN), ("MaximumIterations", 0),
                 ("ChordError", -0.5), ("ChordError", NAN)]
        for name, value in cases:
            with self.subTest(name=name, value=value):
                coarsen = vtkFoamCoarsen()
                coarsen.SetInputData(self.films)
                set_properties(coarsen, {name: value})
                self.rejects(coarsen, name, str(value))
                self.rejects_again(coarsen, name)

    def rejects_again(self, coarsen, name):
        """Another time gives the error again, and a good value the foam."""
        self.rejects(coarsen, name, time=10.0)
        set_properties(coarsen, {name: getattr(vtkFoamCoarsen(), "Get" + name)()})
        self.accepts(coarsen)

    def test_relative_thresholds(self):
        for value in (0, -0.5, NAN):
            coarsen = vtkFoamCoarsen()
            coarsen.SetInputData(self.films)
            coarsen.SetThresholds(vtkFoamCoarsen.Relative)
            coarsen.SetAlpha(value)
            self.rejects(coarsen, "Alpha", str(value))

    def test_thresholds_that_are_not_small(self):
        """Absolute or Relative, they warn: films a fifth as long as the root of the mean area."""
        area = column(self.films.GetFieldData(), "BubbleTargetArea").mean()
        for name, value in (("T1Length", area**0.5), ("T2Area", area), ("Alpha", 0.5 ** 0.5)):
            for factor, told in ((0.01, 0), (0.99, 1)):
                coarsen = vtkFoamCoarsen()
                coarsen.SetInputData(self.films)
                set_properties(coarsen, {"T1Length": 0, "T2Area": 0, name: factor * value, "Thresholds": (
                    vtkFoamCoarsen.Relative if name == "Alpha" else vtkFoamCoarsen.Absolute)})
                messages = Messages(coarsen)
                coarsen.Update()
                self.assertEqual((messages.errors, len(messages.warnings)), ([], told), messages.warnings)
                for text in messages.warnings:
                    self.assertIn("not small", text)
                    self.assertIn(f"{area:.6g}", text)

    def test_newton_from_event_to_event_on_a_gpu(self):
        coarsen = vtkFoamCoarsen()
        coarsen.SetInputData(self.films)
        coarsen.SetDevice(vtkFoamCoarsen.CUDA)
        self.rejects(coarsen, "Device = CUDA, but ")
        coarsen.SetDevice(vtkFoamCoarsen.CPU)
        self.accepts(coarsen)

    def test_a_step_that_leads_nowhere(self):
        films = copy(self.films)
        films.GetFieldData().GetArray("TimeValue").SetValue(0, 5.0)
        coarsen = vtkFoamCoarsen()
        coarsen.SetInputData(films)
        coarsen.SetTimeStep(1e-30)
        self.rejects(coarsen, "TimeStep", "1.0000000000000001e-30", "5")


class Films(Rejecting):
    """Films that are no foam, for both filters that read them."""

    @classmethod
    def setUpClass(cls):
        cls.films = {}
        for periodic in (False, True):
            foam = foam_of_points(20, periodic=periodic)
            foam.Update()
            cls.films[periodic] = copy(foam.GetOutput(0))

    def rejects_films(self, films, *parts):
        for filter_class in (vtkFoamCoarsen, vtkFoamStatistics):
            with self.subTest(filter=filter_class.__name__):
                algorithm = filter_class()
                algorithm.SetInputData(films)
                self.rejects(algorithm, *parts)

    def changed(self, change, periodic=False):
        films = copy(self.films[periodic])
        change(films)
        return films

    def test_good(self):
        for films in self.films.values():
            for filter_class in (vtkFoamCoarsen, vtkFoamStatistics):
                algorithm = filter_class()
                algorithm.SetInputData(films)
                self.accepts(algorithm)

    def test_empty(self):
        self.rejects_films(vtkPolyData(), "no films")
        self.rejects_films(points_of(SQUARE), "no films")

    def test_other_data(self):
        lines = points_of(SQUARE)
        cells = vtkCellArray()
        cells.InsertNextCell(2)
        cells.InsertCellPoint(0)
        cells.InsertCellPoint(1)
        lines.SetLines(cells)
        self.rejects_films(lines, "not a foam", "FormatVersion is missing")

    def test_format_version(self):
        for version in (-1, 0, 3, 7):
            def change(films):
                films.GetFieldData().GetArray("FormatVersion").SetValue(0, version)
            self.rejects_films(self.changed(change), "FormatVersion", str(version))

    def test_missing_arrays(self):
        for kind, names in [
                ("PointData", ["JunctionId"]), ("CellData", ["LeftBubble", "RightBubble", "HalfAngle"]),
                ("FieldData", ["BubbleId", "BubblePressure", "BubbleTargetArea", "TimeValue",
                               "SurfaceTension", "Boundary", "PeriodicBounds", "T1Count", "T2Count",
                               "T3Count", "Converged", "Iterations", "FormatVersion"])]:
            for name in names:
                def change(films):
                    getattr(films, "Get" + kind)().RemoveArray(name)
                self.rejects_films(self.changed(change), name, "is missing")

    def test_derived_arrays_are_not_needed(self):
        def change(films):
            for name in ("Curvature", "PressureDifference", "Length", "OnBoundary"):
                films.GetCellData().RemoveArray(name)
            films.GetFieldData().RemoveArray("Energy")
        statistics = vtkFoamStatistics()
        statistics.SetInputData(self.changed(change))
        self.accepts(statistics)

    def test_wrong_shapes(self):
        def replace(kind, name, array_class, components, tuples):
            def change(films):
                array = array_class()
                array.SetName(name)
                array.SetNumberOfComponents(components)
                array.SetNumberOfTuples(tuples)
                getattr(films, "Get" + kind)().AddArray(array)
            return self.changed(change)

        self.rejects_films(replace("CellData", "HalfAngle", vtkStringArray, 1, 57),
                           "HalfAngle", "not numeric")
        self.rejects_films(replace("CellData", "HalfAngle", vtkDoubleArray, 1, 5), "HalfAngle", "5")
        self.rejects_films(replace("CellData", "LeftBubble", vtkIdTypeArray, 2, 57),
                           "LeftBubble", "2 components")
        self.rejects_films(replace("PointData", "JunctionId", vtkIdTypeArray, 1, 1), "JunctionId", "1")
        self.rejects_films(replace("FieldData", "BubblePressure", vtkDoubleArray, 1, 19),
                           "BubblePressure", "19", "20")
        self.rejects_films(replace("FieldData", "PeriodicBounds", vtkDoubleArray, 1, 3),
                           "PeriodicBounds", "3")
        self.rejects_films(replace("FieldData", "TimeValue", vtkFloatArray, 1, 2), "TimeValue", "2")
        self.rejects_films(replace("CellData", "FilmTension", vtkStringArray, 1, 57), "FilmTension", "not numeric")
        self.rejects_films(replace("CellData", "FilmTension", vtkDoubleArray, 1, 5), "FilmTension", "5", "57")
        self.rejects_films(replace("FieldData", "PeriodVectors", vtkStringArray, 4, 1), "PeriodVectors", "not numeric")
        self.rejects_films(replace("FieldData", "PeriodVectors", vtkDoubleArray, 2, 1), "PeriodVectors", "2", "4")
        self.rejects_films(replace("FieldData", "OutsidePressure", vtkStringArray, 1, 1),
                           "OutsidePressure", "not numeric")
        self.rejects_films(replace("FieldData", "OutsidePressure", vtkDoubleArray, 1, 2),
                           "OutsidePressure", "2 values for 1 outside")

    def test_values(self):
        cases = [("PointData", "JunctionId", 1000, "1000"), ("PointData", "JunctionId", -2, "-2"),
                 ("PointData", "JunctionId", -1, ""), ("PointData", "JunctionId", 5, ""),
                 ("CellData", "LeftBubble", -5, "-5"), ("CellData", "LeftBubble", 99, "99"),
                 ("CellData", "HalfAngle", NAN, "nan"), ("CellData", "HalfAngle", 3.5, "3.5"),
                 ("CellData", "HalfAngle", math.inf, "inf"),
                 ("FieldData", "BubbleId", -1, "-1"), ("FieldData", "BubbleId", 3, "3"),
                 ("FieldData", "BubbleId", 77, ""), ("FieldData", "BubblePressure", NAN, "nan"),
                 ("FieldData", "BubbleTargetArea", 0, "0"),
                 ("FieldData", "BubbleTargetArea", -0.5, "-0.5"),
                 ("FieldData", "SurfaceTension", 0, "0"),
                 ("FieldData", "SurfaceTension", -0.25, "-0.25"),
                 ("FieldData", "SurfaceTension", NAN, "nan"), ("FieldData", "TimeValue", NAN, "nan"),
                 ("FieldData", "Boundary", 3, "3"), ("FieldData", "Boundary", -1, "-1"),
                 ("FieldData", "T1Count", -4, "-4"), ("FieldData", "Converged", 2, "2")]
        for kind, name, value, text in cases:
            for periodic in (False, True):
                with self.subTest(name=name, value=value, periodic=periodic):
                    def change(films):
                        getattr(films, "Get" + kind)().GetArray(name).SetValue(0, value)
                    self.rejects_films(self.changed(change, periodic), text)

    def test_tensions(self):
        for tensions, *parts in [((NAN,), "FilmTension of film 0 is nan"),
                                 ((math.inf,), "FilmTension of film 0 is inf"),
                                 ((0.5, 0), "tension of film 1", "positive", "0"),
                                 ((0.5, -0.5), "tension of film 1", "positive", "-0.5"),
                                 ((1.25,), "junction", "cannot hold", "1.25")]:
            def change(films):
                rest = [0.5] * (films.GetNumberOfLines() - len(tensions))
                films.GetCellData().AddArray(array_of("FilmTension", [*tensions, *rest]))
            for periodic in (False, True):
                self.rejects_films(self.changed(change, periodic), *parts)

    def test_period_vectors(self):
        for periods, *parts in [((3, 0, 0, NAN), "PeriodVectors", "nan"),
                                ((3, 1, 6, 2), "PeriodVectors", "no area", "3 1 6 2"),
                                ((0, 3, 3, 0), "PeriodVectors", "no area", "0 3 3 0"),
                                ((3, 0, 0, 3), "film", "not whole periods away")]:
            def change(films):
                films.GetFieldData().AddArray(array_of("PeriodVectors", periods))
            self.rejects_films(self.changed(change, periodic=True), *parts)

    def test_outside_pressure(self):
        def change(films):
            films.GetFieldData().AddArray(array_of("OutsidePressure", [NAN]))
        self.rejects_films(self.changed(change), "OutsidePressure of outside 0 is nan")
        self.rejects_films(self.changed(change, periodic=True), "OutsidePressure", "1 values for 0 outsides")

    def test_swapped_sides(self):
        def change(films):
            cells = films.GetCellData()
            left, right = cells.GetArray("LeftBubble"), cells.GetArray("RightBubble")
            value = left.GetValue(3)
            left.SetValue(3, right.GetValue(3))
            right.SetValue(3, value)
        self.rejects_films(self.changed(change))

    def test_mirrored(self):
        """All films clockwise: the topology is one, the areas are not."""
        def change(films):
            for i in range(films.GetNumberOfPoints()):
                x, y, z = films.GetPoint(i)
                films.GetPoints().SetPoint(i, -x, y, z)
        self.rejects_films(self.changed(change), "area")

    def test_positions(self):
        def not_a_number(films):
            films.GetPoints().SetPoint(0, NAN, 0, 0)

        def off_its_junction(films):
            ids = films.GetCell(0).GetPointIds()
            point = films.GetPoints().InsertNextPoint(9, 9, 0)
            films.GetPointData().GetArray("JunctionId").InsertNextValue(
                films.GetPointData().GetArray("JunctionId").GetValue(ids.GetId(0)))
            lines = vtkCellArray()
            lines.DeepCopy(films.GetLines())
            changed = vtkCellArray()
            for i in range(lines.GetNumberOfCells()):
                points = films.GetCell(i).GetPointIds()
                points = [points.GetId(k) for k in range(points.GetNumberOfIds())]
                if i == 0:
                    points[0] = point
                changed.InsertNextCell(len(points))
                for p in points:
                    changed.InsertCellPoint(p)
            films.SetLines(changed)

        for periodic in (False, True):
            self.rejects_films(self.changed(not_a_number, periodic), "nan")
            self.rejects_films(self.changed(off_its_junction, periodic), "film 0", "(9, 9)")

    def test_scaled_torus(self):
        """Periods that are no longer those of the box."""
        def change(films):
            for i in range(films.GetNumberOfPoints()):
                x, y, z = films.GetPoint(i)
                films.GetPoints().SetPoint(i, 1.3 * x, 1.3 * y, z)
        self.rejects_films(self.changed(change, periodic=True), "not whole periods")

    def test_empty_box(self):
        def change(films):
            films.GetFieldData().GetArray("PeriodicBounds").SetTuple4(0, 1, 1, 0, 5)
        self.rejects_films(self.changed(change, periodic=True), "PeriodicBounds", "1 1 0 5")

    def test_cells(self):
        def relined(make):
            def change(films):
                lines = vtkCellArray()
                for i in range(films.GetNumberOfLines()):
                    ids = films.GetCell(i).GetPointIds()
                    points = make(i, [ids.GetId(k) for k in range(ids.GetNumberOfIds())])
                    lines.InsertNextCell(len(points))
                    for p in points:
                        lines.InsertCellPoint(p)
                films.SetLines(lines)
            return change

        self.rejects_films(self.changed(relined(lambda i, p: p[:1] if i == 4 else p)), "film 4", "1")
        self.rejects_films(self.changed(relined(lambda i, p: [] if i == 4 else p)), "film 4", "0")
        self.rejects_films(self.changed(relined(lambda i, p: p[:-1] + [10**6] if i == 4 else p)),
                           "film 4", "1000000")
        self.rejects_films(self.changed(relined(lambda i, p: p[:-1] + [-7] if i == 4 else p)),
                           "film 4", "-7")

        def with_vertex(films):
            vertex = vtkCellArray()
            vertex.InsertNextCell(1)
            vertex.InsertCellPoint(0)
            films.SetVerts(vertex)
        self.rejects_films(self.changed(with_vertex), "polylines")

        def bad_offsets(films):
            offsets, connectivity = vtkIdTypeArray(), vtkIdTypeArray()
            for value in (0, 5, 3, 400):
                offsets.InsertNextValue(value)
            for value in range(10):
                connectivity.InsertNextValue(value)
            lines = vtkCellArray()
            lines.SetData(offsets, connectivity)
            films.SetLines(lines)
        self.rejects_films(self.changed(bad_offsets), "offsets")

    def test_a_piece_of_a_foam(self):
        def change(films):
            lines = vtkCellArray()
            count = films.GetNumberOfLines() - 1
            for i in range(count):
                lines.InsertNextCell(films.GetCell(i))
            for name in ("LeftBubble", "RightBubble", "HalfAngle"):
                films.GetCellData().GetArray(name).Resize(count)
            films.SetLines(lines)
        self.rejects_films(self.changed(change), "not three")

    def test_bubbles_instead_of_films(self):
        foam = foam_of_points(20)
        foam.Update()
        self.rejects_films(copy(foam.GetOutput(1)), "no films")

    def test_what_was_connected_is_said(self):
        """And what is wanted, for all that is no films."""
        foam = foam_of_points(20)
        foam.Update()
        points = vtkFoamPoints()
        points.SetNumberOfPoints(17)
        points.Update()
        sphere = vtkSphereSource()
        sphere.Update()
        line = vtkLineSource()
        line.Update()
        for data, *parts in ((copy(foam.GetOutput(1)), "no films", "20 bubbles of a foam"),
                             (points.GetOutput(), "no films", "17 points"),
                             (sphere.GetOutput(), "no films", "surface of 96 polygons"),
                             (line.GetOutput(), "1 lines", "FormatVersion is missing"),
                             (vtkPolyData(), "no films", "empty", "read completely")):
            self.rejects_films(data, *parts, *(["first output of FoamFromPoints"] if data.GetNumberOfPoints() else []))

    def test_one_word_for_what_is_no_surface_at_all(self):
        """Blocks, tables, images: one error each, of all filters."""
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, self.films[False])
        for data, told in ((blocks, "lock"), (vtkImageData(), "vtkImageData"), (vtkTable(), "vtkTable")):
            for algorithm in (vtkFoamCoarsen(), vtkFoamStatistics(), vtkFoamFromPoints(), vtkFoamEnsembleStatistics()):
                producer = vtkTrivialProducer()
                producer.SetOutput(data)
                algorithm.SetInputConnection(producer.GetOutputPort())
                self.rejects(algorithm, told, "wanted")

    def test_no_runs(self):
        """One foam is no ensemble, nor are blocks or a collection of several."""
        blocks = vtkMultiBlockDataSet()
        blocks.SetBlock(0, self.films[False])
        for data in (self.films[False], blocks, vtkPartitionedDataSetCollection()):
            ensemble = vtkFoamEnsembleStatistics()
            ensemble.SetInputDataObject(data)
            self.rejects(ensemble, "is a " + data.GetClassName(), "wanted", "Group Datasets")

    def test_random_changes(self):
        """Whatever the arrays hold, there is an error and nothing, or a foam; never a crash."""
        random.seed(2)
        values = [NAN, math.inf, -math.inf, -1, 0, 1, 2, 3, -2, 1e300, -1e300, 1e-300, 7, 2**40, 0.5]
        for trial in range(150):
            films = copy(self.films[trial % 2 == 0])
            for _ in range(random.randint(1, 3)):
                kind = random.choice(["PointData", "CellData", "FieldData", "Points"])
                if kind == "Points":
                    films.GetPoints().SetPoint(random.randrange(films.GetNumberOfPoints()),
                                               random.choice(values), random.choice(values), 0)
                    continue
                attributes = getattr(films, "Get" + kind)()
                array = attributes.GetArray(random.randrange(attributes.GetNumberOfArrays()))
                i = random.randrange(array.GetNumberOfTuples())
                value = random.choice(values)
                if not array.IsA("vtkDoubleArray"):
                    value = int(value) if math.isfinite(value) and abs(value) < 2**31 else 2**30
                array.SetComponent(i, random.randrange(array.GetNumberOfComponents()), value)
            statistics = vtkFoamStatistics()
            statistics.SetInputData(films)
            messages = Messages(statistics)
            statistics.Update()
            self.assertLessEqual(len(messages.errors), 1)
            self.assertEqual(statistics.GetOutput(0).GetNumberOfRows(), 1 - len(messages.errors))


class Nothing(Rejecting):
    def test_no_input(self):
        for filter_class in (vtkFoamFromPoints, vtkFoamCoarsen, vtkFoamStatistics):
            algorithm = filter_class()
            messages = Messages(algorithm)
            algorithm.Update()
            self.assertGreater(len(messages.errors), 0)


class Files(Rejecting):
    def test_cut_short(self):
        """A .vtp that ends early, anywhere: no foam comes out of it."""
        foam = foam_of_points(20)
        foam.Update()
        with tempfile.TemporaryDirectory() as folder:
            whole, cut = Path(folder) / "whole.vtp", Path(folder) / "cut.vtp"
            for mode in (vtkXMLPolyDataWriter.Appended, vtkXMLPolyDataWriter.Binary,
                         vtkXMLPolyDataWriter.Ascii):
                writer = vtkXMLPolyDataWriter()
                writer.SetFileName(str(whole))
                writer.SetInputData(foam.GetOutput(0))
                writer.SetDataMode(mode)
                writer.Write()
                text = whole.read_bytes()
                for part in (0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 0.98):
                    cut.write_bytes(text[:int(part * len(text))])
                    for filter_class in (vtkFoamCoarsen, vtkFoamStatistics):
                        with self.subTest(mode=mode, part=part, filter=filter_class.__name__):
                            self.check_cut(cut, filter_class())

    def check_cut(self, path, algorithm):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        parser_messages = Messages(reader)
        algorithm.SetInputConnection(reader.GetOutputPort())
        messages = Messages(algorithm)
        algorithm.Update()
        self.assertGreater(len(messages.errors) + len(parser_messages.errors), 0)
        self.assertLessEqual(len(messages.errors), 1)
        self.assertEqual(size(algorithm.GetOutputDataObject(0)), 0)

    def test_nothing_after_bad_points(self):
        """An error upstream leaves the filters after it with nothing, and a word."""
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of(SQUARE[:2]))
        coarsen = vtkFoamCoarsen()
        coarsen.SetInputConnection(foam.GetOutputPort(0))
        self.rejects(coarsen, "no films")

    def test_good_again(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "films.vtp"
            path.write_text("no XML")
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(str(path))
            coarsen = vtkFoamCoarsen()
            coarsen.SetInputConnection(reader.GetOutputPort())
            coarsen.Update()
            self.assertEqual(size(coarsen.GetOutput(0)), 0)
            foam = foam_of_points(20)
            foam.Update()
            write(foam.GetOutput(0), path)
            reader.Modified()
            self.accepts(coarsen)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Names, defaults, ports and arrays: the public contract, written out."""

import unittest
from pathlib import Path
from xml.etree import ElementTree

import numpy
from vtkmodules.util.vtkConstants import VTK_DOUBLE
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from foam.vtkFoamFilters import (vtkFoamCoarsen, vtkFoamDeform, vtkFoamEnsembleStatistics, vtkFoamEvolverReader, vtkFoamFromLabels,
                                 vtkFoamFromPoints, vtkFoamFromPolygons, vtkFoamPoints, vtkFoamStatistics)
from foam_testing import (Messages, column, coarsening_of, differences, foam_of_points, go_to, points_of,
                          set_properties, single, skewed_torus, times, with_tensions)

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "sample-data"
XML = ROOT / "xml"
FILTERS = [vtkFoamPoints, vtkFoamFromPoints, vtkFoamCoarsen, vtkFoamDeform, vtkFoamStatistics, vtkFoamEnsembleStatistics,
           vtkFoamEvolverReader, vtkFoamFromLabels, vtkFoamFromPolygons]
FILM_CELLS = ["LeftBubble", "RightBubble", "Curvature", "PressureDifference", "Length",
              "HalfAngle", "OnBoundary"]
FIELD_PER_BUBBLE = ["BubbleId", "BubblePressure", "BubbleTargetArea"]
FIELD_SINGLE = ["TimeValue", "SurfaceTension", "Boundary", "PeriodicBounds", "Energy",
                "MaxAngleError", "MaxAreaError", "Residual", "Converged", "Iterations", "T1Count",
                "T2Count", "T3Count", "FormatVersion"]
BUBBLE_CELLS = ["BubbleId", "Area", "TargetArea", "Pressure", "Sides", "Perimeter", "OnBoundary", "Stress"]
SUMMARY = ["Time", "Bubbles", "MeanSides", "Mu2", "MeanArea", "AreaSecondMoment", "Energy",
           "AboavA", "StressXX", "StressYY", "StressXY", "NormalStressDifference",
           "Strain", "T1Count", "T2Count", "T3Count", "Iterations", "MaxAngleError", "MaxAreaError"]
BY_SIDES = ["Sides", "Count", "Fraction", "MeanNeighbourSides", "AboavProduct", "AboavIdeal",
            "MeanArea"]


WALLS = ["WallPieces", "WallFrame", "WallForce", "WallContact"]
COARSENING_FIELDS = ["TimeStep", "GrowthConstant", "T1Length", "T2Area"]


def names(attributes):
    return [attributes.GetArrayName(i) for i in range(attributes.GetNumberOfArrays())]


def columns(table):
    return [table.GetColumnName(i) for i in range(table.GetNumberOfColumns())]


def xml_defaults(filter_class):
    """The properties of a filter's proxy and their defaults."""
    text = (XML / "Foam.xml.in").read_text()
    for shared in ("StartProperties", "KeyframeProperties", "EquilibratorProperties"):
        text = text.replace(f"@{shared}@", (XML / f"{shared}.xml.in").read_text())
    proxy = ElementTree.fromstring(text).find(f".//*[@class='{filter_class.__name__}']")
    for element in proxy:
        values = element.get("default_values", "").split()
        if element.tag == "StringVectorProperty":
            yield element.get("name"), " ".join(values)
        elif values and element.get("information_only") != "1":
            numbers = tuple(map(float, values))
            yield element.get("name"), numbers if len(numbers) > 1 else numbers[0]


class Properties(unittest.TestCase):
    def test_defaults_are_those_of_the_proxies(self):
        for filter_class in FILTERS:
            defaults = dict(xml_defaults(filter_class))
            self.assertGreater(len(defaults), 0)
            for name, value in defaults.items():
                with self.subTest(filter_class=filter_class.__name__, name=name):
                    self.assertEqual(getattr(filter_class(), "Get" + name)(), value)

    def test_only_changes_are_modifications(self):
        for filter_class in FILTERS:
            changed = filter_class()
            for name, _ in xml_defaults(filter_class):
                with self.subTest(filter_class=filter_class.__name__, name=name):
                    before, value = changed.GetMTime(), getattr(changed, "Get" + name)()
                    getattr(changed, "Set" + name)(value)
                    self.assertEqual(changed.GetMTime(), before)
                    if isinstance(value, (int, float)):
                        other = type(value)(not value if value in (0, 1) else 2 * value)
                        other = 0 if name == "Thresholds" else other
                        getattr(changed, "Set" + name)(other)
                        self.assertGreater(changed.GetMTime(), before)
                        self.assertEqual(getattr(changed, "Get" + name)(), other)

    def test_choices_are_clamped(self):
        coarsen = vtkFoamCoarsen()
        for name, last in (("Equilibrator", 1), ("Device", 2), ("Thresholds", 2), ("TopologicalAlgorithm", 3)):
            for value, expected in ((-1, 0), (last, last), (7, last)):
                getattr(coarsen, "Set" + name)(value)
                self.assertEqual(getattr(coarsen, "Get" + name)(), expected, name)
            self.assertEqual(getattr(coarsen, f"Get{name}MinValue")(), 0)
            self.assertEqual(getattr(coarsen, f"Get{name}MaxValue")(), last)

    def test_ports(self):
        for filter_class, ports in [(vtkFoamPoints, 1), (vtkFoamFromPoints, 2),
                                    (vtkFoamCoarsen, 3), (vtkFoamDeform, 3), (vtkFoamStatistics, 4)]:
            self.assertEqual(filter_class().GetNumberOfOutputPorts(), ports)

    def test_printing(self):
        for filter_class in FILTERS:
            text = str(filter_class())
            for name, _ in xml_defaults(filter_class):
                self.assertIn(name + ":", text)


class Points(unittest.TestCase):
    def test_their_rectangle_is_theirs_alone(self):
        """Points that were scaled, or some of them, get the torus of points that come from elsewhere."""
        source = vtkFoamPoints()
        source.SetNumberOfPoints(100)
        source.SetJitter(0)
        source.Update()
        grid = source.GetOutput()

        def sides(points):
            foam = vtkFoamFromPoints()
            foam.SetInputData(points)
            foam.SetBoundary(vtkFoamFromPoints.Periodic)
            foam.Update()
            xmin, xmax, ymin, ymax = column(foam.GetOutput(0).GetFieldData(), "PeriodicBounds")[0]
            return xmax - xmin, ymax - ymin

        self.assertEqual(sides(grid), (10, 10))
        scaled, part = vtkPolyData(), vtkPolyData()
        for data, factor, count in ((scaled, 0.9, 100), (part, 1, 90)):
            points = vtkPoints()
            points.SetDataTypeToDouble()
            for i in range(count):
                points.InsertNextPoint([factor * x for x in grid.GetPoint(i)])
            data.SetPoints(points)
            data.SetFieldData(grid.GetFieldData())
        numpy.testing.assert_allclose(sides(scaled), (9, 9), rtol=1e-12)
        numpy.testing.assert_allclose(sides(part), (10, 9), rtol=1e-12)

    def test_same_seed_same_points(self):
        def points(seed):
            source = vtkFoamPoints()
            source.SetNumberOfPoints(50)
            source.SetSeed(seed)
            source.Update()
            output = source.GetOutput()
            self.assertEqual(output.GetPoints().GetDataType(), VTK_DOUBLE)
            return [output.GetPoint(i) for i in range(50)]

        self.assertEqual(points(1), points(1))
        self.assertNotEqual(points(1), points(2))

    def test_seed_1_on_every_platform(self):
        source = vtkFoamPoints()
        source.SetNumberOfPoints(4)
        source.SetJitter(0)
        source.Update()
        found = [source.GetOutput().GetPoint(i)[:2] for i in range(4)]
        self.assertEqual(sorted(found), [(0.5, 0.5), (0.5, 1.5), (1.5, 0.5), (1.5, 1.5)])


class Arrays(unittest.TestCase):
    def check_films(self, films, more_cells=(), more_fields=()):
        self.assertEqual(films.GetPoints().GetDataType(), VTK_DOUBLE)
        self.assertEqual(names(films.GetPointData()), ["JunctionId"])
        self.assertEqual(names(films.GetCellData()), [*FILM_CELLS, *more_cells])
        self.assertEqual(sorted(names(films.GetFieldData())),
                         sorted([*FIELD_PER_BUBBLE, *FIELD_SINGLE, *more_fields]))
        for name in ("LeftBubble", "RightBubble"):
            self.assertEqual(films.GetCellData().GetArray(name).GetClassName(), "vtkIdTypeArray")
        self.assertEqual(single(films, "FormatVersion"), 2)
        bounds = films.GetFieldData().GetArray("PeriodicBounds")
        self.assertEqual(bounds.GetNumberOfValues(), 4)

    def check_bubbles(self, films, bubbles):
        self.assertEqual(names(bubbles.GetCellData()), BUBBLE_CELLS)
        ids = column(films.GetFieldData(), "BubbleId")
        self.assertTrue((numpy.diff(ids) > 0).all())
        cells = bubbles.GetCellData()
        self.assertTrue((column(cells, "BubbleId") == ids).all())
        for name in ("Pressure", "TargetArea"):
            self.assertTrue((column(cells, name) ==
                             column(films.GetFieldData(), "Bubble" + name)).all())

    def check_films_against_bubbles(self, films, bubbles):
        """The films' values follow from their bubbles and their polylines."""
        ids = column(films.GetFieldData(), "BubbleId")
        pressure = {-1: 0.0, **dict(zip(ids, column(films.GetFieldData(), "BubblePressure")))}
        sides = dict.fromkeys(ids, 0)
        perimeter = dict.fromkeys(ids, 0.0)
        cells = films.GetCellData()
        left, right = column(cells, "LeftBubble"), column(cells, "RightBubble")
        difference = column(cells, "PressureDifference")
        tension = (column(cells, "FilmTension") if cells.HasArray("FilmTension") else
                   numpy.full(len(left), 2 * single(films, "SurfaceTension")))
        junction = column(films.GetPointData(), "JunctionId")
        for i in range(films.GetNumberOfLines()):
            self.assertEqual(difference[i], pressure[left[i]] - pressure[right[i]])
            # Laplace and Young: p_left − p_right = 2γ·curvature.
            self.assertAlmostEqual(difference[i], tension[i] * column(cells, "Curvature")[i], 7)
            self.assertEqual(column(cells, "OnBoundary")[i], -1 in (left[i], right[i]))
            length = column(cells, "Length")[i]
            for b in {left[i], right[i]} - {-1}:
                sides[b] += 1
                perimeter[b] += length
            points = films.GetCell(i).GetPointIds()
            ids_along = [junction[points.GetId(k)] for k in range(points.GetNumberOfIds())]
            self.assertTrue(min(ids_along[0], ids_along[-1]) >= 0)
            self.assertTrue(all(j == -1 for j in ids_along[1:-1]))
            chain = numpy.array([films.GetPoint(points.GetId(k))
                                 for k in range(points.GetNumberOfIds())])
            polyline = numpy.linalg.norm(numpy.diff(chain, axis=0), axis=1).sum()
            self.assertLessEqual(polyline, length * (1 + 1e-12))
            self.assertGreater(polyline, length * 0.9)
            # The curvature is positive where the film bulges to the right.
            chord = chain[-1] - chain[0]
            middle = chain[len(chain) // 2] - chain[0]
            if len(chain) > 2:
                self.assertEqual(numpy.cross(chord, middle)[2] < 0, column(cells, "Curvature")[i] > 0)
        self.assertEqual(list(column(bubbles.GetCellData(), "Sides")), [sides[b] for b in ids])
        numpy.testing.assert_allclose(column(bubbles.GetCellData(), "Perimeter"),
                                      [perimeter[b] for b in ids], rtol=1e-12)
        self.assertAlmostEqual(single(films, "Energy"), (tension * column(cells, "Length")).sum(), 9)

    def check_polygons(self, bubbles, origin=None, periods=None):
        areas = column(bubbles.GetCellData(), "Area")
        for i in range(bubbles.GetNumberOfPolys()):
            points = bubbles.GetCell(i).GetPoints()
            p = numpy.array([points.GetPoint(k)[:2] for k in range(points.GetNumberOfPoints())])
            q = numpy.roll(p, -1, axis=0)
            cross = p[:, 0] * q[:, 1] - q[:, 0] * p[:, 1]
            area = cross.sum() / 2
            self.assertAlmostEqual(area / areas[i], 1, 1)
            # Drawn as a fan of triangles around its first point it covers no more than itself.
            fan = numpy.cross(p[1:-1] - p[0], p[2:] - p[0]) / 2
            self.assertLess(-fan[fan < 0].sum() / area, 1e-3)
            if periods is not None:
                centroid = ((p + q) * cross[:, None]).sum(axis=0) / (6 * area)
                inside = numpy.linalg.solve(numpy.transpose(periods), centroid - origin)
                self.assertTrue((inside >= 0).all() and (inside < 1).all(), inside)

    def test_free(self):
        foam = foam_of_points(60)
        foam.Update()
        films, bubbles = foam.GetOutput(0), foam.GetOutput(1)
        self.check_films(films)
        self.check_bubbles(films, bubbles)
        self.check_films_against_bubbles(films, bubbles)
        self.check_polygons(bubbles)
        self.assertEqual(films.GetNumberOfLines(), 3 * 60 - 3)
        self.assertEqual(single(films, "Boundary"), 0)
        self.assertEqual(single(films, "Converged"), 1)
        self.assertLess(single(films, "MaxAngleError"), 1e-8)
        self.assertLess(single(films, "MaxAreaError"), 1e-9)
        self.assertEqual(single(films, "TimeValue"), 0)
        self.assertEqual(list(column(films.GetFieldData(), "BubbleId")), list(range(60)))

    def test_periodic(self):
        foam = foam_of_points(60, periodic=True)
        foam.SetPeriodicBounds(0, 8, 0, 8)
        foam.Update()
        films, bubbles = foam.GetOutput(0), foam.GetOutput(1)
        self.check_films(films)
        self.check_bubbles(films, bubbles)
        self.check_films_against_bubbles(films, bubbles)
        self.check_polygons(bubbles, (0, 0), ((8, 0), (0, 8)))
        self.assertEqual(films.GetNumberOfLines(), 3 * 60)
        self.assertEqual(single(films, "Boundary"), 1)
        bounds = films.GetFieldData().GetArray("PeriodicBounds")
        self.assertEqual([bounds.GetValue(i) for i in range(4)], [0, 8, 0, 8])
        self.assertFalse(column(films.GetCellData(), "OnBoundary").any())
        self.assertAlmostEqual(column(bubbles.GetCellData(), "Area").sum(), 64, 8)

    def test_skewed_torus(self):
        periods = skewed_torus(40)
        foam = foam_of_points(40, periodic=True, PeriodVectors=periods)
        coarsen = coarsening_of(foam)
        messages = Messages(coarsen)
        area = periods[0] * periods[3] - periods[1] * periods[2]
        for frame in range(21):
            films, bubbles = go_to(coarsen, frame)
            self.assertEqual(single(films, "Converged"), 1)
            self.assertLess(single(films, "Residual"), 1e-9)
            self.assertAlmostEqual(column(bubbles.GetCellData(), "Area").sum() / area, 1, 12)
        self.assertEqual(messages.errors + messages.warnings, [])
        self.assertGreater(single(films, "T1Count") + single(films, "T2Count"), 0)
        self.check_films(films, more_fields=["PeriodVectors", *COARSENING_FIELDS])
        self.check_bubbles(films, bubbles)
        self.check_films_against_bubbles(films, bubbles)
        self.assertEqual(tuple(column(films.GetFieldData(), "PeriodVectors")[0]), periods)
        xmin, xmax, ymin, ymax = column(films.GetFieldData(), "PeriodicBounds")[0]
        points = foam.GetInput().GetBounds()
        self.assertEqual((xmin, ymin), (points[0], points[2]))
        self.assertEqual((xmax, ymax), (xmin + periods[0], ymin + periods[3]))
        self.check_polygons(bubbles, (xmin, ymin), (periods[:2], periods[2:]))
        self.assertEqual(differences(films, go_to(coarsening_of(films), 0)[0]), [])

    def test_periods_of_a_torus(self):
        """Those of a rectangle are its bounds, and other periods of the same torus make the same foam."""
        def films(periods):
            foam = foam_of_points(60, periodic=True, PeriodVectors=periods)
            foam.SetPeriodicBounds(0, 8, 0, 8)
            foam.Update()
            return foam.GetOutput(0)

        rectangle = films((0, 0, 0, 0))
        self.assertEqual(differences(films((8, 0, 0, 8)), rectangle), [])
        again = films((8, 0, 16, 8))
        self.assertAlmostEqual(single(again, "Energy") / single(rectangle, "Energy"), 1, 12)

    def test_own_tensions(self):
        foam = foam_of_points(60)
        foam.Update()
        for frame in (1, 10):
            films, bubbles = go_to(coarsening_of(with_tensions(foam.GetOutput(0))), frame)
            self.assertEqual(single(films, "Converged"), 1)
            self.check_films(films, more_cells=["FilmTension"], more_fields=COARSENING_FIELDS)
            self.check_bubbles(films, bubbles)
            self.check_films_against_bubbles(films, bubbles)

    def test_fixed(self):
        foam = foam_of_points(30, Boundary=vtkFoamFromPoints.Fixed)
        foam.Update()
        films = foam.GetOutput(0)
        self.check_films(films, more_cells=["Kind"], more_fields=WALLS)
        self.assertEqual(single(films, "Boundary"), 2)
        wall = column(films.GetCellData(), "OnBoundary") == 1
        self.assertTrue(wall.any())
        self.assertTrue((column(films.GetCellData(), "Curvature")[wall] == 0).all())

    def test_initial_mesh(self):
        foam = foam_of_points(60, Equilibrate=False)
        foam.Update()
        films = foam.GetOutput(0)
        self.check_films(films)
        self.assertEqual(single(films, "Converged"), 0)
        self.assertGreater(single(films, "MaxAngleError"), 0.1)
        self.assertTrue((column(films.GetCellData(), "HalfAngle") == 0).all())

    def test_any_point_set_in_any_plane(self):
        from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid
        plane = points_of([(x + 0.1 * y * y, y, 7.0) for x in range(4) for y in range(4)])
        grid = vtkUnstructuredGrid()
        grid.SetPoints(plane.GetPoints())
        foam = vtkFoamFromPoints()
        foam.SetInputData(grid)
        foam.Update()
        self.assertEqual(foam.GetOutput(1).GetNumberOfPolys(), 16)
        self.assertEqual(foam.GetOutput(1).GetBounds()[4:], (0, 0))

    def test_target_areas(self):
        coordinates = [(x + 0.1 * y, y + 0.05 * x * x) for x in range(4) for y in range(4)]
        areas = [1 + 0.02 * i for i in range(16)]
        foam = vtkFoamFromPoints()
        foam.SetInputData(points_of(coordinates, Wanted=areas))
        foam.SetTargetAreas(vtkFoamFromPoints.Array)
        foam.SetTargetAreaArray("Wanted")
        foam.Update()
        cells = foam.GetOutput(1).GetCellData()
        self.assertEqual(list(column(cells, "TargetArea")), areas)
        numpy.testing.assert_allclose(column(cells, "Area"), areas, rtol=1e-9)
        foam.SetTargetAreas(vtkFoamFromPoints.Uniform)
        foam.Update()
        areas = column(foam.GetOutput(1).GetCellData(), "TargetArea")
        self.assertEqual(areas.min(), areas.max())

    def test_measured_target_areas_are_fitted(self):
        """To a torus and to a container: up to 1 % with a word, more with FitAreas alone; ratios stay."""
        coordinates = [(x + 0.1 * y, y + 0.05 * x) for x in range(4) for y in range(4)]
        shape = numpy.array([1 + 0.02 * i for i in range(16)])
        for boundary in (vtkFoamFromPoints.Periodic, vtkFoamFromPoints.Fixed):
            def foam_of(areas, fit=False, kind=vtkFoamFromPoints.Array):
                foam = vtkFoamFromPoints()
                foam.SetInputData(points_of(coordinates, Wanted=areas))
                set_properties(foam, {"Boundary": boundary, "PeriodicBounds": (-0.5, 3.7, -0.5, 3.7),
                                      "TargetAreas": kind, "TargetAreaArray": "Wanted", "FitAreas": fit})
                messages = Messages(foam)
                foam.Update()
                return foam.GetOutput(1), messages

            bubbles, _ = foam_of(shape, kind=vtkFoamFromPoints.Initial)
            space = column(bubbles.GetCellData(), "TargetArea").sum()
            for off, fit, told, refused in ((0, False, 0, 0), (1e-8, False, 0, 0), (0.004, False, 1, 0),
                                            (-0.009, False, 1, 0), (0.02, False, 0, 1), (0.02, True, 0, 0),
                                            (99, True, 0, 0), (-0.99, True, 0, 0)):
                with self.subTest(boundary=boundary, off=off, fit=fit):
                    total = space * (1 + off)
                    bubbles, messages = foam_of(shape * (total / shape.sum()), fit)
                    self.assertEqual((len(messages.warnings), len(messages.errors)), (told, refused))
                    for text in messages.errors:
                        self.assertIn(f"{total:.3f}"[:5], text)
                        self.assertIn(f"{space:.3f}"[:5], text)
                        self.assertIn("FitAreas", text)
                    for text in messages.warnings:
                        self.assertIn(f"scaled by {1 / (1 + off):.6g}", text)
                    if not refused:
                        areas = column(bubbles.GetCellData(), "Area")
                        numpy.testing.assert_allclose(areas, shape * (space / shape.sum()), rtol=1e-8)

    def test_chord_error(self):
        foam = foam_of_points(60)
        foam.Update()
        coarse = foam.GetOutput(0).GetNumberOfPoints()
        foam.SetChordError(1e-5)
        foam.Update()
        self.assertGreater(foam.GetOutput(0).GetNumberOfPoints(), 2 * coarse)

    def test_first_piece_has_the_foam(self):
        foam = foam_of_points(60)
        coarsen = coarsening_of(foam)
        for piece, rows in ((1, 0), (0, 1)):
            statistics = vtkFoamStatistics()  # from VTK 9.3 on no table is made again for another piece alone
            statistics.SetInputConnection(coarsen.GetOutputPort())
            statistics.UpdatePiece(piece, 2, 0)
            self.assertEqual(statistics.GetOutput(0).GetNumberOfRows(), rows)
            self.assertEqual(foam.GetOutput(0).GetNumberOfLines() > 0, rows == 1)

    def test_coarsened(self):
        coarsen = coarsening_of(foam_of_points(60))
        films, bubbles = go_to(coarsen, 5)
        self.check_films(films, more_fields=COARSENING_FIELDS)
        self.check_bubbles(films, bubbles)
        self.check_films_against_bubbles(films, bubbles)
        self.assertEqual(single(films, "TimeValue"), times(coarsen)[5])
        information = coarsen.GetOutput(1).GetInformation()
        self.assertEqual(information.Get(films.DATA_TIME_STEP()), times(coarsen)[5])


class Statistics(unittest.TestCase):
    def setUp(self):
        self.coarsen = coarsening_of(foam_of_points(60, periodic=True))
        self.films, self.bubbles = go_to(self.coarsen, 12)
        self.statistics = vtkFoamStatistics()
        self.statistics.SetInputData(self.films)
        self.statistics.Update()

    def test_columns(self):
        tables = [self.statistics.GetOutput(i) for i in range(4)]
        self.assertEqual([columns(t) for t in tables],
                         [SUMMARY, BY_SIDES, BUBBLE_CELLS, ["Sides", "Fraction", "MeasuredFraction"]])
        for table in tables:
            self.assertEqual(table.GetFieldData().GetNumberOfArrays(), 0)

    def test_summary(self):
        summary = self.statistics.GetOutput(0)
        self.assertEqual(summary.GetNumberOfRows(), 1)
        value = {name: summary.GetValueByName(0, name).ToDouble() for name in SUMMARY}
        sides = column(self.bubbles.GetCellData(), "Sides")
        areas = column(self.bubbles.GetCellData(), "Area")
        self.assertEqual(value["Time"], times(self.coarsen)[12])
        self.assertEqual(value["Bubbles"], len(sides))
        self.assertAlmostEqual(value["MeanSides"], 6, 12)
        self.assertAlmostEqual(value["Mu2"], ((sides - 6.0) ** 2).mean(), 12)
        self.assertAlmostEqual(value["MeanArea"], areas.mean(), 12)
        self.assertAlmostEqual(value["AreaSecondMoment"], (areas ** 2).mean() / areas.mean() ** 2, 12)
        for name in ("Energy", "T1Count", "T2Count", "T3Count", "Iterations", "MaxAngleError",
                     "MaxAreaError"):
            self.assertEqual(value[name], single(self.films, name), name)

    def test_distribution(self):
        """Beside p(n) of this foam that of the measured one, also for n that do not occur."""
        measured = numpy.genfromtxt(SAMPLES / "measured-sides.csv", delimiter=",", names=True)
        row_data = self.statistics.GetOutput(3).GetRowData()
        sides, fraction, beside = (column(row_data, name)
                                   for name in ("Sides", "Fraction", "MeasuredFraction"))
        self.assertEqual(list(sides), list(range(sides[0], sides[-1] + 1)))
        bubbles = column(self.bubbles.GetCellData(), "Sides")
        for n, p in zip(sides, fraction):
            self.assertAlmostEqual(p, (bubbles == n).mean(), 12)
        self.assertAlmostEqual(fraction.sum(), 1, 12)
        self.assertEqual([p for p in beside if p > 0], list(measured["fraction"]))
        self.assertEqual([n for n, p in zip(sides, beside) if p > 0], list(measured["sides"]))

    def test_by_sides(self):
        table = self.statistics.GetOutput(1)
        sides = column(self.bubbles.GetCellData(), "Sides")
        areas = column(self.bubbles.GetCellData(), "Area")
        self.assertEqual(table.GetNumberOfRows(), len(set(sides)))
        for row, n in enumerate(sorted(set(sides))):
            value = {name: table.GetValueByName(row, name).ToDouble() for name in BY_SIDES}
            self.assertEqual(value["Sides"], n)
            self.assertEqual(value["Count"], (sides == n).sum())
            self.assertAlmostEqual(value["Fraction"], (sides == n).mean(), 12)
            self.assertAlmostEqual(value["AboavProduct"], n * value["MeanNeighbourSides"], 12)
            self.assertAlmostEqual(value["AboavIdeal"], 5 * n + 7.4, 12)
            self.assertAlmostEqual(value["MeanArea"], areas[sides == n].mean() / areas.mean(), 12)

    def test_bubbles(self):
        table = self.statistics.GetOutput(2)
        self.assertEqual(table.GetNumberOfRows(), self.bubbles.GetNumberOfPolys())
        for name in BUBBLE_CELLS:
            expected = column(self.bubbles.GetCellData(), name)
            found = column(table.GetRowData(), name)
            numpy.testing.assert_allclose(found, expected, rtol=1e-13, atol=1e-15)

    def stress_of_films(self):
        """The sum over all films of T times the integral of t t, by what is written of them: the length in full, and
        beside it the chord's direction, as far as the arc has one."""
        cells, total = self.films.GetCellData(), numpy.zeros((2, 2))
        angles, lengths = column(cells, "HalfAngle"), column(cells, "Length")
        for i in range(self.films.GetNumberOfLines()):
            points = self.films.GetCell(i).GetPointIds()
            ends = [numpy.array(self.films.GetPoint(points.GetId(k))[:2])
                    for k in (0, points.GetNumberOfIds() - 1)]
            along = (ends[1] - ends[0]) / numpy.linalg.norm(ends[1] - ends[0])
            turn = 2 * angles[i]
            part = numpy.sinc(turn / numpy.pi) * (2 * numpy.outer(along, along) - numpy.eye(2))
            total += lengths[i] / 2 * (numpy.eye(2) + part)
        return 2 * single(self.films, "SurfaceTension") * total

    def test_stress(self):
        """The foam's stress follows from its films and pressures, and is the mean of its bubbles'."""
        cells = self.bubbles.GetCellData()
        areas, pressures, each = (column(cells, name) for name in ("Area", "Pressure", "Stress"))
        self.assertEqual([cells.GetArray("Stress").GetComponentName(k) for k in range(6)],
                         ["XX", "YY", "ZZ", "XY", "YZ", "XZ"])
        numpy.testing.assert_array_equal(each[:, [2, 4, 5]], 0)
        mean = (areas[:, None] * each).sum(axis=0) / areas.sum()
        films = (self.stress_of_films() - (areas * pressures).sum() * numpy.eye(2)) / areas.sum()
        numpy.testing.assert_allclose(mean[[0, 1, 3]], [films[0, 0], films[1, 1], films[0, 1]], atol=1e-12)
        summary = self.statistics.GetOutput(0)
        value = {name: summary.GetValueByName(0, name).ToDouble() for name in SUMMARY}
        self.assertAlmostEqual(value["StressXX"], mean[0], 12)
        self.assertAlmostEqual(value["StressYY"], mean[1], 12)
        self.assertAlmostEqual(value["StressXY"], mean[3], 12)
        self.assertAlmostEqual(value["NormalStressDifference"], mean[0] - mean[1], 12)
        self.assertGreater(abs(value["StressXY"]), 1e-6)

    def test_cluster_has_no_stress(self):
        foam = foam_of_points(60)
        statistics = vtkFoamStatistics()
        statistics.SetInputConnection(foam.GetOutputPort(0))
        statistics.Update()
        for name in ("StressXX", "StressYY", "StressXY"):
            self.assertAlmostEqual(statistics.GetOutput(0).GetValueByName(0, name).ToDouble(), 0, 9)

    def test_boundary(self):
        foam = foam_of_points(60)
        statistics = vtkFoamStatistics()
        statistics.SetInputConnection(foam.GetOutputPort(0))
        statistics.Update()
        on_boundary = column(foam.GetOutput(1).GetCellData(), "OnBoundary")
        self.assertEqual(statistics.GetOutput(0).GetValueByName(0, "Bubbles").ToInt(),
                         60 - on_boundary.sum())
        self.assertEqual(statistics.GetOutput(2).GetNumberOfRows(), 60)
        statistics.IncludeBoundaryOn()
        statistics.Update()
        self.assertEqual(statistics.GetOutput(0).GetValueByName(0, "Bubbles").ToInt(), 60)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What films say of their equilibrium is measured: after they were changed it no longer holds."""

import random
import re
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformFilter

from foam.vtkFoamFilters import vtkFoamCoarsen, vtkFoamFromPoints, vtkFoamStatistics
from foam_testing import (Messages, coarsening_of, column, copy, differences, foam_of_points, go_to, single,
                          skewed_torus, times)


def transformed(films, change):
    """Films after ParaView's Transform."""
    transform = vtkTransform()
    change(transform)
    transformer = vtkTransformFilter()
    transformer.SetInputData(films)
    transformer.SetTransform(transform)
    transformer.Update()
    return copy(transformer.GetOutput())


def in_single_precision(films):
    result = copy(films)
    points = vtkPoints()
    points.SetDataTypeToFloat()
    points.DeepCopy(films.GetPoints())
    result.SetPoints(points)
    assert points.GetDataType() == 10
    return result


def with_angles_in_single_precision(films):
    result = copy(films)
    angles = vtkFloatArray()
    angles.DeepCopy(films.GetCellData().GetArray("HalfAngle"))
    result.GetCellData().AddArray(angles)
    assert result.GetCellData().GetArray("HalfAngle").GetDataType() == 10
    return result


def with_the_points_of_each_film_reversed(films):
    lines = vtkCellArray()
    for i in range(films.GetNumberOfLines()):
        points = films.GetCell(i).GetPointIds()
        lines.InsertNextCell(points.GetNumberOfIds())
        for k in reversed(range(points.GetNumberOfIds())):
            lines.InsertCellPoint(points.GetId(k))
    result = copy(films)
    result.SetLines(lines)
    return result


class Measuring(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.films = {}
        for boundary in ("Free", "Periodic", "Fixed"):
            foam = foam_of_points(60, Boundary=getattr(vtkFoamFromPoints, boundary))
            cls.films[boundary] = go_to(coarsening_of(foam), 7)[0]

    def statistics(self, films):
        """The summary of films, and the warnings."""
        statistics = vtkFoamStatistics()
        statistics.SetInputData(films)
        messages = Messages(statistics)
        statistics.Update()
        self.assertEqual(messages.errors, [])
        row = {name: statistics.GetOutput(0).GetValueByName(0, name).ToDouble()
               for name in ("MaxAngleError", "MaxAreaError", "MeanArea")}
        return row, messages.warnings

    def bubbles(self, films):
        """Of films that are read, though rounding may have taken them out of equilibrium."""
        statistics = vtkFoamStatistics()
        statistics.SetInputData(films)
        messages = Messages(statistics)
        statistics.Update()
        self.assertEqual(messages.errors, [])
        rows = statistics.GetOutput(2).GetRowData()
        return {name: column(rows, name) for name in ("Area", "Sides", "Perimeter")}

    def start(self, films, **properties):
        """The first frame that FoamCoarsen makes of films, the filter, and the warnings."""
        coarsen = coarsening_of(films, **properties)
        messages = Messages(coarsen)
        shown, _ = go_to(coarsen, 0)
        self.assertEqual(messages.errors, [])
        return shown, coarsen, messages.warnings

    def check_holds(self, films):
        shown, _, warnings = self.start(films)
        self.assertEqual(warnings + self.statistics(films)[1], [])
        self.assertEqual(single(shown, "Converged"), 1)

    def rejects(self, films, *parts):
        for algorithm in (vtkFoamCoarsen(), vtkFoamStatistics()):
            algorithm.SetInputData(films)
            messages = Messages(algorithm)
            algorithm.Update()
            self.assertEqual(len(messages.errors), 1, messages.errors)
            for part in parts:
                self.assertIn(part, messages.errors[0])


class Unchanged(Measuring):
    def test_a_frame_holds(self):
        for films in self.films.values():
            self.check_holds(films)

    def test_frames_of_both_methods_hold(self):
        for properties in ({"Equilibrator": vtkFoamCoarsen.Junction}, {"Stepping": vtkFoamCoarsen.FixedSteps}, {}):
            for boundary in ("Free", "Periodic"):
                coarsen = coarsening_of(self.films[boundary], **properties)
                for frame in range(6):
                    films, _ = go_to(coarsen, frame)
                    statistics = vtkFoamStatistics()
                    statistics.SetInputData(films)
                    messages = Messages(statistics)
                    statistics.Update()
                    self.assertEqual(messages.errors + messages.warnings, [])

    def test_moved_and_turned(self):
        random.seed(1)
        for far in (1, 1e3, 4e6, 1e9):
            angle, x, y = 360 * random.random(), far * random.random(), -far * random.random()

            def change(transform):
                transform.Translate(x, y, 0)
                transform.RotateZ(angle)
            for boundary in ("Free", "Fixed"):
                self.check_holds(transformed(self.films[boundary], change))
            self.check_holds(transformed(self.films["Periodic"], lambda t: t.Translate(x, y, 0)))

    def test_in_single_precision(self):
        for boundary in ("Free", "Fixed"):
            self.check_holds(in_single_precision(self.films[boundary]))
            self.check_holds(in_single_precision(
                transformed(self.films[boundary], lambda t: t.Translate(1000, 0, 0))))

    def test_half_angles_in_single_precision(self):
        """Alone, where coordinates have all their digits."""
        for films in self.films.values():
            self.check_holds(with_angles_in_single_precision(films))

    def test_a_torus_in_single_precision(self):
        """Films find their junctions' images as far from the origin as rounding tells these apart."""
        skewed = foam_of_points(60, periodic=True, PeriodVectors=skewed_torus())
        for films in (self.films["Periodic"], go_to(coarsening_of(skewed), 7)[0]):
            self.check_holds(in_single_precision(films))
            for far in (300, 3e4):
                rounding = far * 2.0**-23
                self.assertGreater(rounding, 1e-6 * 60**0.5, "films of all digits may not be off so far")
                moved = transformed(films, lambda t: t.Translate(far, -far, 0))
                exact, rounded = self.bubbles(moved), self.bubbles(in_single_precision(moved))
                numpy.testing.assert_array_equal(rounded["Sides"], exact["Sides"])
                self.assertLess((abs(rounded["Area"] - exact["Area"]) / exact["Perimeter"]).max(), 2 * rounding)

    def test_a_torus_too_far_for_single_precision(self):
        films = transformed(self.films["Periodic"], lambda t: t.Translate(3e8, 0, 0)) # where numbers are 32 apart
        self.rejects(in_single_precision(films), "not a foam")

    def test_a_torus_of_all_digits(self):
        """Its films end within a millionth of a period of their junctions' images."""
        for off, accepted in ((1e-7, True), (1e-5, False)):
            films = copy(self.films["Periodic"])
            xmin, xmax, *_ = column(films.GetFieldData(), "PeriodicBounds")[0]
            places = vtk_to_numpy(films.GetPoints().GetData())
            junctions = column(films.GetPointData(), "JunctionId")
            first = {junction: i for i, junction in reversed(list(enumerate(junctions))) if junction >= 0}
            image = next(i for i, junction in enumerate(junctions)
                         if junction >= 0 and abs(places[i] - places[first[junction]])[0] > 1)
            places[image, 0] += off * (xmax - xmin)
            if accepted:
                self.bubbles(films)
            else:
                self.rejects(films, "not whole periods away")


class Mirrored(Measuring):
    def test_turned_round_as_the_error_says(self):
        """The mirror image of a foam coarsens as its mirror image."""
        for boundary, films in self.films.items():
            mirrored = transformed(films, lambda t: t.Scale(-1, 1, 1))
            self.rejects(mirrored, "was it mirrored? Then the points of each film are to be reversed")
            turned = with_the_points_of_each_film_reversed(mirrored)
            self.check_holds(turned)
            (expected, bubbles), (after, image) = (go_to(coarsening_of(start), 12) for start in (films, turned))
            for name in ("T1Count", "T2Count", "T3Count"):
                self.assertEqual(single(after, name), single(expected, name), boundary)
            self.assertGreater(single(after, "T1Count"), single(films, "T1Count"))
            self.assertAlmostEqual(single(after, "Energy") / single(expected, "Energy"), 1, 8)
            numpy.testing.assert_allclose(column(image.GetCellData(), "Area"), column(bubbles.GetCellData(), "Area"),
                                          rtol=1e-7)


class Changed(Measuring):
    def test_scaled(self):
        """Twice as wide, areas are four times their targets: off by three times those."""
        for scale in (2, 0.5, 1.001):
            films = transformed(self.films["Free"], lambda t: t.Scale(scale, scale, 1))
            row, warnings = self.statistics(films)
            self.assertEqual(len(warnings), 1, warnings)
            self.assertIn("not", warnings[0])
            self.assertIn(f"areas by up to {abs(scale**2 - 1):.3g} times their targets", warnings[0])
            self.assertAlmostEqual(row["MaxAreaError"], abs(scale**2 - 1), 7)
            self.assertLess(row["MaxAngleError"], 1e-7)
            shown, _, warnings = self.start(films)
            self.assertEqual(len(warnings), 1, warnings)
            self.assertIn("Measured", warnings[0])
            self.assertEqual(single(shown, "Converged"), 0)
            self.assertAlmostEqual(single(shown, "MaxAreaError"), abs(scale**2 - 1), 7)

    def test_stretched(self):
        films = transformed(self.films["Free"], lambda t: t.Scale(1.02, 1 / 1.02, 1))
        row, warnings = self.statistics(films)
        self.assertEqual(len(warnings), 1, warnings)
        self.assertGreater(row["MaxAngleError"], 0.01)
        shown, _, warnings = self.start(films)
        self.assertEqual((single(shown, "Converged"), len(warnings)), (0, 1))
        self.assertEqual(single(shown, "MaxAngleError"), row["MaxAngleError"])

    def test_other_pressures(self):
        """They are named where they are what is off."""
        films = copy(self.films["Free"])
        pressure = films.GetFieldData().GetArray("BubblePressure")
        pressure.SetValue(3, 1.01 * pressure.GetValue(3))
        warnings = self.statistics(films)[1]
        self.assertEqual(len(warnings), 1)
        self.assertIn("pressures", warnings[0])
        self.assertEqual(single(self.start(films)[0], "Converged"), 0)
        scaled = transformed(self.films["Free"], lambda t: t.Scale(2, 2, 1)) # areas are further off
        self.assertNotIn("pressures", self.statistics(scaled)[1][0])

    def test_targets(self):
        """FromFilms, the foam shrinks to what it was; Measured, it keeps its areas and its equilibrium."""
        films = transformed(self.films["Free"], lambda t: t.Scale(1.5, 1.5, 1))
        for targets, scale in ((vtkFoamCoarsen.FromFilms, 1), (vtkFoamCoarsen.Measured, 2.25)):
            shown, coarsen, warnings = self.start(films, TargetAreas=targets, Permeability=0)
            expected = scale * column(self.films["Free"].GetFieldData(), "BubbleTargetArea")
            numpy.testing.assert_allclose(column(shown.GetFieldData(), "BubbleTargetArea"), expected, rtol=1e-8)
            kept = targets == vtkFoamCoarsen.Measured
            self.assertEqual([("TargetAreas Measured" in text) for text in warnings], [] if kept else [True])
            self.assertEqual(single(shown, "Converged"), kept)
            after, bubbles = go_to(coarsen, 1)
            self.assertEqual(single(after, "Converged"), 1)
            self.assertEqual(single(after, "TimeValue"), times(coarsen)[1])
            numpy.testing.assert_allclose(column(bubbles.GetCellData(), "Area"), expected, rtol=1e-8)
            # Energy is a length: that of the foam so large.
            self.assertAlmostEqual(single(after, "Energy") / (scale**0.5 * single(self.films["Free"], "Energy")), 1, 7)

    def test_targets_can_be_changed_again(self):
        films = transformed(self.films["Free"], lambda t: t.Scale(1.5, 1.5, 1))
        coarsen = coarsening_of(films)
        Messages(coarsen)
        first, _ = go_to(coarsen, 1)
        coarsen.SetTargetAreas(vtkFoamCoarsen.Measured)
        go_to(coarsen, 1)
        coarsen.SetTargetAreas(vtkFoamCoarsen.FromFilms)
        self.assertEqual(differences(go_to(coarsen, 1)[0], first), [])


    def test_measured_in_another_size(self):
        """It goes on as the same foam: lengths times s, areas and times times s², pressures over s."""
        expected, bubbles = go_to(coarsening_of(self.films["Free"], TargetAreas=vtkFoamCoarsen.Measured), 20)
        areas = column(bubbles.GetCellData(), "Area")
        events = [single(expected, name) for name in ("T1Count", "T2Count", "T3Count")]
        self.assertGreater(sum(events), 0)
        for scale in (1e3, 30, 1e-3):
            films = transformed(self.films["Free"], lambda t: t.Scale(scale, scale, 1))
            films.GetFieldData().GetArray("TimeValue").SetValue(0, 0)
            coarsen = coarsening_of(films, TargetAreas=vtkFoamCoarsen.Measured)
            messages = Messages(coarsen)
            after, bubbles = go_to(coarsen, 20)
            self.assertEqual(messages.errors + messages.warnings, [])
            self.assertEqual([single(after, name) for name in ("T1Count", "T2Count", "T3Count")], events)
            numpy.testing.assert_allclose(column(bubbles.GetCellData(), "Area"), scale**2 * areas, rtol=1e-8)
            self.assertAlmostEqual(single(after, "TimeStep") / (scale**2 * single(expected, "TimeStep")), 1, 9)
            numpy.testing.assert_allclose(column(after.GetFieldData(), "BubblePressure"),
                                          column(expected.GetFieldData(), "BubblePressure") / scale, rtol=1e-7)


def with_targets(films, factor):
    """Films whose target areas were multiplied."""
    result = copy(films)
    areas = column(result.GetFieldData(), "BubbleTargetArea")
    areas *= factor
    return result


class Closed(Measuring):
    """Target areas have to fill a torus or a container."""

    def check(self, films, space, off):
        """That targets which are off by a part of the space are scaled with a word or refused."""
        if abs(off) > 0.01:
            coarsen = coarsening_of(films)
            messages = Messages(coarsen)
            coarsen.Update()
            self.assertEqual((len(messages.errors), messages.warnings), (1, []))
            text = messages.errors[0]
            self.assertIn("TargetAreas Measured", text)
            sums = [float(number) for number in re.findall(r"(?:add up to|is) ([\d.]+)", text)]
            numpy.testing.assert_allclose(sums, [space * (1 + off), space], rtol=1e-9)
        else:
            shown, coarsen, warnings = self.start(films, Permeability=0)
            self.assertEqual(len(warnings), 1)
            self.assertIn(f"scaled by {1 / (1 + off):.6g}", warnings[0])
            offered = times(coarsen)
            after, bubbles = go_to(coarsen, 1)
            self.assertEqual(times(coarsen), offered)
            self.assertAlmostEqual(column(bubbles.GetCellData(), "Area").sum() / space, 1, 9)
            self.assertEqual(single(after, "Converged"), 1)
        self.check_measured(films)

    def check_measured(self, films):
        shown, _, warnings = self.start(films, TargetAreas=vtkFoamCoarsen.Measured)
        self.assertEqual((single(shown, "Converged"), warnings), (1, []))

    def test_container_scaled(self):
        space = column(self.films["Fixed"].GetFieldData(), "BubbleTargetArea").sum()
        for scale in (1.3, 1.006, 1.002, 0.998, 0.5):
            films = transformed(self.films["Fixed"], lambda t: t.Scale(scale, scale, 1))
            self.check(films, space * scale**2, scale**-2 - 1)

    def test_targets_changed(self):
        for boundary in ("Periodic", "Fixed"):
            space = column(self.films[boundary].GetFieldData(), "BubbleTargetArea").sum()
            for off in (-0.3, -0.004, 0.0099, 0.011, 100):
                self.check(with_targets(self.films[boundary], 1 + off), space, off)

    def test_rounded_targets(self):
        """As of a file with eight digits."""
        for boundary in ("Periodic", "Fixed"):
            _, _, warnings = self.start(with_targets(self.films[boundary], 1 + 1e-8))
            self.assertEqual(warnings, [])

    def test_frames_of_the_thesis_method(self):
        """Which lets sums drift, and says so."""
        foam = foam_of_points(40, Boundary=vtkFoamFromPoints.Periodic)
        films, _ = go_to(coarsening_of(foam, Equilibrator=vtkFoamCoarsen.Junction), 60)
        drift = column(films.GetFieldData(), "BubbleTargetArea").sum() / 40 - 1
        self.assertGreater(abs(drift), 1e-6)
        coarsen = coarsening_of(films, Equilibrator=vtkFoamCoarsen.Junction)
        resumed, _ = go_to(coarsen, 0)
        numpy.testing.assert_array_equal(column(resumed.GetFieldData(), "BubbleTargetArea"),
                                         column(films.GetFieldData(), "BubbleTargetArea"))


class Torus(Measuring):
    def test_scaled(self):
        """By a whole number too, with which films still end whole periods away."""
        for scale in (1.3, 0.5):
            films = transformed(self.films["Periodic"], lambda t: t.Scale(scale, scale, 1))
            self.rejects(films, "not whole periods", "transformed")
        films = transformed(self.films["Periodic"], lambda t: t.Scale(2, 2, 1))
        row = column(self.films["Periodic"].GetFieldData(), "PeriodicBounds")[0]
        cell = (row[1] - row[0]) * (row[3] - row[2])
        self.rejects(films, "do not fit their torus", f"cover {4 * cell:.4g}"[:9], f"area of {cell:.4g}"[:11])

    def test_turned(self):
        self.rejects(transformed(self.films["Periodic"], lambda t: t.RotateZ(30)), "do not fit their torus")

    def test_turned_out_of_the_plane(self):
        for films in self.films.values():
            self.rejects(transformed(films, lambda t: t.RotateX(20)), "plane of constant z")


if __name__ == "__main__":
    unittest.main()

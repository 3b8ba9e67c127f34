# SPDX-License-Identifier: GPL-3.0-or-later
"""FoamDeform, and the events of both filters that take a foam from frame to frame."""

import math
import tempfile
import unittest
from pathlib import Path

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from foam.vtkFoamFilters import vtkFoamDeform, vtkFoamFromPoints, vtkFoamStatistics
from foam_testing import (Messages, bits, coarsening_of, copy, deformation_of, foam_of_points, go_to, points_of, read,
                          single, times, write)

HEXAGONAL_MODULUS = 0.465302429551  # T/√A


def honeycomb(columns=6, rows=6, unit=1):
    height = math.sqrt(0.75) * unit
    foam = vtkFoamFromPoints()
    foam.SetInputData(points_of([((column + 0.5 * (row % 2)) * unit, row * height) for row in range(rows)
                                 for column in range(columns)]))
    foam.SetBoundary(vtkFoamFromPoints.Periodic)
    foam.SetPeriodicBounds(0, columns * unit, 0, rows * height)
    return foam


def summary(films):
    statistics = vtkFoamStatistics()
    statistics.SetInputData(films)
    statistics.Update()
    table = statistics.GetOutput(0)
    return {table.GetColumnName(i): table.GetColumn(i).GetValue(0) for i in range(table.GetNumberOfColumns())}


def shear_modulus(films):
    statistics = vtkFoamStatistics()
    statistics.SetInputData(films)
    statistics.ShearModulusOn()
    messages = Messages(statistics)
    statistics.Update()
    return statistics.GetOutput(0).GetColumnByName("ShearModulus").GetValue(0), messages.warnings


def events(algorithm):
    output = algorithm.GetOutput(2)
    data = output.GetPointData()
    result = {name: vtk_to_numpy(data.GetArray(name)) for name in ("Kind", "Time", "Strain", "Bubbles")}
    result["Place"] = vtk_to_numpy(output.GetPoints().GetData()).reshape(-1, 3)
    return result


class Deform(unittest.TestCase):
    def test_times_are_accumulated_strain(self):
        deform = deformation_of(foam_of_points(periodic=True), NumberOfFrames=6, StrainStep=-0.1, Amplitude=0.2)
        self.assertEqual(times(deform), [0.1 * k for k in range(7)])
        strains = []
        for frame in range(1, 7):
            films, _ = go_to(deform, frame)
            strains.append(single(films, "Strain"))
            self.assertEqual(single(films, "StrainDirection"), -1 if frame <= 2 else 1)
        numpy.testing.assert_allclose(strains, [-0.1, -0.2, -0.1, 0, 0.1, 0.2], atol=1e-15)

    def test_stress_of_a_honeycomb(self):
        """G·γ/√(1 + γ²/4), N₁ = γ·τ."""
        foam = honeycomb()
        deform = deformation_of(foam, StrainStep=0.25, NumberOfFrames=4)
        for frame in range(1, 5):
            films, _ = go_to(deform, frame)
            figures = summary(films)
            area = figures["MeanArea"]
            unit = 2 * single(films, "SurfaceTension") / math.sqrt(area)
            strain = 0.25 * frame
            exact = HEXAGONAL_MODULUS * strain / math.sqrt(1 + strain**2 / 4)
            self.assertAlmostEqual(figures["StressXY"] / unit, exact, 9)
            self.assertAlmostEqual(figures["NormalStressDifference"] / unit, strain * exact, 9)

    def test_shear_modulus(self):
        """In any unit that of a honeycomb; none of what is no torus."""
        for unit in (1e-6, 1, 300):
            foam = honeycomb(unit=unit)
            foam.Update()
            films = foam.GetOutput(0)
            tension = 2 * single(films, "SurfaceTension")
            modulus, _ = shear_modulus(films)
            self.assertAlmostEqual(modulus * unit * math.sqrt(math.sqrt(0.75)) / tension, HEXAGONAL_MODULUS, 10)
        cluster = foam_of_points(30)
        cluster.Update()
        modulus, warnings = shear_modulus(cluster.GetOutput(0))
        self.assertTrue(math.isnan(modulus))
        self.assertEqual(len(warnings), 1)
        self.assertIn("not periodic", warnings[0])

    def test_a_honeycomb_yields_at_its_strain(self):
        """All of its horizontal films swap at 2/√3, whatever the frames; then it is as unstrained."""
        for step in (0.1, 0.0125):
            deform = deformation_of(honeycomb(), StrainStep=step, NumberOfFrames=round(1.2 / step))
            go_to(deform, round(1.2 / step))
            found = events(deform)
            self.assertEqual(list(found["Kind"]), 36 * [1])
            numpy.testing.assert_allclose(found["Strain"], 2 / math.sqrt(3), atol=1e-9)
            self.assertEqual(len({frozenset(four) for four in found["Bubbles"].tolist()}), 36)

    def test_any_order_of_frames_has_the_same_bits(self):
        foam = foam_of_points(40, periodic=True)
        deform = deformation_of(foam, StrainStep=0.05, NumberOfFrames=24, KeyframeInterval=5)
        there = [bits(go_to(deform, frame)[0]) for frame in (3, 12, 24)]
        counts = len(events(deform)["Kind"])
        self.assertGreater(counts, 2)
        back = [bits(go_to(deform, frame)[0]) for frame in (24, 12, 3)]
        self.assertEqual(there, back[::-1])
        self.assertLess(len(events(deform)["Kind"]), counts)

    def test_a_run_goes_on_from_a_keyframe_that_was_written(self):
        foam = foam_of_points(40, periodic=True)
        deform = deformation_of(foam, StrainStep=0.05, NumberOfFrames=20, Amplitude=0.4)
        with tempfile.TemporaryDirectory() as folder:
            file = str(Path(folder) / "films.vtp")
            write(go_to(deform, 10)[0], file)
            resumed = deformation_of(read(file), StrainStep=0.05, NumberOfFrames=10, Amplitude=0.4)
            self.assertEqual(bits(go_to(resumed, 10)[0]), bits(go_to(deform, 20)[0]))

    def test_coarsening_of_what_was_deformed_and_the_other_way(self):
        deform = deformation_of(foam_of_points(40, periodic=True), StrainStep=0.1, NumberOfFrames=5)
        coarsen = coarsening_of(deform, TimeStep=0.1, NumberOfFrames=5)
        films, _ = go_to(coarsen, 5)
        self.assertEqual(single(films, "Converged"), 1)
        self.assertAlmostEqual(single(films, "TimeValue"), 1, 12)
        self.assertAlmostEqual(single(films, "Strain"), 0.5, 12)
        again = deformation_of(coarsen, StrainStep=0.1, NumberOfFrames=2)
        films, _ = go_to(again, 2)
        self.assertEqual(single(films, "Converged"), 1)
        self.assertAlmostEqual(single(films, "Strain"), 0.7, 12)

    def test_bad_input(self):
        torus = foam_of_points(30, periodic=True)
        for source, properties, words in (
                (foam_of_points(30), {}, "its Boundary is not Periodic"),
                (torus, {"StrainStep": 0.0}, "StrainStep"),
                (torus, {"StrainStep": math.nan}, "StrainStep"),
                (torus, {"Amplitude": 0.001}, "Amplitude"),
                (torus, {"Equilibrator": vtkFoamDeform.Junction}, "Newton"),
                (torus, {"NumberOfFrames": -1}, "NumberOfFrames")):
            with self.subTest(words=words, properties=properties):
                deform = deformation_of(source, **properties)
                messages = Messages(deform)
                deform.Update()
                self.assertEqual(len(messages.errors), 1, messages.errors)
                self.assertIn(words, messages.errors[0])
                self.assertEqual(deform.GetOutput(0).GetNumberOfCells(), 0)


class Events(unittest.TestCase):
    def test_are_what_the_counts_count(self):
        for algorithm in (coarsening_of(foam_of_points(50), NumberOfFrames=40),
                          coarsening_of(foam_of_points(50, periodic=True), NumberOfFrames=40, Stepping=1, TimeStep=0.05),
                          coarsening_of(foam_of_points(50), NumberOfFrames=40, Equilibrator=1),
                          deformation_of(foam_of_points(50, periodic=True), NumberOfFrames=40, StrainStep=0.05)):
            first = copy(go_to(algorithm, 0)[0])
            self.assertEqual(algorithm.GetOutput(2).GetNumberOfVerts(), 0)
            self.assertEqual(algorithm.GetOutput(2).GetPointData().GetNumberOfArrays(), 4)
            last = go_to(algorithm, 40)[0]
            found = events(algorithm)
            self.assertGreater(len(found["Kind"]), 5)
            for kind in (1, 2, 3):
                count = single(last, f"T{kind}Count") - single(first, f"T{kind}Count")
                self.assertEqual(numpy.count_nonzero(found["Kind"] == kind), count)
            self.assertTrue((numpy.diff(found["Time"]) >= 0).all())
            self.assertGreaterEqual(found["Time"][0], times(algorithm)[0])
            self.assertLessEqual(found["Time"][-1], times(algorithm)[40] * (1 + 1e-12))
            vanished = found["Bubbles"][found["Kind"] > 1, 0]
            left = vtk_to_numpy(last.GetFieldData().GetArray("BubbleId"))
            self.assertFalse(set(vanished) & set(left))
            if not isinstance(algorithm, vtkFoamDeform):  # whose cell changes
                low, high = numpy.reshape(last.GetBounds(), (3, 2))[:2].T
                self.assertTrue(((found["Place"][:, :2] > low - 1) & (found["Place"][:, :2] < high + 1)).all())
            middle = go_to(algorithm, 20)
            until = events(algorithm)
            numpy.testing.assert_array_equal(until["Bubbles"], found["Bubbles"][:len(until["Kind"])])
            self.assertTrue((found["Time"][len(until["Kind"]):] >= single(middle[0], "TimeValue") - 1e-12).all())

    def test_do_not_depend_on_the_frames(self):
        """Of a small foam, whose events are found at their own times."""
        found = []
        for step in (0.01, 0.1):
            coarsen = coarsening_of(foam_of_points(60), TimeStep=step, NumberOfFrames=round(0.5 / step),
                                    Thresholds=0, T1Length=0.001, T2Area=0.001)
            go_to(coarsen, round(0.5 / step))
            found.append(events(coarsen))
        self.assertGreater(len(found[0]["Kind"]), 3)
        numpy.testing.assert_array_equal(found[0]["Kind"], found[1]["Kind"])
        numpy.testing.assert_array_equal(found[0]["Bubbles"], found[1]["Bubbles"])
        numpy.testing.assert_allclose(found[0]["Time"], found[1]["Time"], atol=1e-6)
        numpy.testing.assert_allclose(found[0]["Place"], found[1]["Place"], atol=2e-3)  # a free foam slides

    def test_are_no_foam(self):
        coarsen = coarsening_of(foam_of_points(30), NumberOfFrames=20)
        go_to(coarsen, 20)
        data = vtkPolyData()
        data.DeepCopy(coarsen.GetOutput(2))
        again = coarsening_of(data)
        messages = Messages(again)
        again.Update()
        self.assertEqual(len(messages.errors), 1)


if __name__ == "__main__":
    unittest.main()

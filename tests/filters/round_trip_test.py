# SPDX-License-Identifier: GPL-3.0-or-later
"""Films written to a .vtp and read back are the same foam, bit for bit."""

import tempfile
import unittest
from pathlib import Path

from foam.vtkFoamFilters import vtkFoamFromPoints
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from foam_testing import (Messages, array_of, coarsening_of, copy, differences, differences_of_foams, foam_of_points,
                          go_to, read, single, skewed_torus, with_tensions, write)


class RoundTrip(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "films.vtp"

    def check(self, films):
        """Frame 0 of a coarsening is what its input was read as, written again."""
        again, _ = go_to(coarsening_of(films), 0)
        self.assertEqual(differences_of_foams(films, again), [])
        write(films, self.path)
        loaded = read(self.path)
        self.assertEqual(differences(films, loaded), [])
        again, _ = go_to(coarsening_of(loaded), 0)
        self.assertEqual(differences_of_foams(films, again), [])

    def test_free(self):
        foam = foam_of_points()
        foam.Update()
        self.check(copy(foam.GetOutput(0)))

    def test_periodic(self):
        foam = foam_of_points(periodic=True)
        foam.Update()
        self.check(copy(foam.GetOutput(0)))

    def test_small_torus(self):
        """Where films wrap both ways and bubbles are their own neighbours."""
        for count in (3, 4, 5):
            foam = foam_of_points(count, periodic=True)
            messages = Messages(foam)
            foam.Update()
            if not messages.errors:
                self.check(copy(foam.GetOutput(0)))

    def test_fixed(self):
        foam = foam_of_points(30, Boundary=vtkFoamFromPoints.Fixed)
        foam.Update()
        self.check(copy(foam.GetOutput(0)))

    def test_skewed_torus(self):
        foam = foam_of_points(periodic=True, PeriodVectors=skewed_torus())
        foam.Update()
        films = copy(foam.GetOutput(0))
        self.assertTrue(films.GetFieldData().HasArray("PeriodVectors"))
        self.check(films)

    def test_torus_whose_bounds_are_rounded(self):
        """Periods that the bounds do not give back to the last digit are written themselves."""
        foam = foam_of_points(periodic=True, PeriodVectors=(8 - 2 ** -49, 0, 0, 7.7))
        foam.SetPeriodicBounds(1000.1, 1001, 0.1, 1)
        foam.Update()
        films = copy(foam.GetOutput(0))
        self.assertTrue(films.GetFieldData().HasArray("PeriodVectors"))
        self.check(films)

    def test_own_tensions(self):
        for periodic in (False, True):
            foam = foam_of_points(periodic=periodic)
            foam.Update()
            films, _ = go_to(coarsening_of(with_tensions(foam.GetOutput(0))), 3)
            self.assertTrue(films.GetCellData().HasArray("FilmTension"))
            self.check(films)

    def test_outside_pressure(self):
        foam = foam_of_points()
        foam.Update()
        films = copy(foam.GetOutput(0))
        films.GetFieldData().AddArray(array_of("OutsidePressure", [0.3]))
        films, _ = go_to(coarsening_of(films), 1)
        self.assertEqual(single(films, "OutsidePressure"), 0.3)
        self.assertEqual(single(films, "Converged"), 1)
        self.check(films)

    def test_initial_mesh(self):
        foam = foam_of_points(Equilibrate=False)
        foam.Update()
        self.check(copy(foam.GetOutput(0)))

    def test_coarsened(self):
        for periodic in (False, True):
            foam = foam_of_points(periodic=periodic)
            films, _ = go_to(coarsening_of(foam), 23)
            self.check(films)

    def test_ascii_and_small_ids(self):
        foam = foam_of_points()
        foam.Update()
        films = copy(foam.GetOutput(0))
        films.GetLines().ConvertTo32BitStorage()
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(self.path))
        writer.SetInputData(films)
        writer.SetDataModeToAscii()
        writer.SetIdTypeToInt32()
        writer.Write()
        again, _ = go_to(coarsening_of(read(self.path)), 0)
        self.assertEqual(differences_of_foams(foam.GetOutput(0), again), [])


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Films written to a .vtp and read back are the same foam, bit for bit."""

import tempfile
import unittest
from pathlib import Path

from foam.vtkFoamFilters import vtkFoamFromPoints
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from foam_testing import (Messages, coarsening_of, copy, differences, foam_of_points, go_to, read,
                          write)


class RoundTrip(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = Path(folder.name) / "films.vtp"

    def check(self, films):
        """Frame 0 of a coarsening is what its input was read as, written again."""
        again, _ = go_to(coarsening_of(films), 0)
        self.assertEqual(differences(films, again), [])
        write(films, self.path)
        loaded = read(self.path)
        self.assertEqual(differences(films, loaded), [])
        again, _ = go_to(coarsening_of(loaded), 0)
        self.assertEqual(differences(films, again), [])

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
        self.assertEqual(differences(foam.GetOutput(0), again), [])


if __name__ == "__main__":
    unittest.main()

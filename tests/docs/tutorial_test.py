# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tutorial's blocks of Python with few frames, and looks at what they leave."""

import csv
import os
import runpy
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

ROOT = Path(__file__).resolve().parent.parent.parent
PIXEL = 0.042  # cm, as the tutorial says


class Tutorial(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.addClassCleanup(os.chdir, os.getcwd())
        sys.argv[1:] = [folder.name, "--quick"]
        cls.names = runpy.run_path(str(ROOT / "scripts/run_tutorial.py"), run_name="__main__")

    def films(self, frame):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / f"films/films_{frame:04d}.vtp"))
        reader.Update()
        field = reader.GetOutput().GetFieldData()
        return {field.GetArrayName(i): vtk_to_numpy(field.GetArray(i)) for i in range(field.GetNumberOfArrays())}

    def test_the_foam_has_the_measured_areas(self):
        with open(ROOT / "sample-data/real-foam-centroids.csv", newline="") as file:
            measured = [float(row["area"]) * PIXEL**2 for row in csv.DictReader(file)]
        films = self.films(0)
        np.testing.assert_allclose(films["BubbleTargetArea"], measured, rtol=1e-6)
        self.assertEqual(films["Converged"], 1)
        self.assertLess(films["MaxAngleError"], 1e-6)

    def test_times(self):
        expected = [0.02 * i for i in range(self.names["FEW"] + 1)]
        entries = ElementTree.parse(self.folder / "films.pvd").getroot().iter("DataSet")
        np.testing.assert_allclose([float(entry.get("timestep")) for entry in entries], expected)
        np.testing.assert_allclose(self.names["time"], expected)

    def test_figures(self):
        self.assertTrue(all(0 < count < 378 for count in self.names["bubbles"]), "the edge is left out")
        self.assertTrue(all(0 < mu2 < 2 for mu2 in self.names["mu2"]))

    def test_film_and_pictures(self):
        self.assertEqual((self.folder / "film.ogv").read_bytes()[:4], b"OggS")
        for name in ("foam.png", "plot.png"):
            pixels = np.asarray(Image.open(self.folder / name).convert("RGB"))
            self.assertTrue((pixels[0, 0] == 255).all(), "a white margin")
            self.assertGreater((pixels < 128).any(axis=2).mean(), 0.01, "something drawn")


if __name__ == "__main__":
    unittest.main()

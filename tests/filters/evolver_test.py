# SPDX-License-Identifier: GPL-3.0-or-later
"""Foams that are written for Surface Evolver, and read back."""

import re
import tempfile
import unittest
from pathlib import Path

import numpy

from foam.vtkFoamFilters import vtkFoamEvolverReader, vtkFoamEvolverWriter, vtkFoamFromPoints, vtkFoamPoints
from foam_testing import Messages, coarsening_of, column, foam_of_points, go_to, set_properties, single

DATA = Path(__file__).resolve().parents[1] / "data"
REFERENCE = DATA / "evolver-100/foam100_arc.fe"
EXACT = ("LeftBubble", "RightBubble", "OnBoundary", "BubbleId", "Sides", "SurfaceTension", "Boundary", "TimeValue")


def reader_of(path, **properties):
    reader = vtkFoamEvolverReader()
    reader.SetFileName(str(path))
    set_properties(reader, properties)
    return reader


def write(data, path):
    """Writes, and returns whether that went well and what was said."""
    writer = vtkFoamEvolverWriter()
    messages = Messages(writer)
    writer.SetFileName(str(path))
    writer.SetInputDataObject(data)
    return writer.Write(), messages.errors


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def assert_same(self, found, expected):
        self.assertEqual(found.GetNumberOfCells(), expected.GetNumberOfCells())
        for kind in ("CellData", "FieldData"):
            attributes = getattr(expected, "Get" + kind)()
            for i in range(attributes.GetNumberOfArrays()):
                name = attributes.GetArrayName(i)
                if name in ("Iterations", "Residual", "MaxAngleError", "MaxAreaError", "Converged", "T1Count"):
                    continue
                with self.subTest(name):
                    a, b = (column(getattr(data, "Get" + kind)(), name) for data in (found, expected))
                    if name in EXACT:
                        numpy.testing.assert_array_equal(a, b)
                    else:
                        numpy.testing.assert_allclose(a, b, rtol=0, atol=1e-12)

    def test_round_trip(self):
        for properties in ({}, {"periodic": True}, {"Boundary": vtkFoamFromPoints.Container}):
            source = foam_of_points(**properties)
            coarsen = coarsening_of(source, NumberOfFrames=3)
            films, bubbles = go_to(coarsen, 3)
            path = self.folder / "foam.fe"
            self.assertEqual(write(films, path), (1, []))
            reader = reader_of(path)
            messages = Messages(reader)
            reader.Update()
            self.assertEqual(messages.errors + messages.warnings, [])
            read = reader.GetOutput(0)
            self.assertLess(single(read, "ArcMisfit"), 1e-12)
            self.assertLess(single(read, "MaxAngleError"), 1e-8)
            for name in ("TimeStep", "GrowthConstant", "T1Length", "T2Area"):  # of a run, not of a foam
                films.GetFieldData().RemoveArray(name)
            self.assert_same(read, films)
            self.assert_same(reader.GetOutput(1), bubbles)

    def test_reads_and_relaxes(self):
        reader = reader_of(REFERENCE)
        reader.Update()
        self.assertAlmostEqual(single(reader.GetOutput(0), "Energy"), 206.296975169638, delta=1e-10)
        self.assertEqual(single(reader.GetOutput(0), "Converged"), 0)
        reader.SetEquilibrate(True)
        reader.Update()
        self.assertEqual(single(reader.GetOutput(0), "Converged"), 1)
        self.assertLess(single(reader.GetOutput(0), "Energy"), 190)
        coarsen = coarsening_of(reader, NumberOfFrames=2)
        self.assertEqual(single(go_to(coarsen, 2)[0], "Converged"), 1)

    def test_knows_files(self):
        self.assertTrue(vtkFoamEvolverReader.CanReadFile(str(REFERENCE)))
        self.assertFalse(vtkFoamEvolverReader.CanReadFile(str(DATA / "README.md")))
        self.assertFalse(vtkFoamEvolverReader.CanReadFile(str(self.folder)))

    def test_includes_lie_beside_the_file(self):
        (self.folder / "part").write_text(REFERENCE.read_text())
        (self.folder / "whole.fe").write_text('#include "part"\n')
        reader = reader_of(self.folder / "whole.fe")
        reader.Update()
        self.assertEqual(reader.GetOutput(1).GetNumberOfCells(), 100)

    def test_warnings_and_errors_name_file_and_line(self):
        path = self.folder / "foam.fe"
        text = REFERENCE.read_text()
        for damage, told in (("\nVERTICES", "\nhovering 3\nVERTICES"), (r"(\nEDGES\n.*)", r"\1 fixed")):
            path.write_text(re.sub(damage, told, text, count=1))
            reader = reader_of(path)
            messages = Messages(reader)
            reader.Update()
            found = messages.warnings if "hovering" in told else messages.errors
            self.assertEqual(len(found), 1)
            self.assertRegex(found[0], rf"{path}: line \d+: '(hovering|fixed)'")
            self.assertEqual(reader.GetOutput(1).GetNumberOfCells(), 100 if "hovering" in told else 0)
        for name in ("", self.folder / "none.fe", self.folder):
            reader = reader_of(name)
            messages = Messages(reader)
            reader.Update()
            self.assertEqual(len(messages.errors), 1, name)
            self.assertRegex(messages.errors[0], f"names no file|cannot read {name}")

    def test_what_cannot_be_written_is_told(self):
        points = vtkFoamPoints()
        for source, port, path, told in ((foam_of_points(), 1, "foam.fe", "the input has no films|bubbles"),
                                         (points, 0, "foam.fe", "the input has no films"),
                                         (foam_of_points(), 0, "", "names no file"),
                                         (foam_of_points(), 0, "none/foam.fe", "cannot write .*No such file")):
            source.Update()
            written, errors = write(source.GetOutputDataObject(port), path and self.folder / path)
            self.assertFalse(written)
            self.assertEqual(len(errors), 1)
            self.assertRegex(errors[0], told)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Films and bubbles are read to the last bit as each version of ParaView has written them, and by other programs, where
they are installed: PyVista and F3D."""

import os
import shutil
import subprocess
import tempfile
import unittest
from importlib.util import find_spec
from pathlib import Path

import numpy
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())
DATA = Path(__file__).resolve().parents[1] / "data"
IN_PYVISTA = """
import sys
import numpy, pyvista
data = pyvista.read(sys.argv[1])
arrays = {f"{kind}/{name}": found[name] for kind, found in
          (("Point", data.point_data), ("Cell", data.cell_data), ("Field", data.field_data)) for name in found.keys()}
arrays = {name: array for name, array in arrays.items() if numpy.asarray(array).dtype.kind in "fiu"}
numpy.savez(sys.argv[2], Points=data.points, **arrays)
"""


def tearDownModule():
    simple.Disconnect()


def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def arrays_of(data):
    """All arrays of numbers of a data set, by kind and name."""
    found = {"Points": vtk_to_numpy(data.GetPoints().GetData())}
    for kind in ("Point", "Cell", "Field"):
        of_kind = getattr(data, f"Get{kind}Data")()
        for i in range(of_kind.GetNumberOfArrays()):
            if of_kind.GetArray(i):
                found[f"{kind}/{of_kind.GetArrayName(i)}"] = vtk_to_numpy(of_kind.GetArray(i))
    return found


class Versions(unittest.TestCase):
    def test_films_are_the_same_whoever_has_written_them(self):
        original = arrays_of(read(DATA / "version-1/free.vtp"))
        files = sorted((DATA / "written-by").glob("*.vtp"))
        self.assertEqual([file.stem for file in files], ["paraview-5.11", "paraview-5.13", "paraview-6.1"])
        for file in files:
            with self.subTest(file.stem):
                found = arrays_of(read(file))
                for name, values in original.items():
                    numpy.testing.assert_array_equal(found[name], values, name)
                    self.assertEqual(found[name].dtype, values.dtype, name)


class OtherPrograms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=40), Boundary="Periodic")
        coarsen = FoamCoarsen(Input=foam, NumberOfFrames=5)
        coarsen.UpdatePipeline(coarsen.TimestepValues[-1])
        cls.written = {}
        for port, name in enumerate(("films", "bubbles")):
            writer = vtkXMLPolyDataWriter()
            writer.SetFileName(str(cls.folder / f"{name}.vtp"))
            writer.SetInputData(coarsen.GetClientSideObject().GetOutputDataObject(port))
            writer.Write()
            cls.written[name] = arrays_of(writer.GetInput())

    @unittest.skipUnless(find_spec("pyvista"), "PyVista is not installed")
    def test_pyvista_keeps_all_arrays(self):
        for name, written in self.written.items():
            result = self.folder / f"{name}.npz"
            subprocess.run(["python3", "-c", IN_PYVISTA, self.folder / f"{name}.vtp", result], check=True)
            found = numpy.load(result)
            for array, values in written.items():
                with self.subTest(name, array=array):
                    numpy.testing.assert_array_equal(numpy.squeeze(found[array]), numpy.squeeze(values))

    @unittest.skipUnless(shutil.which("f3d"), "F3D is not installed")
    def test_f3d_draws(self):
        for name in self.written:
            picture = self.folder / f"{name}.png"
            subprocess.run(["f3d", self.folder / f"{name}.vtp", f"--output={picture}", "--resolution=300,300"],
                           check=True, capture_output=True)
            reader = vtkPNGReader()
            reader.SetFileName(str(picture))
            reader.Update()
            colours = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
            self.assertGreater(len(numpy.unique(colours, axis=0)), 1, name)


if __name__ == "__main__":
    unittest.main()

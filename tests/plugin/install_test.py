# SPDX-License-Identifier: GPL-3.0-or-later
"""What is installed works where it is put: plugin, Python package, examples, samples."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

from paraview import servermanager

IN_PARAVIEW = """
from paraview.simple import *
foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=30))
FoamStatistics(Input=foam).UpdatePipeline()
print(foam.GetDataInformation(1).GetNumberOfCells(), "bubbles")
"""
IN_PYTHON = """
from foam.vtkFoamFilters import vtkFoamFromPoints, vtkFoamPoints
points = vtkFoamPoints()
points.SetNumberOfPoints(30)
foam = vtkFoamFromPoints()
foam.SetInputConnection(points.GetOutputPort())
foam.Update()
print(foam.GetOutput(1).GetNumberOfPolys(), "bubbles")
"""
IN_ANOTHER_VTK = """
from vtkmodules import vtkCommonCore
class vtkVersion:
    GetVTKMajorVersion = staticmethod(lambda: 8)
    GetVTKMinorVersion = staticmethod(lambda: 1)
vtkCommonCore.vtkVersion = vtkVersion
import foam
"""


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.prefix = Path(folder.name) / "prefix"
        subprocess.run([os.environ["FOAM_CMAKE"], "--install", os.environ["FOAM_BUILD"],
                        "--prefix", cls.prefix], check=True, stdout=subprocess.DEVNULL)

    def only(self, name):
        (found,) = self.prefix.rglob(name)
        return found

    def run_script(self, command, script, **environment):
        path = self.prefix / "script.py"
        path.write_text(script)
        return subprocess.run([*command, path], env={**os.environ, **environment},
                              capture_output=True, text=True, check=False)

    def test_plugin(self):
        done = self.run_script([os.environ["FOAM_PVPYTHON"], "--no-mpi"], IN_PARAVIEW,
                               PV_PLUGIN_PATH=str(self.only("Foam.so").parent), PYTHONPATH="")
        self.assertEqual(done.stdout.splitlines()[-1:], ["30 bubbles"], done.stderr)

    def test_python(self):
        package = self.only("foam/__init__.py").parent
        done = self.run_script([os.environ["FOAM_PYTHON"]], IN_PYTHON, PYTHONPATH=str(package.parent))
        self.assertEqual(done.stdout, "30 bubbles\n", done.stderr)

    def test_another_vtk(self):
        package = self.only("foam/__init__.py").parent
        done = self.run_script([os.environ["FOAM_PYTHON"]], IN_ANOTHER_VTK, PYTHONPATH=str(package.parent))
        self.assertNotEqual(done.returncode, 0)
        self.assertRegex(done.stderr, r"ImportError: foam is built for VTK 9\.\d+, but .* VTK 8\.1")

    def test_debian_package(self):
        """It has the plugin, and depends on the ParaView that this was built for."""
        packages = self.prefix.parent / "packages"
        build = os.environ["FOAM_BUILD"]
        subprocess.run([os.environ["FOAM_CPACK"], "-G", "DEB", "--config", f"{build}/CPackConfig.cmake",
                        "-B", packages], check=True, stdout=subprocess.DEVNULL)
        (package,) = packages.glob("*.deb")
        read = {option: subprocess.run(["dpkg-deb", option, package], check=True, capture_output=True,
                                       text=True).stdout for option in ("--contents", "--field")}
        self.assertIn("/plugins/Foam/Foam.so", read["--contents"])
        self.assertIn("/foam/vtkFoamFilters.so", read["--contents"])
        self.assertNotIn("/include/", read["--contents"])
        manager = servermanager.vtkSMProxyManager
        major, minor = manager.GetVersionMajor(), manager.GetVersionMinor()
        self.assertIn(f"paraview (>= {major}.{minor}), paraview (<< {major}.{minor + 1})", read["--field"])

    def test_files(self):
        for name in ("README.md", "copyright", "coarsen_real_foam.py", "real-foam-centroids.csv"):
            self.assertTrue(list(self.prefix.rglob(name)), name)


if __name__ == "__main__":
    unittest.main()

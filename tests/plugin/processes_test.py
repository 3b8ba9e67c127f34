# SPDX-License-Identifier: GPL-3.0-or-later
"""Several processes: under MPI and with a server the filters give the foam of one process, and give it once."""

import json
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

AS_ROOT = ["--allow-run-as-root"] if os.geteuid() == 0 else []
MPIEXEC = [os.environ["FOAM_MPIEXEC"], *AS_ROOT, "--oversubscribe", "-n", "2"]

SCRIPT = """
import builtins, json, os, sys
from paraview import servermanager
from paraview.simple import *

folder, port = sys.argv[1], int(sys.argv[2])
if port:
    Connect("localhost", port)
    LoadPlugin(os.environ["FOAM_PLUGIN"], remote=True, ns=globals())
LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())

foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=80), Boundary="Periodic")
coarsen = FoamCoarsen(Input=foam, NumberOfFrames=12)
statistics = FoamStatistics(Input=coarsen)
# Films whose cells several processes share, with those of a neighbour beside them to look at.
shared = ProgrammableSource(OutputDataSetType="vtkPolyData", Script=f'''
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkParallelCore import vtkMultiProcessController
reader = vtkXMLPolyDataReader()
reader.SetFileName("{folder}/films/films_0012.vtp")
reader.Update()
films, output = reader.GetOutput(), self.GetOutput()
controller = vtkMultiProcessController.GetGlobalController()
rank, processes = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
ghosts = vtkUnsignedCharArray()
ghosts.SetName("vtkGhostType")
output.DeepCopy(films)
output.BuildCells()
for i in range(films.GetNumberOfCells()):
    if i % 5 not in (0, 2) and i % processes != rank:
        output.DeleteCell(i)
    else:
        ghosts.InsertNextValue(0 if i % processes == rank else 1)
output.RemoveDeletedCells()
output.GetFieldData().DeepCopy(films.GetFieldData())
output.GetCellData().AddArray(ghosts)
''')
for name, proxy, port in (("films", coarsen, 0), ("bubbles", coarsen, 1), ("shared", shared, 0), ("sphere", Sphere(), 0)):
    SaveData(f"{folder}/{name}.pvd", proxy=OutputPort(proxy, port))
SaveData(f"{folder}/films.fe", proxy=OutputPort(coarsen, 0))
SaveData(f"{folder}/shared.fe", proxy=OutputPort(shared, 0))
evolver = FoamEvolverReader(FileName=f"{folder}/shared.fe")
evolver.UpdatePipeline()
again = {"evolver": evolver.GetDataInformation(0).GetNumberOfCells()}
for name in ("films", "shared", "sphere"):
    reader = PVDReader(FileName=f"{folder}/{name}.pvd")
    reader.UpdatePipeline(reader.TimestepValues[-1] if len(reader.TimestepValues) else 0)
    again[name] = reader.GetDataInformation().GetNumberOfCells()
last = FoamStatistics(Input=PVDReader(FileName=f"{folder}/shared.pvd"))
again["bubbles"] = servermanager.Fetch(last).GetValueByName(0, "Bubbles").ToInt()
runs = [FoamFromPoints(Input=FoamPoints(NumberOfPoints=40, Seed=seed)) for seed in (1, 2, 3)]
members = GroupDatasets(Input=runs, OutputType="vtkPartitionedDataSet")
ensemble = FoamEnsembleStatistics(Input=members)
pooled = servermanager.Fetch(ensemble)
for proxy in (coarsen, statistics):
    proxy.UpdatePipeline(coarsen.TimestepValues[-1])

def count(proxy, port):  # of all processes together
    data = proxy.GetDataInformation(port)
    return builtins.max(data.GetNumberOfCells(), data.GetNumberOfRows())  # a script has put NumPy's in its place

numbers = {"processes": servermanager.ActiveConnection.GetNumberOfDataPartitions(),
           "again": again, "counts": [count(coarsen, 0), count(coarsen, 1)] + [count(statistics, i) for i in range(4)],
           "pooled": [[pooled.GetValue(i, k).ToString() for k in range(pooled.GetNumberOfColumns())]
                      for i in range(pooled.GetNumberOfRows())]}
with open(f"{folder}/counts.json", "w") as file:
    json.dump(numbers, file)
"""


class Processes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.script = cls.folder / "script.py"
        cls.script.write_text(SCRIPT)
        cls.alone = cls.run_script("alone", os.environ["FOAM_PVPYTHON"], "--no-mpi")

    @classmethod
    def run_script(cls, name, *command, port=0):
        """What a run left: its files and the counts."""
        folder = cls.folder / name
        folder.mkdir()
        done = subprocess.run([*command, cls.script, folder, str(port)], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        # Several processes list what they share in another order, and ParaView writes a sphere in pieces.
        files = {path.relative_to(folder): path.read_bytes() for name in ("films", "bubbles")
                 for path in (folder / f"{name}.pvd", *(folder / name).iterdir())}
        files[Path("films.fe")] = (folder / "films.fe").read_bytes()
        return files, json.loads((folder / "counts.json").read_text())

    def check(self, found, processes):
        files, numbers = found
        expected_files, expected = self.alone
        self.assertEqual(numbers, {**expected, "processes": processes})
        self.assertEqual(files.keys(), expected_files.keys())
        self.assertEqual([name for name in files if files[name] != expected_files[name]], [])

    def test_one_process(self):
        files, numbers = self.alone
        self.assertEqual(len(files), 2 * 14 + 1)
        self.assertEqual(numbers["processes"], 1)
        self.assertEqual(numbers["again"], {"films": numbers["counts"][0], "shared": numbers["counts"][0], "sphere": 96,
                                            "evolver": numbers["counts"][0], "bubbles": numbers["counts"][1]})
        films, bubbles, summary, _, rows, _ = numbers["counts"]
        self.assertIn(["Mu2", "0", "3"], [row[:3] for row in numbers["pooled"]])
        self.assertEqual((films, summary, rows), (3 * bubbles, 1, bubbles))  # Euler's formula on the torus

    def test_two_processes(self):
        self.check(self.run_script("batch", *MPIEXEC, os.environ["FOAM_PVBATCH"]), 2)

    def test_server_of_two_processes(self):
        with subprocess.Popen([*MPIEXEC, os.environ["FOAM_PVSERVER"], "--server-port=0"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as server:
            try:
                found = (re.search(r"Accepting connection.*:(\d+)", line) for line in server.stdout)
                port = next(match.group(1) for match in found if match)
                self.check(self.run_script("server", os.environ["FOAM_PVPYTHON"], port=port), 2)
                self.assertEqual(server.wait(30), 0)
            finally:
                server.kill()


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the pages' blocks of Python, and compares the arrays that the pages list with those that come out."""

import os
import re
import tempfile
import unittest
from pathlib import Path

from paraview.simple import *

ROOT = Path(__file__).resolve().parent.parent.parent
LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())


def tearDownModule():
    Disconnect()


def page_of(proxy):
    return (ROOT / f"docs/proxies/{proxy}.md").read_text()


def run_blocks(proxy, names):
    """A page's blocks, with few bubbles."""
    for block in re.findall(r"^```python\n(.*?)^```", page_of(proxy), re.MULTILINE | re.DOTALL):
        exec(re.sub(r"NumberOfPoints=\d+", "NumberOfPoints=60", block), names)


def listed(proxy, heading, kind, sometimes=False):
    """The arrays of a kind that a page lists below a heading, those that are always there or those that are not."""
    section = re.search(rf"^## {heading}.*?\n(.*?)(?=^## |\Z)", page_of(proxy), re.MULTILINE | re.DOTALL)[1]
    rows = re.search(rf"^\| {kind} .*?\n\|[-|]+\n((?:\|.*\n)+)", section, re.MULTILINE)[1]
    return [name for row in rows.splitlines() if ("only where" in row) == sometimes
            for name in re.findall(r"`(\w+)`", row.split("|")[1])]


def names_of(attributes):
    return [attributes.GetAbstractArray(i).GetName() for i in range(attributes.GetNumberOfArrays())]


class Outputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.names = dict(globals())
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.addClassCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        for proxy in ("FoamPoints", "FoamFromPoints", "FoamCoarsen", "FoamStatistics", "FoamSeriesWriter"):
            run_blocks(proxy, cls.names)
        run_blocks("FoamEvolverWriter", cls.names)
        run_blocks("FoamEvolverReader", cls.names)  # of the file that the writer's page has made
        cls.names["films"] = [cls.names["foam"], FoamFromPoints(Input=FoamPoints(NumberOfPoints=60, Seed=2))]
        run_blocks("FoamEnsembleStatistics", cls.names)

    def output(self, name, port=0):
        self.names[name].UpdatePipeline()
        return self.names[name].GetClientSideObject().GetOutputDataObject(port)

    def check(self, proxy, heading, kind, attributes, *more):
        with self.subTest(proxy, heading=heading, kind=kind):
            self.assertEqual(sorted([*listed(proxy, heading, kind), *more]), sorted(names_of(attributes)))

    def test_films_and_bubbles(self):
        for maker, more in (("foam", []), ("coarsen", ["TimeStep", "GrowthConstant", "T1Length", "T2Area"])):
            films, bubbles = self.output(maker), self.output(maker, 1)
            self.assertGreater(films.GetNumberOfCells(), 0)
            self.check("FoamFromPoints", "Output 0: films", "cell array", films.GetCellData())
            self.check("FoamFromPoints", "Output 0: films", "point array", films.GetPointData())
            self.check("FoamFromPoints", "Output 0: films", "field array", films.GetFieldData(), *more)
            self.check("FoamFromPoints", "Output 1: bubbles", "cell array", bubbles.GetCellData())

    def test_events(self):
        deform = FoamDeform(Input=FoamFromPoints(Input=FoamPoints(NumberOfPoints=30), Boundary="Periodic"))
        self.names.update(deform=deform)
        for maker in ("coarsen", "deform"):
            self.check("FoamCoarsen", "Output 2: events", "point array", self.output(maker, 2).GetPointData())

    def test_arrays_that_are_there_sometimes(self):
        points = FoamPoints(NumberOfPoints=60)
        torus = FoamFromPoints(Input=points, Boundary="Periodic", PeriodVectors=[8, 0, 2, 7.5])
        tensions = Calculator(Input=FoamFromPoints(Input=points), AttributeType="Cell Data",
                              ResultArrayName="FilmTension", Function="0.5 + 0.001*LeftBubble")
        pressure = ProgrammableFilter(Input=tensions, CopyArrays=True, Script="""
array = vtk.vtkDoubleArray()
array.SetName("OutsidePressure")
array.InsertNextValue(0.1)
output.GetFieldData().AddArray(array)""")
        self.names.update(torus=torus, own=FoamCoarsen(Input=pressure, NumberOfFrames=1))
        self.names.update(walled=FoamFromPoints(Input=points, Boundary="Container"))
        sheared = FoamDeform(Input=torus, NumberOfFrames=1)
        sheared.UpdatePipeline(0.01)
        own, skewed, walled = self.output("own"), self.output("torus"), self.output("walled")
        sheared = sheared.GetClientSideObject().GetOutputDataObject(0)
        few = FoamCoarsen(Input=FoamFromPoints(Input=FoamPoints(NumberOfPoints=4)), TimeStep=100, NumberOfFrames=1)
        few.UpdatePipeline(100)
        ended = few.GetClientSideObject().GetOutputDataObject(0)
        for kind, found in (("cell array", {*names_of(own.GetCellData()), *names_of(walled.GetCellData())}),
                            ("field array", {*names_of(own.GetFieldData()), *names_of(skewed.GetFieldData()), *names_of(walled.GetFieldData()),
                                             *names_of(ended.GetFieldData()), *names_of(sheared.GetFieldData())})):
            page = "FoamFromPoints", "Output 0: films", kind
            self.assertEqual(found - set(listed(*page)), set(listed(*page, sometimes=True)))

    def test_points(self):
        points = self.output("points")
        self.assertEqual(points.GetNumberOfPoints(), 60)
        self.assertEqual(names_of(points.GetPointData()), [])

    def test_statistics(self):
        for port, heading in enumerate(("Summary", "BySides", "Bubbles", "Distribution")):
            table = self.output("statistics", port)
            self.assertGreater(table.GetNumberOfRows(), 0)
            self.check("FoamStatistics", f"Output {port}: {heading}", "column", table.GetRowData())

    def test_ensemble(self):
        self.check("FoamEnsembleStatistics", "Output", "column", self.output("ensemble").GetRowData())

    def test_series(self):
        written = Path("films.pvd").read_text()
        self.assertEqual(written.count("films/films_"), len(list(Path("films").glob("films_*.vtp"))))
        self.assertEqual(written.count("films/films_"), len(self.names["coarsen"].TimestepValues))


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The thesis's experiments in miniature: the page, its figures and its numbers, and what measures them."""

import csv
import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy
from PIL import Image
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

EXAMPLES = Path(os.environ["FOAM_EXAMPLES"])
sys.path.append(str(EXAMPLES))
from thesis_experiments import experiments, measures, published, scale
from thesis_experiments.foams import Coarsening, Source, field_value, newton


def run(*arguments):
    return subprocess.run([os.environ["FOAM_PVPYTHON"], "--no-mpi", str(EXAMPLES / "thesis.py"), *arguments],
                          capture_output=True, text=True, check=False)


def rows_of(path):
    with open(path, newline="") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.process = run("--quick", "--output", folder.name)
        assert cls.process.returncode == 0, cls.process.stderr
        cls.page = (cls.folder / "thesis.md").read_text()

    def table_row(self, section, name):
        """The cells of a row of the first table in a section."""
        text = self.page.split(f"\n## {section}", 1)[1].split("\n## ", 1)[0]
        row = next(line for line in text.splitlines() if line.startswith(f"| {name} |"))
        return [cell.strip() for cell in row.strip("|").split("|")][1:]

    def test_every_section_is_there(self):
        titles = [experiment.title for experiment in experiments.ALL]
        self.assertEqual(re.findall(r"^## (.*?)(?: \(thesis .*\))?$", self.page, re.MULTILINE)[1:], titles)

    def test_figures(self):
        figures = re.findall(r"!\[.*?\]\((.*?)\)", self.page)
        self.assertGreater(len(figures), 4 * len(experiments.EVOLUTIONS))
        for name in figures:
            with Image.open(self.folder / name) as picture:
                self.assertGreater(picture.width, 1000, name)
                colours = numpy.asarray(picture.convert("RGB")).reshape(-1, 3)
                self.assertGreater(len(numpy.unique(colours, axis=0)), 20, name)

    def test_numbers_are_those_of_the_results(self):
        for experiment in experiments.EVOLUTIONS:
            last = [rows_of(self.folder / experiment.name / f"{name}.csv")[-1] for name in ("thesis", "newton")]
            for title, column in (("bubbles left in the last frame", "Bubbles"), ("T1s", "T1Count"),
                                  ("T2s", "T2Count"), ("last frame", "Frame")):
                with self.subTest(experiment=experiment.name, title=title):
                    self.assertEqual(self.table_row(experiment.title, title)[1:],
                                     [f"{row[column]:.0f}" for row in last])

    def test_gas_is_what_von_neumanns_law_leaves(self):
        """A free foam loses K(6 + n) a second for n bubbles on its boundary."""
        rows = rows_of(self.folder / "small" / "newton.csv")
        for before, after in zip(rows, rows[1:]):
            if after["T2Count"] == before["T2Count"] and after["T1Count"] == before["T1Count"]:
                on_boundary = before["Bubbles"] - before["BulkBubbles"]
                loss = scale.diffusion_constant() * (6 + on_boundary) * (after["Time"] - before["Time"])
                self.assertAlmostEqual(before["Gas"] - after["Gas"], loss, delta=1e-9 * before["Gas"])

    def test_sweeps(self):
        rows = rows_of(self.folder / "sweeps" / "foams.csv")
        title = experiments.SWEEPS.title
        cells = self.table_row(title, "mean")
        for column, name in ((1, "GaussSeidel"), (3, "Jacobi"), (4, "Newton")):
            mean = numpy.mean([row[f"{name}Iterations"] for row in rows])
            self.assertAlmostEqual(float(cells[column]), mean, delta=5e-3 * mean)
        self.assertEqual([cells[0], cells[2]], ["26.9077", "23.1105"])  # the thesis's

    def test_what_is_missing_is_named(self):
        for run_of in experiments.DISTANCE.runs:
            label = run_of.method.label
            frames = self.folder / "distance" / f"{run_of.name}.csv"
            there = frames.exists() and rows_of(frames)
            self.assertIn(f"| {label} |" if there else f"*{label}* is missing: ", self.page)

    def test_the_page_alone(self):
        page = self.folder / "again" / "page.md"
        self.assertEqual(run("--page", str(page), "--output", str(self.folder)).returncode, 0)
        self.assertEqual(page.read_text().replace("(page/", "(thesis/"), self.page)

    def test_bad_arguments(self):
        for arguments, words in ((["--only", "nonsense"], "nonsense"), (["--budget", "0"], "--budget")):
            process = run(*arguments, "--output", str(self.folder / "nothing"))
            self.assertNotEqual(process.returncode, 0)
            self.assertIn(words, process.stderr)
            self.assertFalse((self.folder / "nothing").exists())


class Scale(unittest.TestCase):
    def test_spacing(self):
        """Worked out by hand: 0.93 · (2π/3 · 0.25) · 2000 s = 973.9 cm², over 20906/413 − 1 = 49.62."""
        self.assertAlmostEqual(scale.spacing_of("6.1.2"), 4.430, delta=1e-3)

    def test_published_numbers_say_where_they_stand(self):
        for experiment in experiments.ALL:
            if experiment.section in ("4.3", "6.4"):
                continue  # compared with nothing in the thesis
            self.assertRegex(published.where(experiment.section), "Section|Figure|Appendix")


def polyline_films(*lines):
    """Polylines as a filter has them."""
    films, points, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    for line in lines:
        cells.InsertNextCell(len(line))
        for x, y in line:
            cells.InsertCellPoint(points.InsertNextPoint(x, y, 0))
    films.SetPoints(points)
    films.SetLines(cells)
    return films


class Measures(unittest.TestCase):
    def frame(self, method, steps=0):
        coarsening = Coarsening(Source(40, method), method, 1 / 30, steps or 1)
        coarsening.go_to(steps)
        return coarsening

    def test_angle_errors_are_the_filters(self):
        for method in (newton(), experiments.ENERGY_DECAY):
            films = self.frame(method, 3).films
            self.assertAlmostEqual(measures.angle_errors(films).max(), field_value(films, "MaxAngleError"), delta=1e-12)

    def test_area_errors_are_the_filters(self):
        coarsening = self.frame(experiments.ENERGY_DECAY, 3)
        self.assertAlmostEqual(measures.area_errors(coarsening.bubbles).max(),
                               field_value(coarsening.films, "MaxAreaError"), delta=1e-12)

    def test_inverted_junctions(self):
        films = self.frame(newton()).films
        self.assertEqual(measures.inverted_junctions(films), 0)
        # Seen in a mirror every junction is inverted, arcs and all.
        for i in range(films.GetNumberOfPoints()):
            x, y, z = films.GetPoint(i)
            films.GetPoints().SetPoint(i, -x, y, z)
        half_angle = films.GetCellData().GetArray("HalfAngle")
        for i in range(half_angle.GetNumberOfTuples()):
            half_angle.SetValue(i, -half_angle.GetValue(i))
        self.assertEqual(measures.inverted_junctions(films), len(measures.angle_errors(films)))

    def test_crossing_films(self):
        self.assertEqual(measures.crossing_films(self.frame(newton()).films), 0)
        across = [(0, 0), (2, 2)], [(0, 2), (2, 0)]
        meeting = [(2, 2), (3, 2), (4, 1)], [(4, 1), (5, 5)]
        self.assertEqual(measures.crossing_films(polyline_films(*across, *meeting)), 1)
        through_all = [(0, 1.5), (6, 1.5)]  # not the corner (4, 1)
        self.assertEqual(measures.crossing_films(polyline_films(*across, *meeting, through_all)), 5)

    def test_excess_energy(self):
        equilibrium = self.frame(newton())
        for excess in measures.excess_energy(equilibrium.films, equilibrium.bubbles).values():
            self.assertAlmostEqual(excess, 0, delta=1e-10)
        thesis = self.frame(experiments.ENERGY_DECAY)
        excess = measures.excess_energy(thesis.films, thesis.bubbles)
        # At given areas an equilibrium has the least energy, and the work is right to first order.
        self.assertGreater(excess["ExcessAtTargets"], 1e-4)
        self.assertLess(excess["ExcessAtTargets"], 0.05)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples to be copied, in a quick form, and what they leave."""

import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy
from paraview import simple
from PIL import Image
from scipy.spatial import cKDTree
from skimage import measure
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from foam.vtkFoamFilters import vtkFoamCoarsen, vtkFoamFromPoints, vtkFoamPoints

EXAMPLES = Path(os.environ["FOAM_EXAMPLES"])
sys.path.insert(0, str(EXAMPLES))
import foam_in_picture
DATA = Path(os.environ["FOAM_TEST_DATA"])


def run(name, *arguments):
    return subprocess.run([os.environ["FOAM_PVPYTHON"], "--no-mpi", str(EXAMPLES / name), *map(str, arguments)],
                          capture_output=True, text=True, check=False)


def rows_of(path):
    with open(path, newline="") as file:
        return [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]


def films_of(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def foam_of(count, **properties):
    """The films of a foam of random points, as the filter that makes them."""
    points, foam = vtkFoamPoints(), vtkFoamFromPoints()
    points.SetNumberOfPoints(count)
    foam.SetInputConnection(points.GetOutputPort())
    for name, value in properties.items():
        getattr(foam, "Set" + name)(value)
    return foam


class Example(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_example(self, name, *arguments):
        process = run(name, *arguments, "--output", self.folder)
        self.assertEqual(process.returncode, 0, process.stderr)
        warnings = [line for line in process.stderr.splitlines() if "WARN" in line]
        self.assertEqual([line for line in warnings if "Frame 0, time 0 s, is not" not in line], [])  # made by hand
        return process.stdout


class Short(unittest.TestCase):
    def test_examples_are_short_enough_to_be_read(self):
        for name in ("film", "continue_run", "clusters", "parameter_study", "foam_from_picture", "ensemble",
                     "foam_in_channel", "foam_in_outline", "shear", "shear_and_coarsen"):
            self.assertLessEqual(len((EXAMPLES / f"{name}.py").read_text().splitlines()), 60, name)


class Containers(Example):
    def test_channel_becomes_bamboo(self):
        words = self.run_example("foam_in_channel.py", "--bubbles", 24, "--length", 12, "--width", 0.8)
        self.assertIn("two films and two walls", words)
        with open(self.folder / "channel.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertLess(int(rows[0]["Bamboo"]), int(rows[0]["Bubbles"]))
        self.assertEqual(rows[-1]["Bamboo"], rows[-1]["Bubbles"])
        self.assertLess(float(rows[-1]["Energy"]), float(rows[0]["Energy"]))

    def test_outline(self):
        self.assertIn(" bubbles in ", self.run_example("foam_in_outline.py", "--bubbles", 120))
        films = films_of(self.folder / "outline.vtp")
        self.assertEqual(films.GetFieldData().GetArray("Converged").GetValue(0), 1)


class FilmAndContinue(Example):
    def series(self):
        frames = ElementTree.parse(self.folder / "films.pvd").findall("./Collection/DataSet")
        return [float(f.get("timestep")) for f in frames], [self.folder / f.get("file") for f in frames]

    def test_a_continued_run_is_as_one_that_did_not_stop(self):
        """From a keyframe it has the same bits."""
        words = self.run_example("film.py", "--bubbles", 40, "--frames", 10)
        self.assertIn("40 bubbles at first", words)
        self.assertEqual((self.folder / "film.ogv").read_bytes()[:4], b"OggS")
        with Image.open(self.folder / "last.png") as picture:
            colours = numpy.unique(numpy.asarray(picture.convert("RGB")).reshape(-1, 3), axis=0)
            self.assertGreater(len(colours), 20)
        times, _ = self.series()
        self.assertEqual(len(times), 11)

        self.run_example("continue_run.py", "--frames", 5)
        times, files = self.series()
        coarsen = vtkFoamCoarsen()
        foam = foam_of(40)
        coarsen.SetInputConnection(foam.GetOutputPort())
        coarsen.SetNumberOfFrames(15)
        self.assertEqual(len(times), 16)
        for time, file in zip(times, files):
            coarsen.UpdateTimeStep(time)
            expected, found = coarsen.GetOutput(0), films_of(file)
            for name in ("HalfAngle", "Length"):
                self.assertEqual(*(vtk_to_numpy(films.GetCellData().GetArray(name)).tobytes()
                                   for films in (expected, found)), (time, name))

    def test_nothing_to_continue(self):
        process = run("continue_run.py", "--output", self.folder)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn("films.pvd", process.stderr)


class Clusters(Example):
    def test_lengths_are_the_exact_ones(self):
        self.run_example("clusters.py")
        with open(DATA / "free_clusters_unit_area.csv", newline="") as file:
            exact = {row["N"]: row["P_line_tension_1"] for row in csv.DictReader(file)}
        rows = rows_of(self.folder / "clusters.csv")
        self.assertEqual([row["Bubbles"] for row in rows], [2, 3, 4, 5, 6, 7])
        for row in rows:
            self.assertAlmostEqual(row["Length"], float(exact[f"{row['Bubbles']:.0f}"]), delta=1e-8)


class Ensemble(Example):
    def test_two_processes_share_the_seeds_and_pool_them(self):
        arguments = ["--seeds", 5, "--bubbles", 40, "--frames", 6, "--output"]
        as_root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
        tables = []
        for count in ("1", "2"):
            folder = self.folder / count
            command = [os.environ["FOAM_MPIEXEC"], *as_root, "--oversubscribe", "-n", count, os.environ["FOAM_PVBATCH"],
                       "--symmetric", EXAMPLES / "ensemble.py", *arguments, folder]
            done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            tables.append((folder / "ensemble.csv").read_text())
        self.assertIn("Process 0: seeds [1, 3, 5]", done.stdout)
        self.assertIn("Process 1: seeds [2, 4]", done.stdout)
        self.assertEqual(*tables)

        rows = list(csv.DictReader(tables[0].splitlines()))
        foams = {row["Quantity"]: row for row in rows if row["Sides"] == "0"}
        self.assertEqual({row["Members"] for row in foams.values()}, {"5"})
        self.assertAlmostEqual(float(foams["MeanSides"]["Mean"]), 6, places=12)
        self.assertAlmostEqual(sum(float(row["Mean"]) for row in rows if row["Quantity"] == "Fraction"), 1, places=12)
        # On a torus Σ(n − 6)² p(n) is the same of the means as the mean of μ₂.
        mu2 = sum((int(row["Sides"]) - 6)**2 * float(row["Mean"]) for row in rows if row["Quantity"] == "Fraction")
        self.assertAlmostEqual(float(foams["Mu2"]["Mean"]), mu2, places=12)
        self.assertGreater(float(foams["GrowthRate"]["Mean"]), 0)


class Shear(Example):
    def test_energy_is_the_work_that_was_done(self):
        words = self.run_example("shear.py", "--bubbles", 30, "--strain", 0.4, "--step", 0.02)
        self.assertIn("modulus", words)
        rows = rows_of(self.folder / "shear.csv")
        self.assertEqual(len(rows), 21)
        area, quiet = rows[0]["MeanArea"] * 30, 0
        for before, after in zip(rows, rows[1:]):
            if before["T1Count"] == after["T1Count"]:
                quiet += 1
                work = area * (before["StressXY"] + after["StressXY"]) / 2 * (after["Strain"] - before["Strain"])
                self.assertAlmostEqual((after["Energy"] - before["Energy"]) / work, 1, 2)
        self.assertGreater(quiet, 8)
        for name in ("stress.png", "foam.png"):
            with Image.open(self.folder / name) as picture:
                self.assertGreater(len(set(picture.convert("RGB").resize((60, 60)).getdata())), 50)


    def test_and_coarsening_in_turns(self):
        words = self.run_example("shear_and_coarsen.py", "--rates", 0, 1, "--bubbles", 40, "--frames", 6, "--runs", 2)
        self.assertEqual(words.count("T1s a bubble"), 2)
        rows = rows_of(self.folder / "growth.csv")
        still, sheared = ([row["MeanArea"] for row in rows if row["Rate"] == rate] for rate in (0, 1))
        self.assertEqual((still[0], sheared[0]), (1, 1))
        for areas in (still, sheared):  # bubbles vanish, and none is made
            self.assertEqual(areas, sorted(areas))
            self.assertGreater(areas[-1], 1.5)
        self.assertNotEqual(still, sheared)


class ParameterStudy(Example):
    def test_figures_are_those_of_the_foams(self):
        self.run_example("parameter_study.py", "--jitter", 0.3, 0.9, "--bubbles", 60, "--frames", 3)
        rows = rows_of(self.folder / "study.csv")
        self.assertEqual([row["Jitter"] for row in rows], 4 * [0.3] + 4 * [0.9])
        with Image.open(self.folder / "area_moments.png") as picture:
            self.assertGreater(picture.width, 900)
        self.assertLess(rows[0]["AreaSecondMoment"], rows[4]["AreaSecondMoment"])
        for first, *later in (rows[:4], rows[4:]):
            for row in later:  # nothing leaves a torus, and its Euler characteristic makes the mean six
                self.assertAlmostEqual(row["MeanArea"] * row["Bubbles"], first["MeanArea"] * first["Bubbles"], places=6)
                self.assertAlmostEqual(row["MeanSides"], 6, places=12)


def shapes(bubbles):
    """Centroid (cm) and area (cm²) of each bubble, from its outline."""
    found = []
    for i in range(bubbles.GetNumberOfCells()):
        ids = bubbles.GetCell(i).GetPointIds()
        x, y = vtk_to_numpy(bubbles.GetPoints().GetData())[[ids.GetId(k) for k in range(ids.GetNumberOfIds())], :2].T
        cross = x * numpy.roll(y, -1) - numpy.roll(x, -1) * y
        moments = [((c + numpy.roll(c, -1)) * cross).sum() / 3 for c in (x, y)]
        found.append((*(moment / cross.sum() for moment in moments), cross.sum() / 2))
    return numpy.array(found)


def neighbours(films):
    """Pairs of bubbles on the two sides of a film."""
    sides = zip(*(vtk_to_numpy(films.GetCellData().GetArray(f"{side}Bubble")) for side in ("Left", "Right")))
    return {tuple(sorted(pair)) for pair in sides if min(pair) >= 0}


class Picture(Example):
    """A foam is drawn, and the picture becomes a foam: is it the same, bubble by bubble?"""

    PIXELS = 40  # per cm

    def draw(self, films):
        """Films in ink on white; returns where the lower left corner is."""
        bounds = numpy.array(films.GetBounds()[:4]).reshape(2, 2)
        size = numpy.ceil((bounds[:, 1] - bounds[:, 0] + 1) * self.PIXELS).astype(int)
        centre = bounds.mean(axis=1)
        view = simple.CreateRenderView(ViewSize=list(size), InteractionMode="2D", OrientationAxesVisibility=0,
                                       UseColorPaletteForBackground=0, Background=[1, 1, 1],
                                       CameraPosition=[*centre, 10], CameraFocalPoint=[*centre, 0],
                                       CameraParallelScale=size[1] / self.PIXELS / 2)
        source = simple.TrivialProducer()
        source.GetClientSideObject().SetOutput(films)
        simple.Show(source, view, ColorArrayName=[None, ""], AmbientColor=[0, 0, 0], Ambient=1, Diffuse=0, LineWidth=2)
        simple.SaveScreenshot(str(self.folder / "foam.png"), view)
        self.addCleanup(simple.ResetSession)
        return centre - size / self.PIXELS / 2

    def test_round_trip(self):
        points_to_foam = foam_of(60)
        coarsen = vtkFoamCoarsen()
        coarsen.SetInputConnection(points_to_foam.GetOutputPort())
        coarsen.UpdateTimeStep(0.3)  # when none is too small to be seen
        films, drawn = coarsen.GetOutput(0), shapes(coarsen.GetOutput(1))
        corner = self.draw(films)
        self.run_example("foam_from_picture.py", "--picture", self.folder / "foam.png")

        # What was measured in the picture is what was drawn: centroids to half a pixel, areas to the films' width.
        seen = numpy.array([list(row.values()) for row in rows_of(self.folder / "bubbles.csv")])
        scale = numpy.sqrt(seen[:, 2].mean()) / self.PIXELS
        seen = seen / [self.PIXELS, self.PIXELS, self.PIXELS**2] + [*corner, 0]
        self.assertEqual(len(seen), len(drawn))
        distance = numpy.hypot(*(drawn[:, None, :2] - seen[None, :, :2]).transpose(2, 0, 1))
        nearest = distance.argmin(axis=1)
        self.assertEqual(len(set(nearest)), len(drawn))
        self.assertLess(distance.min(axis=1).max(), 0.5 / self.PIXELS)
        numpy.testing.assert_allclose(seen[nearest, 2], drawn[:, 2], rtol=0.05)

        # The foam that comes of it is the foam that was drawn: neighbours, centroids, areas.
        again = films_of(self.folder / "films.vtp")
        number = dict(zip(vtk_to_numpy(films.GetFieldData().GetArray("BubbleId")), nearest))
        self.assertEqual(neighbours(again), {tuple(sorted((number[a], number[b]))) for a, b in neighbours(films)})
        coarsen = vtkFoamCoarsen()
        coarsen.SetInputData(again)
        coarsen.Update()
        made = shapes(coarsen.GetOutput(1)) * [scale, scale, scale**2] + [*corner, 0]
        numpy.testing.assert_allclose(made[nearest], drawn, atol=0.03)

    def test_what_is_no_picture_of_films_is_refused(self):
        foam = foam_of(60)
        foam.Update()
        self.draw(foam.GetOutput(0))
        with Image.open(self.folder / "foam.png") as picture:
            dark = numpy.asarray(picture.convert("L"))
        labels = measure.label(dark > 128, connectivity=1)
        random = numpy.random.default_rng(1)
        for name, pixels, words in (("blank", 0 * dark + 200, "blank"), ("black", 0 * dark, "blank"),
                                    ("labels", labels.astype(numpy.uint8), "numbered"),
                                    ("labels16", labels.astype(numpy.uint16), "numbered"),
                                    ("regions", random.permutation(256)[labels].astype(numpy.uint8), "numbered"),
                                    ("cut", dark[:20, :20], "20 x 20 pixels")):
            path = self.folder / f"{name}.png"
            Image.fromarray(pixels).save(path)
            with self.subTest(name=name), self.assertRaises(SystemExit) as refused:
                foam_in_picture.read_picture(path, 0, 0, 0, 0)
            self.assertIn(words, str(refused.exception))
            self.assertIn(f"{name}.png", str(refused.exception))
        with self.assertRaises(SystemExit) as refused:
            foam_in_picture.films_in(random.uniform(size=dark.shape))
        self.assertIn("no films that hang together", str(refused.exception))
        self.assertEqual(foam_in_picture.read_picture(self.folder / "foam.png", 0, 0, 0, 0).shape, dark.shape)
        process = run("foam_from_picture.py", "--picture", self.folder / "blank.png", "--output", self.folder)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn("blank", process.stderr)
        self.assertNotIn("Traceback", process.stderr)

    def test_no_picture_at_all(self):
        path = self.folder / "text.png"
        path.write_text("no picture")
        with self.assertRaises(SystemExit) as refused:
            foam_in_picture.read_picture(path, 0, 0, 0, 0)
        self.assertIn("text.png", str(refused.exception))

    def test_no_picture(self):
        process = run("foam_from_picture.py", "--picture", self.folder / "none.png", "--output", self.folder)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn("none.png", process.stderr)
        self.assertNotIn("Traceback", process.stderr)


class Polarity(unittest.TestCase):
    """Films of any width, dark or bright, with a border round the foam or without: the same bubbles."""

    PIXELS = 50  # per cm

    @classmethod
    def setUpClass(cls):
        coarsen = vtkFoamCoarsen()
        foam = foam_of(60)
        coarsen.SetInputConnection(foam.GetOutputPort())
        coarsen.SetChordError(1e-4)
        coarsen.UpdateTimeStep(0.3)
        films, cls.bubbles = coarsen.GetOutput(0), shapes(coarsen.GetOutput(1))
        cls.bounds = numpy.array(films.GetBounds()[:4]).reshape(2, 2)
        places = vtk_to_numpy(films.GetPoints().GetData())[:, :2]
        lines = []
        for i in range(films.GetNumberOfLines()):
            ids = films.GetCell(i).GetPointIds()
            lines.append(places[[ids.GetId(k) for k in range(ids.GetNumberOfIds())]])
        ink = [a + (b - a) * numpy.linspace(0, 1, 2 + int(4 * cls.PIXELS * math.dist(a, b)))[:, None]
               for line in lines for a, b in zip(line, line[1:])]
        cls.ink = cKDTree(numpy.vstack(ink))

    def look_at(self, growth):
        """Of the foam's bounds, grown (cm): each pixel's distance from films, and of each bubble the centroid and how
        far that is from films and from the picture's edge, all in pixels."""
        (left, right), (bottom, top) = self.bounds + [-growth, growth]
        x, y = (numpy.arange(a, b, 1 / self.PIXELS) + 0.5 / self.PIXELS for a, b in ((left, right), (bottom, top)))
        distance, _ = self.ink.query(numpy.stack(numpy.meshgrid(x, y), axis=-1))
        places = (self.bubbles[:, :2] - [left, bottom]) * self.PIXELS
        inner, _ = self.ink.query(self.bubbles[:, :2])
        edge = numpy.minimum(places, distance.shape[::-1] - places).min(axis=1)
        return distance * self.PIXELS, places, inner * self.PIXELS, edge

    def test_any_films(self):
        random = numpy.random.default_rng(5)
        for growth in (0.5, -1):
            distance, places, inner, edge = self.look_at(growth)
            for width in (1, 4, 10, 20):
                dark = numpy.clip(distance - width / 2 + 0.5, 0, 1)
                dark = numpy.clip(dark + random.normal(0, 0.1, dark.shape), 0, 1)
                found = []
                for picture in (dark, 1 - dark):
                    labels = foam_in_picture.bubbles_in(picture)
                    found.append([(r.centroid[1] + 0.5, r.centroid[0] + 0.5) for r in measure.regionprops(labels)])
                with self.subTest(growth=growth, width=width):
                    self.assertEqual(len(found[0]), len(found[1]))
                    self.assertLess(cKDTree(found[0]).query(found[1])[0].max(), 0.1)
                    # Each is one that was drawn, and all are found that are to be seen, and not cut off.
                    off, which = cKDTree(places).query(found[0])
                    self.assertLess(off.max(), 3)
                    seen = numpy.flatnonzero((inner > width / 2 + 3) & (edge > self.PIXELS))
                    self.assertLessEqual(set(seen), set(which))
                    self.assertGreater(len(seen), 5)


def tearDownModule():
    simple.Disconnect()  # closes the view before Python ends


if __name__ == "__main__":
    unittest.main()

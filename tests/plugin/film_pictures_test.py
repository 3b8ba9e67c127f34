# SPDX-License-Identifier: GPL-3.0-or-later
"""The representation Foam Films, measured in its pictures."""

import math
import os
import sys
import tempfile
import unittest
from pathlib import Path

import matplotlib.image
import numpy as np
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import vtkIdList
sys.path.insert(0, str(Path(__file__).parent))
from pictures import (Messages, add_cell_arrays, arc_length, darkness, distance_to_arc, picture, pixel_centres, pixel_size,
                      polylines, show, source_of, view_of)

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())

ROOT3 = math.sqrt(3)
# Arcs of 30°, 90°, 180° and 240° and a straight line, far enough apart not to touch.
ARCS = [((-1.2, -1.2), (1.2, -1.2), math.radians(15)), ((-1.2, -0.6), (0, -0.6), math.radians(45)),
        ((0.2, -0.3), (1.2, 0.1), math.radians(90)), ((-0.8, 0.3), (-0.5, 0.5), math.radians(-120)),
        ((-1.2, 1.3), (1.2, 1.1), 0.0)]
# Two bubbles of radius 1 with a straight film between them; films meet at 120°.
DOUBLE_BUBBLE = [((0, -ROOT3 / 2), (0, ROOT3 / 2), math.radians(120)),
                 ((0, -ROOT3 / 2), (0, ROOT3 / 2), math.radians(-120)),
                 ((0, ROOT3 / 2), (0, -ROOT3 / 2), 0.0)]


def distance_to(view, arcs):
    """Distance of each pixel from the nearest of arcs, in pixels."""
    x, y = pixel_centres(view)
    return np.min([distance_to_arc(x, y, *arc) for arc in arcs], axis=0) / pixel_size(view)


def coverage(distance, width):
    """What a straight line along the pixels covers of a pixel at this distance."""
    return np.clip(np.minimum(width / 2, distance + 0.5) - np.maximum(-width / 2, distance - 0.5), 0, 1)


def tearDownModule():
    simple.Disconnect()  # closes the views before Python ends


class FilmPictures(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def tearDown(self):
        simple.ResetSession()

    def check_exact(self, view, arcs, width):
        """Dark are the pixels within half a width of the arcs, and the edges are as soft as a pixel."""
        found = darkness(view)
        distance = distance_to(view, arcs)
        self.assertGreater((found > 0.5).sum(), 50)
        self.assertLess(distance[found > 0.5].max(), width / 2 + 0.1)
        self.assertGreater(distance[found < 0.5].min(), width / 2 - 0.1)
        self.assertLess(np.abs(found - coverage(distance, width)).max(), 0.06)

    def test_arcs_are_exact(self):
        for width in (1, 2, 7):
            with self.subTest(width=width):
                view = view_of()
                show(polylines(ARCS), view, FilmWidth=width)
                self.check_exact(view, ARCS, width)

    def test_arcs_are_exact_a_thousand_times_closer(self):
        """At a place of each arc, with a view of a thousandth of the whole."""
        for arc in ARCS[:3]:
            with self.subTest(arc=arc):
                start, end, half_angle = arc
                chord = np.subtract(end, start)
                apex = (np.add(start, end) / 2
                        - np.array([-chord[1], chord[0]]) / 2 * math.tan(half_angle / 2))
                view = view_of(scale=1.5e-3, centre=tuple(apex))
                show(polylines(ARCS), view, FilmWidth=3)
                self.check_exact(view, [arc], 3)

    def test_width_is_the_same_at_any_zoom_and_aspect_ratio(self):
        arc = ARCS[1]
        for size in ((400, 400), (640, 240)):
            for scale in (1, 3, 20):
                with self.subTest(size=size, scale=scale):
                    view = view_of(size, scale, centre=(-0.6, -0.7))
                    show(polylines([arc]), view, FilmWidth=4)
                    length = arc_length(*arc) / pixel_size(view)
                    ends = math.pi * 2**2  # round
                    self.assertAlmostEqual((darkness(view).sum() - ends) / length, 4, delta=0.12)

    def test_smooth_with_and_without_multisampling(self):
        pictures = []
        for samples in (0, 4):
            view = view_of()
            view.GetRenderWindow().SetMultiSamples(samples)
            show(polylines(ARCS), view, FilmWidth=3)
            self.check_exact(view, ARCS, 3)
            pictures.append(darkness(view))
        self.assertLess(np.abs(pictures[0] - pictures[1]).max(), 0.01)

    def test_films_join_without_overlap_or_gap(self):
        for opacity in (1, 0.5):
            with self.subTest(opacity=opacity):
                view = view_of(scale=0.2, centre=(0, -ROOT3 / 2))
                show(polylines(DOUBLE_BUBBLE), view, FilmWidth=40, Opacity=opacity)
                expected = opacity * coverage(distance_to(view, DOUBLE_BUBBLE), 40)
                self.assertLess(np.abs(darkness(view) - expected).max(), 0.06 * opacity)

    def test_films_meet_at_120_degrees(self):
        """Where a small circle around the junction is crossed by films."""
        view = view_of(scale=0.05, centre=(0, -ROOT3 / 2), size=(600, 600))
        show(polylines(DOUBLE_BUBBLE), view, FilmWidth=5)
        dark = darkness(view)
        x, y = pixel_centres(view)
        y = y + ROOT3 / 2
        radius = np.hypot(x, y)
        angle = np.degrees(np.arctan2(y, x))
        ring = np.abs(radius - 0.04) < 2 * pixel_size(view)
        directions = []
        for expected in (90, -30, 210):
            near = ring & (np.abs((angle - expected + 180) % 360 - 180) < 20)
            deviation = (angle[near] - expected + 180) % 360 - 180
            directions.append(expected + np.average(deviation, weights=dark[near]))
        # A circle of radius 1 turns away from its tangent by asin(r/2) at a distance r.
        bend = math.degrees(math.asin(0.04 / 2))
        self.assertAlmostEqual(directions[0] - (directions[1] - bend), 120, delta=0.2)
        self.assertAlmostEqual(directions[2] + bend - directions[0], 120, delta=0.2)

    def test_films_seen_aslant_keep_their_width(self):
        """A straight film away from the viewer, in perspective, is as wide everywhere."""
        view = view_of(CameraParallelProjection=0, CameraPosition=[0, -6, 4])
        show(polylines([((0, -1), (0, 2), 0.0)]), view, FilmWidth=5)
        rows = darkness(view).sum(axis=1)
        inside = np.flatnonzero(rows > 0.5)[6:-6]
        self.assertGreater(len(inside), 100)
        self.assertLess(np.abs(rows[inside] - 5).max(), 0.1)

    def test_colour_is_that_of_the_array(self):
        view = view_of(scale=2)
        display = show(polylines(DOUBLE_BUBBLE, Weight=[1.0, 2.0, 4.0]), view, FilmWidth=9)
        simple.ColorBy(display, ("CELLS", "Weight"))
        colours = simple.GetColorTransferFunction("Weight")
        colours.RGBPoints = [1, 1, 0, 0, 2, 0, 1, 0, 4, 0, 0, 1]
        shown = picture(view)
        x, y = pixel_centres(view)
        for place, colour in (((1.5, 0), (1, 0, 0)), ((-1.5, 0), (0, 1, 0)), ((0, 0), (0, 0, 1))):
            pixel = np.unravel_index(np.argmin(np.hypot(x - place[0], y - place[1])), x.shape)
            self.assertLess(np.abs(shown[pixel] - colour).max(), 0.03, place)

    def test_colour_of_points_goes_along_the_film(self):
        data = polylines([((-1, 0), (1, 0), 0.0)])
        view = view_of()
        source = simple.Elevation(Input=source_of(data), LowPoint=[-1, 0, 0], HighPoint=[1, 0, 0])
        display = show(source, view, FilmWidth=9)
        simple.ColorBy(display, ("POINTS", "Elevation"))
        colours = simple.GetColorTransferFunction("Elevation")
        colours.ColorSpace = "RGB"
        colours.RGBPoints = [0, 0, 0, 0, 1, 1, 0, 0]
        red = picture(view)[200, :, 0]
        x = pixel_centres(view)[0][0]
        inside = np.abs(x) < 0.95
        self.assertLess(np.abs(red[inside] - (x[inside] + 1) / 2).max(), 0.03)

    def test_borders_are_tangent_to_straight_films(self):
        """Between straight films at 120° the sides are circles that touch them."""
        ends = [(math.cos(a), math.sin(a)) for a in np.radians((90, 210, 330))]
        arcs = [((0, 0), end, 0.0) for end in ends]
        view = view_of(scale=0.3)
        show(polylines(arcs), view, FilmWidth=2, BorderRadius=0.3)
        x, y = pixel_centres(view)
        r = np.hypot(x, y)
        films = distance_to(view, arcs)
        from_centre = np.min([np.hypot(x - 0.3 * 2 / ROOT3 * math.cos(a), y - 0.3 * 2 / ROOT3 * math.sin(a))
                              for a in np.radians((30, 150, 270))], axis=0)
        # The liquid is what lies outside all three circles, as far out as they touch the films.
        gas = (0.3 - from_centre) / pixel_size(view)
        inside = (r < 0.3 / ROOT3 * 0.98)
        expected = np.where(inside, np.clip(1.5 - np.minimum(films, gas), 0, 1), coverage(films, 2))
        clear = np.abs(r - 0.3 / ROOT3) > 0.01
        self.assertLess(np.abs(darkness(view) - expected)[clear].max(), 0.08)

    def test_borders_on_a_wall_have_two_sides(self):
        """A film at right angles to a wall: a side on either side of it, and none on the wall's back."""
        arcs = [((0, 0), (-1, 0), 0.0), ((0, 0), (1, 0), 0.0), ((0, 0), (0, 1), 0.0)]
        view = view_of(scale=0.3)
        show(polylines(arcs), view, FilmWidth=2, BorderRadius=0.2)
        x, y = pixel_centres(view)
        films = distance_to(view, arcs)
        gas = (0.2 - np.hypot(np.abs(x) - 0.2, y - 0.2)) / pixel_size(view)
        inside = (np.abs(x) < 0.2) & (y > 0) & (y < 0.2)
        expected = np.where(inside, np.clip(1.5 - np.minimum(films, gas), 0, 1), coverage(films, 2))
        self.assertLess(np.abs(darkness(view) - expected).max(), 0.08)

    def test_two_sided_bubble_is_wet_at_both_ends(self):
        """A lens on a film: as much liquid at either end, above and below, and the lens stays open."""
        half_angle = math.radians(60)
        arcs = [((-1.5, 0), (-0.5, 0), 0.0), ((-0.5, 0), (0.5, 0), half_angle),
                ((-0.5, 0), (0.5, 0), -half_angle), ((0.5, 0), (1.5, 0), 0.0)]
        view = view_of(scale=1)
        display = show(polylines(arcs), view, FilmWidth=2)
        dry = darkness(view)
        display.BorderRadius = 0.15
        wet = darkness(view)
        self.assertLess(np.abs(wet - wet[::-1]).max(), 0.03)
        self.assertLess(np.abs(wet - wet[:, ::-1]).max(), 0.03)
        extra = (wet - dry)[:, :200].sum() * pixel_size(view) ** 2
        self.assertAlmostEqual(extra / (0.15**2 * (ROOT3 - math.pi / 2)), 1, delta=0.3)
        self.assertEqual(wet[180:220, 180:220].max(), 0)

    def test_borders_of_bent_films_hold_together(self):
        """A double bubble's borders: darkness is one piece, as thick as a film at the borders' tips."""
        view = view_of(scale=0.3, centre=(0, -ROOT3 / 2))
        display = show(polylines(DOUBLE_BUBBLE), view, FilmWidth=3)
        dry = darkness(view)
        display.BorderRadius = 0.1
        wet = darkness(view)
        x, y = pixel_centres(view)
        r = np.hypot(x, y + ROOT3 / 2)
        self.assertGreater((wet - dry).min(), -0.02)  # nothing is taken away
        self.assertEqual(np.abs(wet - dry)[r > 0.09].max(), 0)  # and nothing put on the films
        extra = (wet - dry).sum() * pixel_size(view) ** 2
        # Area between three circles of radius R that touch: R²(√3 − π/2), in first order.
        self.assertAlmostEqual(extra / (0.1**2 * (ROOT3 - math.pi / 2)), 1, delta=0.25)

    def test_texture_goes_along_the_film_in_its_proportions(self):
        """From the film's middle: a period twice as long as the film is wide, red and then blue."""
        red, blue = [255, 0, 0], [0, 0, 255]
        path = self.picture_file(np.array([[red] * 8 + [blue] * 8] * 8, np.uint8))
        for scale in (1, 0.5):
            with self.subTest(scale=scale):
                view = view_of(scale=scale)
                show(polylines([((-0.9, 0), (0.9, 0), 0.0)]), view, FilmWidth=10, FilmStyle="Texture",
                     FilmTextureFile=path, AmbientColor=[1, 1, 1], DiffuseColor=[1, 1, 1])
                shown = picture(view)[200]
                for offset, colour in ((5, red), (15, blue), (25, red), (-5, blue), (-15, red)):
                    self.assertLess(np.abs(shown[200 + offset] - np.array(colour) / 255).max(), 0.05)

    def test_textures_that_come_with_foam(self):
        folder = Path(__file__).parent.parent.parent / "rendering" / "textures"
        for path in sorted(folder.glob("*.png")):
            with self.subTest(path.name):
                view = view_of()
                show(polylines(ARCS), view, FilmWidth=16, FilmStyle="Texture", FilmTextureFile=str(path))
                distance = distance_to(view, ARCS)
                dark = darkness(view)
                self.assertGreater(dark[distance < 1].mean(), 0.9)
                self.assertEqual(dark[distance > 9].max(), 0)

    def test_no_texture_is_said_and_drawn_plain(self):
        view = view_of()
        display = show(polylines(ARCS), view, FilmWidth=5)
        plain = darkness(view)
        folder = Path(tempfile.gettempdir())
        text = Path(self.folder.name) / "text.png"
        text.write_text("no picture")
        for path, cause in (("/nowhere/rope.png", "/nowhere/rope.png does not exist"),
                            (str(text), "text.png is not a picture"), (str(folder), "does not exist")):
            with self.subTest(path), Messages() as messages:
                display.FilmStyle = "Texture"
                display.FilmTextureFile = path
                self.assertEqual(np.abs(darkness(view) - plain).max(), 0)
                self.assertIn(cause, messages.text())

    def test_ink_swells_and_tapers(self):
        view = view_of(scale=1)
        show(polylines([((-0.9, 0), (0.9, 0), 0.0)]), view, FilmWidth=20, FilmStyle="Ink")
        width = darkness(view).sum(axis=0)
        inside = width[40:-40]
        self.assertAlmostEqual(width[22], 7, delta=1)  # about a third at the ends
        self.assertAlmostEqual(width[-22], 7, delta=1)
        self.assertTrue(15 < inside.max() < 28)
        self.assertGreater(np.std(width[160:240]), 0.2)

    def picture_file(self, pixels):
        path = str(Path(self.folder.name) / "texture.png")
        matplotlib.image.imsave(path, pixels)
        return path

    def test_other_representations_are_as_before(self):
        data = polylines(ARCS, samples=60)
        view = view_of()
        display = show(data, view, FilmWidth=4, BorderRadius=0.01)
        before = darkness(view)
        display.Representation = "Wireframe"
        lines = darkness(view)
        self.assertGreater(np.abs(lines - before).max(), 0.5)
        display.Representation = "Foam Films"
        self.assertEqual(np.abs(darkness(view) - before).max(), 0)

    def test_walls_are_drawn_round_their_corners(self):
        corners = [(-0.6, 0.3), (0.1, 0.3), (0.1, -0.5), (0.7, -0.5)]
        sides = [(*pair, 0.0) for pair in zip(corners, corners[1:])]
        film = ((-0.6, 0.3), (-0.6, -0.6), 0.0)
        data = polylines([film])
        points, line = data.GetPoints(), vtkIdList()
        for x, y in corners:
            line.InsertNextId(points.InsertNextPoint(x, y, 0))
        data.GetLines().InsertNextCell(line)
        add_cell_arrays(data, {"HalfAngle": [0, 0], "Kind": [0, 1]})
        view = view_of(scale=1)
        show(data, view, FilmWidth=4)
        found = darkness(view)
        distance = distance_to(view, [film, *sides])
        self.assertLess(distance[found > 0.5].max(), 2 * 2**0.5 + 0.1)  # corners are pointed
        self.assertGreater(distance[found < 0.5].min(), 1.9)

    def test_selection_finds_films(self):
        view = view_of(scale=2)
        source = source_of(polylines(DOUBLE_BUBBLE, 30))
        show(source, view, FilmWidth=5)
        picture(view)
        for film, place in ((0, (350, 200)), (1, (50, 200)), (2, (200, 200))):
            x, y = place
            simple.SelectSurfaceCells(Rectangle=[x - 4, y - 4, x + 4, y + 4], View=view)
            chosen = servermanager._getPyProxy(source.SMProxy.GetSelectionInput(0)).Input[0]
            self.assertEqual(list(chosen.IDs)[1::2], [film])
            simple.ClearSelection(source)


class OrdinaryDrawing(unittest.TestCase):
    """What is not films is drawn as lines, and said to be."""

    def tearDown(self):
        simple.ResetSession()

    def check_drawn_as_lines(self, data, cause):
        view = view_of()
        display = show(data, view)
        with Messages() as messages:
            darkness(view)
            films = darkness(view)
        self.assertEqual(messages.text().count("Films are drawn as ordinary lines"), 1)
        self.assertIn(cause, messages.text())
        display.Representation = "Wireframe"
        self.assertGreater(films.sum(), 100)
        self.assertEqual(np.abs(films - darkness(view)).max(), 0)

    def test_no_half_angle(self):
        self.check_drawn_as_lines(polylines(ARCS, 30, HalfAngle=None), "HalfAngle is missing")

    def test_half_angle_is_text(self):
        self.check_drawn_as_lines(polylines(ARCS, 30, HalfAngle=["a"] * 5), "HalfAngle is not numeric")

    def test_half_angle_out_of_range(self):
        self.check_drawn_as_lines(polylines(ARCS, 30, HalfAngle=[4.0] * 5), "HalfAngle of film 0 is 4")


if __name__ == "__main__":
    unittest.main()

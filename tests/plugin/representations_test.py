# SPDX-License-Identifier: GPL-3.0-or-later
"""The representations as ParaView offers them: names, defaults, documentation; a foam in time."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from paraview import simple

sys.path.insert(0, str(Path(__file__).parent))
from pictures import darkness, picture, read_picture, show, view_of

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())

DEFAULTS = {
    "Foam Films": {"FilmWidth": 2, "BorderRadius": 0, "FilmStyle": "Plain", "FilmTextureFile": ""},
    "Soap Films": {"ThicknessArray": "None", "Thickness": 450, "ThicknessGradient": 20,
                   "RefractiveIndex": 1.333},
}


def tearDownModule():
    simple.Disconnect()  # closes the views before Python ends


class Representations(unittest.TestCase):
    def setUp(self):
        self.foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=30))
        self.foam.UpdatePipeline()

    def tearDown(self):
        simple.ResetSession()

    def test_are_offered_with_documented_properties(self):
        view = view_of()
        for port, (name, defaults) in enumerate(DEFAULTS.items()):
            display = simple.Show(simple.OutputPort(self.foam, port), view)
            self.assertIn(name, display.GetProperty("Representation").Available)
            for key, value in defaults.items():
                self.assertEqual(getattr(display, key), value, key)
                text = display.GetProperty(key).SMProperty.GetDocumentation().GetDescription()
                self.assertGreater(len(text), 30, key)

    def test_change_with_time(self):
        """Each frame of an animation is the picture of its time, and time can go back."""
        coarsen = FoamCoarsen(Input=self.foam, NumberOfFrames=2, TimeStep=0.2)
        view = view_of(scale=4, centre=(2.5, 2.5))
        show(coarsen, view)
        scene = simple.GetAnimationScene()
        scene.UpdateAnimationUsingDataTimeSteps()
        times = list(coarsen.TimestepValues)
        with tempfile.TemporaryDirectory() as folder:
            simple.SaveAnimation(str(Path(folder) / "frame.png"), view, ImageResolution=[400, 400])
            frames = [1 - read_picture(path).mean(axis=2) for path in sorted(Path(folder).glob("*.png"))]
        self.assertEqual(len(frames), len(times))
        for frame, other in zip(frames, frames[1:]):
            self.assertGreater(np.abs(frame - other).max(), 0.5)
        for i in (2, 0, 1):
            view.ViewTime = times[i]
            self.assertLess(np.abs(darkness(view) - frames[i]).max(), 0.01, i)

    def test_films_lie_on_bubbles_without_a_halo(self):
        """In whatever order they come: films' soft edges let nothing through but the bubbles."""
        for films_first in (True, False):
            with self.subTest(films_first=films_first):
                view = view_of(scale=1.2, centre=(2.5, 2.5), Background=[0, 1, 0])
                if films_first:
                    show(self.foam, view, FilmWidth=5)
                bubbles = simple.Triangulate(Input=simple.OutputPort(self.foam, 1))
                simple.Show(bubbles, view, Ambient=1, Diffuse=0, ColorArrayName=[None, ""],
                            AmbientColor=[1, 0, 0], DiffuseColor=[1, 0, 0])
                if not films_first:
                    show(self.foam, view, FilmWidth=5)
                red, green, _ = np.moveaxis(picture(view), 2, 0)
                self.assertLess(green.max(), 0.02)  # no background between bubbles and films
                self.assertLess(red.min(), 0.02)
                self.assertGreater(((red > 0.2) & (red < 0.8)).sum(), 100)  # soft edges


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The representation Soap Films, measured in its pictures."""

import colorsys
import os
import sys
import unittest
from pathlib import Path

import numpy as np
from paraview import simple

sys.path.insert(0, str(Path(__file__).parent))
from pictures import Messages, picture, pixel_centres, source_of, squares, view_of

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())


def tearDownModule():
    simple.Disconnect()  # closes the views before Python ends


class SoapFilms(unittest.TestCase):
    def setUp(self):
        self.view = view_of(scale=2)

    def tearDown(self):
        simple.ResetSession()

    def show(self, data, **properties):
        display = simple.Show(source_of(data), self.view)
        display.Representation = "Soap Films"
        simple.SetProperties(display, ThicknessGradient=0, **properties)
        return display

    def colour_at(self, x, y):
        xs, ys = pixel_centres(self.view)
        pixel = np.unravel_index(np.argmin(np.hypot(xs - x, ys - y)), xs.shape)
        return picture(self.view)[pixel]

    def hue_at(self, x, y):
        return 360 * colorsys.rgb_to_hsv(*self.colour_at(x, y))[0]

    def test_colours_of_an_array(self):
        """Thicknesses of Newton's black, white, violet and green (nm): Opticks, book II, in water."""
        self.show(squares(4, Nanometres=[0.0, 100.0, 213.0, 480.0]), ThicknessArray="Nanometres")
        self.assertEqual(self.colour_at(-1.5, 0).max(), 0)
        self.assertGreater(self.colour_at(-0.5, 0).min(), 0.9)
        self.assertAlmostEqual(self.hue_at(0.5, 0), 265, delta=20)
        self.assertAlmostEqual(self.hue_at(1.5, 0), 150, delta=25)

    def test_gradient_goes_downwards_from_the_middle(self):
        """A film of 100 nm is white; 250 nm/cm thinner 0.4 cm above, it is black."""
        display = self.show(squares(4), Thickness=100)
        self.assertGreater(self.colour_at(0.5, 0.4).min(), 0.9)
        display.ThicknessGradient = 250
        self.assertLess(self.colour_at(0.5, 0.4).max(), 0.05)
        self.assertAlmostEqual(self.hue_at(0.5, -0.45), 265, delta=25)  # violet at 213 nm

    def test_arrays_that_are_no_thicknesses(self):
        for name, cause in (("Nothing", "Nothing is missing"), ("Text", "Text is not numeric")):
            with self.subTest(name), Messages() as messages:
                self.show(squares(4, Text=["a"] * 4), Thickness=100, ThicknessArray=name)
                self.assertGreater(self.colour_at(0.5, 0).min(), 0.9)
                self.assertIn("100 nm thick: cell array " + cause, messages.text())

    def test_refractive_index_that_does_not_refract(self):
        with Messages() as messages:
            self.show(squares(4), Thickness=100, RefractiveIndex=1)
            self.assertGreater(self.colour_at(0.5, 0).min(), 0.9)
            self.assertIn("RefractiveIndex must be greater than 1, not 1", messages.text())


if __name__ == "__main__":
    unittest.main()

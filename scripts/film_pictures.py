# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of docs/films.md, for scripts/update-pictures: pvpython film_pictures.py FOLDER."""

import os
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont
from matplotlib import font_manager
from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

ROOT = Path(__file__).resolve().parent.parent
LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())

INK = [0.06, 0.09, 0.20]
GAP = 12  # pixels between the parts of a picture


def font(size):
    return ImageFont.truetype(font_manager.findfont("DejaVu Sans"), size)


def picture_of(view):
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "part.png")
        SaveScreenshot(path, view, ImageResolution=list(view.ViewSize))
        return Image.open(path).convert("RGB")


class Scene:
    """A view from above on films, of which pictures are taken part by part."""

    def __init__(self, size, centre, height, background=(1, 1, 1)):
        self.view = CreateRenderView(ViewSize=size, InteractionMode="2D", CameraParallelProjection=1,
                                     OrientationAxesVisibility=0, UseColorPaletteForBackground=0,
                                     Background=background, CameraViewUp=[0, 1, 0])
        self.look_at(centre, height)

    def look_at(self, centre, height):
        """height is that of the view (cm)."""
        self.view.CameraPosition = [*centre, 10]
        self.view.CameraFocalPoint = [*centre, 0]
        self.view.CameraParallelScale = height / 2

    def show(self, source, representation, **properties):
        display = Show(source, self.view)
        display.Representation = representation
        SetProperties(display, **{"ColorArrayName": [None, ""], "AmbientColor": INK, "DiffuseColor": INK,
                                  **properties})
        return display

    def picture(self):
        return picture_of(self.view)


def side_by_side(parts, columns):
    """Pictures of one size, in rows, each with its caption below."""
    (width, height), caption = parts[0][1].size, 44
    rows = -(-len(parts) // columns)
    whole = Image.new("RGB", (columns * (width + GAP) - GAP, rows * (height + caption)), "white")
    draw = ImageDraw.Draw(whole)
    for i, (text, part) in enumerate(parts):
        x, y = i % columns * (width + GAP), i // columns * (height + caption)
        whole.paste(part, (x, y))
        draw.text((x + width / 2, y + height + caption / 2), text, fill="black", font=font(20), anchor="mm")
    return whole


def films_of(foam):
    foam.UpdatePipeline()
    return foam.GetClientSideObject().GetOutputDataObject(0)


def frame_of(data):
    """The middle of a square view of all of the data, and its height."""
    x0, x1, y0, y1 = data.GetBounds()[:4]
    return ((x0 + x1) / 2, (y0 + y1) / 2), 1.05 * max(x1 - x0, y1 - y0)


def bent_sample(films):
    """A sample inside the most bent film that has one."""
    bend = np.abs(vtk_to_numpy(films.GetCellData().GetArray("HalfAngle")))
    for film in np.argsort(-bend):
        cell = films.GetCell(int(film))
        if cell.GetNumberOfPoints() > 2:
            return films.GetPoint(cell.GetPointId(1))[:2]
    raise RuntimeError("All films are straight")


def closer(foam):
    """ParaView's own lines and ours, of the whole foam and a thousand times closer."""
    films = films_of(foam)
    middle, height = frame_of(films)
    parts = []
    scene = Scene((560, 560), middle, height)
    display = scene.show(foam, "Wireframe", LineWidth=3, FilmWidth=3)
    for zoom, centre in ((1, middle), (1000, bent_sample(films))):
        scene.look_at(centre, height / zoom)
        for representation, name in (("Wireframe", "ParaView’s lines"), ("Foam Films", "Foam Films")):
            display.Representation = representation
            parts.append((f"{name}, {zoom:,}×", scene.picture()))
    return side_by_side(parts, 2)


def styles(foam):
    textures = ROOT / "rendering" / "textures"
    scene = Scene((560, 420), (3, 3), 4.4)
    display = scene.show(foam, "Foam Films", FilmWidth=5)
    ColorBy(display, ("CELLS", "PressureDifference"))
    GetColorTransferFunction("PressureDifference").ApplyPreset("Cool to Warm (Extended)", True)
    parts = [("coloured by PressureDifference", scene.picture())]
    ColorBy(display, None)
    for name, properties in {
            "Ink": {"FilmStyle": "Ink", "FilmWidth": 6},
            "Texture, rope.png": {"FilmStyle": "Texture", "FilmWidth": 15, "Colour": [0.93, 0.75, 0.47],
                                  "FilmTextureFile": str(textures / "rope.png")},
            "Texture, pearls.png": {"FilmStyle": "Texture", "FilmWidth": 15, "Colour": [0.93, 0.95, 1.0],
                                    "FilmTextureFile": str(textures / "pearls.png")}}.items():
        colour = properties.pop("Colour", INK)
        SetProperties(display, AmbientColor=colour, DiffuseColor=colour, **properties)
        parts.append((name, scene.picture()))
    return side_by_side(parts, 2)


def wet(foam):
    scene = Scene((560, 420), (3, 3), 4.4)
    display = scene.show(foam, "Foam Films", FilmWidth=3, AmbientColor=[0.13, 0.35, 0.60],
                         DiffuseColor=[0.13, 0.35, 0.60])
    parts = []
    for radius in (0, 0.1, 0.2, 0.4):
        display.BorderRadius = radius
        parts.append((f"BorderRadius {radius:g} cm", scene.picture()))
    return side_by_side(parts, 2)


def soap(foam):
    scene = Scene((560, 560), *frame_of(films_of(foam)), background=(0, 0, 0))
    scene.show(foam, "Foam Films", FilmWidth=1.5, AmbientColor=[1, 1, 1], DiffuseColor=[1, 1, 1],
               BorderRadius=0.1)
    bubbles = OutputPort(foam, 1)
    scene.show(bubbles, "Soap Films", Thickness=450, ThicknessGradient=60)
    parts = [("450 nm in the middle, 60 nm/cm", scene.picture())]
    Hide(bubbles, scene.view)
    drained = Calculator(Input=bubbles, AttributeType="Cell Data", ResultArrayName="Nanometres",
                         Function="150+200*Area")
    scene.show(drained, "Soap Films", ThicknessArray="Nanometres", ThicknessGradient=15)
    parts.append(("from an array: 150 nm + 200 nm/cm² · Area", scene.picture()))
    return side_by_side(parts, 2)


# The thickness of water (nm) at which Newton saw each order's first and last colour at its best.
ORDERS = {"1": (46, 171), "2": (213, 375), "3": (400, 610), "4": (648, 768), "5": (876, 1000),
          "6": (1119, 1238), "7": (1353, 1467)}


def colour_scale():
    """The colours from 0 to 1500 nm, with the orders of Newton's table."""
    width, height, thickest = 1132, 90, 1500
    strips = vtkPolyData()
    points, cells, thickness = vtkPoints(), vtkCellArray(), vtkDoubleArray()
    thickness.SetName("Nanometres")
    for i in range(width):
        cells.InsertNextCell(4)
        for x, y in ((i, 0), (i + 1, 0), (i + 1, height), (i, height)):
            cells.InsertCellPoint(points.InsertNextPoint(x, y, 0))
        thickness.InsertNextValue(thickest * (i + 0.5) / width)
    strips.SetPoints(points)
    strips.SetPolys(cells)
    strips.GetCellData().AddArray(thickness)
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(strips)
    scene = Scene((width, height), (width / 2, height / 2), height)
    scene.show(source, "Soap Films", ThicknessArray="Nanometres", ThicknessGradient=0)

    whole = Image.new("RGB", (width, height + 70), "white")
    whole.paste(scene.picture(), (0, 30))
    draw = ImageDraw.Draw(whole)
    for order, (first, last) in ORDERS.items():
        x = [value / thickest * width for value in (first, last)]
        draw.line((x[0], 24, x[1], 24), fill="black", width=2)
        draw.text((sum(x) / 2, 11), order, fill="black", font=font(16), anchor="mm")
    for nanometres in range(0, thickest + 1, 250):
        x = nanometres / thickest * width
        anchor = "lm" if nanometres == 0 else "rm" if nanometres == thickest else "mm"
        draw.text((x, height + 52), f"{nanometres} nm", fill="black", font=font(16), anchor=anchor)
    return whole


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    small = FoamFromPoints(Input=FoamPoints(NumberOfPoints=40, Seed=3))
    large = FoamFromPoints(Input=FoamPoints(NumberOfPoints=120, Seed=3))
    for name, made in (("films_closer", closer(large)), ("films_styles", styles(small)),
                       ("films_wet", wet(small)), ("soap_films", soap(large)),
                       ("soap_colours", colour_scale())):
        made.save(folder / f"{name}.png")
    Disconnect()  # closes the views before Python ends

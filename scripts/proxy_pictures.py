# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the pictures of docs/proxies/, for scripts/update-pictures: pvpython proxy_pictures.py FOLDER."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from film_pictures import *

sys.path.insert(0, str(ROOT / "examples"))
import foam_in_outline

SIDES = range(3, 10)


def show_bubbles(bubbles, view):
    Show(bubbles, view, Ambient=1, Diffuse=0)


def show_foam(scene, foam, **properties):
    show_bubbles(OutputPort(foam, 1), scene.view)
    return scene.show(OutputPort(foam, 0), "Foam Films", **{"FilmWidth": 2.5, **properties})


def with_colours_of_sides(picture):
    """The picture, and below it what its colours mean."""
    colours = GetColorTransferFunction("Sides").GetClientSideObject()
    whole = Image.new("RGB", (picture.width, picture.height + 44), "white")
    whole.paste(picture, (0, 0))
    draw, side = ImageDraw.Draw(whole), 26
    x, y = picture.width / 2 - (len(SIDES) * 74 + 60) / 2, picture.height + 9
    draw.text((x, y + side / 2), "sides", fill="black", font=font(20), anchor="lm")
    for i, n in enumerate(SIDES):
        left, rgb = x + 72 + i * 74, [0.0] * 3
        colours.GetColor(n, rgb)
        draw.rectangle((left, y, left + side, y + side), fill=tuple(round(255 * c) for c in rgb),
                       outline="black")
        draw.text((left + side + 6, y + side / 2), {3: "≤ 3", 9: "≥ 9"}.get(n, str(n)), fill="black", font=font(20),
                  anchor="lm")
    return whole


def dots(points, radius):
    """The points as discs of a radius (cm)."""
    glyph = Glyph(Input=points, GlyphType="2D Glyph", GlyphMode="All Points", ScaleFactor=2 * radius)
    SetProperties(glyph.GlyphType, GlyphType="Circle", Filled=1)
    return glyph


def points():
    parts = []
    scene = Scene((370, 370), (5, 5), 10.4)
    for jitter in (0, 0.5, 1):
        scene.show(dots(FoamPoints(NumberOfPoints=100, Jitter=jitter), 0.11), "Surface", Ambient=1, Diffuse=0)
        parts.append((f"Jitter {jitter:g}", scene.picture()))
        HideAll(scene.view)
    return side_by_side(parts, 3)


def from_points():
    source = FoamPoints(NumberOfPoints=64, Seed=5)
    scene = Scene((460, 460), (4, 4), 11)
    parts = []
    for caption, properties in {"Equilibrate off: the initial mesh": {"Equilibrate": 0}, "Free": {},
                                "Periodic": {"Boundary": "Periodic"}, "Fixed": {"Boundary": "Fixed"}}.items():
        foam = FoamFromPoints(Input=source, **properties)
        show_foam(scene, foam)
        if not foam.Equilibrate:
            scene.show(dots(source, 0.08), "Surface", Ambient=1, Diffuse=0)
        parts.append((caption, scene.picture()))
        HideAll(scene.view)
    return with_colours_of_sides(side_by_side(parts, 2))


def containers():
    spacing = 0.1
    cells = np.array([(x, y) for x in np.arange(-1, 1, spacing) for y in np.arange(-1, 1, spacing)])
    points = cells + np.random.default_rng(2).uniform(0.1, 0.9, cells.shape) * spacing
    radius = np.hypot(*points.T)
    walls = foam_in_outline.heart(120) / 17.5
    parts = []
    scene = Scene((370, 370), (0, 0), 2.1)
    for caption, inside, properties in (
            ("Disc", radius < 0.97, {}), ("Annulus", (radius < 0.97) & (radius > 0.38), {"InnerRadius": 0.36}),
            ("Channel, periodic along x", np.abs(points[:, 1]) < 0.5, {"ContainerBounds": [-1, 1, -0.5, 0.5]}),
            ("Outline", foam_in_outline.inside(walls, points),
             {"Walls": PolyLineSource(Points=foam_in_outline.source(walls), Closed=1)})):
        foam = FoamFromPoints(Input=PolyLineSource(Points=foam_in_outline.source(points[inside])), Boundary="Container",
                              Container=caption.split(",")[0], **{"ContainerBounds": [-1, 1, -1, 1], **properties})
        show_bubbles(OutputPort(foam, 1), scene.view)
        scene.show(OutputPort(foam, 0), "Surface", LineWidth=2.5, Ambient=1, Diffuse=0)
        parts.append((caption, scene.picture()))
        HideAll(scene.view)
    return with_colours_of_sides(side_by_side(parts, 2))


def periodic_run(frames=150):
    foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=400, Seed=2), Boundary="Periodic")
    return FoamCoarsen(Input=foam, NumberOfFrames=frames)


def time_steps(run, frames, scene, captions, **properties):
    show_foam(scene, run, **properties)
    run.UpdatePipelineInformation()
    parts = []
    for frame in frames:
        scene.view.ViewTime = run.TimestepValues[frame]
        run.UpdatePipeline(scene.view.ViewTime)
        bubbles = run.GetClientSideObject().GetOutputDataObject(1)
        parts.append((captions.format(frame=frame, time=scene.view.ViewTime, bubbles=bubbles.GetNumberOfCells()),
                      scene.picture()))
    return parts


def coarsen(run):
    parts = time_steps(run, (0, 60, 150), Scene((370, 370), (10, 10), 25.5), "{time:.0f} s, {bubbles} bubbles",
                       FilmWidth=1.6)
    return with_colours_of_sides(side_by_side(parts, 3))


def deform():
    """Three strains: bubbles by their shear stress, and where T1s were since the one before."""
    foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=300, Seed=2), Boundary="Periodic", TargetAreas="Uniform")
    run = FoamDeform(Input=foam, StrainStep=0.02, NumberOfFrames=100)
    scene = Scene((370, 370), (8.7, 8.7), 21)
    events = Threshold(Input=OutputPort(run, 2), Scalars=["POINTS", "Time"])
    parts = []
    for strain in (0, 1, 2):
        scene.view.ViewTime = strain
        SetProperties(events, LowerThreshold=strain - 1, UpperThreshold=strain)
        bubbles = scene.show(OutputPort(run, 1), "Surface", Ambient=1, Diffuse=0)
        ColorBy(bubbles, ("CELLS", "Stress", "XY"))
        colours = GetColorTransferFunction("Stress")
        colours.ApplyPreset("Cool to Warm", True)
        colours.RescaleTransferFunction(-0.5, 0.5)
        scene.show(OutputPort(run, 0), "Surface", LineWidth=1.6, Ambient=1, Diffuse=0)
        scene.show(events, "Point Gaussian", GaussianRadius=0.17, ShaderPreset="Plain circle",
                   AmbientColor=[0.05, 0.45, 0.15], DiffuseColor=[0.05, 0.45, 0.15], ColorArrayName=[None, ""])
        parts.append((f"strain {strain}", scene.picture()))
    return side_by_side(parts, 3)


def series(run):
    parts = time_steps(run, range(0, 60, 12), Scene((216, 216), (5, 5), 8), "films_{frame:04d}.vtp", FilmWidth=2)
    return side_by_side(parts, 5)


def evolver():
    """A datafile, as it is and in equilibrium."""
    scene = Scene((460, 460), (5, 5), 11.5)
    parts = []
    for caption, equilibrate in (("as Surface Evolver's file has it", 0), ("Equilibrate on", 1)):
        path = ROOT / "tests/data/evolver-100/foam100_arc.fe"
        show_foam(scene, FoamEvolverReader(FileName=str(path), Equilibrate=equilibrate))
        parts.append((caption, scene.picture()))
        HideAll(scene.view)
    return with_colours_of_sides(side_by_side(parts, 2))


def polygons():
    """Polygons, and the foam of them."""
    bubbles = OutputPort(FoamFromPoints(Input=FoamPoints(NumberOfPoints=64, Seed=5), Equilibrate=0), 1)
    scene = Scene((460, 460), (4, 4), 11)
    show_bubbles(bubbles, scene.view)
    scene.show(ExtractEdges(Input=bubbles), "Wireframe", LineWidth=2)
    parts = [("polygons", scene.picture())]
    HideAll(scene.view)
    show_foam(scene, FoamFromPolygons(Input=bubbles))
    return with_colours_of_sides(side_by_side([*parts, ("FoamFromPolygons", scene.picture())], 2))


def labels():
    """A picture of the regions that are nearest to points in a disc, and the foam of it."""
    random = np.random.default_rng(3)
    sites = random.uniform(-1, 1, (400, 2))
    sites = sites[np.hypot(*sites.T) < 0.9][:110]
    y, x = np.mgrid[-1.1:1.1:150j, -1.1:1.1:150j]
    nearest = np.argmin((x[..., None] - sites[:, 0])**2 + (y[..., None] - sites[:, 1])**2, axis=-1) + 1
    image = vtkImageData()
    image.SetDimensions(151, 151, 1)
    array = numpy_to_vtk(np.where(np.hypot(x, y) < 1, nearest, 0).ravel(), deep=True)
    array.SetName("labels")
    image.GetCellData().SetScalars(array)
    picture = TrivialProducer()
    picture.GetClientSideObject().SetOutput(image)
    scene = Scene((370, 370), (75, 75), 152)
    shades = random.uniform(0.55, 1, (9, 3))
    colours = GetColorTransferFunction("labels")
    colours.RGBPoints = [v for i in range(0, 111) for v in (i, *(shades[i % 9] if i else (1, 1, 1)))]
    scene.show(picture, "Surface", ColorArrayName=["CELLS", "labels"], LookupTable=colours,
               Ambient=1, Diffuse=0)
    parts = [("the picture", scene.picture())]
    HideAll(scene.view)
    for caption, equilibrate in (("Equilibrate off: the arcs that fit it", 0), ("in equilibrium", 1)):
        show_foam(scene, FoamFromLabels(Input=picture, Equilibrate=equilibrate), FilmWidth=1.6)
        parts.append((caption, scene.picture()))
        HideAll(scene.view)
    return with_colours_of_sides(side_by_side(parts, 3))


def statistics(run):
    measured = FoamStatistics(Input=run)
    measured.UpdatePipeline(2)
    parts = []
    for port, name, kind in ((3, "Distribution", "FoamDistributionView"), (1, "BySides", "FoamAboavWeaireView")):
        view = CreateView(kind)
        SetProperties(view, ViewSize=[560, 400], ViewTime=2, BottomAxisUseCustomRange=1, BottomAxisRangeMinimum=2,
                      BottomAxisRangeMaximum=12, LeftAxisTitleFontSize=16, BottomAxisTitleFontSize=16,
                      LeftAxisLabelFontSize=14, BottomAxisLabelFontSize=14, LegendFontSize=14)
        Show(OutputPort(measured, port), view)
        parts.append((name, picture_of(view)))
    return side_by_side(parts, 2)


def ensemble():
    """p(n) of ten foams, pooled, with the intervals."""
    films = []
    for seed in range(1, 11):
        foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=400, Seed=seed), Boundary="Periodic")
        run = FoamCoarsen(Input=foam, NumberOfFrames=90)
        run.UpdatePipeline(3)
        films.append(films_at_end(run))
    pooled = FoamEnsembleStatistics(Input=GroupDatasets(Input=films, OutputType="vtkPartitionedDataSet"))
    pooled.UpdatePipeline()
    table = pooled.GetClientSideObject().GetOutputDataObject(0)
    rows = [{table.GetColumnName(c): table.GetValue(r, c) for c in range(table.GetNumberOfColumns())}
            for r in range(table.GetNumberOfRows())]
    rows = [row for row in rows if row["Quantity"].ToString() == "Fraction"]
    figure, axes = plt.subplots(figsize=(7.4, 4.2), dpi=100, layout="constrained")
    sides = [row["Sides"].ToInt() for row in rows]
    mean, upper = ([row[name].ToDouble() for row in rows] for name in ("Mean", "Upper95"))
    axes.bar(sides, mean, 0.62, color="#a9cfe8")
    axes.errorbar(sides, mean, np.subtract(upper, mean), fmt="none", ecolor="#1f4e8c", capsize=5, lw=1.6)
    axes.set(xlabel="sides n", ylabel="fraction of bubbles p(n)", xticks=sides)
    axes.spines[["top", "right"]].set_visible(False)
    figure.canvas.draw()
    return Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB")


def films_at_end(run):
    """The films that the run has come to, as a source of their own."""
    data = vtkPolyData()
    data.DeepCopy(films_of(run))
    source = TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    return source


if __name__ == "__main__":
    folder = Path(sys.argv[1])
    run = periodic_run()
    for name, made in (("proxy_points", points), ("proxy_from_points", from_points),
                       ("proxy_containers", containers), ("proxy_evolver", evolver),
                       ("proxy_polygons", polygons), ("proxy_labels", labels),
                       ("proxy_coarsen", lambda: coarsen(run)), ("proxy_deform", deform), ("proxy_series", lambda: series(run)),
                       ("proxy_statistics", lambda: statistics(run)), ("proxy_ensemble", ensemble)):
        made().save(folder / f"{name}.png")
    Disconnect()  # closes the views before Python ends

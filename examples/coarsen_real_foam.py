# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsens a real foam: points measured in a photograph become a foam, and the foam grows old.

Run it with ParaView's Python:

    pvpython examples/coarsen_real_foam.py [--frames 300] [--output output]

or let scripts/run do everything. It leaves in the output folder

    films.pvd, bubbles.pvd    time series for ParaView, with films/*.vtp and bubbles/*.vtp
    foam_first.png, foam_middle.png, foam_last.png
    bubble_count.png, mu2.png, sides.png, aboav_weaire.png
    statistics.csv            a row per frame: what the plots are drawn from

Units: the simulation's constants are in centimetres and seconds, the measured points in pixels. The
points are scaled so that the mean measured bubble area becomes 1 cm².
"""
import argparse
import math
import os
import sys
import time
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from foam_plugin import *

# Bubbles by number of sides: blue ones shrink, orange ones grow, six sides keep their area.
SIDE_COLOURS = {3: "#1f4e8c", 4: "#4f8fc9", 5: "#a9cfe8", 6: "#f3efe4",
                7: "#f6c27a", 8: "#e08a2e", 9: "#a85512"}
SIDE_LABELS = {3: "≤ 3", 9: "≥ 9"}
INK = "#1a2430"
MOMENTS = {"first": "#a9cfe8", "middle": "#4f8fc9", "last": "#1f4e8c"}


def parse_arguments():
    parser = argparse.ArgumentParser(
        prog="coarsen_real_foam.py",
        description="Turns measured points into a foam, coarsens it, and leaves a time series, "
                    "pictures and plots.")
    parser.add_argument("--input", type=Path, default=ROOT / "sample-data/real-foam-centroids.csv",
                        help="CSV with the columns x, y, area of each bubble (default: %(default)s)")
    parser.add_argument("--output", type=Path, default=Path("output"),
                        help="folder for the results (default: %(default)s)")
    parser.add_argument("--frames", type=int, default=300,
                        help="number of time steps (default: %(default)s)")
    parser.add_argument("--time-step", type=float, default=1 / 50,
                        help="length of a time step in s (default: 1/50)")
    arguments = parser.parse_args()
    if arguments.frames < 1:
        parser.error(f"--frames must be at least 1, not {arguments.frames}")
    if not (0 < arguments.time_step < math.inf):
        parser.error(f"--time-step must be greater than 0, not {arguments.time_step}")
    return arguments


def output_of(proxy, port=0):
    return proxy.GetClientSideObject().GetOutputDataObject(port)


def field_value(data, name):
    return data.GetFieldData().GetArray(name).GetTuple1(0)


def write_whole(path, write):
    """Lets write(path) write under another name first: what has its name is complete."""
    unfinished = path.with_name(f".unfinished-{path.name}")
    write(unfinished)
    os.replace(unfinished, path)


class Series:
    """A .pvd file with a .vtp file for each time; it can be opened while it grows."""

    def __init__(self, folder, name):
        self.index = folder / f"{name}.pvd"
        self.folder = folder / name
        self.folder.mkdir(parents=True, exist_ok=True)
        self.index.unlink(missing_ok=True)
        for old in self.folder.glob(f"{name}_*.vtp"):
            old.unlink()
        self.entries = []

    def add(self, data, seconds):
        path = self.folder / f"{self.folder.name}_{len(self.entries):04d}.vtp"
        write_whole(path, lambda unfinished: self._write_data(data, unfinished))
        self.entries.append(f'    <DataSet timestep="{seconds!r}" file="{self.folder.name}/{path.name}"/>')
        write_whole(self.index, self._write_index)

    @staticmethod
    def _write_data(data, path):
        writer = vtkXMLPolyDataWriter()
        writer.SetFileName(str(path))
        writer.SetInputData(data)
        writer.SetCompressionLevel(1)  # as small within a few percent, and faster
        if not writer.Write():
            sys.exit(f"Cannot write {path}")

    def _write_index(self, path):
        lines = ['<?xml version="1.0"?>', '<VTKFile type="Collection" version="0.1">',
                 "  <Collection>", *self.entries, "  </Collection>", "</VTKFile>", ""]
        path.write_text("\n".join(lines))


class Camera:
    """Takes pictures of the foam, all from the same place."""

    def __init__(self, coarsen):
        self.view = CreateRenderView(ViewSize=[1600, 960], InteractionMode="2D",
                                     CameraParallelProjection=1, OrientationAxesVisibility=0,
                                     UseColorPaletteForBackground=0, Background=[1, 1, 1])
        self._show_bubbles(OutputPort(coarsen, 1))
        self._show_films(OutputPort(coarsen, 0))
        self.title = Text()
        Show(self.title, self.view, WindowLocation="Upper Center", FontSize=28,
             Color=matplotlib.colors.to_rgb(INK))
        self._frame(output_of(coarsen, 1).GetBounds())

    def _show_bubbles(self, bubbles):
        # ParaView fills a polygon as if it were convex; triangles are filled as they are.
        triangles = Triangulate(Input=bubbles)
        shown = Calculator(Input=triangles, AttributeType="Cell Data", ResultArrayName="sides",
                           Function="min(max(Sides,3),9)")
        display = Show(shown, self.view, Ambient=1, Diffuse=0, Specular=0)
        ColorBy(display, ("CELLS", "sides"))
        colours = GetColorTransferFunction("sides")
        colours.InterpretValuesAsCategories = 1
        colours.Annotations = [text for n in SIDE_COLOURS
                               for text in (str(n), SIDE_LABELS.get(n, str(n)))]
        colours.IndexedColors = [c for colour in SIDE_COLOURS.values()
                                 for c in matplotlib.colors.to_rgb(colour)]
        ink = matplotlib.colors.to_rgb(INK)
        SetProperties(GetScalarBar(colours, self.view), Visibility=1, Title="sides",
                      ComponentTitle="", Orientation="Horizontal", AutoOrient=0,
                      WindowLocation="Lower Center", ScalarBarLength=0.4, ScalarBarThickness=26,
                      TitleFontSize=20, LabelFontSize=20, TitleColor=ink, LabelColor=ink)

    def _show_films(self, films):
        ink = matplotlib.colors.to_rgb(INK)
        Show(films, self.view, ColorArrayName=[None, ""], AmbientColor=ink, DiffuseColor=ink,
             Ambient=1, Diffuse=0, Specular=0, LineWidth=3)

    def _frame(self, bounds):
        x, y = (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2
        aspect = self.view.ViewSize[0] / self.view.ViewSize[1]
        half_height = max((bounds[3] - bounds[2]) / 2 / 0.78, (bounds[1] - bounds[0]) / 2 / aspect / 0.96)
        self.view.CameraPosition = [x, y, 10]
        self.view.CameraFocalPoint = [x, y, 0]
        self.view.CameraViewUp = [0, 1, 0]
        self.view.CameraParallelScale = half_height

    def picture(self, path, seconds, bubbles):
        self.view.ViewTime = seconds
        self.title.Text = f"t = {seconds:.2f} s,  {bubbles} bubbles"
        write_whole(path, lambda unfinished: SaveScreenshot(str(unfinished), self.view))


class Progress:
    """A line about the frame just done: renewed in place on a terminal, else now and then."""

    def __init__(self, frames):
        self.frames = frames
        self.begin = time.monotonic()
        self.terminal = os.isatty(1)  # pvpython's sys.stdout does not know

    def report(self, frame, seconds, bubbles, films):
        events = "  ".join(f"{name} {field_value(films, name + 'Count'):.0f}"
                           for name in ("T1", "T2", "T3"))
        line = (f"frame {frame:4d}/{self.frames}  t = {seconds:6.2f} s  {bubbles:5d} bubbles  "
                f"{events}  {time.monotonic() - self.begin:5.1f} s elapsed")
        if self.terminal:
            print(f"\r{line}", end="\n" if frame == self.frames else "", flush=True)
        elif frame % 10 == 0 or frame == self.frames:
            print(line, flush=True)


def new_plot(xlabel, ylabel):
    figure, axes = plt.subplots(figsize=(6.4, 4.2), dpi=150, layout="constrained")
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_xlabel(xlabel)
    axes.set_ylabel(ylabel)
    return figure, axes


def save_plot(figure, axes, path):
    axes.legend(frameon=False)
    write_whole(path, figure.savefig)
    plt.close(figure)


def plot_over_time(folder, rows):
    seconds = [row["Time"] for row in rows]
    for name, column, label in (("bubble_count", "Bubbles", "bubbles"), ("mu2", "Mu2", "μ₂")):
        figure, axes = new_plot("time / s", label)
        axes.plot(seconds, [row[column + "All"] for row in rows], color="#e08a2e", label="all bubbles")
        axes.plot(seconds, [row[column] for row in rows], color="#1f4e8c",
                  label="without those on the boundary")
        if name == "mu2":
            axes.axhline(1.4, color="0.6", lw=1, ls="--", zorder=0,
                         label="measured scaling state (Stavans & Glazier 1989)")
        axes.set_ylim(bottom=0)
        save_plot(figure, axes, folder / f"{name}.png")


def plot_sides(folder, snapshots):
    figure, axes = new_plot("sides n", "p(n), without bubbles on the boundary")
    width = 0.8 / len(snapshots)
    for i, (moment, (seconds, by_sides)) in enumerate(snapshots.items()):
        axes.bar(by_sides["Sides"] + (i - (len(snapshots) - 1) / 2) * width, by_sides["Fraction"],
                 width, color=MOMENTS[moment], label=f"t = {seconds:.2f} s")
    axes.xaxis.get_major_locator().set_params(integer=True)
    save_plot(figure, axes, folder / "sides.png")


def plot_aboav_weaire(folder, snapshots):
    figure, axes = new_plot("sides n", "n·m(n), without bubbles on the boundary")
    largest = max(by_sides["Sides"].max() for _, by_sides in snapshots.values())
    n = np.array([3, largest])
    axes.plot(n, 5 * n + 7.4, color="0.6", lw=1, ls="--", label="5n + 7.4, the scaling state (μ₂ = 1.4)")
    for (moment, (seconds, by_sides)), marker in zip(snapshots.items(), "os^"):
        axes.plot(by_sides["Sides"], by_sides["AboavProduct"], marker, color=MOMENTS[moment],
                  mec=INK, mew=0.6, label=f"t = {seconds:.2f} s")
    axes.xaxis.get_major_locator().set_params(integer=True)
    save_plot(figure, axes, folder / "aboav_weaire.png")


def coarsen_foam(arguments):
    folder = arguments.output
    foam, _ = foam_of_measured_points(arguments.input)
    coarsen = FoamCoarsen(Input=foam, NumberOfFrames=arguments.frames, TimeStep=arguments.time_step)
    bulk = FoamStatistics(Input=coarsen, IncludeBoundary=0)
    everything = FoamStatistics(Input=coarsen, IncludeBoundary=1)

    foam.UpdatePipeline()
    if output_of(foam).GetNumberOfCells() == 0:
        sys.exit(f"{arguments.input} could not be made into a foam: see the message above")
    coarsen.UpdatePipelineInformation()
    times = list(coarsen.TimestepValues)
    moments = {0: "first", len(times) // 2: "middle", len(times) - 1: "last"}
    series = {0: Series(folder, "films"), 1: Series(folder, "bubbles")}
    progress = Progress(len(times) - 1)
    camera = None
    rows, snapshots, unconverged = [], {}, []

    for frame, seconds in enumerate(times):
        for statistics in (bulk, everything):
            statistics.UpdatePipeline(seconds)
        films = output_of(coarsen)
        if films.GetNumberOfCells() == 0:
            sys.exit(f"No foam at t = {seconds} s: see the message above")
        for port, written in series.items():
            written.add(output_of(coarsen, port), seconds)

        count = output_of(coarsen, 1).GetNumberOfCells()
        if not field_value(films, "Converged"):
            unconverged.append(frame)
        rows.append({**first_row(bulk, seconds), "BubblesAll": count,
                     "Mu2All": first_row(everything, seconds)["Mu2"]})
        progress.report(frame, seconds, count, films)

        if frame in moments:
            camera = camera or Camera(coarsen)
            camera.picture(folder / f"foam_{moments[frame]}.png", seconds, count)
            snapshots[moments[frame]] = (seconds, arrays(output_of(bulk, 1).GetRowData()))

    write_whole(folder / "statistics.csv", lambda path: write_table(path, rows))
    plot_over_time(folder, rows)
    plot_sides(folder, snapshots)
    plot_aboav_weaire(folder, snapshots)

    print(f"Largest deviation from 120°: {max(row['MaxAngleError'] for row in rows):.1e} rad; "
          f"from a target area: {max(row['MaxAreaError'] for row in rows):.1e}")
    print(f"Results are in {folder}/; open {folder / 'films.pvd'} and {folder / 'bubbles.pvd'} in ParaView")
    if unconverged:
        sys.exit(f"Not in equilibrium to the tolerance: frames {unconverged}")


if __name__ == "__main__":
    arguments = parse_arguments()
    try:
        coarsen_foam(arguments)
    except OSError as error:
        sys.exit(str(error))
    finally:
        Disconnect()  # closes the view before Python ends, also after an error

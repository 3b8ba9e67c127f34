# SPDX-License-Identifier: GPL-3.0-or-later
"""The page's figures, in one style: the thesis's numbers grey, its method orange, Newton blue."""
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.ticker import FuncFormatter
from PIL import Image

from thesis_experiments import published, scale
from thesis_experiments.results import write_whole

INK, PUBLISHED = "#1a2430", "0.45"
COLOURS = {"thesis": "#d97818", "newton": "#1f4e8c"}
NAMES = {"thesis": "thesis's method", "newton": "Newton"}
BINS = 120  # of time, in plots of what fluctuates from frame to frame

plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": INK,
                     "text.color": INK, "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK,
                     "axes.titlesize": 9, "legend.frameon": False, "legend.fontsize": 8, "lines.linewidth": 1.3})


def save(figure, path):
    """As a PNG of at most 256 colours."""
    picture = io.BytesIO()
    figure.savefig(picture, dpi=120, facecolor="white")
    plt.close(figure)
    image = Image.open(picture).convert("RGB")
    few = image.quantize(256, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    write_whole(path, lambda unfinished: few.save(unfinished, format="PNG", optimize=True))


def new_figure(rows, columns, height, **options):
    return plt.subplots(rows, columns, figsize=(9, height), layout="constrained", squeeze=False, **options)


def draw_frames(results, path):
    """The six frames that the thesis shows, a row for each method."""
    columns = snapshot_columns(results)
    figure, axes = new_figure(len(results), len(columns), 0.35 + 1.62 * len(results))
    for row, (name, result) in zip(axes, results.items()):
        row[0].text(-0.06, 0.5, NAMES[name], color=COLOURS[name], rotation=90, va="center", ha="center",
                    transform=row[0].transAxes)
        for cell, column in zip(row, columns):
            cell.axis("off")
            if name not in column:
                continue
            snapshot = column[name]
            lines = result.drawn_lines(snapshot["frame"])
            width = 0.15 if snapshot["bubbles"] > 5000 else 0.3 if snapshot["bubbles"] > 800 else 0.6
            cell.add_collection(LineCollection(lines, colors=INK, linewidths=width))
            points = np.concatenate(lines)
            # Most of the junctions: where the method went wrong, films may stand out far.
            low, high = np.quantile(points, [0.002, 0.998], axis=0)
            centre, half = (low + high) / 2, 0.54 * (high - low).max()
            cell.set(xlim=(centre[0] - half, centre[0] + half), ylim=(centre[1] - half, centre[1] + half), aspect=1)
            cell.set_title(f"frame {snapshot['frame']:,}\n{snapshot['bubbles']:,} bubbles", fontsize=7)
    save(figure, path)


def snapshot_columns(results):
    """Snapshots of the runs side by side: those of frames that are no more than a step apart, by the runs' names."""
    apart = max(result.about["frames_per_step"] for result in results.values())
    columns = []
    every = [(snapshot["frame"], name, snapshot) for name, result in results.items()
             for snapshot in result.about["snapshots"]]
    for frame, name, snapshot in sorted(every, key=lambda entry: entry[0]):
        if columns and name not in columns[-1] and frame - next(iter(columns[-1].values()))["frame"] < apart:
            columns[-1][name] = snapshot
        else:
            columns.append({name: snapshot})
    return columns


def bin_edges(results):
    """Edges in time of bins for all of the runs, none narrower than a step of any."""
    end = max(result.last("Time") for result in results.values())
    step = max(result.about["time_step"] for result in results.values())
    return np.linspace(0, end + step, 1 + min(BINS, round(end / step) + 1))


def binned(result, edges, values, summarise):
    """The middle times of bins and the summaries of the frames in them; bins without frames are left out."""
    groups = np.digitize(result.frames["Time"], edges) - 1
    there = np.unique(groups)
    return (edges[there] + edges[there + 1]) / 2, np.array([summarise(values[groups == group]) for group in there])


def plot_development(results, section, path):
    """Numbers of bubbles, and μ₂ with and without the boundary as mean and range."""
    figure, ((bubbles, every, bulk),) = new_figure(1, 3, 2.6)
    edges = bin_edges(results)
    for name, result in results.items():
        seconds = result.frames["Time"]
        bubbles.plot(seconds, result.frames["Bubbles"], color=COLOURS[name], label=NAMES[name])
        bubbles.plot(seconds, result.frames["BulkBubbles"], color=COLOURS[name], ls=":", lw=1)
        for axes, column in ((every, "Mu2"), (bulk, "BulkMu2")):
            time, mean = binned(result, edges, result.frames[column], np.mean)
            low, high = (binned(result, edges, result.frames[column], extreme)[1] for extreme in (np.min, np.max))
            axes.fill_between(time, low, high, color=COLOURS[name], alpha=0.25, lw=0)
            axes.plot(time, mean, color=COLOURS[name])
    bubbles.plot([], [], color=PUBLISHED, ls=":", lw=1, label="without boundary")
    if published.text(section, "bubbles left") != "–":
        end = 0 if section == "6.2" else published.number(section, "frames") * scale.time_step()
        bubbles.plot(end, published.number(section, "bubbles left"), "D", ms=5, color=PUBLISHED, label="thesis")
    for axes in (every, bulk):
        axes.axhline(published.number("reference", "mu2"), color=PUBLISHED, lw=0.8, ls="--", zorder=0)
        axes.set(ylim=(0, min(4, axes.get_ylim()[1])), xlabel="time / s")
    bubbles.set(xlabel="time / s", title="bubbles")
    bubbles.set_yscale("log")
    for axis in (bubbles.yaxis.set_major_formatter, bubbles.yaxis.set_minor_formatter):
        axis(FuncFormatter(lambda y, _: f"{y:,.0f}" if f"{y:.0e}"[0] in "125" else ""))
    every.set_title("μ₂ with boundary")
    bulk.set_title("μ₂ without boundary")
    bubbles.legend()
    save(figure, path)


def plot_sides(results, path):
    """p(n) and n·m(n) without (filled) and with (outlined) the boundary, a column for each of the frames."""
    columns = snapshot_columns(results)
    figure, axes = new_figure(2, len(columns), 3.6, sharex=True, sharey="row")
    n = np.arange(2, 13)
    slope, offset = (published.number("reference", name) for name in ("aboav_slope", "aboav_offset"))
    for (distribution, aboav), column in zip(axes.T, columns):
        for name, shift in (("thesis", -0.2), ("newton", 0.2)):
            if name not in column:
                continue
            every, bulk = column[name]["sides"], column[name]["bulk_sides"]
            distribution.bar(np.array(bulk["Sides"]) + shift, bulk["Fraction"], 0.4, color=COLOURS[name])
            distribution.bar(np.array(every["Sides"]) + shift, every["Fraction"], 0.4, color="none", edgecolor=INK,
                             lw=0.5)
            newton = name == "newton"
            aboav.plot(bulk["Sides"], bulk["AboavProduct"], "s" if newton else "o", ms=3 if newton else 6,
                       color=COLOURS[name], mfc=COLOURS[name] if newton else "none")
        aboav.plot(n, slope * n + offset, color=PUBLISHED, lw=0.8, ls="--", zorder=0)
        distribution.set_title(f"frame {next(iter(column.values()))['frame']:,}", fontsize=8)
        aboav.set(xlabel="n", xlim=(1.5, 11.5), xticks=(3, 6, 9), ylim=(0, 72))
    axes[0, 0].set_ylabel("p(n)")
    axes[1, 0].set_ylabel("n·m(n)")
    handles = [plt.Rectangle((0, 0), 1, 1, color=COLOURS[name]) for name in results]
    axes[1, 0].legend(handles, [NAMES[name] for name in results], loc="lower left", fontsize=6.5, handlelength=1,
                      borderpad=0.1, borderaxespad=0.2)
    save(figure, path)


def plot_work(results, path):
    """Iterations, topological operations and time."""
    figure, axes = new_figure(2, 3, 4.2, sharex=True)
    edges = bin_edges(results)
    panels = dict(zip(("iterations per step", "T1s per second", "T2s and T3s per second",
                       "iterations per bubble and step", "wall time (s) per simulated second",
                       "iterations per second of wall time"), axes.flat))
    for name, result in results.items():
        frames, step = result.frames, result.about["time_step"]
        rate = {column: np.diff(frames[column], prepend=frames[column][0]) / step
                for column in ("T1Count", "T2Count", "T3Count")}
        label = f"{NAMES[name]}, steps of {step:.2g} s"
        for panel, values in zip(panels.values(), (
                frames["Iterations"], rate["T1Count"], rate["T2Count"] + rate["T3Count"],
                frames["Iterations"] / frames["Bubbles"], frames["WallSeconds"] / step,
                frames["Iterations"] / frames["WallSeconds"])):
            panel.plot(*binned(result, edges, values, np.mean), color=COLOURS[name], label=label)
    for title, panel in panels.items():
        panel.set_title(title)
        if "wall" in title or title == "iterations per step":
            panel.set_yscale("log")
        else:
            panel.set_ylim(bottom=0)
    for panel in axes[1]:
        panel.set_xlabel("time / s")
    low, high = axes[0, 0].get_ylim()
    axes[0, 0].set_ylim(low, high * (high / low) ** 0.45)  # room for the legend
    axes[0, 0].legend(loc="upper left")
    save(figure, path)


def plot_sweeps(foams, labels, path):
    """Iterations against time, as in Figure 4.14."""
    figure, (row,) = new_figure(1, 3, 2.7)
    for axes, (name, label) in zip(row, labels.items()):
        seconds, iterations = foams[f"{name}CpuSeconds"], foams[f"{name}Iterations"]
        colour = COLOURS["newton" if name == "Newton" else "thesis"]
        axes.plot(seconds, iterations, "o", ms=3, color=colour, alpha=0.6, mew=0)
        axes.set(title=label, xlabel="processor time / s", xlim=(0, 1.08 * seconds.max()),
                 ylim=(0, 1.08 * iterations.max()))
    row[0].set_ylabel("iterations")
    save(figure, path)


def plot_distance(results, path):
    """How far each method stops from equilibrium: of all examined frames the median and the range."""
    figure, (row,) = new_figure(1, 3, 0.9 + 0.32 * len(results))
    panels = (("angle error / rad", "MeanAngle", "MaxAngle"), ("area error", "MeanArea", "MaxArea"),
              ("excess energy at target areas", "ExcessAtTargets", None))
    for axes, (title, mean, largest) in zip(row, panels):
        for y, (name, result) in enumerate(results.items()):
            colour = COLOURS["newton" if name == "newton" else "thesis"]
            for column, marker, filled in ((mean, "o", True), (largest, "o", False)):
                if column is None:
                    continue
                values = np.abs(result.quality.get(column, np.array([])))
                values = values[np.isfinite(values) & (values > 0)]
                if len(values):
                    axes.plot([values.min(), values.max()], [y, y], color=colour, lw=1, alpha=0.5)
                    axes.plot(np.median(values), y, marker, color=colour, ms=5, mfc=colour if filled else "white")
        axes.set(title=title, xscale="log", ylim=(len(results) - 0.5, -0.5), yticks=range(len(results)))
        axes.set_yticklabels([result.about["label"] for result in results.values()] if axes is row[0] else [])
    save(figure, path)

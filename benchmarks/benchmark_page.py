# SPDX-License-Identifier: GPL-3.0-or-later
"""The page on speed, from compare.py's figures."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = {"Foam": "#1f5fa8", "Surface Evolver": "#c4591b"}


def find(figures, program, work, bubbles=None, cores=1):
    """The first figure of a piece of work, or none."""
    for figure in figures[program]:
        if figure["work"] == work and bubbles in (None, figure["bubbles"]) and figure.get("cores", 1) == cores:
            return figure
    return None


def seconds(value):
    return f"{1e3 * value:.3g} ms" if value < 1 else f"{value:.3g} s"


def ratio_row(figures, title, work, bubbles, goal):
    ours, theirs = (find(figures, program, work, bubbles) for program in ("foam", "evolver"))
    if not ours:
        return None
    time = ours["cpu"] if work == "equilibrium" else ours["cpu_per_frame"]
    if not theirs:
        return [title, seconds(time), "–", goal, "–"]
    return [title, seconds(time), seconds(theirs["cpu"]), goal, f"{theirs['cpu'] / time:.0f} times faster"]


def goal_rows(figures):
    """One row per goal: work, ours, Surface Evolver's, goal, reached."""
    rows = [
        ratio_row(figures, "equilibrium from random points, 1,000 bubbles", "equilibrium", 1000, "30 times faster"),
        ratio_row(figures, "the same, 10,000", "equilibrium", 10000, "50 times faster"),
        ratio_row(figures, "one coarsening step, 1,000 bubbles", "steps", 1000, "60 times faster"),
        ratio_row(figures, "the same, 100 bubbles", "steps", 100, "60 times faster"),
    ]
    small, large = (find(figures, "foam", "frames", bubbles) for bubbles in (10000, 100000))
    if small and large:
        times = [seconds(f["cpu_per_frame"]) for f in (small, large)]
        rows.append(["a frame at 100,000 bubbles over one at 10,000", f"{times[1]} / {times[0]}", "", "at most 13",
                     f"{large['cpu_per_frame'] / small['cpu_per_frame']:.1f}"])
    parallel = [f for f in figures["foam"] if f["cores"] > 1 and f["work"] == "frames"]
    for f in parallel:
        if f["bubbles"] < 20000:
            rows.append(["10,000 bubbles, tolerance 1e-6, all cores", seconds(f["wall_per_frame"]) + " a frame", "",
                         "15 frames/s", f"{1 / f['wall_per_frame']:.1f} frames/s"])
        else:
            rows.append([f"100,000 bubbles built, equilibrated, {f['frames']} frames, all cores",
                         f"{f['wall_in_all']:.0f} s, {f['memory_mib'] / 1024:.2f} GiB", "", "300 s, 4 GiB",
                         f"{f['wall_in_all']:.0f} s"])
    for thesis in (f for f in figures["foam"] if f["work"] == "thesis"):
        where = "on one core" if thesis["cores"] == 1 else "on all cores"
        rows.append([f"the thesis's test, {where}: {thesis['bubbles']:,} bubbles, {thesis['frames']:,} frames "
                     "(72 min on its GPU, 383 on its CPU)",
                     seconds(thesis["wall_in_all"]), "", "15 s", seconds(thesis["wall_in_all"])])
    for work, boundary in (("build_free", "free"), ("build_periodic", "periodic")):
        build = find(figures, "foam", work)
        if build:
            rows.append([f"mesh of a million points, {boundary}", seconds(build["cpu"]), "", "10 s",
                         seconds(build["cpu"])])
    memory = find(figures, "foam", "memory")
    if memory:
        own = (memory["bytes_per_bubble"] - memory["system_bytes_per_bubble"]) / 1000
        rows.append(["memory for each of 100,000 bubbles but for the matrix and its factorisation", f"{own:.2f} kB", "",
                     "2 kB", f"{own:.2f} kB"])
    return [row for row in rows if row]


def table(header, rows):
    lines = ["| " + " | ".join(map(str, row)) + " |" for row in [header, ["---"] * len(header), *rows]]
    return "\n".join(lines)


def plot(figures, path):
    figure, axes = plt.subplots(1, 3, figsize=(12, 3.8), sharey=True)
    curves = {"equilibrium": ("From random points to equilibrium", "cpu"),
              "steps": ("A coarsening step, ours to 1e-9", "cpu_per_frame"),
              "frames": ("A frame of the thesis's constants, to 1e-6", "cpu_per_frame")}
    for axis, (work, (title, key)) in zip(axes, curves.items()):
        for name, program in (("Foam", "foam"), ("Surface Evolver", "evolver")):
            points = sorted((f["bubbles"], f.get(key, f["cpu"] if program == "evolver" else None))
                            for f in figures[program] if f["work"] == work and f.get("cores", 1) == 1)
            if points:
                axis.loglog(*zip(*points), "o-", color=COLOURS[name], label=name, markersize=4)
        axis.set_title(title, fontsize=10)
        axis.set_xlabel("bubbles")
        axis.grid(which="major", color="#dddddd")
        axis.spines[["top", "right"]].set_visible(False)
    axes[0].set_ylabel("processor time, s")
    axes[0].legend(frameon=False)
    figure.tight_layout()
    figure.savefig(path, dpi=110)


def write(path, figures):
    path.parent.mkdir(parents=True, exist_ok=True)
    plot(figures, path.parent / "time_against_size.png")
    unconverged = sum(f.get("unconverged", 0) for f in figures["foam"])
    details = [[f["work"], f["bubbles"], f["cores"], f.get("frames", ""),
                seconds(f.get("cpu_per_frame", f.get("cpu"))), seconds(f.get("wall_per_frame", f.get("wall"))),
                f"{f['residual']:.1g}" if "residual" in f else "", f.get("t1", ""), f.get("t2", ""),
                f"{f['memory_mib']:.0f}"] for f in figures["foam"] if f["work"] != "memory"]
    lengths = [[e["bubbles"], f"{f['length']:.4f}", f"{e['length']:.4f}", f"{100 * (f['length'] / e['length'] - 1):+.2f} %"]
               for e in figures["evolver"] if e["work"] == "equilibrium"
               for f in figures["foam"] if f["work"] == "equilibrium" and f["bubbles"] == e["bubbles"]]
    path.write_text(f"""# How fast it is

Every figure on this page was measured in one run of `benchmarks/compare.py`, on {figures["machine"]}, which had a load
average of {figures["load"]:.1f} from other work when it began (other work on the same cores makes both programs slower).
Make the page anew with

    scripts/benchmark

Surface Evolver ([K. A. Brakke](https://kenbrakke.com/evolver/evolver.html), Debian's package `evolver`) is given the
very foam that ours starts from, with circular arcs for edges, and the commands in `benchmarks/evolver/`. Times are
processor times on one core unless all cores are named. Frames that did not reach equilibrium: {unconverged}.

{table(["work", "Foam", "Surface Evolver", "goal", "reached"], goal_rows(figures))}

![Time against the number of bubbles](time_against_size.png)

[Where the time goes](profile.md), and why a goal is missed. [On the GPU](cuda.md).

A coarsening step is one of the Evolver script's: areas grow by 0.01(n − 6) at mean area 1. Ours ends at a residual of
1e-9, Evolver's where its energy stands still or after its 25 rounds. A frame has the thesis's constants (Δt = 1/30 s)
at 4.4 cm a bubble, on a torus, to a tolerance of 1e-6.

From the same start the two need not find the same equilibrium, since it depends on the order of the T1s; total film
lengths (cm):

{table(["bubbles", "Foam", "Surface Evolver", "difference"], lengths)}

## All figures

{table(["work", "bubbles", "cores", "frames", "processor time", "wall time", "residual", "T1s", "T2s", "memory, MiB"],
       details)}

Processor and wall time of `frames`, `steps` and `thesis` are those of one frame; memory is the process's peak.
""")

# SPDX-License-Identifier: GPL-3.0-or-later
"""The page's sections, one for each experiment."""
import numpy as np

from thesis_experiments import plots, published, scale
from thesis_experiments.markdown import as_published, figure, number, table
from thesis_experiments.running import SWEEP_METHODS

ANOMALIES = {"Inverted": "inverted junctions", "Crossing": "pairs of films that cross",
             "NegativeArea": "bubbles with area of the wrong sign"}


def sweeps(foams, about, folder):
    labels = {name: method.label for name, method in SWEEP_METHODS.items()}
    plots.plot_sweeps(foams, labels, folder / "sweeps.png")
    limit = published.number("constants", "MaximumIterations")
    count = len(foams["Seed"])

    def measured(name):
        iterations, seconds = foams[f"{name}Iterations"], foams[f"{name}CpuSeconds"]
        divergent = 100 * np.mean(iterations >= limit)
        return [number(x) for x in (count, iterations.max(), iterations.min(), iterations.mean(), seconds.max(),
                                    seconds.min(), seconds.mean(), divergent,
                                    100 * np.mean(foams[f"{name}Converged"] == 0),
                                    np.median(foams[f"{name}MaxAngleError"]))]

    def quoted(name):
        return [as_published(published.text("4.13", "simulations"))] + [
            published.text("4.13", f"{name} {what}") for what in
            ("maximum", "minimum", "mean", "maximum seconds", "minimum seconds", "mean seconds", "divergent percent")
        ] + ["–", "–"]

    quantities = ["foams", "most iterations", "fewest", "mean", "longest time / s", "shortest", "mean time / s",
                  f"not at rest after {number(limit)} iterations / %", "marked as not converged / %",
                  "largest angle error / rad, median"]
    columns = [quoted("GaussSeidel"), measured("GaussSeidel"), quoted("Jacobi"), measured("Jacobi"), measured("Newton")]
    means = {name: foams[f"{name}Iterations"].mean() for name in labels}
    theirs = {name: published.number("4.13", f"{name} mean") for name in ("GaussSeidel", "Jacobi")}
    same = (means["Jacobi"] < means["GaussSeidel"]) == (theirs["Jacobi"] < theirs["GaussSeidel"])
    return f"""\
## Gauss–Seidel against Jacobi (thesis {published.where("4.13")})

The first equilibria of {number(count)} foams of {number(about["bubbles"])} bubbles, as many as fit into the
time given (the thesis: {as_published(published.text("4.13", "simulations"))}). The thesis measured an early version of
its method, without the Energy Decay Constraint; so do these, without either constraint. Times are processor times,
those of all threads added up.

{table(["", "Gauss–Seidel, thesis", "run here", "Jacobi, thesis", "run here", "Newton"],
       [[quantity, *values] for quantity, *values in zip(quantities, *columns)])}

Jacobi takes {number(means["Jacobi"])} iterations on average against {number(means["GaussSeidel"])} of Gauss–Seidel;
{"also in the thesis" if same else "in the thesis it is the other way round:"} {number(theirs["Jacobi"])}
against {number(theirs["GaussSeidel"])}. Newton takes
{number(means["Newton"])}, each of which solves for the whole foam, and is the only one of the three whose result is an
equilibrium.

{figure(folder / "sweeps.png", "Iterations against time for every foam, as in the thesis's Figure 4.14.")}"""


def evolution(experiment, found, folder):
    thesis, newton = found.get("thesis"), found.get("newton")
    pictures = {name: folder / f"{experiment.name}-{name}.png" for name in ("frames", "development", "sides", "work")}
    plots.draw_frames(found, pictures["frames"])
    plots.plot_development(found, experiment.section, pictures["development"])
    plots.plot_sides(found, pictures["sides"])
    plots.plot_work(found, pictures["work"])
    aboav = f"{published.text('reference', 'aboav_slope')}n + {published.text('reference', 'aboav_offset')}"
    header = ["", "thesis", *(plots.NAMES[name] for name in found)]
    rows = [[name, quoted, *(values(result) for result in found.values())]
            for name, quoted, values in evolution_rows(experiment, found)]
    about = next(iter(found.values())).about
    small = about["bubbles"] != published.number(experiment.section, "bubbles")
    return "\n\n".join([
        f"## {experiment.title} (thesis {published.where(experiment.section)})",
        f"In miniature, with {number(about['bubbles'])} bubbles." if small else "", "\n".join(
            f"- {plots.NAMES[name]}{constraint(name, result)}: {progress(result)}" for name, result in found.items()),
        table(header, rows), comparison(thesis, newton) if thesis and newton else "", remark(experiment, found),
        figure(pictures["frames"], "Frames shown in the thesis, and the last one of each run. Frame 1 is the first "
                                   "equilibrium."),
        figure(pictures["development"], "Number of bubbles, with the boundary and without (dotted), and μ₂: mean and "
                                        f"range. The dashed line is the μ₂ = {published.text('reference', 'mu2')} "
                                        "of Stavans and Glazier."),
        figure(pictures["sides"], "Distribution of the number of sides without the boundary (filled) and with it "
                                  f"(outlined), and Aboav–Weaire's n·m(n) without the boundary against "
                                  f"{aboav} (dashed)."),
        figure(pictures["work"], "Iterations, topological operations and time. Newton's iterations are solutions for a "
                                 "patch or the whole foam, the thesis's sweeps over all junctions.")])


def remark(experiment, found):
    """What an experiment says about the scale."""
    if experiment.section == "6.1.1":
        frames = {name: result.last("Frame") for name, result in found.items() if "left" in result.about["status"]}
        theirs = published.number("6.1.1", "frames")
        return " ".join(
            f"With {'the ' if name == 'thesis' else ''}{plots.NAMES[name]} it takes {number(count)} frames until "
            f"no more than three are left; since times go with the square of lengths, the thesis's {number(theirs)} frames stand for a spacing of "
            f"{number(scale.spacing() * np.sqrt(theirs / count))} cm." for name, count in frames.items())
    if experiment.section == "6.2":
        lost = published.number("6.2", "bubbles") - published.number("6.2", "bubbles left")
        smallest = min(result.frames["SmallestArea"][0] for result in found.values())
        limit = published.number("constants", "T2Area")
        return (f"The thesis loses {number(lost)} bubbles in its first frame. Here the smallest bubble of the first "
                f"equilibrium has {number(smallest)} cm², {number(smallest / limit)} times the T2 area: "
                + ("at this scale none is about to vanish." if smallest > limit else "some are about to vanish."))
    return ""


def constraint(name, result):
    return f" ({result.about['label']})" if name == "thesis" else ""


def progress(result):
    about = result.about
    frame = number(result.last("Frame"))
    goal = number(about["steps"] * about["frames_per_step"] + 1)
    steps = number(len(result.frames["Frame"]) - 1)
    return (f"{steps} steps of {number(about['time_step'])} s, up to frame {frame} of {goal} (t = "
            f"{number(result.last('Time'))} s): {about['status']}; on {about['cores']} cores{looked_for(about)}.")


def looked_for(about):
    every = about["examine_every"]
    return f", with anomalies looked for in {'every step' if every == 1 else f'one of {every} steps'}" if every else ""


def evolution_rows(experiment, found):
    """Triples of a quantity, what the thesis says, and what measures it in a result."""
    def quoted(name):
        return as_published(published.text(experiment.section, name))

    common = min(result.last("Time") for result in found.values())
    yield "bubbles at first", quoted("bubbles"), lambda r: number(r.frames["Bubbles"][0])
    if experiment.section == "6.2":
        yield "bubbles in the second frame", quoted("bubbles left"), lambda r: number(r.frames["Bubbles"][1])
    else:
        yield f"bubbles left at t = {number(common)} s", "–", lambda r: number(r.at(common, "Bubbles"))
    yield "bubbles left in the last frame", quoted("bubbles left"), lambda r: number(r.last("Bubbles"))
    yield ("last frame", number(published.number(experiment.section, "frames")), lambda r: number(r.last("Frame")))
    yield "μ₂ with boundary, last quarter", quoted("mu2 with boundary"), lambda r: number(late(r, "Mu2"))
    yield "μ₂ without boundary, last quarter", quoted("mu2 without boundary"), lambda r: number(late(r, "BulkMu2"))
    yield "gas left / %", "–", lambda r: number(100 * gas_left(r))
    if experiment.section != "6.2":
        yield "growth of ⟨A⟩ without boundary, second half / K", "–", lambda r: number(growth(r))
    for name in ("T1", "T2", "T3"):
        yield f"{name}s", "–", lambda r, name=name: number(r.last(f"{name}Count"))
    yield "largest angle error / rad, median", "–", lambda r: number(np.median(r.frames["MaxAngleError"]))
    yield "largest area error, median", "–", lambda r: number(np.median(r.frames["MaxAreaError"]))
    yield "frames marked as not converged / %", "–", lambda r: number(100 * np.mean(r.frames["Converged"] == 0))
    for name, label in ANOMALIES.items():
        yield f"{label}, per 1,000 frames", "–", lambda r, name=name: number(per_thousand(r, name))
    yield "iterations per step", "–", lambda r: number(r.frames["Iterations"].mean())
    yield "wall time per step / s", "–", lambda r: number(r.frames["WallSeconds"].mean())
    yield "wall time per simulated second / s", "–", lambda r: number(
        r.frames["WallSeconds"].sum() / max(r.last("Time"), r.about["time_step"]))


def late(result, column):
    """The mean of a column over the last quarter of the frames."""
    values = result.frames[column]
    values = values[-max(1, len(values) // 4):]
    values = values[np.isfinite(values)]
    return values.mean() if len(values) else np.nan


def gas_left(result):
    return result.frames["Gas"][-1] / result.frames["Gas"][0]


def growth(result):
    """d⟨A⟩/dt of the bulk over the second half of the run, in units of K."""
    half = result.frames["Time"] >= result.last("Time") / 2
    seconds, area = result.frames["Time"][half], result.frames["BulkMeanArea"][half]
    there = np.isfinite(area)
    if there.sum() < 3:
        return np.nan
    return np.polyfit(seconds[there], area[there], 1)[0] / scale.diffusion_constant()


def per_thousand(result, name):
    """Anomalies per 1,000 frames, from the examined ones."""
    return 1000 * result.quality[name].mean() if result.quality else np.nan


def frames_with_anomaly(result):
    """Frames with any anomaly, per 1,000."""
    return 1000 * np.mean(sum(result.quality[name] for name in ANOMALIES) > 0) if result.quality else np.nan


def comparison(thesis, newton):
    seconds = min(thesis.last("Time"), newton.last("Time"))
    bubbles = {name: result.at(seconds, "Bubbles") for name, result in (("thesis", thesis), ("newton", newton))}
    difference = 100 * (bubbles["thesis"] / bubbles["newton"] - 1)
    faster = (newton.frames["WallSeconds"].sum() / newton.last("Time")
              / (thesis.frames["WallSeconds"].sum() / thesis.last("Time")))
    words = (f"{number(1 / faster)} times as long as Newton" if faster < 1 else
             f"1/{number(faster)} of the time that Newton takes")
    return (f"At t = {number(seconds)} s, the last time that both reached, the thesis's method has "
            f"{number(bubbles['thesis'])} bubbles and Newton {number(bubbles['newton'])}, a difference of "
            f"{number(abs(difference), 2)} %. Per simulated second the thesis's method takes {words}. "
            f"{number(frames_with_anomaly(thesis))} of 1,000 frames of the thesis's method and "
            f"{number(frames_with_anomaly(newton))} of Newton's have an anomaly of at least one kind.")


def median(result, column):
    values = result.quality.get(column, np.array([]))
    values = values[np.isfinite(values)]
    return np.median(values) if len(values) else np.nan


def distance(found, missing, folder):
    plots.plot_distance(found, folder / "distance.png")
    header = ["", *(result.about["label"] for result in found.values())]
    quantities = [
        ("largest angle error / rad", lambda r: median(r, "MaxAngle")),
        ("mean angle error / rad", lambda r: median(r, "MeanAngle")),
        ("largest area error", lambda r: median(r, "MaxArea")),
        ("mean area error", lambda r: median(r, "MeanArea")),
        ("excess energy", lambda r: median(r, "Excess")),
        ("excess energy at target areas", lambda r: median(r, "ExcessAtTargets")),
        *((f"{label}, per 1,000 frames", lambda r, name=name: per_thousand(r, name))
          for name, label in ANOMALIES.items()),
        ("frames with an anomaly, per 1,000", frames_with_anomaly),
        ("frames marked as not converged, per 1,000", lambda r: 1000 * np.mean(r.frames["Converged"] == 0)),
        ("frames done", lambda r: r.last("Frame")),
        ("bubbles left", lambda r: r.last("Bubbles")),
        ("wall time per frame / s", lambda r: r.frames["WallSeconds"].mean()),
    ]
    first = next(iter(found.values()))
    notes = "".join(f"\n\n*{label}* is missing: {status}." for label, status in missing.items())
    statuses = ", ".join(f"{result.about['label']}: {result.about['status']}" for result in found.values())
    caption = ("Mean (filled) and largest (open) error of each method: medians and ranges over the examined frames. "
               "Excess energies are absolute values.")
    return f"""\
## How far from equilibrium each method stops

The same {number(first.about["bubbles"])} points, relaxed and coarsened in steps of
{number(first.about["time_step"])} s by the thesis's method with each of its constraints, by the root search on energies
instead of angles that it proposes in Section 7.1.1, and by
Newton. Errors are medians over the examined frames: of the deviation of angles from 120°, in the worst junction and on
average over the junctions, and of areas from their targets. Excess energy is relative to Newton's equilibrium of the
same frame, found from the frame's films without diffusion or thresholds; since bubbles that are smaller than they ought
to be have shorter films, it is also given with the work p·(A^τ − A) added that their missing area would take. Where a
bubble is inside out there is no such equilibrium, and the frame is left out. Films are tested for crossings as sampled
in the output.

{table(header, [[name, *(number(measure(result)) for result in found.values())] for name, measure in quantities])}

Runs: {statuses}.{notes}

{figure(folder / "distance.png", caption)}

{verdicts(found)}"""


def verdicts(found):
    """What the table says, in sentences."""
    sentences = []
    constrained = {name: found[name] for name in ("energy-decay", "orientation-invariant", "both", "neither")
                   if name in found}
    if constrained:
        best = min(constrained.values(), key=lambda r: median(r, "MeanAngle"))
        calmest = min(constrained.values(), key=frames_with_anomaly)
        sentences.append(
            f"Of the thesis's variants *{best.about['label']}* comes nearest to 120°, with a mean angle error of "
            f"{number(median(best, 'MeanAngle'))} rad, and *{calmest.about['label']}* has the fewest frames with "
            f"anomalies, {number(frames_with_anomaly(calmest))} of 1,000.")
    if "newton" in found:
        newton = found["newton"]
        sentences.append(f"Newton's mean angle error is {number(median(newton, 'MeanAngle'))} rad, and "
                         f"{number(frames_with_anomaly(newton))} of 1,000 of its frames have an anomaly.")
    for name in ("energies-zero", "energies-straight"):
        if name in found and "neither" in found:
            sentences.append(promise(found[name], found["neither"]))
    return " ".join(sentences)


def promise(energies, angles):
    """Whether the energy-based root search does without constraints what the angles cannot (7.1.1)."""
    fewer = frames_with_anomaly(energies) < frames_with_anomaly(angles)
    nearer = median(energies, "MeanAngle") <= median(angles, "MeanAngle")
    kept = {(True, True): "keeps its promise here", (True, False): "keeps half of its promise: it goes wrong less "
            "often, but stops farther from equilibrium", (False, True): "keeps half of its promise: it comes nearer to "
            "equilibrium, but does not go wrong less often", (False, False): "does not keep its promise here"}
    return (f"The root search on *{energies.about['label']}* has {number(frames_with_anomaly(energies))} frames with "
            f"anomalies of 1,000 and a mean angle error of {number(median(energies, 'MeanAngle'))} rad, against "
            f"{number(frames_with_anomaly(angles))} and {number(median(angles, 'MeanAngle'))} rad of the angles "
            f"without constraint: it {kept[fewer, nearer]}.")


def algorithms(found):
    header = ["", *(result.about["label"] for result in found.values())]
    quantities = [
        ("frames done", lambda r: r.last("Frame")),
        ("bubbles left", lambda r: r.last("Bubbles")),
        *((f"{name}s", lambda r, name=name: r.last(f"{name}Count")) for name in ("T1", "T2", "T3")),
        ("bubbles that ought to have vanished, per 1,000 frames", lambda r: per_thousand(r, "Unfinished")),
        *((f"{label}, per 1,000 frames", lambda r, name=name: per_thousand(r, name))
          for name, label in ANOMALIES.items()),
        ("frames with an anomaly, per 1,000", frames_with_anomaly),
        ("frames marked as not converged, per 1,000", lambda r: 1000 * np.mean(r.frames["Converged"] == 0)),
        ("mean angle error / rad, median", lambda r: median(r, "MeanAngle")),
        ("iterations per frame", lambda r: r.frames["Iterations"].mean()),
        ("wall time per frame / s", lambda r: r.frames["WallSeconds"].mean()),
    ]
    first = next(iter(found.values()))
    left = {result.about["label"]: per_thousand(result, "Unfinished") for result in found.values()}
    most, fewest = max(left, key=left.get), min(left, key=left.get)
    verdict = "" if len(found) < 2 else ("They leave equally many operations undone." if left[most] == left[fewest] else
               f"*{most}* leaves the most operations undone, *{fewest}* the fewest.")
    return f"""\
## The topological algorithms (thesis Section 4.3)

{number(first.about["bubbles"])} bubbles with the Energy Decay Constraint, coarsened with each of the three algorithms
for topological operations. A cascade is unfinished where after a frame's operations a three-sided bubble is left
whose target area is below the T2 area.

{table(header, [[name, *(number(measure(result)) for result in found.values())] for name, measure in quantities])}

{verdict}"""

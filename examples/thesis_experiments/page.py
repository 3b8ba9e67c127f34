# SPDX-License-Identifier: GPL-3.0-or-later
"""The page: what was run, what came out, beside the thesis's numbers. Its numbers are those of the result files."""
import json

from thesis_experiments import experiments, published, results, scale, sections
from thesis_experiments.markdown import as_published, number, table, wrapped

TITLE = "# The thesis's experiments, run again"

INTRODUCTION = f"""\
B. K. Vedel-Larsen, *Quasi-static Simulation of Foam in the Vertex Model* (University of Copenhagen, 2010), relaxes a
dry foam junction by junction and shows what becomes of foams of {published.text("6.1.1", "bubbles")} to
{as_published(published.text("6.1.2", "bubbles"))} bubbles. Here its experiments are run again:
by its own method (`Equilibrator` *Junction*, two-sided bubbles sliding to a corner) and by the default, *Newton*, which
solves for all junctions, films and pressures at once and steps from one topological event to the next. Both start from
the same points. The thesis's results are mostly pictures; the columns *thesis* quote what its text, tables and captions
say. In the figures the thesis's method is orange, Newton blue, and what the thesis or the literature says grey.

The page is written by `examples/thesis.py` from the results of its runs, numbers and sentences about numbers
included."""


def write(path, folder):
    """Writes the page and, in a folder beside it that has its name, its figures."""
    figures = path.with_suffix("")
    parts = [TITLE, INTRODUCTION, scale_section()]
    foams = folder / experiments.SWEEPS.name / "foams.csv"
    if foams.exists():
        parts.append(sections.sweeps(results.columns(foams), json.loads(foams.with_suffix(".json").read_text()),
                                     figures))
    for experiment in experiments.EVOLUTIONS:
        found = results.read(folder, experiment)
        if found:
            parts.append(sections.evolution(experiment, found, figures))
    distance = results.read(folder, experiments.DISTANCE)
    if distance:
        parts.append(sections.distance(distance, without_results(folder, experiments.DISTANCE, distance), figures))
    algorithms = results.read(folder, experiments.ALGORITHMS)
    if algorithms:
        parts.append(sections.algorithms(algorithms))
    results.write_whole(path, lambda unfinished: unfinished.write_text(wrapped("\n\n".join(parts)) + "\n"))


def without_results(folder, experiment, found):
    """The statuses of the runs that were not run, or went wrong before their first frame was there."""
    statuses = {}
    for run in experiment.runs:
        about = folder / experiment.name / f"{run.name}.json"
        if run.name not in found and about.exists():
            statuses[run.method.label] = json.loads(about.read_text())["status"]
    return statuses


def scale_section():
    spacings = {section: scale.spacing_of(section) for section in ("6.1.2", "6.1.3")}
    deviation = spacings["6.1.3"] / spacings["6.1.2"] - 1
    rows = [[section, *(as_published(published.text(section, name)) for name in ("bubbles", "bubbles left", "frames")),
             number(spacing)] for section, spacing in spacings.items()]
    constants = table(["constant", "value"], [[f"`{name}`", f"{value:.4g}"] for name, value in
                                              {**published.constants(), "TimeStep": scale.time_step()}.items()])
    return f"""\
## Constants and scale

All runs use the constants of the thesis's Figures 4.19 and 6.2, under the names that they have in the filters:

{constants}

They leave the size of the bubbles open. In the scaling state the mean area grows linearly, ⟨A⟩ = ⟨A⟩₀ + g·K·t with
g = {scale.GROWTH} and K = (2π/3)γκ = {number(scale.diffusion_constant())} cm²/s, and while a foam keeps its gas
⟨A⟩ is inversely proportional to the number of bubbles. With one point per s² the numbers in the thesis's text then give
the spacing s of its grid:

{table(["section", "bubbles at first", "left", "frames", "s / cm"], rows)}

The two differ by {number(100 * abs(deviation), 2)} %. All runs use **s = {scale.spacing()} cm**, where the T1 length is
{number(100 * published.number("constants", "T1Length") / scale.spacing(), 2)} % of the spacing and the T2 area
{number(100 * published.number("constants", "T2Area") / scale.spacing() ** 2, 2)} % of the mean area. A free
foam also loses gas through its boundary, which the estimate leaves out; how much, the tables below say."""

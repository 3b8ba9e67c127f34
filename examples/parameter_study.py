# SPDX-License-Identifier: GPL-3.0-or-later
"""A parameter study: how long does a foam remember how orderly it began?

    pvpython examples/parameter_study.py [--jitter 0.2 0.4 0.7 1] [--bubbles 1000] [--frames 120]

Points on square grids, disturbed more or less, become foams, and these coarsen. How unequal their bubbles are,
⟨A²⟩/⟨A⟩², is plotted against the mean bubble area, which grows with time: runs that begin apart come together.
"""
from foam_plugin import *


def coarsening(jitter, bubbles, frames):
    """A row of figures per frame of a periodic foam."""
    points = FoamPoints(NumberOfPoints=bubbles, Jitter=jitter)
    foam = FoamFromPoints(Input=points, Boundary="Periodic")
    coarsen = FoamCoarsen(Input=foam, NumberOfFrames=frames, TimeStep=0.1)
    statistics = FoamStatistics(Input=coarsen)
    return [{"Jitter": jitter, **first_row(statistics, time)} for time in coarsen.TimestepValues]


def main():
    options = read_options(__doc__, "output/study", jitter=[0.2, 0.4, 0.7, 1.0], bubbles=1000, frames=120)
    figure, axes = plt.subplots(figsize=(6.4, 4.2), dpi=150, layout="constrained")
    rows = []
    colours = plt.cm.viridis(np.linspace(0, 0.85, len(options.jitter)))
    for jitter, colour in zip(options.jitter, colours):
        run = coarsening(jitter, options.bubbles, options.frames)
        first, last = run[0], run[-1]
        print(f"jitter {jitter}: from {first['Bubbles']} bubbles with ⟨A²⟩/⟨A⟩² = {first['AreaSecondMoment']:.2f} "
              f"to {last['Bubbles']} with {last['AreaSecondMoment']:.2f}")
        areas, moments = zip(*((row["MeanArea"], row["AreaSecondMoment"]) for row in run))
        axes.plot(areas, moments, color=colour, label=f"jitter {jitter}")
        rows += run
    axes.set(xlabel="mean bubble area / cm²", ylabel="⟨A²⟩/⟨A⟩²", ylim=(1, None))
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False)
    figure.savefig(options.output / "area_moments.png")
    write_table(options.output / "study.csv", rows)
    print(f"Plot and table are in {options.output}/")


if __name__ == "__main__":
    run(main)

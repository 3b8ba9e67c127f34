# SPDX-License-Identifier: GPL-3.0-or-later
"""Does shear speed coarsening up? Foams that coarsen and are sheared meanwhile, more and more.

    pvpython examples/shear_and_coarsen.py [--rates 0 1 4] [--bubbles 400] [--frames 100] [--runs 4]

Steps of coarsening and of quasi-static shear take turns. Time is in units of ⟨A⟩/K at the start, with von Neumann's
constant K; a rate is the strain in such a time. The mean area then grows by about the same in each unit.
"""
from foam_plugin import *
from vtkmodules.vtkCommonDataModel import vtkPolyData

LENGTH = 3  # of a run, in units of ⟨A⟩/K


def coarsening(rate, bubbles, frames, seed):
    """Mean area, over the first, and number of T1s a bubble of the start, by frame."""
    foam = FoamFromPoints(Input=FoamPoints(NumberOfPoints=bubbles, Seed=seed), Boundary="Periodic")
    first = first_row(FoamStatistics(Input=foam))
    step = LENGTH / frames * first["MeanArea"] / (2 * np.pi / 3 * foam.SurfaceTension)
    source, films, rows = TrivialProducer(), result(foam), [(1, 0)]
    source.GetClientSideObject().SetOutput(films)
    last = coarsen = FoamCoarsen(Input=source, TimeStep=step, NumberOfFrames=1)
    if rate > 0:
        last = FoamDeform(Input=coarsen, StrainStep=rate * LENGTH / frames, NumberOfFrames=1)
    statistics = FoamStatistics(Input=last)
    for _ in range(frames):
        start = vtkPolyData()
        start.DeepCopy(films)
        source.GetClientSideObject().SetOutput(start)
        source.MarkModified(source.SMProxy)
        last.UpdatePipelineInformation()
        end = last.TimestepValues[-1]
        films, row = result(last, 0, end), first_row(statistics, end)
        rows.append((row["MeanArea"] / first["MeanArea"], row["T1Count"] / bubbles))
    return np.array(rows)


def main():
    options = read_options(__doc__, "output/shear_and_coarsen", rates=[0.0, 1.0, 4.0], bubbles=400, frames=100, runs=4)
    figure, axes = plt.subplots(figsize=(6.4, 4.2), dpi=150, layout="constrained")
    time = np.linspace(0, LENGTH, options.frames + 1)
    late, table = time >= LENGTH / 2, []
    for rate, colour in zip(options.rates, plt.cm.viridis(np.linspace(0, 0.85, len(options.rates)))):
        runs = np.array([coarsening(rate, options.bubbles, options.frames, seed + 1) for seed in range(options.runs)])
        growth = [np.polyfit(time[late], run[late, 0], 1)[0] for run in runs]
        error = np.std(growth, ddof=1) / np.sqrt(len(growth)) if len(growth) > 1 else math.nan
        print(f"rate {rate:g}: ⟨A⟩ grows by {np.mean(growth):.3f} ± {error:.3f} K in the second half, "
              f"{runs[:, -1, 1].mean():.2f} T1s a bubble")
        axes.plot(time, runs[:, :, 0].mean(axis=0), color=colour, label=f"strain rate {rate:g}")
        table += [{"Rate": rate, "Time": t, "MeanArea": area} for t, area in zip(time, runs[:, :, 0].mean(axis=0))]
    axes.set(xlabel="time / (⟨A⟩/K at the start)", ylabel="mean area / its first")
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False)
    figure.savefig(options.output / "growth.png")
    write_table(options.output / "growth.csv", table)


if __name__ == "__main__":
    run(main)

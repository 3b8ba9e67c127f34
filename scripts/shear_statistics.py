# SPDX-License-Identifier: GPL-3.0-or-later
"""The figures of docs/shear.md: disordered foams that are sheared far beyond yield.

    PYTHONPATH=build/release/lib/python python3 scripts/shear_statistics.py OUTPUT [--foams 10] [--bubbles 1000]

Writes OUTPUT/SEED.csv with a row a frame for each foam, unless it is there, and prints means over the foams with 95 %
confidence intervals. Stresses are in units of T/√⟨A⟩, after the frozen stress of the foam at rest has been taken off.
"""
import argparse
import csv
import math
from pathlib import Path

import numpy as np
from scipy import stats

from foam.vtkFoamFilters import vtkFoamDeform, vtkFoamFromPoints, vtkFoamPoints, vtkFoamStatistics

STEP, STRAIN, FLOWING = 0.02, 4.0, 1.5  # FLOWING: from this strain on a foam has forgotten its start


def deformation(seed, bubbles):
    """A periodic foam of random points, as the filter that shears it."""
    points, foam, deform = vtkFoamPoints(), vtkFoamFromPoints(), vtkFoamDeform()
    points.SetNumberOfPoints(bubbles)
    points.SetSeed(seed)
    points.SetJitter(1)
    foam.SetInputConnection(points.GetOutputPort())
    foam.SetBoundary(vtkFoamFromPoints.Periodic)
    deform.SetInputConnection(foam.GetOutputPort())
    deform.SetStrainStep(STEP)
    deform.SetNumberOfFrames(round(STRAIN / STEP))
    return deform


def sheared(seed, bubbles):
    """Rows of its figures, frame by frame."""
    deform, statistics = deformation(seed, bubbles), vtkFoamStatistics()
    statistics.SetInputConnection(deform.GetOutputPort())
    for frame in range(round(STRAIN / STEP) + 1):
        statistics.SetShearModulus(frame == 0)
        statistics.UpdateTimeStep(frame * STEP)
        table = statistics.GetOutput(0)
        row = {table.GetColumnName(i): table.GetColumn(i).GetValue(0) for i in range(table.GetNumberOfColumns())}
        field = deform.GetOutput(0).GetFieldData()
        unit = 2 * field.GetArray("SurfaceTension").GetValue(0) / math.sqrt(row["MeanArea"])
        yield {"strain": row["Strain"], "modulus": row.get("ShearModulus", math.nan) / unit,
               "stress": row["StressXY"] / unit, "normal": row["NormalStressDifference"] / unit,
               "energy": row["Energy"], "t1s": row["T1Count"] / bubbles, "second_moment": row["AreaSecondMoment"],
               "residual": field.GetArray("Residual").GetValue(0)}


def figures(rows):
    """Those of one foam."""
    run = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    flowing = run["strain"] > FLOWING
    stress, normal = run["stress"] - run["stress"][0], run["normal"] - run["normal"][0]
    flow = stress[flowing].mean()
    drops = -np.diff(stress[flowing])
    return {"shear modulus": run["modulus"][0], "flow stress": flow, "flow stress / modulus": flow / run["modulus"][0],
            "largest stress / flow stress": stress.max() / flow,
            "strain of the largest stress": run["strain"][stress.argmax()],
            "normal stress difference": normal[flowing].mean(),
            "T1s a bubble and unit of strain": np.ptp(run["t1s"][flowing]) / np.ptp(run["strain"][flowing]),
            "mean drop of stress in a frame": drops[drops > 0].mean(),
            "energy / its first": run["energy"][flowing].mean() / run["energy"][0],
            "⟨A²⟩/⟨A⟩²": run["second_moment"][0], "largest residual": run["residual"].max()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--foams", type=int, default=10)
    parser.add_argument("--bubbles", type=int, default=1000)
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    found = []
    for seed in range(1, options.foams + 1):
        path = options.output / f"{seed}.csv"
        if not path.exists():
            rows = list(sheared(seed, options.bubbles))
            with path.open("w", newline="") as file:
                writer = csv.DictWriter(file, rows[0])
                writer.writeheader()
                writer.writerows(rows)
        with path.open(newline="") as file:
            found.append(figures(list(csv.DictReader(file))))
        print(seed, {name: float(f"{value:.4g}") for name, value in found[-1].items()}, flush=True)
    for name in found[0] if len(found) > 1 else ():
        values = np.array([one[name] for one in found])
        half = stats.t.ppf(0.975, len(values) - 1) * stats.sem(values)
        print(f"| {name} | {values.mean():.4g} ± {half:.2g}, at most {values.max():.3g} |")


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes docs/pictures/shear_*.png of what scripts/shear_statistics.py has written:

    PYTHONPATH=build/release/lib/python python3 scripts/shear_pictures.py STATISTICS FOLDER
"""
import csv
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from shear_statistics import STRAIN, deformation
from vtkmodules.util.numpy_support import vtk_to_numpy


def curves(statistics):
    """Stress and normal stress difference of each foam, and their means."""
    runs = [list(csv.DictReader(path.open(newline=""))) for path in sorted(statistics.glob("*.csv"))]
    strain = np.array([float(row["strain"]) for row in runs[0]])
    figure, axes = plt.subplots(figsize=(7.4, 4.2), dpi=100, layout="constrained")
    for name, colour, label in (("stress", "#1f4e8c", "shear stress"),
                                ("normal", "#c8553d", "normal stress difference")):
        values = np.array([[float(row[name]) for row in run] for run in runs])
        values -= values[:, :1]
        axes.plot(strain, values.T, color=colour, lw=0.5, alpha=0.35)
        axes.plot(strain, values.mean(axis=0), color=colour, lw=2.2, label=label)
    modulus = np.mean([float(run[0]["modulus"]) for run in runs])
    axes.axline((0, 0), slope=modulus, color="0.6", lw=1, ls="--", label="shear modulus")
    axes.set(xlabel="strain", ylabel="stress / (T/√⟨A⟩)", xlim=(0, STRAIN), ylim=(-0.02, 0.6))
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, loc="upper left", ncols=3)
    return figure


def events():
    """Where T1s are across the flow, and at which strain, of one foam."""
    deform = deformation(1, 1000)
    deform.UpdateTimeStep(STRAIN)
    output = deform.GetOutput(2)
    y = vtk_to_numpy(output.GetPoints().GetData()).reshape(-1, 3)[:, 1]
    height = deform.GetOutput(0).GetFieldData().GetArray("PeriodVectors").GetValue(3)
    strain = vtk_to_numpy(output.GetPointData().GetArray("Strain"))
    figure, axes = plt.subplots(figsize=(7.4, 3.4), dpi=100, layout="constrained")
    axes.plot(strain, np.mod(y, height) / height, ".", ms=3.2, color="#1f4e8c", alpha=0.6, mew=0)
    axes.set(xlabel="strain", ylabel="place across the flow / height", xlim=(0, STRAIN), ylim=(0, 1))
    axes.spines[["top", "right"]].set_visible(False)
    return figure


if __name__ == "__main__":
    statistics, folder = map(Path, sys.argv[1:3])
    curves(statistics).savefig(folder / "shear_curves.png")
    events().savefig(folder / "shear_events.png")

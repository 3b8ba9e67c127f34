# SPDX-License-Identifier: GPL-3.0-or-later
"""Coarsens foams of many seeds, spread over processes, and pools p(n), μ₂ and growth rate with 95 % intervals.

    mpiexec -n 2 pvbatch --symmetric examples/ensemble.py [--seeds 16] [--bubbles 400] [--frames 90]
"""
import time
from math import pi

import foam_filters
from foam.vtkFoamFilters import (vtkFoamCoarsen, vtkFoamEnsembleStatistics, vtkFoamFromPoints, vtkFoamPoints,
                                 vtkFoamStatistics)
from foam_plugin import *
from vtkmodules.vtkCommonDataModel import vtkPartitionedDataSet, vtkTable
from vtkmodules.vtkParallelCore import vtkMultiProcessController


def member(seed, bubbles, frames):
    """Tables of a run: its last figures with the growth rate d⟨A⟩/dt over K = 2πγκ/3, and p(n)."""
    points, foam, coarsen, statistics = vtkFoamPoints(), vtkFoamFromPoints(), vtkFoamCoarsen(), vtkFoamStatistics()
    points.SetNumberOfPoints(bubbles)
    points.SetSeed(seed)
    foam.SetInputConnection(points.GetOutputPort())
    foam.SetBoundary(vtkFoamFromPoints.Periodic)
    coarsen.SetInputConnection(foam.GetOutputPort())
    statistics.SetInputConnection(coarsen.GetOutputPort())
    coarsen.SetTimeStep(1 / 30)
    coarsen.SetNumberOfFrames(frames)
    moments = coarsen.GetTimeStep() * np.arange(frames // 2, frames + 1)
    areas = []
    for moment in moments:
        statistics.UpdateTimeStep(moment)
        areas.append(statistics.GetOutput(0).GetColumnByName("MeanArea").GetValue(0))
    summary, by_sides = vtkTable(), vtkTable()
    summary.ShallowCopy(statistics.GetOutput(0))
    by_sides.ShallowCopy(statistics.GetOutput(1))
    diffusion = 2 * pi / 3 * foam.GetSurfaceTension() * coarsen.GetPermeability()
    add_arrays(summary.GetRowData(), {"GrowthRate": [np.polyfit(moments, areas, 1)[0] / diffusion]})
    return [summary, by_sides]


def main():
    options = read_options(__doc__, "output/ensemble", seeds=16, bubbles=400, frames=90)
    processes = vtkMultiProcessController.GetGlobalController()
    mine = range(1 + processes.GetLocalProcessId(), options.seeds + 1, processes.GetNumberOfProcesses())
    members = vtkPartitionedDataSet()
    for i, table in enumerate(t for seed in mine for t in member(seed, options.bubbles, options.frames)):
        members.SetPartition(i, table)
    print(f"Process {processes.GetLocalProcessId()}: seeds {list(mine)} in {time.process_time():.1f} s CPU", flush=True)
    ensemble = vtkFoamEnsembleStatistics()  # with all processes; the first has the result
    ensemble.SetInputDataObject(members)
    ensemble.Update()
    rows = rows_of(ensemble.GetOutput())
    if rows:
        write_table(options.output / "ensemble.csv", rows)
    for row in filter(lambda row: row["Quantity"] in ("Mu2", "GrowthRate", "Fraction"), rows):
        print("{Quantity:10} {Sides:2}: {Mean:.4f} from {Lower95:.4f} to {Upper95:.4f}".format(**row))


if __name__ == "__main__":
    run(main)

# SPDX-License-Identifier: GPL-3.0-or-later
"""What a frame of FoamCoarsen costs beyond the simulation: polylines, polygons, arrays, progress, ParaView's pipeline.

    FOAM_PLUGIN=…/Foam.so pvpython benchmarks/frame_in_paraview.py [BUBBLES [FRAMES]]

The same frames are computed twice: each of them requested and output, and only the last. What the first takes longer
is the cost of showing frames. Both are done three times in turn, and the fastest of each counts.
"""
import json
import math
import os
import sys
import time

from paraview import simple

simple.LoadPlugin(os.environ["FOAM_PLUGIN"], remote=False, ns=globals())

ROUNDS = 3
SPACING = 4.4  # cm, as the thesis's large foams


def coarsening(bubbles, frames):
    side = SPACING * math.ceil(math.sqrt(bubbles))
    points = FoamPoints(NumberOfPoints=bubbles, Spacing=SPACING)
    foam = FoamFromPoints(Input=points, Boundary="Periodic", PeriodicBounds=[0, side, 0, side], Tolerance=1e-6)
    return FoamCoarsen(Input=foam, NumberOfFrames=frames, TimeStep=1 / 30, Tolerance=1e-6,
                              KeyframeInterval=frames + 1)


def run(bubbles, frames, every_frame):
    """Seconds of wall time from the first frame to the last."""
    coarsen = coarsening(bubbles, frames)
    coarsen.UpdatePipeline(0)
    times = coarsen.TimestepValues
    begin = time.perf_counter()
    for t in times[1:] if every_frame else times[-1:]:
        coarsen.UpdatePipeline(t)
    seconds = time.perf_counter() - begin
    residual = coarsen.GetFieldDataInformation().GetArray("Residual").GetRange(0)[1]
    if residual > 1e-6:
        raise SystemExit(f"frame_in_paraview.py: the last frame has a residual of {residual}")
    simple.Delete(coarsen)
    return seconds


def main():
    bubbles = int(sys.argv[1]) if len(sys.argv) > 1 else 10000
    frames = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    times = [(run(bubbles, frames, True), run(bubbles, frames, False)) for _ in range(ROUNDS)]
    each, last = (min(column) / frames for column in zip(*times))
    print(json.dumps({"work": "frame_in_paraview", "bubbles": bubbles, "frames": frames, "wall_per_frame": each,
                      "wall_of_simulation": last, "share": 1 - last / each}))


main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings ParaView's window to where the tutorial presses Play, for its picture: paraview --script=tutorial_window.py

Makes the file that FOAM_READY names when it is there.
"""
import os
import sys
from pathlib import Path

sys.path.append(os.environ["FOAM_SCRIPTS"])
from run_tutorial import tutorial

for block in tutorial()[:4]:
    exec(block)

view = GetActiveViewOrCreate("RenderView")
SetProperties(view, InteractionMode="2D", OrientationAxesVisibility=0)
Show(OutputPort(coarsen, 1), view, Ambient=1, Diffuse=0)
films = Show(OutputPort(coarsen, 0), view, ColorArrayName=[None, ""], AmbientColor=[0.06, 0.09, 0.2],
             DiffuseColor=[0.06, 0.09, 0.2])
films.Representation = "Foam Films"
SetActiveSource(coarsen)
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.AnimationTime = coarsen.TimestepValues[50]
ResetCamera(view)
view.CameraParallelScale *= 0.88
Render(view)
Path(os.environ["FOAM_READY"]).touch()

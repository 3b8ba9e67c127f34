# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the tutorial's blocks of Python, all of them in order: pvpython run_tutorial.py FOLDER [--quick]

They leave in FOLDER what the tutorial says. With --quick the foam has a few frames only. FOAM_PLUGIN names the plugin.
"""
import os
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FEW = 4


def tutorial(quick=False):
    """The blocks, with the paths of this clone."""
    page = (ROOT / "docs/tutorial.md").read_text()
    page = re.sub(r'LoadPlugin\("[^"]+"', f'LoadPlugin({os.environ["FOAM_PLUGIN"]!r}', page)
    page = page.replace('"sample-data/', f'"{ROOT}/sample-data/')
    if quick:
        page = re.sub(r"NumberOfFrames=\d+", f"NumberOfFrames={FEW}", page)
    return re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)


if __name__ == "__main__":
    os.chdir(sys.argv[1])
    for block in tutorial("--quick" in sys.argv):
        exec(block)
    Disconnect()  # closes the view before Python ends

# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets Python find the filters' package, foam, of the newest build, unless PYTHONPATH leads to one already."""
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path += map(str, sorted(ROOT.glob("build/*/lib/python"), key=lambda path: path.stat().st_mtime, reverse=True))
try:
    import foam.vtkFoamFilters
except ImportError as error:
    sys.exit(f"The filters are not built, or PYTHONPATH does not lead to them: {error}")

# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the diagram of the architecture page shows the folders that there are, and who includes whom."""

import re
import subprocess
import unittest
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parent.parent.parent
SVG = "{http://www.w3.org/2000/svg}"
INCLUDE = re.compile(r'^\s*#include "((?:[\w.]+/)+[\w.]+)"', re.MULTILINE)
SOURCES = {".h", ".cpp", ".cxx", ".cu", ".cuh"}


class Diagram:
    """Nodes, and arrows as pairs (from, to): solid ones, and dashed ones, which the picture has head first."""

    def __init__(self, path):
        self.nodes, self.solid, self.dashed = set(), set(), set()
        for group in ElementTree.parse(path).iter(f"{SVG}g"):
            title = group.findtext(f"{SVG}title")
            if group.get("class") == "node":
                self.nodes.add(title)
            elif group.get("class") == "edge":
                tail, head = title.split("->")
                if group.find(f"{SVG}path").get("stroke-dasharray"):
                    self.dashed.add((head, tail))
                else:
                    self.solid.add((tail, head))

    def reachable(self, start):
        """The folders to which solid arrows lead, over others too."""
        found, ahead = set(), [start]
        while ahead:
            folder = ahead.pop()
            for head in {head for tail, head in self.solid if tail == folder} - found:
                found.add(head)
                ahead.append(head)
        return found

    def forbidden(self, includes):
        return {(a, b) for a, b in includes if b not in self.reachable(a) and (a, b) not in self.dashed}


def tracked_files():
    try:
        listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        raise unittest.SkipTest(f"which folders there are is asked of git: {error}")
    return [Path(line) for line in listed.stdout.splitlines()]


def node_of(path):
    """The node that a file belongs to."""
    return "/".join(path.parts[:2 if path.parts[0] == "core" else 1])


def folders(files):
    return {node_of(path) for path in files
            if len(path.parts) > (2 if path.parts[0] == "core" else 1) and not path.parts[0].startswith(".")}


def includes_of(files):
    """Pairs (folder, folder that it includes from). core's and cuda's folders are named alike: a file decides."""
    found = set()
    for path in files:
        if path.parts[0] in ("core", "cuda", "filters", "rendering") and path.suffix in SOURCES:
            for name in INCLUDE.findall((ROOT / path).read_text()):
                for base in {path.parts[0], "core"}:
                    if (ROOT / base / name).is_file():
                        found.add((node_of(path), node_of(Path(base, name))))
    return {(a, b) for a, b in found if a != b}


class Architecture(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.files = tracked_files()
        cls.diagram = Diagram(ROOT / "docs/pictures/architecture.svg")

    def test_every_folder_is_drawn_and_no_other(self):
        self.assertEqual(self.diagram.nodes, folders(self.files))

    def test_includes_follow_the_arrows(self):
        includes = includes_of(self.files)
        self.assertIn(("core/mesh", "core/geometry"), includes)
        self.assertEqual(self.diagram.forbidden(includes), set())

    def test_an_include_against_the_arrows_is_found(self):
        for wrong in (("core/geometry", "core/mesh"), ("core/mesh", "filters"), ("core/topology", "core/thesis"),
                      ("core/parallel", "core/engines"), ("rendering", "core/coarsening")):
            with self.subTest(wrong):
                self.assertEqual(self.diagram.forbidden({wrong}), {wrong})

    def test_every_arrow_between_code_is_an_include(self):
        code = {arrow for arrow in self.diagram.solid | self.diagram.dashed if arrow[0] not in ("examples", "plugin")}
        self.assertEqual(code - includes_of(self.files), set())

    def test_what_the_plugin_is_made_of(self):
        made = "".join(path.read_text() for path in (ROOT / "plugin").rglob("CMakeLists.txt"))
        for head in {head for tail, head in self.diagram.solid if tail == "plugin"}:
            self.assertIn(f"${{PROJECT_SOURCE_DIR}}/{head}", made)

    def test_solid_arrows_make_no_circle(self):
        for node in self.diagram.nodes:
            self.assertNotIn(node, self.diagram.reachable(node))


if __name__ == "__main__":
    unittest.main()

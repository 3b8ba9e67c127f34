# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the pages are whole: one for each proxy, and no link that leads nowhere."""

import re
import unittest
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parent.parent.parent
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
GROUPS = {"sources", "filters", "writers"}


def pages():
    return [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]


def anchors(page):
    """The names that a forge gives a page's headings."""
    headings = re.findall(r"^#+ (.*)$", page.read_text(), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


class Pages(unittest.TestCase):
    def test_a_page_for_each_proxy(self):
        groups = ElementTree.parse(ROOT / "xml/Foam.xml.in").findall("ProxyGroup")
        names = [proxy.get("name") for group in groups if group.get("name") in GROUPS for proxy in group]
        self.assertIn("FoamCoarsen", names)
        for name in names:
            with self.subTest(name):
                page = (ROOT / f"docs/proxies/{name}.md").read_text()
                self.assertTrue(page.startswith(f"# {name}\n"))
                self.assertIn(f"<!-- properties of {name} -->\n", page)
                self.assertRegex(page, r"!\[[^]]+\]\(")

    def test_every_page_is_reached_from_the_readme(self):
        reached, ahead = set(), [ROOT / "README.md"]
        while ahead:
            page = ahead.pop().resolve()
            if page not in reached:
                reached.add(page)
                ahead += [page.parent / name for name, _ in LINK.findall(page.read_text()) if name.endswith(".md")]
        self.assertEqual(set(pages()) - reached, set())

    def test_links_lead_somewhere(self):
        for page in pages():
            for name, anchor in LINK.findall(page.read_text()):
                if name.startswith("http"):
                    continue
                with self.subTest(page=page.name, link=f"{name}#{anchor}"):
                    target = page.parent / name if name else page
                    self.assertTrue(target.is_file())
                    self.assertIn(anchor or "", {"", *(anchors(target) if anchor else ())})

    def test_every_picture_is_used(self):
        used = {(page.parent / name).resolve() for page in pages() for name, _ in LINK.findall(page.read_text())}
        self.assertEqual({path for path in (ROOT / "docs").rglob("*.png")} - used, set())


if __name__ == "__main__":
    unittest.main()

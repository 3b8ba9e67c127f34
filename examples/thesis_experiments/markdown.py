# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers and tables in Markdown."""
import math
import textwrap


def number(value, digits=3):
    """A number for a reader: whole numbers whole, others to so many significant digits, large and small in powers."""
    if not math.isfinite(value):
        return "–"
    if value == int(value) and abs(value) < 1e9:
        return f"{int(value):,}"
    if 1e-3 <= abs(value) < 1e5:
        places = max(0, digits - 1 - math.floor(math.log10(abs(value))))
        return f"{value:,.{places}f}"
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    return f"{mantissa}·10{str(int(exponent)).translate(str.maketrans('0123456789-', '⁰¹²³⁴⁵⁶⁷⁸⁹⁻'))}"


def as_published(text):
    """The thesis's number as it stands there, whole ones with separators."""
    return f"{int(text):,}" if text.isdigit() else text


def table(header, rows):
    lines = [header, ["---"] + ["---:"] * (len(header) - 1), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def figure(path, caption):
    """A figure in the folder that has the page's name, with its caption below."""
    return f"![{caption.split('. ')[0].rstrip('.')}]({path.parent.name}/{path.name})\n\n*{caption}*"


def wrapped(page):
    """The page with its paragraphs wrapped; headings, tables, lists and figures as they are."""
    def wrap(block):
        return block if block.startswith(("#", "|", "-", "!")) else textwrap.fill(block, 118, break_long_words=False)

    return "\n\n".join(wrap(block) for block in page.split("\n\n") if block)

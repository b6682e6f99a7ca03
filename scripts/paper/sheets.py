# SPDX-License-Identifier: MIT
"""Sheets of pictures, with a title above each column and beside each row."""

import io

import matplotlib
from PIL import Image, ImageChops, ImageDraw, ImageFilter, ImageFont

FONT = f"{matplotlib.get_data_path()}/fonts/ttf/DejaVuSans.ttf"
GAP = 8
LINE = 17
INK = (20, 20, 20)


def _centred(draw, font, text, left, width, bottom):
    lines = text.split("\n")
    for number, line in enumerate(lines):
        x = left + (width - draw.textlength(line, font=font)) / 2
        draw.text((x, bottom - LINE * (len(lines) - number)), line, fill=INK, font=font)


def _picture(folder, name):
    """FOLDER/NAME.png; for a pair of names 16 times what they differ by, thin lines made thick enough to be seen."""
    if isinstance(name, str):
        return Image.open(folder / f"{name}.png").convert("RGB")
    difference = ImageChops.difference(*(_picture(folder, one) for one in name))
    return difference.point(lambda value: min(255, 16 * value)).filter(ImageFilter.MaxFilter(3))


def sheet(folder, rows, tile, columns=None, row_titles=None):
    """A PNG, as bytes: rows of pictures by _picture(), each reduced to `tile` pixels, or None for a gap.

    columns: a title per column; a row of the form (names, titles) has its own titles instead. row_titles: one per row.
    Grey where all pictures are."""
    font = ImageFont.truetype(FONT, 13)
    rows = [row if isinstance(row, tuple) else (row, columns if number == 0 else None) for number, row in enumerate(rows)]
    margin = 0
    if row_titles:
        margin = GAP + max(int(font.getlength(line)) for title in row_titles for line in title.split("\n"))
    heads = [LINE * max(title.count("\n") + 1 for title in titles) if titles else 0 for _, titles in rows]
    width = margin + max(len(names) for names, _ in rows) * (tile + GAP) + GAP
    height = sum(head + tile + GAP for head in heads) + GAP
    picture = Image.new("RGB", (width, height), "white")
    draw = ImageDraw.Draw(picture)
    coloured = False
    top = GAP
    for number, ((names, titles), head) in enumerate(zip(rows, heads)):
        for column, name in enumerate(names):
            left = margin + GAP + column * (tile + GAP)
            if titles:
                _centred(draw, font, titles[column], left, tile, top + head - 2)
            if name is None:
                continue
            image = _picture(folder, name)
            red, green, blue = image.split()
            coloured = coloured or red.tobytes() != green.tobytes() or red.tobytes() != blue.tobytes()
            picture.paste(image.resize((tile, tile), Image.Resampling.LANCZOS), (left, top + head))
        if row_titles:
            lines = row_titles[number].split("\n")
            first = top + head + (tile - LINE * len(lines)) / 2
            for line, text in enumerate(lines):
                draw.text((GAP, first + LINE * line), text, fill=INK, font=font)
        top += head + tile + GAP
    buffer = io.BytesIO()
    (picture if coloured else picture.convert("L")).save(buffer, "PNG", optimize=True)
    return buffer.getvalue()


def sheets(folder):
    """All sheets: name to bytes."""
    methods = ("gouraud", "quadratic", "phong")
    counts = (168, 374, 690)
    pairs = {
        "horizontal-edges": "quadratic, T3",
        "real-steps": "quadratic, steps",
        "fraction-bits": "quadratic, bits",
        "equation-15": "spherical, eq. 15",
        "equations-10-11": "recurrence, eq. 10",
        "integer-index": "recurrence, index",
        "duff": "Duff",
        "t5": "fast-phong, T5",
        "finite-eye": "fast-phong, finite",
    }
    names = list(pairs)
    misprint_rows = []
    for first in range(0, len(names), 2):
        chosen = names[first : first + 2]
        pictures = []
        titles = []
        for name in chosen:
            right, printed = (f"misprint-{name}-{kind}" for kind in ("right", "printed"))
            pictures += [right, printed, (right, printed)]
            titles += [f"{pairs[name]}\nright", "\nprinted", "\ndifference × 16"]
        misprint_rows.append((pictures, titles))
    return {
        "paper-gouraud-phong": sheet(
            folder, [["figure-5-gouraud", "figure-5-phong"]], 300, ["Gouraud: linear", "Phong: per pixel"]
        ),
        "paper-halos": sheet(
            folder,
            [[f"halo-{kind}-{n}" for n in (5, 10, 20)] for kind in ("power", "bell")],
            210,
            ["n = 5", "n = 10", "n = 20"],
            ["cosⁿx", "cos²ax"],
        ),
        "paper-memories": sheet(
            folder,
            [["memory-4", "memory-6", "memory-exact"]],
            260,
            ["4-bit memories", "6-bit memories", "exact cosines"],
        ),
        "paper-knot": sheet(
            folder,
            [
                (["knot-mesh", "knot-phong"], ["mesh", "Phong"]),
                (["knot-quadratic", "knot-spherical"], ["quadratic", "spherical, cos²"]),
            ],
            270,
        ),
        "paper-spheres": sheet(
            folder,
            [[f"sphere-{count}-{n}-{method}" for method in methods] for count in counts for n in (5, 50)],
            170,
            ["Gouraud", "quadratic", "Phong"],
            [f"{count},\nn = {n}" for count in counts for n in (5, 50)],
        ),
        "paper-curved": sheet(
            folder,
            [[f"curved-{method}-{degrees}" for degrees in (30, 60, 90)] for method in ("phong", "taylor")],
            190,
            ["30°", "60°", "90°"],
            ["Phong", "Taylor"],
        ),
        "paper-misprints": sheet(folder, misprint_rows, 150),
    }

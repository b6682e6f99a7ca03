# SPDX-License-Identifier: MIT
"""A drawing in SVG: boxes, arrows, text. Lengths are pixels, y points down."""

import html
import sys

INK = "#1f2937"
QUIET = "#6b7280"


class Canvas:
    def __init__(self, width, height):
        self.size = (width, height)
        self.parts = []

    def rectangle(self, x, y, width, height, fill="#ffffff", stroke=INK, line=1.4, radius=5, dash=None):
        extra = f' stroke-dasharray="{dash}"' if dash else ""
        self.parts.append(
            f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" rx="{radius}" fill="{fill}" '
            f'stroke="{stroke}" stroke-width="{line}"{extra}/>'
        )

    def text(self, x, y, words, size=13, anchor="middle", fill=INK, bold=False, mono=False):
        family = "monospace" if mono else "sans-serif"
        weight = ' font-weight="bold"' if bold else ""
        self.parts.append(
            f'<text x="{x:g}" y="{y:g}" font-family="{family}" font-size="{size}" text-anchor="{anchor}" '
            f'fill="{fill}"{weight}>{html.escape(words)}</text>'
        )

    def box(self, x, y, width, height, title, lines=(), fill="#ffffff"):
        """A unit: its name, and what it does below."""
        self.rectangle(x, y, width, height, fill)
        top = y + height / 2 + 5 - 8 * len(lines)
        self.text(x + width / 2, top, title, 13, bold=True)
        for k, words in enumerate(lines):
            self.text(x + width / 2, top + 17 + 15 * k, words, 11.5, fill=QUIET)

    def arrow(self, *points, stroke=INK, dash=None, head=True):
        path = " ".join(f"{x:g},{y:g}" for x, y in points)
        extra = f' stroke-dasharray="{dash}"' if dash else ""
        marker = ' marker-end="url(#head)"' if head else ""
        self.parts.append(f'<polyline points="{path}" fill="none" stroke="{stroke}" stroke-width="1.5"{extra}{marker}/>')

    def polygon(self, points, fill="none", stroke=INK, line=1.8):
        path = " ".join(f"{x:g},{y:g}" for x, y in points)
        self.parts.append(f'<polygon points="{path}" fill="{fill}" stroke="{stroke}" stroke-width="{line}"/>')

    def circle(self, x, y, radius, fill=INK):
        self.parts.append(f'<circle cx="{x:g}" cy="{y:g}" r="{radius:g}" fill="{fill}"/>')

    def write(self):
        """Writes the drawing to the file that the command line names."""
        width, height = self.size
        head = (
            '<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" '
            f'orient="auto-start-reverse"><path d="M0,0.8 L8,4 L0,7.2 z" fill="{INK}"/></marker></defs>'
        )
        svg = "\n".join(
            [
                f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" '
                f'height="{height}">',
                head,
                f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
                *self.parts,
                "</svg>",
            ]
        )
        with open(sys.argv[1], "w", encoding="utf-8") as file:
            file.write(svg + "\n")

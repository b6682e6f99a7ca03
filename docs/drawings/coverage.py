# SPDX-License-Identifier: MIT
"""coverage.py OUT.svg: a triangle's walk, from the formulas of docs/architecture.md, "Coverage"."""

from lib.svg_canvas import INK, QUIET, Canvas

SCALE = 46  # drawn pixels for a pixel
WIDTH, HEIGHT = 14, 10
MARGIN = 34
TOP, MIDDLE, BOTTOM = (int(2.3 * 256), int(0.4 * 256)), (int(12.7 * 256), int(5.6 * 256)), (int(4.6 * 256), int(9.3 * 256))


def ceil_div(n, d):
    return -(-n // d)


def edge_at(a, b, row):
    """S: the first pixel right of edge a to b at a row's centres."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    return ceil_div((a[0] - 128) * dy + dx * (256 * row + 128 - a[1]), 256 * dy)


def first_row(y):
    return ceil_div(y - 128, 256)


c = Canvas(2 * MARGIN + WIDTH * SCALE + 250, 2 * MARGIN + HEIGHT * SCALE)


def at(x, y):
    return MARGIN + x * SCALE, MARGIN + y * SCALE


starts = []
for row in range(first_row(TOP[1]), first_row(BOTTOM[1])):
    start = edge_at(TOP, BOTTOM, row)
    end = edge_at(TOP, MIDDLE, row) if row < first_row(MIDDLE[1]) else edge_at(MIDDLE, BOTTOM, row)
    starts.append((start, row))
    for x in range(start, end):
        c.rectangle(*at(x, row), SCALE, SCALE, "#7fb2ff" if x == start else "#dbe9ff", "none", 0, 0)

for x in range(WIDTH + 1):
    c.arrow(at(x, 0), at(x, HEIGHT), stroke="#d5d9e0", head=False)
for y in range(HEIGHT + 1):
    c.arrow(at(0, y), at(WIDTH, y), stroke="#d5d9e0", head=False)
for x in range(WIDTH):
    for y in range(HEIGHT):
        c.circle(*at(x + 0.5, y + 0.5), 1.7, QUIET)
c.polygon([at(x / 256, y / 256) for x, y in (TOP, MIDDLE, BOTTOM)])

for (x, y), (below, next_row) in zip(starts, starts[1:]):
    c.arrow(at(x + 0.5, y + 0.62), at(x + 0.5, next_row + 0.38), stroke="#b42318")
    if below != x:
        c.arrow(at(x + 0.6, next_row + 0.5), at(below + 0.4, next_row + 0.5), stroke="#b42318")

left = 2 * MARGIN + WIDTH * SCALE
c.rectangle(left, 60, 22, 22, "#7fb2ff", "none", 0, 0)
c.text(left + 32, 76, "start pixel, on the long edge", 13, "start")
c.rectangle(left, 96, 22, 22, "#dbe9ff", "none", 0, 0)
c.text(left + 32, 112, "the rest of the span", 13, "start")
c.arrow((left + 11, 134), (left + 11, 160), stroke="#b42318")
c.text(left + 32, 152, "a row: κ pixels along (here 0)", 13, "start")
c.arrow((left - 2, 184), (left + 24, 184), stroke="#b42318")
c.text(left + 32, 188, "a carry: one pixel more", 13, "start")
c.text(left, 236, "Only the end edge changes", 13, "start", INK)
c.text(left, 254, "at the middle vertex.", 13, "start", INK)
c.write()

# SPDX-License-Identifier: MIT
"""skew.py OUT.svg: an accumulator in two slices, one clock apart."""

from lib.svg_canvas import QUIET, Canvas

LEFT, CELL, ROW = 190, 92, 46
SHADES = ["#dbe7ff", "#dff3e3", "#fdecd2", "#f3e1f5", "#e6e8ec"]

c = Canvas(LEFT + 6 * CELL + 20, 330)
for t in range(6):
    c.text(LEFT + (t + 0.5) * CELL, 26, f"t + {t}" if t else "t", 13, fill=QUIET)
    c.arrow((LEFT + t * CELL, 36), (LEFT + t * CELL, 276), stroke="#d5d9e0", head=False)


def row(number, name, note, first, words):
    """A register's contents, one a clock, from clock `first` on."""
    y = 46 + number * ROW
    c.text(LEFT - 14, y + 17, name, 13, "end", bold=True)
    c.text(LEFT - 14, y + 32, note, 11, "end", fill=QUIET)
    for k, word in enumerate(words):
        c.rectangle(LEFT + (first + k) * CELL + 3, y + 3, CELL - 6, ROW - 12, SHADES[k], radius=3, line=1.1)
        c.text(LEFT + (first + k + 0.5) * CELL, y + 23, word, 12, mono=True)


row(0, "command", "as slice 0 obeys it", 0, ["load", "step", "step", "step"])
row(1, "slice 0", "I(15..0)", 1, ["low 0", "low 1", "low 2", "low 3"])
row(2, "carry", "one register", 1, ["-", "c 1", "c 2", "c 3"])
row(3, "slice 1", "I(31..16)", 2, ["high 0", "high 1", "high 2", "high 3"])
row(4, "fragment", "meets slice 1", 2, ["pixel 0", "pixel 1", "pixel 2", "pixel 3"])
c.text(LEFT - 160, 300, "high k = high k-1 + D(31..16) + c k: slice 1 does at t + 1 what slice 0 did at t;", 12.5, "start")
c.text(LEFT - 160, 318, "D has the same skew, so its upper half is there when slice 1 adds it.", 12.5, "start")
c.write()

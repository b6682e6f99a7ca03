# SPDX-License-Identifier: MIT
"""datapath.py OUT.svg: the shading core, unit by unit."""

from lib.svg_canvas import QUIET, Canvas

GEOMETRY = "#e0ecff"
CHANNEL = "#e3f5e6"
QUEUE = "#f1f2f4"

c = Canvas(1350, 480)

# Three triangles in work.
for x, width, words in [(150, 168, "one arrives"), (336, 196, "one is walked"), (640, 172, "one is drawn")]:
    c.rectangle(x, 38, width, 402, "#fbfbfd", "#c7ccd6", 1.2, 8, "6 5")
    c.text(x + width / 2, 29, words, 13, fill=QUIET)

# Geometry, left to right.
c.box(38, 90, 92, 70, "stream_fifo", ["beats"], QUEUE)
c.box(166, 90, 136, 70, "packet_decoder", ["headers, words"], GEOMETRY)
c.box(366, 90, 136, 70, "edge_walker", ["rows, carries"], GEOMETRY)
c.box(540, 90, 92, 70, "stream_fifo", ["spans"], QUEUE)
c.box(658, 90, 136, 70, "span_walker", ["pixel positions"], GEOMETRY)
c.box(836, 90, 150, 70, "highlight_stage", ["with log channels"], GEOMETRY)
c.box(1018, 90, 130, 70, "colour_stage", ["saturate, pack"], GEOMETRY)
c.box(1180, 90, 92, 70, "stream_fifo", ["pixels"], QUEUE)

c.text(8, 82, "s_axis", 12, "start", mono=True)
c.arrow((8, 125), (38, 125))
c.arrow((130, 125), (166, 125))
c.arrow((302, 125), (366, 125))
c.text(331, 117, "job", 12, mono=True)
c.arrow((502, 125), (540, 125))
c.text(521, 117, "span", 12, mono=True)
c.arrow((632, 125), (658, 125))
c.arrow((794, 125), (836, 125))
c.text(817, 82, "fragment", 12, mono=True)
c.arrow((986, 125), (1018, 125))
c.arrow((1148, 125), (1180, 125))
c.arrow((1272, 125), (1342, 125))
c.text(1342, 82, "m_axis", 12, "end", mono=True)

# Stalls, backwards.
c.arrow((586, 90), (586, 60), (434, 60), (434, 90), dash="4 4")
c.text(560, 53, "room", 12, mono=True)
c.arrow((1226, 90), (1226, 60), (726, 60), (726, 90), dash="4 4")
c.text(905, 53, "go (a register)", 12, mono=True)

# The channels, one in front of three more.
for k in (3, 2, 1):
    c.rectangle(366 + 5 * k, 256 - 5 * k, 428, 154, CHANNEL, "#9fb8a4", 1.1)
c.rectangle(366, 256, 428, 154, CHANNEL)
c.text(380, 430, "forward_difference: red, green, blue, depth, log channels", 12.5, "start", bold=True)
c.box(378, 276, 124, 118, "edge part", ["row: I += E", "E += dE, D += dD", "carry: I += D", "D += h, E += dD"])
c.box(530, 296, 112, 78, "its share", ["of the queue:", "I, D of each row"], QUEUE)
c.box(668, 286, 114, 98, "span part", ["pixel: I += D", "D += h"])
c.arrow((502, 335), (530, 335))
c.arrow((642, 335), (668, 335))

c.arrow((234, 160), (234, 335), (378, 335))
c.text(242, 307, "6 words", 12, "start")
c.text(242, 323, "a channel", 12, "start")
c.arrow((434, 160), (434, 276))
c.text(441, 205, "load, step, carry", 12, "start", mono=True)
c.arrow((726, 160), (726, 286))
c.text(733, 205, "load, step", 12, "start", mono=True)
c.arrow((586, 160), (586, 296), dash="2 3")
c.text(593, 205, "addresses", 12, "start", mono=True)
c.arrow((782, 335), (858, 335), (858, 160))
c.text(866, 262, "upper bits of I:", 12, "start")
c.text(866, 279, "s10.4 colour", 12, "start")
c.text(866, 296, "u16.0 depth", 12, "start")
c.text(866, 313, "s8.6 log", 12, "start")

# Materials and power tables.
c.arrow((190, 160), (190, 458), (972, 458), (972, 160))
c.text(640, 474, "material, words of the power table", 12)

c.write()

# SPDX-License-Identifier: MIT
"""Configurations of the benches tb_packet_decoder, tb_edge_walker and tb_shading_core."""

from itertools import product

from vector_configs import add_vector_configs

SHAPES = ((1, 2, 4), (False, True), (False, True))
PLAIN = list(product(*SHAPES, (0,), (False,)))
LIT = [(1, True, True, 1, True), (2, False, True, 1, False), (2, True, True, 3, True), (4, True, True, 2, True)]
CORE = ("words_per_beat", "has_depth", "has_quadratic", "log_channels", "has_power")

UNITS = {
    "packet_decoder": (CORE, PLAIN + LIT),
    "edge_walker": ((), [()]),
    "shading_core": (
        (*CORE, "slices"),
        [*((*shape, 2) for shape in PLAIN + LIT), (1, True, True, 0, False, 1), (2, False, True, 0, False, 1),
         (4, True, False, 0, False, 1), (2, True, True, 3, True, 1)],
    ),
}


def add_configs(lib, build_dir, output_dir):
    """Register every configuration of this module's benches in VUnit library `lib` (vector_configs.py)."""
    add_vector_configs(lib, build_dir, output_dir, UNITS)

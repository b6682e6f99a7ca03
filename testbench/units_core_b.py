# SPDX-License-Identifier: MIT
"""Configurations of the benches tb_packet_decoder, tb_edge_walker and tb_shading_core."""

from itertools import product

from vector_configs import add_vector_configs

SHAPES = ((1, 2, 4), (False, True), (False, True))

UNITS = {
    "packet_decoder": (("words_per_beat", "has_depth", "has_quadratic"), list(product(*SHAPES))),
    "edge_walker": ((), [()]),
    "shading_core": (
        ("words_per_beat", "has_depth", "has_quadratic", "slices"),
        [*product(*SHAPES, (2,)), (1, True, True, 1), (2, False, True, 1), (4, True, False, 1)],
    ),
}


def add_configs(lib, build_dir, output_dir):
    """Register every configuration of this module's benches in VUnit library `lib` (vector_configs.py)."""
    add_vector_configs(lib, build_dir, output_dir, UNITS)

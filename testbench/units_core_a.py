# SPDX-License-Identifier: MIT
"""Configurations of the benches tb_stream_fifo, tb_span_walker, tb_forward_difference and tb_colour_stage."""

from itertools import product

from vector_configs import add_vector_configs

UNITS = {
    "stream_fifo": (
        ("width", "depth_log2", "reserve"),
        [(16, 2, 0), (16, 2, 2), (16, 4, 0), (16, 4, 2), (16, 4, 10), (16, 5, 0), (16, 5, 10)],
    ),
    "span_walker": ((), [()]),
    "forward_difference": (
        ("width", "slices", "second_order", "family"),
        [*product((32, 24, 18), (1, 2, 3), (False, True), ("plain",)),
         *product((32, 18), (2, 3), (False, True), ("ecp5",))],
    ),
    "colour_stage": (("colour_width", "depth_width"), [(32, 32), (24, 24), (18, 18)]),
}


def add_configs(lib, build_dir, output_dir):
    """Register every configuration of this module's benches in VUnit library `lib` (vector_configs.py)."""
    add_vector_configs(lib, build_dir, output_dir, UNITS)

# SPDX-License-Identifier: MIT
"""Configurations of the spherical units' benches: tb_line_interpolator, tb_bell_rom and tb_spherical_pair."""

from vector_configs import add_vector_configs

LINE_INTERPOLATOR = ("phase_bits", "ra_bits")
BELL_ROM = ("address_bits", "data_bits", "exponent_tenths", "wrap_bits", "folded")

UNITS = {
    "line_interpolator": (LINE_INTERPOLATOR, [(12, 6), (12, 4), (22, 12), (32, 32)]),
    "bell_rom": (
        BELL_ROM,
        [
            (6, 6, 20, 0, False),
            (6, 6, 10, 0, False),
            (4, 4, 20, 0, False),
            (4, 4, 10, 0, False),
            (5, 6, 20, 2, True),
            (6, 6, 20, 3, False),
            (8, 8, 95, 3, True),
            (8, 8, 10, 5, True),
            (9, 8, 95, 4, False),
        ],
    ),
    "spherical_pair": (
        ("phase_bits", *BELL_ROM),
        [
            (12, 6, 6, 20, 0, False),
            (12, 6, 6, 10, 0, False),
            (12, 4, 4, 20, 0, False),
            (22, 8, 8, 95, 3, True),
        ],
    ),
}


def add_configs(lib, build_dir, output_dir):
    """Register every configuration of this module's benches in VUnit library `lib` (vector_configs.py)."""
    add_vector_configs(lib, build_dir, output_dir, UNITS)

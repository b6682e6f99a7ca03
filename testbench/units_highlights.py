# SPDX-License-Identifier: MIT
"""Configurations of the benches of what makes highlights: tb_exp2_rom, tb_power_rom, tb_highlight_stage."""

from vector_configs import add_vector_configs

UNITS = {
    "exp2_rom": (("address_bits", "data_bits", "fraction_bits"), [(6, 8, 0), (6, 8, 4), (6, 10, 2), (7, 10, 4)]),
    "power_rom": (("address_bits", "fraction_bits"), [(10, 0), (10, 4), (7, 2)]),
    "highlight_stage": (("log_channels", "has_power"),
                        [(channels, power) for power in ("false", "true") for channels in (1, 2, 3)]),
}


def add_configs(lib, build_dir, output_dir):
    """Register every configuration of this module's benches in VUnit library `lib` (vector_configs.py)."""
    add_vector_configs(lib, build_dir, output_dir, UNITS)

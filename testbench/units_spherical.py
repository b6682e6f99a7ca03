# SPDX-License-Identifier: MIT
"""Configurations of the spherical units' benches: tb_line_interpolator, tb_bell_rom and tb_spherical_pair.

Each configuration is named by its generics, at full speed and with random pauses of the input, and has its vectors
written anew by the C++ kernel before it runs.
"""

import shutil
import subprocess
from functools import partial
from itertools import product
from pathlib import Path

SEED = 1
COUNT = 10000
STALLS = (0, 50)

LINE_INTERPOLATOR = ("phase_bits", "ra_bits")
BELL_ROM = ("address_bits", "data_bits", "exponent_tenths", "wrap_bits", "folded")

# The vector programs write these very configurations: a file that is missing fails its bench.
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


def write_vectors(program, folder):
    """Write a unit's vectors into an empty `folder`; False, which fails the test, if the program fails."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return subprocess.run([program, folder, str(SEED), str(COUNT)], check=False).returncode == 0


def add_configs(lib, build_dir, output_dir):
    """Register every configuration of this module's benches in VUnit library `lib`.

    build_dir: where the programs make_vectors_<unit> are; output_dir: where their vectors go, a folder each.
    """
    for unit, (names, values) in UNITS.items():
        bench = lib.test_bench(f"tb_{unit}")
        program = Path(build_dir).resolve() / f"make_vectors_{unit}"
        for index, (value, stall_percent) in enumerate(product(values, STALLS)):
            generics = dict(zip(names, value), stall_percent=stall_percent)
            name = ",".join(f"{key}={word}" for key, word in generics.items())
            folder = Path(output_dir).resolve() / "vectors" / unit / name
            generics.update(count=COUNT, seed=SEED, vector_folder=str(folder))
            for test in bench.get_tests():
                if not test.name.startswith("reset"):
                    test.add_config(name=name, generics=generics, pre_config=partial(write_vectors, program, folder))
                elif index == 0:  # no vectors and no pauses: once is enough
                    test.add_config(name=name, generics=generics)

# SPDX-License-Identifier: MIT
"""Configurations of tb_uart_core: those of the boards, each with a host of another rate."""

from functools import partial
from pathlib import Path

from vector_configs import SEED, WITH_VECTORS, remove_vectors, write_vectors

# A serial line takes 10 bits a byte, so these vectors are fewer than the other benches have.
COUNT = 400

NAMES = ("words_per_beat", "has_depth", "has_quadratic", "rate_percent")
BOARDS = {
    "ulx3s": (2, True, True, 0),
    "hx8k_breakout": (1, True, True, 2),
    "icebreaker": (1, True, False, -2),
}


def add_configs(lib, build_dir, output_dir):
    """Register every board's configuration in VUnit library `lib`; arguments as in vector_configs.py."""
    bench = lib.test_bench("tb_uart_core")
    program = Path(build_dir).resolve() / "make_vectors_uart_core"
    for board, values in BOARDS.items():
        folder = Path(output_dir).resolve() / "vectors" / "uart_core" / board
        generics = dict(zip(NAMES, values), count=COUNT, seed=SEED, vector_folder=str(folder))
        for test in bench.get_tests():
            if test.name.startswith(WITH_VECTORS):
                test.add_config(name=board, generics=generics, post_check=partial(remove_vectors, folder),
                                pre_config=partial(write_vectors, program, folder, COUNT))
            else:
                test.add_config(name=board, generics=generics)

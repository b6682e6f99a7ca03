# SPDX-License-Identifier: MIT
"""Configurations of the benches that compare a unit with the vectors of its kernel.

Each configuration is named by its generics, at full speed and with random pauses, and has its vectors written anew by
the unit's program, make_vectors_<unit>, before it runs. They go again when it has passed; a failing one leaves them.
"""

import shutil
import subprocess
from functools import partial
from itertools import product
from pathlib import Path

SEED = 1
COUNT = 10000
STALLS = (0, 50)

# Tests that read vectors are named for what every vector shows; the others need one configuration only.
WITH_VECTORS = "every_"


def write_vectors(program, folder, count=COUNT):
    """Write `count` vectors of a unit into an empty `folder`; False, which fails the test, if the program fails."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    if not program.exists():
        print(f"{program}: is missing; `make build` makes it")
        return False
    return subprocess.run([program, folder, str(SEED), str(count)], check=False).returncode == 0


def remove_vectors(folder):
    """Remove the vectors of a configuration that has passed."""
    shutil.rmtree(folder)
    return True


def add_vector_configs(lib, build_dir, output_dir, units):
    """Register the configurations of the benches tb_<unit> in VUnit library `lib`.

    build_dir: where the programs make_vectors_<unit> are; output_dir: where their vectors go, a folder each;
    units: {unit: (names of its generics, [their values, ...])}. Each program writes these very configurations: a file
    that is missing fails its bench.
    """
    for unit, (names, values) in units.items():
        bench = lib.test_bench(f"tb_{unit}")
        program = Path(build_dir).resolve() / f"make_vectors_{unit}"
        for index, (value, stall_percent) in enumerate(product(values, STALLS)):
            generics = dict(zip(names, value), stall_percent=stall_percent)
            name = ",".join(f"{key}={word}" for key, word in generics.items())
            folder = Path(output_dir).resolve() / "vectors" / unit / name
            generics.update(count=COUNT, seed=SEED, vector_folder=str(folder))
            for test in bench.get_tests():
                if test.name.startswith(WITH_VECTORS):
                    test.add_config(name=name, generics=generics, pre_config=partial(write_vectors, program, folder),
                                    post_check=partial(remove_vectors, folder))
                elif index == 0:
                    test.add_config(name=name, generics=generics)

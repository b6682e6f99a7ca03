#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the VHDL benches under VUnit: each unit against the vectors that its kernel writes at this very moment.

Beside VUnit's own options (--help lists them) there is --vectors, the folder of the programs make_vectors_<unit>.
At the end it prints, per unit, how many vectors were compared. Exit status: 0 all tests passed, 1 a test failed.
"""

import os
import re
from pathlib import Path

from vunit import VUnit, VUnitCLI

import units_boards
import units_core_a
import units_core_b
import units_highlights
import units_spherical

BENCH = Path(__file__).resolve().parent
ROOT = BENCH.parent
RTL = ROOT / "rtl_vhdl"
COMPARED = re.compile(r"^(\w+): (\d+) vectors compared$", re.MULTILINE)


def print_compared(results):
    """Print the sums of what the benches of this run reported when they closed their vector files."""
    sums = {}
    for test in results.get_report().tests.values():
        output = test.path / "output.txt"
        if test.status == "passed" and output.exists():
            for unit, count in COMPARED.findall(output.read_text(encoding="utf-8", errors="replace")):
                vectors, configurations = sums.get(unit, (0, 0))
                sums[unit] = (vectors + int(count), configurations + 1)
    for unit, (vectors, configurations) in sorted(sums.items()):
        print(f"{unit}: {vectors} vectors compared in {configurations} configurations")


def main():
    """Add sources and configurations, then let VUnit run what its command line asks for."""
    cli = VUnitCLI(description=__doc__.splitlines()[0])
    cli.parser.add_argument("--vectors", type=Path,
                            default=os.environ.get("VECTORS", ROOT / "build" / "release" / "vectors"),
                            help="folder of the programs make_vectors_<unit> ($VECTORS, or build/release/vectors)")
    arguments = cli.parse_args()
    vunit = VUnit.from_args(args=arguments, compile_builtins=False, vhdl_standard="2008")
    vunit.add_vhdl_builtins()

    sheen = vunit.add_library("sheen")
    for name in (RTL / "files.txt").read_text(encoding="utf-8").split():
        sheen.add_source_file(RTL / name)
    sheen.add_source_files(BENCH / "models" / "*.vhd")
    sheen.add_source_files(ROOT / "constraints" / "*" / "*.vhd")
    bench = vunit.add_library("bench")
    bench.add_source_files(BENCH / "*.vhd")

    for units in (units_spherical, units_core_a, units_core_b, units_highlights, units_boards):
        units.add_configs(bench, arguments.vectors, arguments.output_path)
    vunit.main(post_run=print_compared)


if __name__ == "__main__":
    main()

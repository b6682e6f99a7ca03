#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Builds cores out of context on parts, or a board's bitstream; `make fpga` calls it.

    make_fpga.py [--core "NAME..."] [--part "NAME..."] [--seeds N] [--jobs N]   table and bitstreams
    make_fpga.py --board NAME [--seeds N]                                      the board's bitstream

Everything lies under build/fpga: table.json, and a folder each for core and part. docs/fpga.md is brought up to date
by a run over all cores and all parts. Exit status: 0 done, 1 a tool failed or a board misses its clock, 2 usage.
"""

import argparse
import sys
from concurrent.futures import ThreadPoolExecutor

import tables
import tools
from critical_path import critical_path
from designs import BOARDS, BUILD, CORES, PARTS, ROOT, board_sources
from place_route import area, place_and_route, write_bitstream
from progress import Progress
from synthesis import to_netlist, to_verilog

DOCUMENT = ROOT / "docs" / "fpga.md"
MOST_SEEDS = 100


class UsageError(Exception):
    """A value that the user gave is wrong."""


def chosen(variable, words, known):
    """The names in `words`, all of `known` if there are none."""
    names = words.split()
    for name in names:
        if name not in known:
            raise UsageError(f"{variable}={name} is not known; choose from: {', '.join(known)}")
    return list(dict.fromkeys(names)) or list(known)


def number(variable, word, most):
    """A positive number up to `most`."""
    if not (word.isascii() and word.isdecimal() and 1 <= int(word) <= most):
        raise UsageError(f"{variable}={word} must be a number from 1 to {most}")
    return int(word)


def build_core(core, part, seeds, jobs, progress):
    """Map, place and route one core on one part, with every seed; the bitstream is the fastest seed's."""
    design, target = CORES[core], PARTS[part]
    progress.show(f"{core}: synthesis for {target.family}")
    mapped = BUILD / core / target.family
    verilog = to_verilog(mapped, design.entity, design.generics_for(target.family), design.sources)
    netlist = to_netlist(mapped, target.family, verilog, design.entity, wrapped=True)
    folder = BUILD / core / part

    def run(seed):
        progress.show(f"{core} on {part}, seed {seed}")
        placed = place_and_route(netlist, target, seed, folder)
        progress.step()
        return placed

    with ThreadPoolExecutor(max_workers=jobs) as pool:
        runs = sorted(pool.map(run, range(1, seeds + 1)), key=lambda placed: placed.fmax)
    middle = runs[(len(runs) - 1) // 2]
    bitstream = folder / f"{core}.bin"
    write_bitstream(runs[-1], target, bitstream)
    return tables.Result(core, target.name, target.speed, area(middle, target, netlist.around),
                         tuple(placed.fmax for placed in runs), critical_path(middle.report, netlist),
                         str(bitstream.relative_to(ROOT)))


def build_cores(cores, parts, seeds, jobs):
    """Every core on every part."""
    progress = Progress(len(cores) * len(parts) * seeds)
    results = [build_core(core, part, seeds, jobs, progress) for core in cores for part in parts]
    progress.clear()
    tables.write_json(results, BUILD / "table.json")
    print(tables.text(results))
    if len(results) == len(CORES) * len(PARTS):
        tables.refresh(DOCUMENT, results)
        print(f"fpga: {DOCUMENT.relative_to(ROOT)} is up to date")
    print(f"fpga: table in {(BUILD / 'table.json').relative_to(ROOT)}; bitstreams:",
          *(f"  {result.bitstream}" for result in results), sep="\n")


def build_board(name, seeds):
    """The bitstream of a board: of the first seed that meets the clock."""
    board = BOARDS[name]
    folder = BUILD / name
    progress = Progress(seeds)
    progress.show(f"{name}: synthesis")
    verilog = to_verilog(folder, board.entity, {}, board_sources(board))
    netlist = to_netlist(folder / board.part.family, board.part.family, verilog, board.entity, wrapped=False)
    for seed in range(1, seeds + 1):
        progress.show(f"{name}, seed {seed}")
        placed = place_and_route(netlist, board.part, seed, folder, board.constraints)
        progress.step()
        if placed.fmax >= board.clock:
            break
    progress.clear()
    path = critical_path(placed.report, netlist).words()
    cells = ", ".join(f"{value:,} {key.upper()}" for key, value in area(placed, board.part, {}).items())
    if placed.fmax < board.clock:
        raise tools.FpgaError(f"{name} misses its clock of {board.clock:g} MHz with {seeds} seeds; the last one "
                              f"reaches {placed.fmax:.1f} MHz, from {path}")
    bitstream = folder / f"{name}.bin"
    write_bitstream(placed, board.part, bitstream)
    print(f"{name}: {cells}; {placed.fmax:.1f} MHz, needs {board.clock:g} (seed {placed.seed})\n"
          f"critical path: {path}\nfpga: bitstream in {bitstream.relative_to(ROOT)}")


def main(arguments):
    """The command line; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--core", default="", help=f"some of: {', '.join(CORES)}")
    parser.add_argument("--part", default="", help=f"some of: {', '.join(PARTS)}")
    parser.add_argument("--board", default="", help=f"one of: {', '.join(BOARDS)}")
    parser.add_argument("--seeds", default="5", help="runs of placement and routing")
    parser.add_argument("--jobs", default="1", help="of them at a time")
    options = parser.parse_args(arguments)
    try:
        seeds = number("SEEDS", options.seeds, MOST_SEEDS)
        jobs = number("JOBS", options.jobs, 1000)
        if options.board:
            if options.core or options.part:
                raise UsageError("BOARD has its own core and part; leave CORE and PART out")
            if len(chosen("BOARD", options.board, BOARDS)) > 1:
                raise UsageError(f"BOARD={options.board} names several boards; choose one")
            build_board(options.board.strip(), seeds)
        else:
            build_cores(chosen("CORE", options.core, CORES), chosen("PART", options.part, PARTS), seeds, jobs)
    except UsageError as error:
        print(f"fpga: {error}", file=sys.stderr)
        return 2
    except tools.FpgaError as error:
        print(f"fpga: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks that kernel tops are what an HLS tool can turn into hardware.

Each top is compiled to LLVM IR by clang, once for each release of ac_types, and everything that its extern "C"
functions reach is searched for floating point, division, allocation, recursion, indirect calls and calls to code
that the top doesn't define; in a step top (*_step.cpp) also for loops, since one call is one clock. What the
optimiser removes, an unrolled loop for one, costs no clock and is no finding.

A finding is one line: top, release, reason, function, line of the IR file and its text.
Exit status: 0 nothing found (or, with --expect, what was expected), 1 findings, 2 wrong arguments.
"""

import argparse
import pathlib
import re
import subprocess
import sys

import llvm_ir

ROOT = pathlib.Path(__file__).resolve().parent.parent
FLAGS = ["-std=c++17", "-O2", "-DNDEBUG", "-DSHEEN_CHANNEL_PORTS",  # ac_channel as the port that a tool makes of it
         "-fno-exceptions", "-fno-rtti", "-fno-vectorize", "-fno-slp-vectorize",
         "-fno-discard-value-names", "-mllvm", "-unroll-threshold=4000",
         "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror", "-emit-llvm", "-S"]

FLOATING_POINT = re.compile(r"\b(half|bfloat|float|double|fp128|x86_fp80|ppc_fp128)\b")
DIVISION = re.compile(r"\b[us](div|rem)\b")
DYNAMIC_ALLOCA = re.compile(r"\balloca\b.*,\s*i\d+\s+%")
ALLOCATION = re.compile(r"^(malloc|calloc|realloc|free|aligned_alloc|_Zn[wa].*|_Zd[la].*)$")
# Plain copies, hints and integer operations; they become wires and gates.
INTRINSICS = re.compile(r"^llvm\.(mem(cpy|set|move)|lifetime|assume|dbg|expect|experimental\.noalias|invariant"
                        r"|[us](min|max|add|sub|mul|shl)|abs|ct(lz|tz|pop)|fsh[lr]|bswap|bitreverse)\b")


def compile_to_ir(clang, source, ac_types, output):
    """The text of the source's IR, which stays in output. Exits with clang's own words when it doesn't compile."""
    output.parent.mkdir(parents=True, exist_ok=True)
    command = [clang, *FLAGS, "-I", str(ROOT / "hls/include"), "-isystem", str(ac_types), str(source), "-o", str(output)]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        sys.exit(f"{source} (ac_types {ac_types.name}): does not compile\n{result.stderr}{' '.join(command)}")
    return output.read_text()


def reachable(functions, tops):
    """The functions that tops lead to, tops included, as {name: names of defined functions it calls}."""
    graph = {}
    pending = list(tops)
    while pending:
        name = pending.pop()
        if name not in graph:
            graph[name] = {call.callee for call in functions[name].calls() if call.callee in functions}
            pending += graph[name]
    return graph


def on_cycle(graph, name):
    """Does a chain of calls lead from the function back to it?"""
    seen, pending = set(), list(graph[name])
    while pending:
        callee = pending.pop()
        if callee == name:
            return True
        if callee not in seen:
            seen.add(callee)
            pending += graph[callee]
    return False


def call_findings(functions, function):
    for call in function.calls():
        if call.callee is None:
            yield "indirect_call", call.line
        elif ALLOCATION.match(call.callee):
            yield "allocation", call.line
        elif call.callee not in functions and not INTRINSICS.match(call.callee):
            yield "external_call", call.line


def findings(functions, top_may_loop):
    """(reason, function, line) of everything that no HLS tool takes."""
    tops = [name for name, function in functions.items()
            if not name.startswith("_") and " internal " not in function.header.text]
    if not tops:
        sys.exit('no extern "C" function: nothing to check')
    graph = reachable(functions, tops)
    for name in graph:
        function = functions[name]
        for line in [function.header, *function.lines]:
            if FLOATING_POINT.search(line.code):
                yield "floating_point", name, line
            elif DIVISION.search(line.code):
                yield "division", name, line
            elif DYNAMIC_ALLOCA.search(line.text):
                yield "allocation", name, line
        for reason, line in call_findings(functions, function):
            yield reason, name, line
        if on_cycle(graph, name):
            yield "recursion", name, function.header
        if not top_may_loop:
            for line in function.loops():
                yield "loop", name, line


def check(source, arguments):
    """Prints the findings of one top for each release of ac_types; returns the sets of their reasons."""
    reasons = []
    for ac_types in arguments.ac_types:
        output = arguments.out / f"{source.stem}-{ac_types.name}.ll"
        functions = llvm_ir.parse(compile_to_ir(arguments.clang, source, ac_types, output))
        found = list(findings(functions, source.stem.endswith("_core")))
        for reason, name, line in found:
            print(f"{source} (ac_types {ac_types.name}): {reason} in {name}: {output}:{line.number}: {line.text.strip()}")
        reasons.append({reason for reason, _, _ in found})
    return reasons


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tops", nargs="+", type=pathlib.Path, help="*_step.cpp (no loops) or *_core.cpp")
    parser.add_argument("--ac-types", action="append", type=pathlib.Path, required=True, help="headers; may repeat")
    parser.add_argument("--out", type=pathlib.Path, required=True, help="folder for the IR")
    parser.add_argument("--clang", default="clang++")
    parser.add_argument("--expect", metavar="REASON", help="succeed only when this is the one reason; accepted: none")
    arguments = parser.parse_args()
    for source in arguments.tops:
        if not re.search(r"_(step|core)$", source.stem):
            parser.error(f"{source}: a top is named <unit>_step.cpp or <unit>_core.cpp")

    reasons = [found for source in arguments.tops for found in check(source, arguments)]
    if arguments.expect:
        expected = set() if arguments.expect == "accepted" else {arguments.expect}
        if any(found != expected for found in reasons):
            sys.exit(f"expected {arguments.expect}, found {[sorted(found) for found in reasons]}")
    elif any(reasons):
        sys.exit(1)
    outcome = f"found {arguments.expect}, as expected" if arguments.expect else "no finding"
    print(f"check_synthesizable: {len(arguments.tops)} tops, {len(arguments.ac_types)} releases of ac_types: {outcome}")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Area as a test: every unit and core, mapped to ECP5 and iCE40, against what tests/area/area.json records.

    test_area.py [--update 1] [--record FILE] [--jobs N]

Maps with yosys alone, so the numbers are cells of the netlist: LUTs (for ECP5 four-input LUTs, carries and LUT memory
apart; nextpnr counts them together), flip-flops, block RAMs, multipliers. A number that is more than MARGIN above or
below its record fails, with both; so does a memory or a multiplier that is not where it belongs. Below, because a
record that no longer holds hides the next growth: record it anew.
Exit status: 0 all within the margin, 1 not so or a tool failed, 2 usage.
"""

import argparse
import json
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import tools
from designs import BUILD, CORES, ROOT, Core
from progress import Progress
from synthesis import to_netlist, to_verilog

RECORD = ROOT / "tests" / "area" / "area.json"
MARGIN = 0.05  # of the record; and
SLACK = 4      # this many cells more, so that the smallest units may move at all

KEYS = ("lut", "carry", "lut_ram", "ff", "bram", "dsp")
CELLS = {
    "ecp5": {"lut": ("LUT4",), "carry": ("CCU2C",), "lut_ram": ("TRELLIS_DPR16X4",), "ff": ("TRELLIS_FF",),
             "bram": ("DP16KD", "PDPW16KD"), "dsp": ("MULT18X18D",)},
    "ice40": {"lut": ("SB_LUT4",), "carry": ("SB_CARRY",), "lut_ram": (), "ff": ("SB_DFF",), "bram": ("SB_RAM40_4K",),
              "dsp": ("SB_MAC16",)},
}

UNITS = {
    "stream_fifo": Core("stream_fifo", "the beat queue of the default core",
                        {"width": 67, "depth_log2": 4, "reserve": 0}),
    "packet_decoder": Core("packet_decoder", "of the default core"),
    "edge_walker": Core("edge_walker", ""),
    "span_walker": Core("span_walker", ""),
    "forward_difference": Core("forward_difference", "a second-order colour channel", {"slices": 2},
                               families=("ecp5",)),
    "colour_stage": Core("colour_stage", ""),
    "line_interpolator": Core("line_interpolator", "22 bits", {"phase_bits": 22, "ra_bits": 12}),
    "bell_rom": Core("bell_rom", "cos^9.5, 256 words",
                     {"address_bits": 8, "data_bits": 8, "exponent_tenths": 95, "wrap_bits": 3, "folded": True}),
    "exp2_rom": Core("exp2_rom", "64 words"),
    "power_rom": Core("power_rom", "two banks of 1 KB"),
    "highlight_stage": Core("highlight_stage", "one log channel, exp2_rom alone",
                            {"log_channels": 1, "has_power": False}),
}

# (design, family, key, least, most, why): where memories and multipliers belong.
SHADING = ("gouraud", "quadratic", "quadratic-depth")
BELONGS = [
    ("bell_rom", "ecp5", "bram", 0, 0, "256 x 8 fit into LUTs"),
    ("bell_rom", "ice40", "bram", 1, 1, "the table with its registers is one block RAM"),
    *(("exp2_rom", family, "bram", 0, 0, "64 x 8 fit into LUTs") for family in CELLS),
    ("power_rom", "ecp5", "bram", 1, 1, "two banks of 256 x 32 are one block RAM"),
    ("power_rom", "ice40", "bram", 4, 4, "two banks of 256 x 32 are four block RAMs"),
    *(("highlight_stage", family, "dsp", 0, 0, "highlights are looked up, shifted and added") for family in CELLS),
    ("stream_fifo", "ecp5", "lut_ram", 17, 17, "67 x 16 in LUT memory, four bits each"),
    ("stream_fifo", "ecp5", "bram", 0, 0, "LUT memory serves"),
    ("stream_fifo", "ice40", "bram", 5, 5, "67 x 16 in block RAM, sixteen bits each"),
    *((core, family, "dsp", 0, 0, "the datapath has no multiplier") for core in CORES for family in CELLS),
    *((core, "ecp5", "bram", 0, 0, "queues stand in LUT memory") for core in SHADING),
    *((core, "ecp5", "lut_ram", 1, None, "queues stand in LUT memory") for core in SHADING),
    *((core, "ice40", "bram", 1, None, "queues stand in block RAM") for core in SHADING),
]


def count(cells, family):
    """{key: cells of that kind}. Every kind of iCE40 flip-flop has a name that starts alike."""
    prefixed = {"ff"} if family == "ice40" else set()
    return {key: sum(number for name, number in cells.items()
                     if (name.startswith(CELLS[family][key]) if key in prefixed else name in CELLS[family][key]))
            for key in KEYS}


def measure(jobs):
    """{design: {family: {key: cells}}} of everything."""
    designs = {**UNITS, **CORES}
    progress = Progress(len(designs) * len(CELLS))

    def measure_one(name):
        design, folder = designs[name], BUILD / "area" / name
        found = {}
        for family in CELLS:
            progress.show(f"{name} for {family}")
            verilog = to_verilog(folder / family, design.entity, design.generics_for(family), design.sources)
            netlist = to_netlist(folder / family, family, verilog, design.entity, wrapped=False)
            found[family] = count(netlist.cells, family)
            progress.step()
        return found

    with ThreadPoolExecutor(max_workers=jobs) as pool:
        measured = dict(zip(designs, pool.map(measure_one, designs)))
    progress.clear()
    return measured


def differences(measured, recorded):
    """One line for each number that its record does not allow."""
    for name, families in measured.items():
        for family, found in families.items():
            known = recorded.get(name, {}).get(family)
            if known is None:
                yield f"{name} on {family} is not recorded; found {found}"
                continue
            for key in KEYS:
                allowed = SLACK + MARGIN * known[key] if key in ("lut", "carry", "ff") else 0
                if abs(found[key] - known[key]) > allowed:
                    yield f"{name} on {family}: {key} {found[key]}, recorded {known[key]}, margin {allowed:.0f}"
    for name in recorded:
        if name not in measured:
            yield f"{name} is recorded and no design"


def misplaced(measured):
    """One line for each memory or multiplier that is not where it belongs."""
    for name, family, key, least, most, why in BELONGS:
        found = measured[name][family][key]
        if found < least or (most is not None and found > most):
            wanted = f"at least {least}" if most is None else least if least == most else f"{least} to {most}"
            yield f"{name} on {family}: {key} {found}, must be {wanted}: {why}"


def text(measured):
    """A table of everything."""
    lines = [f"{'design':<20}{'family':<8}" + "".join(f"{key:>9}" for key in KEYS)]
    lines += [f"{name:<20}{family:<8}" + "".join(f"{found[key]:>9,}" for key in KEYS)
              for name, families in measured.items() for family, found in families.items()]
    return "\n".join(lines)


def main(arguments):
    """The command line; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--update", choices=("0", "1"), default="0", help="1: record instead of comparing")
    parser.add_argument("--record", type=Path, default=RECORD, help=f"default: {RECORD.relative_to(ROOT)}")
    parser.add_argument("--jobs", type=int, default=1, help="designs at a time")
    options = parser.parse_args(arguments)
    try:
        measured = measure(options.jobs)
        findings = list(misplaced(measured))
        if options.update == "0":
            if not options.record.exists():
                raise tools.FpgaError(f"{options.record} is missing; `make test-area UPDATE=1` writes it")
            findings += differences(measured, json.loads(options.record.read_text(encoding="utf-8"))["designs"])
    except tools.FpgaError as error:
        print(f"test-area: {error}", file=sys.stderr)
        return 1
    print(text(measured))
    for finding in findings:
        print(f"test-area: {finding}", file=sys.stderr)
    if findings:
        return 1
    if options.update == "1":
        options.record.parent.mkdir(parents=True, exist_ok=True)
        record = {"by": "make test-area UPDATE=1", "yosys": tools.version("yosys"), "designs": measured}
        options.record.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
        print(f"test-area: recorded in {options.record}")
    else:
        print(f"test-area: {len(measured)} designs on {len(CELLS)} families, all within {100 * MARGIN:.0f} %")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

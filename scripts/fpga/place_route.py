# SPDX-License-Identifier: MIT
"""A netlist onto a part: nextpnr, its report, the bitstream."""

import json
import re
from dataclasses import dataclass
from pathlib import Path

import tools
from synthesis import digest, fresh

TEXT = {"ecp5": "--textcfg", "ice40": "--asc"}
UNCONSTRAINED = {"ecp5": "--lpf-allow-unconstrained", "ice40": "--pcf-allow-unconstrained"}
CONSTRAINED = {"ecp5": "--lpf", "ice40": "--pcf"}
EFFORT = {"ecp5": ("--placer-heap-timingweight", "30"), "ice40": ()}
NEXTPNR = {"ecp5": "nextpnr-ecp5", "ice40": "nextpnr-ice40"}

# How nextpnr-ice40 tells what its logic cells hold.
ICE40_CELLS = re.compile(r"Info:\s+(\d+) LCs used as (LUT4 only|LUT4 and DFF|DFF only|CARRY only)")


@dataclass(frozen=True)
class Placed:
    """One run of nextpnr: its own report, what it said, the design as ecppack and icepack take it."""

    seed: int
    report: dict
    log: Path
    text: Path

    @property
    def fmax(self):
        """The slowest clock's greatest frequency in MHz."""
        return min(clock["achieved"] for clock in self.report["fmax"].values())


def place_and_route(netlist, part, seed, folder, constraints=None):
    """Run nextpnr with this seed; a run whose inputs have not changed is read again from `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    report = folder / f"seed-{seed}.report.json"
    text = folder / f"seed-{seed}.text"
    log = folder / f"seed-{seed}.log"
    arguments = [*part.arguments, "--seed", seed, "--freq", part.target, "--timing-allow-fail"]
    arguments += EFFORT[part.family]
    arguments += [CONSTRAINED[part.family], constraints] if constraints else [UNCONSTRAINED[part.family]]
    stamp = folder / f"seed-{seed}.digest"
    constrained = [constraints] if constraints else []
    wanted = digest(tools.version(NEXTPNR[part.family]), netlist.path, arguments, *constrained)
    if not (fresh(stamp, wanted) and report.exists() and text.exists()):
        tools.run(NEXTPNR[part.family], *arguments, "--json", netlist.path, TEXT[part.family], text, "--report", report,
                  log=log)
        stamp.write_text(wanted, encoding="utf-8")
    return Placed(seed, json.loads(report.read_text(encoding="utf-8")), log, text)


def write_bitstream(placed, part, path):
    """The bitstream of a placed design as the file `path`."""
    log = path.with_suffix(".log")
    if part.family == "ecp5":
        tools.run("ecppack", "--compress", "--input", placed.text, "--bit", path, log=log)
    else:
        tools.run("icepack", placed.text, path, log=log)


def area(placed, part, around):
    """{lut, ff, bram, dsp} of the placed design without the cells `around` it.

    lut counts logic cells whose LUT is taken: by logic, by a carry, on ECP5 also as memory. On iCE40 nextpnr counts
    cells that hold only a flip-flop as well; here they are in ff alone.
    """
    used = {name: count["used"] for name, count in placed.report["utilization"].items()}
    if part.family == "ecp5":
        return {"lut": used["TRELLIS_COMB"] - around.get("LUT4", 0),
                "ff": used["TRELLIS_FF"] - around.get("TRELLIS_FF", 0),
                "bram": used["DP16KD"], "dsp": used["MULT18X18D"]}
    log = placed.log.read_text(encoding="utf-8", errors="replace")
    holds = {what: int(count) for count, what in ICE40_CELLS.findall(log)}
    flip_flops = sum(count for name, count in around.items() if name.startswith("SB_DFF"))
    return {"lut": holds["LUT4 only"] + holds["LUT4 and DFF"] + holds.get("CARRY only", 0) - around.get("SB_LUT4", 0),
            "ff": holds["LUT4 and DFF"] + holds["DFF only"] - flip_flops,
            "bram": used["ICESTORM_RAM"], "dsp": used.get("ICESTORM_DSP", 0)}

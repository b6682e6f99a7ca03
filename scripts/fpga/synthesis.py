# SPDX-License-Identifier: MIT
"""VHDL to a netlist of one family's cells: GHDL writes Verilog, yosys maps it.

Every result is kept beside a digest of what it was made from, and made anew only when that changes.
"""

import hashlib
import json
import re
from dataclasses import dataclass
from pathlib import Path

import harness
import tools
from designs import rtl_sources

SYNTH = {"ecp5": "synth_ecp5", "ice40": "synth_ice40"}
LIBRARY = "sheen"


@dataclass(frozen=True)
class Netlist:
    """A mapped design: `cells` counts the design's own cells by type, `around` those of the harness around it."""

    path: Path
    top: str
    units: dict  # instance path -> entity
    cells: dict
    around: dict


def digest(*texts):
    """A digest of texts and files."""
    value = hashlib.sha256()
    for text in texts:
        value.update(text.read_bytes() if isinstance(text, Path) else str(text).encode())
        value.update(b"\0")
    return value.hexdigest()


def fresh(stamp, wanted):
    """Does the file `stamp` hold this digest?"""
    return stamp.exists() and stamp.read_text(encoding="utf-8") == wanted


def to_verilog(folder, entity, generics, sources):
    """Analyse the sources and write the entity as Verilog; returns the file."""
    folder.mkdir(parents=True, exist_ok=True)
    verilog = folder / f"{entity}.v"
    stamp = folder / "verilog.digest"
    files = [*rtl_sources(), *sources]
    wanted = digest(tools.version("ghdl"), entity, sorted(generics.items()), *files)
    if fresh(stamp, wanted) and verilog.exists():
        return verilog
    options = ["--std=08", f"--work={LIBRARY}", f"--workdir={folder}"]
    tools.run("ghdl", "-a", *options, *files, log=folder / "ghdl-analysis.log")
    words = [f"-g{name}={str(value).lower()}" for name, value in generics.items()]
    tools.run("ghdl", "--synth", *options, *words, "--out=verilog", entity, log=folder / "ghdl-synthesis.log",
              output=verilog)
    stamp.write_text(wanted, encoding="utf-8")
    return verilog


def units(verilog, top):
    """{instance path, names with dots between: entity} below `top`; GHDL appends generics to entities' names."""
    entities = sorted((path.stem for path in verilog.parent.glob("*.o")), key=len, reverse=True)
    modules = dict(re.findall(r"^module (\w+)$(.*?)^endmodule$", verilog.read_text(encoding="utf-8"),
                              re.MULTILINE | re.DOTALL))
    found = {}

    def descend(module, path):
        for below, name in re.findall(r"^  (\w+) (\w+) \($", modules[module], re.MULTILINE):
            found[path + name] = next((entity for entity in entities if below.startswith(entity)), below)
            descend(below, f"{path}{name}.")

    descend(top, "")
    return found


def counts(stat_file):
    """Cells by type of the one design that yosys counted."""
    return json.loads(stat_file.read_text(encoding="utf-8"))["design"]["num_cells_by_type"]


def script(folder, family, verilog, top, wrapped):
    """The yosys commands that map `top`, and, apart from it, the harness around it.

    No queue reads a place in the clock in which it writes it (stream_fifo fetches what it stored, and writes where
    there is room), so memories need no logic for that case: -no-rw-check. For a carry cell that a source
    instantiates GHDL writes an empty module each time, and its strings as vectors, which nextpnr does not take.
    """
    yield f"read_verilog -sv -overwrite {verilog}"
    yield 'setparam -set INJECT1_0 "NO" -set INJECT1_1 "NO" t:CCU2C'
    yield f"{SYNTH[family]} -no-rw-check -top {top}"
    yield f"tee -q -o {folder}/cells.json stat -json"
    if wrapped:
        yield "design -stash mapped"
        yield f"read_verilog {folder}/harness.v"
        yield f"{SYNTH[family]} -top harness"
        yield f"tee -q -o {folder}/around.json stat -json"
        yield f"delete ={top}"
        yield f"design -copy-from mapped {top}"
        yield "hierarchy -top harness"
        yield "flatten"
        yield "clean"
    yield f"write_json {folder}/netlist.json"


def to_netlist(folder, family, verilog, top, wrapped):
    """Map a design to a family's cells; `wrapped`: with the harness around it, which is mapped apart."""
    folder.mkdir(parents=True, exist_ok=True)
    if wrapped:
        text = harness.harness(top, harness.ports(verilog.read_text(encoding="utf-8"), top))
        (folder / "harness.v").write_text(text, encoding="utf-8")
    commands = "\n".join(script(folder, family, verilog, top, wrapped)) + "\n"
    stamp = folder / "netlist.digest"
    around = folder / "around.json"
    wanted = digest(tools.version("yosys"), commands, verilog, *([folder / "harness.v"] if wrapped else []))
    netlist = folder / "netlist.json"
    if not (fresh(stamp, wanted) and netlist.exists()):
        (folder / "map.ys").write_text(commands, encoding="utf-8")
        tools.run("yosys", "-q", folder / "map.ys", log=folder / "yosys.log")
        stamp.write_text(wanted, encoding="utf-8")
    return Netlist(netlist, top, units(verilog, top), counts(folder / "cells.json"), counts(around) if wrapped else {})

#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A core to take away: `make ip`.

make_ip.py OUT EXAMPLE VERSION [CORE…]: for each core of cores.txt (or those named) makes the folder OUT/CORE:

    sheen_<core>.v        the core as one Verilog file, its modules named after it
    vhdl/                 the VHDL sources, a top of that name, and files.txt, the order to analyse them in
    example.v             a self-checking example, with example_beats.hex and example_words.hex
    template.v .vhd       instantiations to copy
    sheen_<core>.core     FuseSoC
    README.md LICENSE     ports, how to run the example, what may be done with the files

EXAMPLE is the program built from tests/ip/make_ip_example.cpp. Exit status: 0, 1 a tool failed, 2 an unknown core.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import texts

ROOT = pathlib.Path(__file__).resolve().parents[2]
RTL = ROOT / "rtl_vhdl"
GHDL = os.environ.get("GHDL", "ghdl")
TOP = "shading_core"
# Units that the core doesn't use: a pair with a bench of its own.
NOT_OF_THE_CORE = {"generated/bell_rom_pkg.vhd", "line_interpolator.vhd", "bell_rom.vhd"}


class Core:
    """A configuration: a line of cores.txt."""

    def __init__(self, line):
        self.name, words, self.depth, self.quadratic, self.summary = (field.strip() for field in line.split("|"))
        self.words_per_beat = int(words)
        self.top = "sheen_" + self.name.replace("-", "_")

    @property
    def generics(self):
        """The VHDL generics that make the core, in the order of the entity."""
        return {"words_per_beat": str(self.words_per_beat), "has_depth": self.depth, "has_quadratic": self.quadratic}


def read_cores():
    lines = (ROOT / "scripts/ip/cores.txt").read_text().splitlines()
    return [Core(line) for line in lines if line and not line.startswith("#")]


def run(command, **options):
    """Runs a tool; what it says is shown only when it fails."""
    result = subprocess.run(command, capture_output=True, text=True, **options)
    if result.returncode != 0:
        sys.exit(f"make_ip: {' '.join(map(str, command))} failed:\n{result.stderr}{result.stdout}")
    return result.stdout


def rtl_files():
    names = (RTL / "files.txt").read_text().split()
    return [name for name in names if name not in NOT_OF_THE_CORE]


def synthesize(core, work):
    """The core as Verilog, as GHDL writes it."""
    options = ["--std=08", "--work=sheen", f"--workdir={work}"]
    run([GHDL, "-a", *options, *(RTL / name for name in rtl_files())], cwd=work)
    generics = [f"-g{name}={value}" for name, value in core.generics.items()]
    return run([GHDL, "--synth", *options, *generics, "--out=verilog", TOP], cwd=work)


def self_contained(verilog, core):
    """Modules get the core's name, so that two cores can meet in one design; comments name files without folders."""
    verilog = re.sub(r"/\* (?:\S*/)?([^/\s]+:\d+:\d+)\s*\*/", r"/* \1 */", verilog)
    # A constant's process never wakes: its initial value is all there is. Initial values are no registers.
    verilog = re.sub(r"^  always @\*\n    \w+ = \d+'b[01]+; // \(isignal\)\n", "", verilog, flags=re.MULTILINE)
    verilog = re.sub(r"^(  initial\n    \w+) <= ", r"\1 = ", verilog, flags=re.MULTILINE)
    # GHDL writes the choices of combinational cases as non-blocking; clocked processes have no case.
    verilog = re.sub(r"^( +(?:\d+'b[01]+|default): *\w+) <= ", r"\1 = ", verilog, flags=re.MULTILINE)
    for module in re.findall(r"^module (\w+)", verilog, re.MULTILINE):
        name = core.top if module == TOP else f"{core.top}_{module}"
        verilog = re.sub(rf"^(module |  ){re.escape(module)}\b", rf"\g<1>{name}", verilog, flags=re.MULTILINE)
    return verilog


def ports_of(verilog, top):
    """[(direction, width in bits, name)] of the module `top`."""
    header = re.search(rf"^module {top}\s*\((.*?)\);", verilog, re.MULTILINE | re.DOTALL)
    found = re.findall(r"(input|output)\s+(?:wire\s+|reg\s+)?(?:\[(\d+):0\])?\s*(\w+)", header.group(1))
    return [(direction, int(high or 0) + 1, name) for direction, high, name in found]


def make(core, out, example, version):
    folder = out / core.name
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "vhdl").mkdir(parents=True)
    with tempfile.TemporaryDirectory() as work:
        verilog = self_contained(synthesize(core, work), core)
    ports = ports_of(verilog, core.top)

    def write(name, text):
        (folder / name).write_text(text)

    write(f"{core.top}.v", texts.verilog_head(core, version) + verilog)
    names = [pathlib.Path(name).name for name in rtl_files()]
    for name in rtl_files():
        shutil.copy(RTL / name, folder / "vhdl")
    write(f"vhdl/{core.top}.vhd", texts.vhdl_top(core, ports))
    names.append(f"{core.top}.vhd")
    write("vhdl/files.txt", "\n".join(names) + "\n")
    run([example, str(core.words_per_beat), core.depth, core.quadratic, folder])
    beats, words = (len((folder / f"example_{what}.hex").read_text().split()) for what in ("beats", "words"))
    write("example.v", texts.example(core, beats, words))
    write("template.v", texts.verilog_template(core, ports))
    write("template.vhd", texts.vhdl_template(core, ports))
    write(f"{core.top}.core", texts.fusesoc(core, version, names))
    write("README.md", texts.readme(core, ports, version))
    shutil.copy(ROOT / "LICENSE", folder)
    print(f"ip: {core.name}: {folder / (core.top + '.v')}, example of {words} words")


def main(out, example, version, wanted):
    cores = read_cores()
    names = [core.name for core in cores]
    for name in wanted:
        if name not in names:
            print(f"make_ip: CORE='{name}' is none of {', '.join(names)}", file=sys.stderr)
            sys.exit(2)
    for core in cores:
        if not wanted or core.name in wanted:
            make(core, pathlib.Path(out).resolve(), pathlib.Path(example).resolve(), version)


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit("usage: make_ip.py OUT EXAMPLE VERSION [CORE…]")
    main(*sys.argv[1:4], sys.argv[4:])

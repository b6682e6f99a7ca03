# SPDX-License-Identifier: MIT
"""What is built and on what: cores, parts and boards, each once."""

from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
RTL = ROOT / "rtl_vhdl"
CONSTRAINTS = ROOT / "constraints"
BUILD = ROOT / "build" / "fpga"


@dataclass(frozen=True)
class Core:
    """A design that is built out of context; its clock is `clk`, and a clock gives at most one pixel."""

    entity: str
    about: str
    generics: dict = field(default_factory=dict)
    sources: tuple = ()  # besides those of rtl_vhdl/files.txt
    families: tuple = ()  # those that its generic `family` knows; on others it is plain

    def generics_for(self, family):
        """The generics for parts of a family."""
        return {**self.generics, "family": family} if family in self.families else self.generics


@dataclass(frozen=True)
class Part:
    """An FPGA as nextpnr names it. `target`: the clock, in MHz, that placement and routing strive for."""

    name: str  # the part's name in tables
    family: str
    arguments: tuple
    target: int
    speed: str = ""  # grade; empty where the part's name says it


@dataclass(frozen=True)
class Board:
    """A board: constraints/<folder> holds <entity>.vhd and the constraint file."""

    folder: str
    entity: str
    constraint_file: str
    part: Part
    clock: float  # MHz, as in the constraint file

    @property
    def constraints(self):
        """The constraint file."""
        return CONSTRAINTS / self.folder / self.constraint_file


def shading_core(wanted):
    """A configuration of the core by its name in the list that `make ip` builds from."""
    for line in (ROOT / "scripts" / "ip" / "cores.txt").read_text(encoding="utf-8").splitlines():
        name, *fields = (field.strip() for field in line.split("|"))
        if name == wanted:
            words, depth, quadratic, about = fields
            return Core("shading_core", about, {"words_per_beat": int(words), "has_depth": depth == "true",
                                                "has_quadratic": quadratic == "true"}, families=("ecp5",))
    raise KeyError(f"scripts/ip/cores.txt has no core {wanted}")


CORES = {
    "gouraud": shading_core("gouraud"),
    "quadratic": shading_core("quadratic"),
    "quadratic-depth": shading_core("quadratic-depth"),
    "spherical-pair": Core("spherical_pair", "line_interpolator and bell_rom in a row, paper spherical",
                           sources=(CONSTRAINTS / "out_of_context" / "spherical_pair.vhd",)),
}

ECP5 = ("--85k", "--package", "CABGA756")
PARTS = {
    "ecp5-85k-6": Part("ecp5-85k", "ecp5", (*ECP5, "--speed", "6"), 300, "6"),
    "ecp5-85k-8": Part("ecp5-85k", "ecp5", (*ECP5, "--speed", "8"), 400, "8"),
    "ice40-hx8k": Part("ice40-hx8k", "ice40", ("--hx8k", "--package", "ct256"), 200),
    "ice40-up5k": Part("ice40-up5k", "ice40", ("--up5k", "--package", "sg48"), 60),
}

BOARDS = {
    "ulx3s": Board("ulx3s", "ulx3s_top", "ulx3s.lpf",
                   Part("ecp5-85k", "ecp5", ("--85k", "--package", "CABGA381", "--speed", "6"), 25, "6"), 25.0),
    "hx8k_breakout": Board("hx8k_breakout", "hx8k_breakout_top", "hx8k_breakout.pcf",
                           Part("ice40-hx8k", "ice40", ("--hx8k", "--package", "ct256"), 12), 12.0),
    "icebreaker": Board("icebreaker", "icebreaker_top", "icebreaker.pcf",
                        Part("ice40-up5k", "ice40", ("--up5k", "--package", "sg48"), 12), 12.0),
}

def listed(folder):
    """The files of a folder's files.txt, users after what they use."""
    return [folder / name for name in (folder / "files.txt").read_text(encoding="utf-8").split()]


def rtl_sources():
    """The files of rtl_vhdl."""
    return listed(RTL)


def board_sources(board):
    """The files of a board's top, which come after rtl_sources()."""
    return [path for path in listed(CONSTRAINTS) if path.parent.name in ("common", board.folder)]

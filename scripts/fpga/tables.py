# SPDX-License-Identifier: MIT
"""What `make fpga` found, as JSON, as text and as a part of a document."""

import json
import statistics
from dataclasses import dataclass

import tools
from critical_path import CriticalPath

BEGIN = "<!-- Between these marks stands what `make fpga` wrote. -->"
END = "<!-- end of `make fpga` -->"
HEADINGS = ("core", "part", "LUT", "FF", "BRAM", "DSP", "Fmax median", "best", "Mpixel/s", "a kLUT")


@dataclass(frozen=True)
class Result:
    """A core on a part, over all seeds. fmax: MHz, one a seed, ascending; `path` is that of the median seed."""

    core: str
    part: str
    speed: str
    area: dict
    fmax: tuple
    path: CriticalPath
    bitstream: str

    @property
    def median(self):
        """MHz."""
        return statistics.median(self.fmax)

    def row(self):
        """The row of table.json."""
        return {"core": self.core, "part": self.part, "speed": self.speed, **self.area,
                "fmax_median": round(self.median, 1), "fmax_best": round(self.fmax[-1], 1), "seeds": len(self.fmax)}

    def cells(self):
        """The row of a table for readers. A clock gives a pixel, so Mpixel/s is the median clock."""
        part = f"{self.part} speed {self.speed}" if self.speed else self.part
        return (self.core, part, *(f"{self.area[key]:,}" for key in ("lut", "ff", "bram", "dsp")), f"{self.median:.0f}",
                f"{self.fmax[-1]:.0f}", f"{self.median:.0f}", f"{1000 * self.median / self.area['lut']:.0f}")


def write_json(results, path):
    """table.json."""
    path.write_text(json.dumps([result.row() for result in results], indent=2) + "\n", encoding="utf-8")


def text(results):
    """The table for a terminal, and a line a row on its critical path."""
    rows = [HEADINGS, *(result.cells() for result in results)]
    widths = [max(len(row[column]) for row in rows) for column in range(len(HEADINGS))]
    lines = ["  ".join(cell.ljust(width) if column < 2 else cell.rjust(width)
                       for column, (cell, width) in enumerate(zip(row, widths))) for row in rows]
    lines += ["", "Critical path of the median seed:"]
    lines += [f"  {result.core}, {' '.join(filter(None, (result.part, result.speed)))}: {result.path.words()}"
              for result in results]
    return "\n".join(lines)


def markdown(results):
    """The same as a part of a document, with the tools' versions."""
    lines = ["| " + " | ".join(HEADINGS) + " |", "| --- | --- |" + " ---: |" * (len(HEADINGS) - 2)]
    lines += ["| " + " | ".join(result.cells()) + " |" for result in results]
    seeds = {len(result.fmax) for result in results}
    lines += ["", f"Clocks in MHz, over {', '.join(map(str, sorted(seeds)))} seeds.", "",
              "| core | part | critical path of the median seed |", "| --- | --- | --- |"]
    lines += [f"| {result.cells()[0]} | {result.cells()[1]} | {result.path.words()} |" for result in results]
    versions = ", ".join(f"{command} {tools.version(tool)}" for tool, command in tools.COMMANDS.items())
    return "\n".join([*lines, "", f"Tools: {versions}."])


def refresh(document, results):
    """Replace what stands between the marks of a document."""
    whole = document.read_text(encoding="utf-8")
    before, rest = whole.split(BEGIN)
    after = rest.split(END)[1]
    document.write_text(f"{before}{BEGIN}\n\n{markdown(results)}\n\n{END}{after}", encoding="utf-8")

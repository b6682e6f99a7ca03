# SPDX-License-Identifier: MIT
"""The critical path of nextpnr's report, in words."""

from dataclasses import dataclass

CARRY_PORTS = {"FCI", "FCO", "CIN", "COUT"}


@dataclass(frozen=True)
class CriticalPath:
    """The slowest path between two registers; delays in ns."""

    start: str
    end: str
    luts: int      # levels of logic
    carries: int   # carry cells passed
    logic: float
    routing: float
    slowest_net: str
    slowest_net_delay: float

    def words(self):
        """One sentence, without a full stop."""
        total = self.logic + self.routing
        return (f"{self.start} to {self.end}, {total:.2f} ns: {plural(self.luts, 'LUT')}, "
                f"{plural(self.carries, 'carry', 'carries')}, routing {100 * self.routing / total:.0f} %")


def plural(count, one, more=None):
    """`3 LUTs`, `1 LUT`."""
    return f"{count} {one if count == 1 else more or one + 's'}"


def place(cell, netlist):
    """The unit that a cell's name puts it in: `edge_walker (walker)`; nextpnr names cells after nets they drive."""
    names = cell.split(".")
    if netlist.around and names.pop(0) != "core":
        return "a register before or behind the core"
    for depth in range(len(names) - 1, 0, -1):
        path = ".".join(names[:depth])
        if path in netlist.units:
            return f"{netlist.units[path]} ({path})"
    return netlist.top


def slowest(report):
    """The report's critical path from a clock to itself: the slowest, if there are several clocks."""
    paths = [entry["path"] for entry in report["critical_paths"]
             if "<async>" not in entry["from"] + entry["to"] and entry["from"] == entry["to"]]
    return max(paths, key=lambda path: sum(segment["delay"] for segment in path))


def critical_path(report, netlist):
    """Read the slowest path of a placed synthesis.Netlist."""
    path = slowest(report)
    nets = [segment for segment in path if segment["type"] == "routing"]
    logic = [segment for segment in path if segment["type"] == "logic"]
    passed = [segment for segment in logic if segment["to"]["port"] in CARRY_PORTS]
    worst = max(nets, key=lambda segment: segment["delay"])
    return CriticalPath(
        start=place(nets[0]["from"]["cell"], netlist), end=place(nets[-1]["to"]["cell"], netlist),
        luts=len(logic) - len(passed), carries=len(passed),
        logic=sum(segment["delay"] for segment in path if segment["type"] != "routing"),
        routing=sum(segment["delay"] for segment in nets),
        slowest_net=worst["net"], slowest_net_delay=worst["delay"])

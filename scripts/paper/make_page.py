#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Page and pictures of `make paper`.

make_page.py FOLDER PAGE IMAGES: reads FOLDER/results.json and the single pictures beside it, which paper_results wrote;
draws sheets and plots into FOLDER and IMAGES, and writes the tables between the markers of PAGE. Nothing is written
unless all could be made. Exit status: 0, or 1 with one line that says what is missing or too large.
"""

import json
import os
import pathlib
import platform
import re
import sys

import matplotlib

import plots
import sheets
import tables
import verdicts

MAX_BYTES = 200_000


def write(path, data):
    """Whole or not at all."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    temporary.write_bytes(data)
    temporary.replace(path)


def machine(results):
    """Tools and class of machine of this run."""
    info = pathlib.Path("/proc/cpuinfo")
    match = re.search(r"^model name\s*:\s*(.+)$", info.read_text(), re.MULTILINE) if info.exists() else None
    processor = match.group(1) if match else "unknown processor"
    return (
        f"One run of `make paper`, {results['seconds']:.0f} s. g++ {results['compiler']} with -O2; matplotlib"
        f" {matplotlib.__version__}; {platform.machine()}, {processor}, {len(os.sched_getaffinity(0))} processors."
    )


def blocks(results):
    """The generated parts of the page, by name."""
    parts = {"machine": machine(results), "summary": verdicts.summary(results)}
    for name in (
        "gouraud bells memories halos knot spheres setup ratio fast_phong pixels break_even tables curvature recurrence"
        " misprints"
    ).split():
        parts[name] = getattr(tables, f"{name}_block")(results)
    return parts


def fill(text, parts, path):
    """The page with each part between its markers."""
    for name, part in parts.items():
        begin, end = f"<!-- make paper: {name} -->", f"<!-- {name}: end -->"
        if text.count(begin) != 1 or text.count(end) != 1:
            sys.exit(f"make_page: {path} must hold '{begin}' and '{end}' once each")
        before, rest = text.split(begin)
        text = f"{before}{begin}\n{part}\n{end}{rest.split(end)[1]}"
    return text


def main(folder, page, images):
    folder, page, images = pathlib.Path(folder), pathlib.Path(page), pathlib.Path(images)
    try:
        results = json.loads((folder / "results.json").read_text())
        pictures = {**sheets.sheets(folder), **plots.plots(results)}
        text = fill(page.read_text(), blocks(results), page)
    except (OSError, ValueError) as failure:
        sys.exit(f"make_page: {failure}; `make paper` writes it")
    for name, data in pictures.items():
        if len(data) > MAX_BYTES:
            sys.exit(f"make_page: {name}.png has {len(data)} bytes; {MAX_BYTES} are the limit")
    for name, data in pictures.items():
        for place in (folder, images):
            write(place / f"{name}.png", data)
    write(page, text.encode())
    print(f"paper: {page}, {len(pictures)} pictures in {images}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("usage: make_page.py FOLDER PAGE IMAGES")
    main(*sys.argv[1:])

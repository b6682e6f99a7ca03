#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tables and plots of `make bench`.

plot.py FOLDER PAGE IMAGES: reads throughput.json, kernels_bench.json and setup_bench.json in FOLDER, draws
throughput.png there and into IMAGES, and writes the tables between the two markers of PAGE. Exit status: 0, or 1 with
one line that says which file is missing or which marker PAGE lacks.
"""

import json
import os
import pathlib
import platform
import re
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)

BEGIN = "<!-- make bench: begin -->"
END = "<!-- make bench: end -->"

# RasterIX, full core, equilateral triangles: measured once, before Sheen was begun; not measured again here.
RASTERIX = {10: 0.09, 50: 0.24, 200: 0.48, 1000: 0.73}

# How a table marks the stage that bounds a figure.
MARKS = {"pixels": "", "setup stream": " s", "edge walker": " w"}


def table(head, rows):
    """A Markdown table: the first column to the left, numbers to the right."""
    lines = ["| " + " | ".join(head) + " |", "| --- |" + " ---: |" * (len(head) - 1)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines)


def first_line(command):
    """The first line that a command prints; 'not found' when it isn't there."""
    try:
        output = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return f"{command[0]}: not found"
    return output.splitlines()[0].strip()


def machine():
    """The class of this machine: architecture, processor, number of processors that may be used."""
    model = "unknown processor"
    info = pathlib.Path("/proc/cpuinfo")
    if info.exists():
        match = re.search(r"^model name\s*:\s*(.+)$", info.read_text(), re.MULTILINE)
        model = match.group(1) if match else model
    return f"{platform.machine()}, {model}, {len(os.sched_getaffinity(0))} processors"


def select(rows, **wanted):
    """The rows whose fields have the wanted values."""
    return [row for row in rows if all(row.get(key) == value for key, value in wanted.items())]


def triangle_table(rows, method, stalls):
    """Pixels per clock by shape and area, a column per stream width; `stalls`: (source, sink) in percent."""
    chosen = select(rows, method=method, source_stall_percent=stalls[0], sink_stall_percent=stalls[1])
    widths = sorted({row["stream_bits"] for row in chosen})
    lines = []
    for shape, area in dict.fromkeys((row["shape"], row["area"]) for row in chosen):
        cells = [f"{shape}, {area} px"]
        for bits in widths:
            (row,) = select(chosen, shape=shape, area=area, stream_bits=bits)
            mark = MARKS[row["busiest"]]
            cells.append(f"{row['pixels_per_clock']:.3f}{mark}")
        if stalls == (0, 0) and method == "quadratic":
            rasterix = RASTERIX.get(area) if shape == "equilateral" else None
            cells.append(f"{rasterix:.2f}" if rasterix else "")
        lines.append(cells)
    head = ["triangles"] + [f"{bits} bits" for bits in widths]
    if stalls == (0, 0) and method == "quadratic":
        head.append("RasterIX")
    return table(head, lines)


def mesh_table(rows):
    widths = sorted({row["stream_bits"] for row in rows})
    lines = []
    for mesh, method in dict.fromkeys((row["mesh"], row["method"]) for row in rows):
        group = select(rows, mesh=mesh, method=method)
        cells = [f"{mesh.split(':')[1]}, {method}", str(group[0]["triangles"]), str(group[0]["pixels"])]
        for bits in widths:
            (row,) = select(group, stream_bits=bits)
            cells.append(f"{row['pixels_per_clock']:.3f}")
        lines.append(cells)
    return table(["mesh, 512×512", "triangles", "pixels"] + [f"{bits} bits" for bits in widths], lines)


def device_table(rows):
    lines = []
    for row in rows:
        clocks = f"{row['cycles_per_second'] / 1e3:,.0f} k" if "cycles_per_second" in row else ""
        lines.append([row["device"], f"{row['pixels_per_second'] / 1e3:,.0f} k", clocks])
    return table(["device", "pixels per second", "clocks per second"], lines)


def benchmark_table(report, what):
    lines = []
    for row in report["benchmarks"]:
        if row.get("run_type", "iteration") == "iteration":
            lines.append([f"`{row['name']}`", f"{row['items_per_second'] / 1e6:,.3f} M"])
    return table([what, "per second"], lines)


def plot(rows, path):
    """Pixels per clock against triangle size, a line per stream width, RasterIX beside them."""
    chosen = select(rows, shape="equilateral", method="quadratic", source_stall_percent=0, sink_stall_percent=0)
    figure, axes = plt.subplots(figsize=(7.2, 4.2), dpi=120, layout="constrained")
    styles = {32: ("tab:orange", "s"), 64: ("tab:blue", "o"), 128: ("tab:green", "^")}
    for bits, (colour, marker) in styles.items():
        points = sorted((row["area"], row["pixels_per_clock"]) for row in select(chosen, stream_bits=bits))
        axes.plot(*zip(*points), color=colour, marker=marker, label=f"Sheen, {bits}-bit setup stream")
    axes.plot(*zip(*RASTERIX.items()), color="tab:gray", marker="x", linestyle="--", label="RasterIX, full core")
    axes.set_xscale("log")
    axes.set_xticks([10, 50, 200, 1000, 5000], ["10", "50", "200", "1000", "5000"])
    axes.minorticks_off()
    axes.set_ylim(0, 1.05)
    axes.set_xlabel("area of the triangles (pixels)")
    axes.set_ylabel("pixels per clock")
    axes.set_title("Equilateral triangles at random rotation, quadratic RGB with depth, one lane", fontsize=10)
    axes.grid(alpha=0.3)
    axes.legend(loc="lower right", fontsize=9)
    for target in path:
        figure.savefig(target)
    plt.close(figure)


def page(reports):
    throughput = reports["throughput"]
    triangles = throughput["triangles"]
    error = {
        sliver: 100 * max(row["relative_standard_error"] for row in triangles if (row["shape"] == "sliver") == sliver)
        for sliver in (False, True)
    }
    tools = [first_line(["ghdl", "--version"]), first_line(["verilator", "--version"]), first_line(["g++", "--version"])]
    parts = [
        f"By `make bench BENCH={throughput['extent']}`. Tools: {'; '.join(tools)}. Machine: {machine()}.",
        "### Pixels per clock, random triangles",
        "Random rotation and position, RGB and depth, setup stream included, never stalling. The mark names the stage with"
        " the most to do where it is not the pixels: s setup stream, w edge walker. The standard error of a figure is at most"
        f" {error[False]:.2f} %, of slivers {error[True]:.2f} %.",
        "![Pixels per clock against triangle size](images/throughput.png)",
        "Quadratic:",
        triangle_table(triangles, "quadratic", (0, 0)),
    ]
    if select(triangles, method="gouraud", shape="equilateral"):
        parts += ["Gouraud:", triangle_table(triangles, "gouraud", (0, 0))]
    parts += [
        "Quadratic, the source pauses in a random 25 % of the clocks:",
        triangle_table(triangles, "quadratic", (25, 0)),
        "Quadratic, the sink pauses in a random 25 % of the clocks:",
        triangle_table(triangles, "quadratic", (0, 25)),
        "### Pixels per clock, meshes",
        mesh_table(throughput["meshes"]),
        f"The [cycle model](cycle-model.md) is at most {throughput['worst_deviation_percent']:.2f} % from any of these.",
        "### Speed of the devices",
        "`builtin:sphere-168`, quadratic, 512×512, start and files included. The kernels (`hls`) are untimed.",
        device_table(throughput["devices"]),
        "### Kernels, compiled for this machine",
        benchmark_table(reports["kernels_bench"], "kernel (pixels)"),
        "### Host",
        benchmark_table(reports["setup_bench"], "step (triangles of the torus knot)"),
    ]
    return "\n\n".join(parts)


def main(folder, page_path, images):
    folder = pathlib.Path(folder)
    reports = {}
    for name in ("throughput", "kernels_bench", "setup_bench"):
        try:
            reports[name] = json.loads((folder / f"{name}.json").read_text())
        except (OSError, ValueError) as failure:
            sys.exit(f"plot: {failure}; `make bench` writes it")
    images = pathlib.Path(images)
    images.mkdir(parents=True, exist_ok=True)
    plot(reports["throughput"]["triangles"], [folder / "throughput.png", images / "throughput.png"])
    path = pathlib.Path(page_path)
    text = path.read_text()
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        sys.exit(f"plot: {path} must hold '{BEGIN}' and '{END}' once each")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    path.write_text(f"{before}{BEGIN}\n{page(reports)}\n{END}{after}")
    print(f"bench: tables in {path}, plot in {folder / 'throughput.png'}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit("usage: plot.py FOLDER PAGE IMAGES")
    main(*sys.argv[1:])

# SPDX-License-Identifier: MIT
"""Curves of the papers' figures, drawn from results.json."""

import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend is chosen first)
import numpy as np  # noqa: E402


def _png(figure):
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=100, pil_kwargs={"optimize": True})
    plt.close(figure)
    return buffer.getvalue()


def _both_sides(values):
    """Samples of an even function over 0…90° as angles and values over −90°…90°."""
    values = np.array(values)
    angles = np.linspace(0, 90, len(values))
    return np.concatenate([-angles[:0:-1], angles]), np.concatenate([values[:0:-1], values])


def bells(results):
    """Figure 9: cosⁿ beside the bells cos²(ax)."""
    rows = {row["n"]: row for row in results["bells"]["table"]}
    figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.2), layout="constrained", sharey=True)
    for n in (5, 10, 20, 50, 500):
        left.plot(*_both_sides(rows[n]["power"]), label=f"n = {n}")
    left.set(title="cosⁿx", xlabel="x in degrees")
    for n in (5, 10, 20):
        right.plot(*_both_sides(rows[n]["bell"]), label=f"a = {rows[n]['a']:.2f}")
    right.set(title="cos²ax", xlabel="x in degrees")
    for axes in (left, right):
        axes.set_xticks(range(-90, 91, 30))
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    return _png(figure)


def fits(results):
    """Figure 10: each power and its bell."""
    figure, panels = plt.subplots(2, 3, figsize=(8.4, 4.6), layout="constrained", sharey=True)
    for axes, row in zip(panels.flat, [row for row in results["bells"]["table"] if row["n"] > 2]):
        axes.plot(*_both_sides(row["power"]), color="tab:blue", label="cosⁿx")
        axes.plot(*_both_sides(row["bell"]), color="tab:red", linestyle="--", label="cos²ax")
        axes.set_title(f"n = {row['n']:.0f}, a = {row['a']:.4f}", fontsize=9)
        axes.set_xticks(range(-90, 91, 45))
        axes.grid(alpha=0.3)
    panels[0][0].legend(fontsize=8)
    return _png(figure)


def memories(results):
    """Figure 11: cos² and what a small memory holds of it."""
    figure, panels = plt.subplots(1, 2, figsize=(8.4, 3.2), layout="constrained", sharey=True)
    for axes, memory in zip(panels, results["bells"]["memories"]):
        angles, exact = _both_sides(results["bells"]["cos2"])
        axes.plot(angles, exact, color="tab:blue", label="cos²x")
        axes.step(*_both_sides(memory["values"]), color="tab:red", where="mid", linewidth=1, label="memory")
        axes.set(title=f"{memory['bits']} address and data bits", xlabel="x in degrees")
        axes.set_xticks(range(-90, 91, 30))
        axes.grid(alpha=0.3)
        axes.legend(fontsize=8)
    return _png(figure)


def curvature(results):
    """Taylor's error against the angle between a triangle's normals."""
    rows = results["taylor"]["curvature"]
    degrees = [row["degrees"] for row in rows]
    figure, axes = plt.subplots(figsize=(7.0, 3.6), layout="constrained")
    for key, colour, label in (("diffuse", "tab:blue", "diffuse"), ("highlight", "tab:red", "highlight, n = 20")):
        axes.plot(degrees, [row[f"{key}_max"] for row in rows], color=colour, marker="o", label=f"{label}, largest")
        axes.plot(degrees, [row[f"{key}_rms"] for row in rows], color=colour, linestyle="--", label=f"{label}, rms")
    axes.axvline(60, color="black", linewidth=0.8)
    axes.annotate("the paper's limit", (60, 0.15), rotation=90, ha="right", fontsize=8)
    axes.set(xlabel="degrees between the vertices' normals", ylabel="error in 8-bit steps", yscale="log", ylim=(0.1, 400))
    axes.grid(alpha=0.3)
    axes.legend(fontsize=8)
    return _png(figure)


STYLES = {
    "phong": ("tab:red", "v"),
    "duff": ("tab:orange", "s"),
    "taylor": ("tab:blue", "o"),
    "quadratic": ("tab:green", "^"),
    "gouraud": ("tab:gray", "."),
}


def break_even(results):
    """Price and time a pixel against pixels a triangle."""
    rows = results["break_even"]
    sizes = [row["pixels_per_triangle"] for row in rows]
    figure, panels = plt.subplots(1, 2, figsize=(9.0, 3.8), layout="constrained")
    for axes, key, unit, scale in (
        (panels[0], "price", "operations a pixel, a root and quotient 10", 1),
        (panels[1], "seconds", "time a pixel, Phong's at the right = 1", 1 / rows[-1]["phong"]["seconds"]),
    ):
        for method, (colour, marker) in STYLES.items():
            axes.plot(sizes, [row[method][key] * scale for row in rows], color=colour, marker=marker, label=method)
        axes.axvline(10, color="black", linewidth=0.8)
        axes.set(xscale="log", yscale="log", xlabel="pixels a triangle", title=unit)
        axes.title.set_fontsize(9)
        axes.grid(alpha=0.3, which="both")
    panels[0].legend(fontsize=8)
    return _png(figure)


def plots(results):
    """All plots: name to bytes."""
    return {
        "paper-bells": bells(results),
        "paper-bell-fits": fits(results),
        "paper-memory-curves": memories(results),
        "paper-curvature": curvature(results),
        "paper-break-even": break_even(results),
    }

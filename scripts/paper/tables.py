# SPDX-License-Identifier: MIT
"""The generated parts of docs/paper-results.md, from results.json: name to Markdown."""

import math

# What the papers state. Times are theirs: seconds (fast-phong) and milliseconds (quadratic).
TABLE_1 = {2: 1.0, 5: 1.4502, 10: 1.9845, 20: 2.7582, 50: 4.3143, 100: 6.0791, 500: 13.5535}
FAST_PHONG = {"gouraud": (406, 0), "taylor": (767, 119), "taylor-finite": (850, 202), "duff": (2597, 0), "phong": (3900, 0)}
QUADRATIC_MS = {"gouraud": 230, "quadratic": 250, "phong": 450}
MISPRINTS = {
    "horizontal-edges": ("`quadratic`, T3", "over Y2²: none where edge 12 is horizontal", "barycentric fit"),
    "real-steps": ("`quadratic`, section 5", "X_start += A, real: samples beside the centres", "whole steps"),
    "fraction-bits": ("`quadratic`, section 5", "b > log2 M, here 10 bits", "Sheen's words, 22 bits"),
    "equation-15": ("`spherical`, eq. 15", "+ (cos θ1·cos γ − cos θ2)/sin γ", "− that, as eq. 16"),
    "equations-10-11": ("`recurrence`, eq. 10, 11", "pixels t+3, t+4", "Chebyshev polynomials"),
    "integer-index": ("`recurrence`, eq. 6", "angle tφ at pixel t", "the angle of the pixel's centre"),
    "duff": ("`fast-phong`, Duff", "L within the bars", "\\|Ax + By + C\\|"),
    "t5": ("`fast-phong`, T5", "3ig²", "3cg²"),
    "finite-eye": ("`fast-phong`, finite eye", "m, n, o and T4", "m = D·D, n = 2D·E, o = E·E; T4 of the errata"),
}


def table(head, rows):
    """A Markdown table: the first column to the left, the others to the right."""
    lines = ["| " + " | ".join(head) + " |", "| --- |" + " ---: |" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def shown(quality):
    """PSNR and largest error of a quality."""
    psnr = "equal" if quality["psnr"] is None else "equal" if quality["psnr"] > 200 else f"{quality['psnr']:.1f} dB"
    text = psnr if psnr == "equal" else f"{psnr} / {quality['max_error']:.1f}"
    if quality["undefined_percent"] > 0:
        text += f", {quality['undefined_percent']:.0f} % undefined"
    return text


def by_name(rows):
    return {row["name"]: row for row in rows}


def operations(counts):
    """Counts in the papers' words."""
    words = (
        ("additions", "+"),
        ("multiplications", "×"),
        ("divisions", "÷"),
        ("roots", "√"),
        ("powers", "power"),
        ("table_reads", "table read"),
    )
    parts = [f"{counts[key]:.0f} {word}" for key, word in words if round(counts[key]) > 0]
    return ", ".join(parts) if parts else "0"


def triple(counts):
    return f"{counts['additions']} + {counts['multiplications']} + {counts['divisions']}"


def crossing(rows, key, dear):
    """Pixels a triangle beyond which `taylor` stays cheaper than `dear`, between the sizes measured; None if it is at all
    of them, infinity if it isn't at the largest."""
    rows = sorted(rows, key=lambda row: row["pixels_per_triangle"])
    gains = [math.log(row[dear][key] / row["taylor"][key]) for row in rows]
    dearer = [number for number, gain in enumerate(gains) if gain < 0]
    if not dearer:
        return None
    last = dearer[-1]
    if last + 1 == len(rows):
        return math.inf
    low, high = (math.log(row["pixels_per_triangle"]) for row in rows[last : last + 2])
    return math.exp(low + (high - low) * gains[last] / (gains[last] - gains[last + 1]))


def crossing_text(rows, key, dear):
    value = crossing(rows, key, dear)
    if value is None:
        return f"below {min(row['pixels_per_triangle'] for row in rows):.0f}"
    return "never" if math.isinf(value) else f"{value:.0f}"


def one_colour_break_even(counts):
    """Pixels after which Taylor's setup is paid, for one diffuse colour: against Phong and against Duff."""

    def price(c):
        return c["additions"] + c["multiplications"] + c["divisions"] + 9 * c["roots"]

    one = {name: price(value) for name, value in counts["one_diffuse_colour"].items()}
    against_phong = one["taylor_setup"] / (one["phong_pixel"] - one["taylor_pixel"])
    against_duff = (one["taylor_setup"] - one["duff_setup"]) / (one["duff_pixel"] - one["taylor_pixel"])
    return against_phong, against_duff


def single_colour_additions(counts):
    """Additions a pixel of one colour, diffuse and with a highlight: three colours share the highlight's address, two
    additions."""
    rows = {row["highlight"]: row for row in counts["pixels"] if row["method"] == "taylor"}
    return rows[False]["additions"] / 3, (rows[True]["additions"] - 2) / 3 + 2, rows[True]["table_reads"]


def bells_block(results):
    rows = []
    for row in results["bells"]["table"]:
        n = round(row["n"])
        same = "yes" if f"{row['a']:.4f}" == f"{TABLE_1[n]:.4f}" else "no"
        rows.append(
            [
                str(n),
                f"{TABLE_1[n]:.4f}",
                f"{row['a']:.4f}",
                same,
                f"{row['largest_error']:.3f}",
                f"{row['minimax_a']:.4f}",
                f"{row['minimax_error']:.3f}",
                f"{row['cos9_5_error']:.4f}",
            ]
        )
    head = ["n", "a, printed", "a, from eq. 20", "agree", "largest error", "best a", "its error", "best cos^9.5"]
    wrong, right = results["bells"]["figure_10_misprint"]
    return table(head, rows) + (
        f"\n\nFigure 10 is printed with a = {wrong['a']} for n = 10. The bell's integral is then"
        f" {100 * wrong['integral_mismatch']:+.2f} % off eq. 20; with {right['a']}, as in table 1,"
        f" {100 * right['integral_mismatch']:+.3f} %."
    )


def memories_block(results):
    drawn = {row["bits"]: row for row in results["spherical"]["figure_15"]}
    rows = [
        [
            f"{m['bits']} address, {m['bits']} data",
            f"{m['words']} × {m['bits']} = {m['memory_bits']}",
            f"{m['largest_error']:.3f}",
            shown(drawn[m["bits"]]),
        ]
        for m in results["bells"]["memories"]
    ]
    return table(["memory", "bits", "largest error of cos²", "picture against exact cosines"], rows)


def halos_block(results):
    rows = [[f"{row['n']}", shown(row["power"]), shown(row["bell"])] for row in results["spherical"]["figure_14"]]
    pairs = results["spherical"]["pairs"]
    return table(["n", "cosⁿ, against Phong", "cos²ax, against Phong"], rows) + (
        "\n\nBoth vectors interpolated, or one turned against the other (lamp near the sphere, n = 50): they differ by"
        f" {shown(pairs['turned_against_separate'])} steps; against Phong they have {shown(pairs['separate'])} and"
        f" {shown(pairs['turned'])}."
    )


def gouraud_block(results):
    return f"Gouraud against Phong: {shown(results['spherical']['figure_5'])} steps."


def knot_block(results):
    knot = results["quadratic"]["knot"]
    rows = [[name, shown(knot[name])] for name in ("gouraud", "quadratic", "spherical")]
    return table(["method", f"against Phong, {knot['triangles']} triangles, n = 20"], rows)


def spheres_block(results):
    rows = [
        [f"{row['triangles']}, n = {row['n']}", shown(row["gouraud"]), shown(row["quadratic"])]
        for row in results["quadratic"]["spheres"]
    ]
    return table(["triangles", "Gouraud, against Phong", "quadratic, against Phong"], rows)


def setup_block(results):
    setup = results["counts"]["quadratic_setup"]
    rows = [["paper's statement", "25", "51", "5"]]
    for key, label in (
        ("printed", "printed T0 to T5, run"),
        ("barycentric", "ours, corners' places given"),
        ("barycentric_rgb", "ours, red, green, blue"),
    ):
        rows.append([label] + [str(setup[key][name]) for name in ("additions", "multiplications", "divisions")])
    return table(["coefficients from six nodes", "additions", "multiplications", "divisions"], rows)


def ratio_block(results):
    times = by_name(results["times"]["quadratic"])
    base = times["gouraud"]["whole_seconds"]
    ours = {name: times[name]["whole_seconds"] / base for name in QUADRATIC_MS}
    rows = [
        [name, str(ms), f"{ms / QUADRATIC_MS['gouraud']:.2f}", f"{ours[name]:.2f}"] for name, ms in QUADRATIC_MS.items()
    ]
    # One unknown cost a pixel that all methods share: what makes Phong's ratio theirs, and what quadratic's is then.
    paper_phong = QUADRATIC_MS["phong"] / QUADRATIC_MS["gouraud"]
    common = (ours["phong"] - paper_phong) / (paper_phong - 1)
    predicted = (ours["quadratic"] + common) / (1 + common)
    return table(["method", "paper, ms", "paper, ratio", "ours, ratio"], rows) + (
        f"\n\nWith a cost common to all methods of {common:.1f} times Gouraud's loop, Phong's ratio is the paper's"
        f" {paper_phong:.2f}, and quadratic's {predicted:.2f}, where the paper has 1.09."
    )


def fast_phong_block(results):
    part = results["times"]["fast_phong"]
    times = by_name(part["rows"])
    base = times["gouraud"]["whole_seconds"]
    rows = []
    for name in ("gouraud", "taylor", "taylor-finite", "duff", "phong", "quadratic"):
        whole = times[name]["whole_seconds"]
        paper = FAST_PHONG.get(name)
        share = f"{100 * paper[1] / paper[0]:.0f} %" if paper and paper[1] else ""
        rows.append(
            [
                name,
                f"{paper[0]}" if paper else "",
                f"{paper[0] / FAST_PHONG['gouraud'][0]:.2f}" if paper else "",
                f"{whole / base:.2f}",
                share,
                f"{100 * times[name]['setup_seconds'] / whole:.0f} %",
            ]
        )
    head = ["method", "paper, s", "paper, ratio", "ours, ratio", "paper, coefficients", "ours, setup"]
    root = part["seconds_per_root_and_division"]
    shares = [
        f"{100 * root * times[name]['pixels'] / times[name]['whole_seconds']:.0f} % of {label}"
        for name, label in (("duff", "Duff's"), ("phong", "Phong's"))
    ]
    return table(head, rows) + (
        f"\n\nA root and a quotient by it, each waiting for the one before, would be {' and '.join(shares)} time; in the"
        f" paper roots alone are 55 % and 36 %."
    )


def pixels_block(results):
    counts = results["counts"]
    one = counts["one_diffuse_colour"]
    rows = [
        ["Phong, one diffuse colour", "7 +, 6 ×, 1 ÷, 1 √", operations(one["phong_pixel"])],
        ["Duff, one diffuse colour", "3 +, 1 ÷, 1 √", operations(one["duff_pixel"])],
        ["Taylor, one diffuse colour", "2 +", operations(one["taylor_pixel"])],
    ]
    diffuse, highlight, reads = single_colour_additions(counts)
    rows.append(["Taylor's loop, diffuse, a colour", "2 +", f"{diffuse:.0f} +"])
    rows.append(
        ["Taylor's loop, with a highlight, a colour", "5 +, 1 table read", f"{highlight:.0f} +, {reads:.0f} table read"]
    )
    for row in counts["pixels"]:
        if row["highlight"] and row["method"] in ("gouraud", "quadratic", "taylor", "duff", "phong"):
            rows.append([f"`{row['method']}`, red, green, blue, highlight", "", operations(row)])
    return table(["per pixel", "paper", "counted"], rows)


def break_even_block(results):
    rows = results["break_even"]
    against_phong, against_duff = one_colour_break_even(results["counts"])
    body = [
        ["one diffuse colour, counted", f"{against_phong:.1f}", f"{against_duff:.1f}"],
        ["three colours, highlight, setup and spans, counted"]
        + [crossing_text(rows, "price", dear) for dear in ("phong", "duff")],
        ["the same, timed"] + [crossing_text(rows, "seconds", dear) for dear in ("phong", "duff")],
    ]
    return table(["pixels a triangle from which Taylor is cheaper", "than Phong", "than Duff"], body)


def tables_block(results):
    paper = {1024: 20, 8192: 164}
    rows = [
        [
            f"{row['bytes'] // 1024} KB",
            str(paper[row["bytes"]]),
            str(row["greatest_n"]),
            f"{100 * row['sampling_error']:.3f} %",
            f"{100 * row['next_error']:.3f} %",
            f"{100 * row['error_with_bytes']:.2f} %",
        ]
        for row in results["taylor"]["tables"]
    ]
    return table(["table", "paper, n", "ours, n", "error there", "at n + 1", "rounded to bytes"], rows)


def curvature_block(results):
    rows = results["taylor"]["curvature"]
    lines = [
        [label] + [f"{row[key]:.1f}" for row in rows]
        for key, label in (
            ("diffuse_max", "diffuse, largest"),
            ("diffuse_rms", "diffuse, root mean square"),
            ("highlight_max", "highlight, n = 20, largest"),
            ("highlight_rms", "highlight, root mean square"),
        )
    ]
    return table(["degrees"] + [f"{row['degrees']:.0f}" for row in rows], lines)


def recurrence_block(results):
    times = by_name(results["times"]["recurrence"])
    normal = results["counts"]["unit_normal"]

    def factor(name, suffix):
        return times[f"phong{suffix}"]["whole_seconds"] / times[f"{name}{suffix}"]["whole_seconds"]

    alone = results["times"]["normals"]
    rows = [
        ["the unit normal and N·L, spans of 512 px", f"{alone['linear'] / alone['recurrent_normal']:.2f}", ""],
        ["N·L alone (eq. 14), spans of 512 px", f"{alone['linear'] / alone['recurrent_product']:.2f}", ""],
    ]
    rows += [
        [label, f"{factor('recurrence', suffix):.2f}", f"{factor('recurrence, 4 pixels', suffix):.2f}"]
        for suffix, label in (
            (", long spans", "whole loop, one triangle of 480 px"),
            ("", "whole loop, sphere of 168 triangles"),
        )
    ]
    counts = [
        ["normalised linear normal", "5 +, 3 ×, 3 ÷, 1 √", operations(normal["linear"])],
        ["recurrent normal", "3 −, 3 ×, 3 shifts", operations(normal["recurrence"])],
    ]
    return (
        table(["unit normal at a pixel", "paper", "counted"], counts)
        + "\n\n"
        + table(["times as fast as Phong (paper: more than 2)", "one pixel a step", "four pixels a step"], rows)
    )


def misprints_block(results):
    rows = []
    for row in results["misprints"]["pairs"]:
        where, printed, right = MISPRINTS[row["name"]]
        rows.append([where, printed, shown(row["printed"]), right, shown(row["right"])])
    second_order = results["misprints"]["printed_t4_t5_on_horizontal_edges"]
    return table(["where", "printed", "printed, drawn", "right", "right, drawn"], rows) + (
        f"\n\nWhere edge 12 is horizontal the printed T1, T2, T4 and T5 are at most {second_order:.0e} off: only T3 is lost."
    )

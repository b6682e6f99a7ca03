# SPDX-License-Identifier: MIT
"""The papers' claims, ours beside them, and whether they agree: judged by rules, from results.json."""

import tables


def _agrees(condition, otherwise):
    return "agrees" if condition else otherwise


def _spherical(results):
    rows = results["bells"]["table"]
    same = all(f"{row['a']:.4f}" == f"{tables.TABLE_1[round(row['n'])]:.4f}" for row in rows)
    worst = max(row["largest_error"] for row in rows)
    halo = min(row["bell"]["psnr"] for row in results["spherical"]["figure_14"])
    drawn = {row["bits"]: row for row in results["spherical"]["figure_15"]}
    pairs = results["spherical"]["pairs"]["turned_against_separate"]
    knot = results["quadratic"]["knot"]["spherical"]
    return [
        ("`spherical`, table 1", "a for 7 powers", "the same to 4 digits" if same else "differ", _agrees(same, "disagrees")),
        (
            "`spherical`, figure 10",
            "cos²ax is quite good for cosⁿx",
            f"at most {worst:.3f} off",
            _agrees(worst < 0.1, "disagrees"),
        ),
        (
            "`spherical`, figure 14",
            "halos a little smaller, centres bigger",
            f"{halo:.1f} dB or more against Phong",
            _agrees(halo > 40, "visible"),
        ),
        (
            "`spherical`, figure 15",
            "4 bits show rings, 6 bits none",
            f"errors to {drawn[4]['max_error']:.0f} and {drawn[6]['max_error']:.0f} steps",
            "agrees for 4 bits; 6 bits are fainter, not clean"
            if drawn[6]["max_error"] > 2
            else _agrees(drawn[4]["max_error"] > 8, "disagrees"),
        ),
        (
            "`spherical`, section 6",
            "turned and separate vectors look alike",
            f"{tables.shown(pairs)} steps",
            _agrees(pairs["psnr"] > 45, "disagrees"),
        ),
        ("`spherical`, figure 16", "as Phong on a complex mesh", tables.shown(knot), _agrees(knot["psnr"] > 40, "visible")),
    ]


def _quadratic(results):
    setup = results["counts"]["quadratic_setup"]
    printed = setup["printed"]
    ours = setup["barycentric"]
    same = (printed["additions"], printed["multiplications"], printed["divisions"]) == (25, 51, 5)
    coarse = [row for row in results["quadratic"]["spheres"] if row["n"] == 50]
    knot = results["quadratic"]["knot"]["quadratic"]
    times = tables.by_name(results["times"]["quadratic"])
    ratio = {name: times[name]["whole_seconds"] / times["gouraud"]["whole_seconds"] for name in times}
    return [
        (
            "`quadratic`, setup",
            "25 +, 51 ×, 5 ÷",
            f"printed terms: {tables.operations(printed)}; ours: {tables.operations(ours)}",
            _agrees(same, "disagrees") + ", and ours is cheaper",
        ),
        (
            "`quadratic`, figures 9 to 11",
            "as Phong, far better than Gouraud",
            "n = 50: " + ", ".join(f"{row['quadratic']['psnr']:.0f}" for row in coarse) + " dB; Gouraud "
            + ", ".join(f"{row['gouraud']['psnr']:.0f}" for row in coarse),
            "agrees from 374 triangles on; on 168 a sharp highlight differs"
            if coarse[0]["quadratic"]["max_error"] > 20
            else "agrees",
        ),
        ("`quadratic`, figure 8", "indistinguishable from Phong", tables.shown(knot), _agrees(knot["psnr"] > 42, "close, not the same")),
        (
            "`quadratic`, times",
            "1 : 1.09 : 1.96",
            f"1 : {ratio['quadratic']:.2f} : {ratio['phong']:.2f}",
            ("same order" if ratio["quadratic"] < ratio["phong"] else "another order")
            + "; our loops leave out what all methods share",
        ),
    ]


def _fast_phong(results):
    counts = results["counts"]
    diffuse, highlight, reads = tables.single_colour_additions(counts)
    against_phong, against_duff = tables.one_colour_break_even(counts)
    sizes = [(row["bytes"], row["greatest_n"]) for row in results["taylor"]["tables"]]
    at_30, at_60 = (row for row in results["taylor"]["curvature"] if row["degrees"] in (30, 60))
    times = tables.by_name(results["times"]["fast_phong"]["rows"])
    ratio = {name: times[name]["whole_seconds"] / times["gouraud"]["whole_seconds"] for name in tables.FAST_PHONG}
    # Two that differ by less than a tenth count as equal.
    ordered = sorted(tables.FAST_PHONG, key=lambda name: tables.FAST_PHONG[name][0])
    same_order = all(ratio[later] > 0.9 * ratio[name] for name, later in zip(ordered, ordered[1:]))
    return [
        (
            "`fast-phong`, additions a pixel",
            "2; with a highlight 5 and a read",
            f"{diffuse:.0f}; {highlight:.0f} and {reads:.0f} read",
            _agrees((round(diffuse), round(highlight), round(reads)) == (2, 5, 1), "disagrees"),
        ),
        (
            "`fast-phong`, times",
            " : ".join(f"{value[0] / 406:.1f}" for value in tables.FAST_PHONG.values()),
            " : ".join(f"{ratio[name]:.1f}" for name in tables.FAST_PHONG),
            "same order; roots have become cheap" if same_order else "another order; roots have become cheap",
        ),
        (
            "`fast-phong`, break-even",
            "10 pixels",
            f"one diffuse colour: {against_phong:.0f} against Phong, {against_duff:.0f} against Duff",
            _agrees(max(against_phong, against_duff) <= 10, "later"),
        ),
        (
            "`fast-phong`, tables",
            "1 KB to n = 20, 8 KB to n = 164",
            ", ".join(f"{size // 1024} KB to n = {n}" for size, n in sizes),
            _agrees(sizes == [(1024, 20), (8192, 164)], "disagrees"),
        ),
        (
            "`fast-phong`, curvature",
            "noticeable beyond 60°",
            f"at 30° up to {at_30['diffuse_max']:.0f} steps, at 60° {at_60['diffuse_max']:.0f}",
            _agrees(at_30["diffuse_max"] < 2 < at_60["diffuse_max"], "noticeable from about 30° on"),
        ),
    ]


def _recurrence(results):
    times = tables.by_name(results["times"]["recurrence"])
    short, long = (
        times[f"phong{kind}"]["whole_seconds"] / times[f"recurrence{kind}"]["whole_seconds"]
        for kind in ("", ", long spans")
    )
    alone = results["times"]["normals"]
    normals = alone["linear"] / alone["recurrent_normal"]
    normal = results["counts"]["unit_normal"]
    return [
        (
            "`recurrence`, normal",
            "3 −, 3 × for 5 +, 3 ×, 3 ÷, 1 √",
            f"{tables.operations(normal['recurrence'])} for {tables.operations(normal['linear'])}",
            _agrees(
                (normal["recurrence"]["additions"], normal["recurrence"]["multiplications"]) == (3, 3)
                and tables.operations(normal["linear"]) == "5 +, 3 ×, 3 ÷, 1 √",
                "disagrees",
            ),
        ),
        (
            "`recurrence`, speed",
            "more than 2 times Phong's",
            f"normals alone {normals:.1f} times; with the highlight's power {long:.1f}, on the sphere of 168 {short:.1f}",
            _agrees(min(short, long) > 2, "agrees for the normals, not for all of the shading" if normals > 2 else "less"),
        ),
    ]


def summary(results):
    rows = _spherical(results) + _quadratic(results) + _fast_phong(results) + _recurrence(results)
    lines = ["| claim | paper | ours | verdict |", "| --- | --- | --- | --- |"]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])

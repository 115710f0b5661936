#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Keeps the tables of docs/exploration.md equal to bench/results/exploration.csv.

    scripts/fill_exploration.py           writes the page
    scripts/fill_exploration.py --check   says whether it is stale

`./dev bench explore` makes the figures.
"""

import csv
import sys

from project_files import ROOT

PAGE = ROOT / "docs" / "exploration.md"
RESULTS = ROOT / "bench" / "results" / "exploration.csv"
COLUMNS = [("goals or loop", ("all goals reached", "loop closed"), ""), ("collisions", ("collisions in all",), ""), ("covered", ("covered",), "%"),
           ("way [m]", ("way",), ""), ("time [s]", ("time",), ""), ("map's error [cm]", ("mean absolute error of its map",), ""),
           ("x real time", ("times real time, one core",), ""), ("control step p99 [ms]", ("control step, p99",), "")]


def read_rows():
    """Row of the bench and method -> what was measured -> (median, how many runs), in the order of the file."""
    rows = {}
    with RESULTS.open(encoding="utf-8", newline="") as file:
        for line in csv.DictReader(file):
            name, what = line["figure"].split(": ", 1)
            what, _, runs = what.partition(", of ")
            rows.setdefault(name, {})[what] = (line["value"], runs)
    return rows


def cell(measured, names, unit):
    for name in names:
        if name in measured:
            value, runs = measured[name]
            if unit == "%":
                return f"{100 * float(value):.1f} %"
            return f"{value} of {runs}" if runs else f"{float(value):g}"
    return ""


def table(rows, drifting):
    lines = ["| scene and strategy | method | " + " | ".join(head for head, _, _ in COLUMNS) + " |", "| --- " * (2 + len(COLUMNS)) + "|"]
    for name, measured in rows.items():
        row, method = name.rsplit(", ", 1)
        if row.endswith(", drifting") == drifting:
            row = row.removesuffix(", drifting")
            lines.append(f"| {row} | `{method}` | " + " | ".join(cell(measured, names, unit) for _, names, unit in COLUMNS) + " |")
    lines.append("")
    lines.append("Ten seeds each, three of a building; medians, sums of collisions. Made by `./dev bench explore`.")
    return "\n".join(lines)


def filled(text, marker, content):
    begin, end = f"<!-- exploration:{marker} -->\n", "<!-- /exploration -->"
    head, rest = text.split(begin, 1)
    return head + begin + content + "\n" + end + rest.split(end, 1)[1]


def main():
    rows = read_rows()
    text = PAGE.read_text(encoding="utf-8")
    fresh = filled(filled(text, "results", table(rows, False)), "drift", table(rows, True))
    if "--check" in sys.argv:
        if fresh != text:
            sys.exit("docs/exploration.md is stale: run scripts/fill_exploration.py")
        return
    PAGE.write_text(fresh, encoding="utf-8")
    print("filled docs/exploration.md")


if __name__ == "__main__":
    main()

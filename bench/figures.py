# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Figures with targets: how they are printed and where they are kept."""

import csv
import datetime
import os
import pathlib
import re
import statistics
import subprocess
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
COLUMNS = ["figure", "value", "unit", "target", "verdict", "min", "median", "max", "runs", "date", "compiler", "revision"]


@dataclass(frozen=True)
class Target:
    at_least: bool
    limit: float

    def __str__(self):
        return f"{'>=' if self.at_least else '<='} {self.limit:g}"

    def met(self, value):
        return value >= self.limit if self.at_least else value <= self.limit


def at_least(limit):
    return Target(True, limit)


def at_most(limit):
    return Target(False, limit)


@dataclass
class Figure:
    name: str
    unit: str
    samples: list
    target: Target | None = None
    best: bool = False  # stated as the best run, else as the median

    @property
    def value(self):
        if self.best:
            return max(self.samples) if self.unit.endswith("/s") else min(self.samples)
        return statistics.median(self.samples)

    @property
    def verdict(self):
        return "" if self.target is None else "met" if self.target.met(self.value) else "MISSED"


def machine_name():
    model = "unknown"
    for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if line.startswith("model name"):
            model = line.split(":", 1)[1]
            break
    slug = re.sub(r"[^a-z0-9]+", "-", model.lower()).strip("-")
    return f"{slug}-{os.cpu_count()}-cores"


def git(*arguments):
    done = subprocess.run(["git", "-C", str(HERE), *arguments], capture_output=True, text=True, check=False)
    return done.stdout.strip() if done.returncode == 0 else ""


def revision():
    short = git("rev-parse", "--short=12", "HEAD") or "unknown"
    return short + ("-changed" if git("status", "--porcelain", "--untracked-files=no") else "")


def digits(value):
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:.0f}"


def print_table(figures):
    rows = [("figure", "measured", "target", "verdict")]
    rows += [(f.name, f"{digits(f.value)} {f.unit}", str(f.target or ""), f.verdict) for f in figures]
    widths = [max(len(row[k]) for row in rows) for k in range(4)]
    for row in rows:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())
    missed = [f.name for f in figures if f.verdict == "MISSED"]
    print(f"{len(missed)} of {sum(f.target is not None for f in figures)} targets missed")


def write_csv(path, figures, compiler):
    path.parent.mkdir(exist_ok=True)
    constant = [datetime.date.today().isoformat(), compiler, revision()]
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for f in figures:
            spread = [digits(min(f.samples)), digits(statistics.median(f.samples)), digits(max(f.samples))]
            writer.writerow([f.name, digits(f.value), f.unit, f.target or "", f.verdict, *spread, len(f.samples), *constant])

# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Prints how long files and functions are, and fails when they grow past the house limits.

Files: 95 % at most 300 lines. Functions: 95 % at most 40 lines, none longer than 80. Function spans are those of
Universal Ctags; the product (include, src, apps) and what stands around it (tests, bench, fuzz) are held apart.
"""

import json
import subprocess
import sys
from pathlib import Path

from project_files import ROOT, project_files

FILE_P95, FUNCTION_P95, FUNCTION_MAX = 300, 40, 80
PRODUCT = {"include", "src", "apps"}


def percentile(sorted_values: list[int], share: float) -> int:
    """Nearest-rank percentile."""
    rank = max(1, -(-len(sorted_values) * int(share * 100) // 100))
    return sorted_values[rank - 1]


def function_lengths(files: list[Path], root: Path) -> list[tuple[int, str]]:
    """(lines, "file:line name") of every function definition."""
    command = ["ctags", "--output-format=json", "--fields=+ne", "--language-force=C++", "--kinds-C++=f", "-f", "-", "-L", "-"]
    listing = subprocess.run(command, input="\n".join(map(str, files)), cwd=root, capture_output=True, text=True, check=True)
    tags = [json.loads(line) for line in listing.stdout.splitlines()]
    return [(tag["end"] - tag["line"] + 1, f"{tag['path']}:{tag['line']} {tag['name']}") for tag in tags if "end" in tag]


def report(title: str, lengths: list[tuple[int, str]], p95_limit: int, max_limit: int | None) -> list[str]:
    """Prints one line of distribution; returns what exceeds the limits."""
    if not lengths:
        return []
    lengths = sorted(lengths)
    values = [length for length, _ in lengths]
    p95 = percentile(values, 0.95)
    print(f"{title:26} {len(values):5}   p50 {percentile(values, 0.5):4}   p95 {p95:4}   max {values[-1]:4}  {lengths[-1][1]}")
    problems = []
    if p95 > p95_limit:
        problems.append(f"{title}: p95 is {p95} lines, limit {p95_limit}")
    if max_limit is not None:
        problems += [f"{where}: {length} lines, limit {max_limit}" for length, where in lengths if length > max_limit]
    return problems


def main() -> int:
    root = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    files = project_files("cpp", root)
    problems = []
    for title, chosen in (("product", [f for f in files if f.parts[0] in PRODUCT]),
                          ("tests, bench, fuzz", [f for f in files if f.parts[0] not in PRODUCT])):
        lines = [(len((root / file).read_text().splitlines()), str(file)) for file in chosen]
        problems += report(f"files, {title}", lines, FILE_P95, None)
        problems += report(f"fns, {title}", function_lengths(chosen, root) if chosen else [], FUNCTION_P95, FUNCTION_MAX)
    print("\n".join(problems) if problems else "sizes: within the limits")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

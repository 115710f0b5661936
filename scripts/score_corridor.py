# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Maps the recorded corridor with every method and writes the scores into docs/corridor.md.

`score_corridor.py COMMAND DATA`: COMMAND is the built `echoarc`, DATA the folder that holds run1, run2, run3. The tables
stand between `<!-- scores:NAME -->` and `<!-- /scores -->`; NAME is one of the settings below.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "corridor.md"
BLOCK = re.compile(r"(<!-- scores:([a-z_0-9]+) -->\n).*?(<!-- /scores -->)", re.S)
RUNS = ("run1", "run2", "run3")

# What `echoarc map` is given besides the log and `--method all`.
SETTINGS = {
    "as_shipped": [],
    # Below 3 m, as the independent program has it; the cut itself keeps what is exactly as far.
    "near": ["--set", "sensing.range_cut_m=2.9995", "--set", "vt.cell_m=0.02", "--set", "vt.sampling=sampled",
             "--set", "carve.guard_m=0.02", "--set", "combined.guard_m=0.02"],
}


def echoarc(command: str, *arguments: str | Path) -> str:
    answer = subprocess.run([command, *map(str, arguments)], capture_output=True, text=True, check=False)
    if answer.returncode != 0:
        sys.exit(f"{command} {arguments[0]}: {answer.stderr.strip()}")
    return answer.stdout


def scores(command: str, log: Path, settings: list[str]) -> dict[str, dict[str, float]]:
    """Every method's scores on one run."""
    description = ROOT / "descriptions" / "corridor.toml"
    with tempfile.TemporaryDirectory() as scratch:
        maps = Path(scratch) / "maps"
        echoarc(command, "map", log, "--describe", description, "--method", "all", *settings, "-o", maps)
        return json.loads(echoarc(command, "eval", maps, "--reference", log, "--describe", description, "--json"))["methods"]


def share(value: float | None) -> str:
    return "-" if value is None else f"{100 * value:.1f}"


def table(command: str, data: Path, settings: list[str]) -> str:
    runs = [scores(command, data / run, settings) for run in RUNS]
    rows = ["| method | " + " | ".join(f"run {run[3:]}, points | per 5 cm cell" for run in RUNS) + " |",
            "| --- |" + " ---: | ---: |" * len(RUNS)]
    for method in runs[0]:
        cells = []
        for run in runs:
            for kind in ("", "thinned_"):
                score = run[method]
                cells.append(f"{share(score[kind + 'accuracy_10cm'])} / {share(score[kind + 'coverage'])}")
        rows.append(f"| `{method}` | " + " | ".join(cells) + " |")
    return "\n".join(rows) + "\n"


def main() -> int:
    command, data = sys.argv[1], Path(sys.argv[2])
    text = PAGE.read_text()
    PAGE.write_text(BLOCK.sub(lambda m: m[1] + table(command, data, SETTINGS[m[2]]) + m[3], text))
    return 0


if __name__ == "__main__":
    sys.exit(main())

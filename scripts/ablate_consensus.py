# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Maps the recorded corridor with tangent consensus, in each of its modes and without each of its parts, and writes the
scores into docs/methods/consensus.md.

`ablate_consensus.py COMMAND DATA`: COMMAND is the built `echoarc`, DATA the folder that holds run1, run2, run3. The tables
stand between `<!-- corridor:NAME -->` and `<!-- /corridor -->`.
"""

import json
import re
import sys
import tempfile
from pathlib import Path

from score_corridor import ROOT, RUNS, echoarc

PAGE = ROOT / "docs" / "methods" / "consensus.md"
BLOCK = re.compile(r"(<!-- corridor:([a-z]+) -->\n).*?(<!-- /corridor -->)", re.S)
KINDS = ("accuracy_10cm", "coverage", "thinned_accuracy_10cm", "thinned_coverage")

# Method and settings of each row; echoes below 3 m, which consensus shows anyway.
NEAR = ["sensing.range_cut_m=2.9995"]
MODES = {
    "`centerline`": ("centerline", NEAR),
    "`atm_mod`, 13°": ("atm_mod", [*NEAR, "atm_mod.theta_t_deg=13"]),
    **{f"`consensus`, {mode}": ("consensus", [f"consensus.mode={mode}"]) for mode in ("strict", "balanced", "complete")},
}
WITHOUT = {
    "everything": [],
    "nothing thinned": ["thin_move_m=0", "thin_turn_deg=0", "thin_range_m=0"],
    "one sweep": ["sweeps=1"],
    "four sweeps": ["sweeps=4"],
    "support not tempered": ["independence=1"],
    "nothing against what was looked through": ["facing=0"],
    "half the neighbours, K = 48": ["neighbours=48"],
    "bearings within the nominal beam only": ["search_beams=0.5"],
    "no vote": ["blocked=1000000", "passed=1000000"],
    "no links": ["link_m=0"],
}


def scores(command: str, log: Path, method: str, settings: list[str]) -> dict[str, float]:
    description = ROOT / "descriptions" / "corridor.toml"
    values = [word for setting in settings for word in ("--set", setting)]
    with tempfile.TemporaryDirectory() as scratch:
        maps = Path(scratch) / "maps"
        echoarc(command, "map", log, "--describe", description, "--method", method, *values, "-o", maps)
        answer = echoarc(command, "eval", maps, "--reference", log, "--describe", description, "--json")
        return json.loads(answer)["methods"][method]


def modes(command: str, data: Path) -> str:
    rows = ["| points; one per 5 cm cell | " + " | ".join(f"run {run[3:]}" for run in RUNS) + " |",
            "| --- |" + " --- |" * len(RUNS)]
    for name, (method, settings) in MODES.items():
        runs = [scores(command, data / run, method, settings) for run in RUNS]
        cells = ["{:.3f} / {:.3f}; {:.3f} / {:.3f}".format(*(run[kind] for kind in KINDS)) for run in runs]
        rows.append(f"| {name} | " + " | ".join(cells) + " |")
    return "\n".join(rows) + "\n"


def ablation(command: str, data: Path) -> str:
    rows = ["| mean of the three runs | points, within 10 cm | coverage | per 5 cm cell, within 10 cm | coverage |",
            "| --- |" + " ---: |" * 4]
    for name, settings in WITHOUT.items():
        settings = [f"consensus.{setting}" for setting in settings]
        runs = [scores(command, data / run, "consensus", settings) for run in RUNS]
        means = [sum(run[kind] for run in runs) / len(runs) for kind in KINDS]
        rows.append(f"| {name} | " + " | ".join(f"{mean:.3f}" for mean in means) + " |")
    return "\n".join(rows) + "\n"


def main() -> int:
    command, data = sys.argv[1], Path(sys.argv[2])
    text = PAGE.read_text()
    tables = {"modes": modes, "ablation": ablation}
    PAGE.write_text(BLOCK.sub(lambda m: m[1] + tables[m[2]](command, data) + m[3], text))
    return 0


if __name__ == "__main__":
    sys.exit(main())

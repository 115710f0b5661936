# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Maps the recorded corridor with tangent consensus, each time without one of its parts, and writes the scores into
docs/methods/consensus.md.

`ablate_consensus.py COMMAND DATA`: COMMAND is the built `echoarc`, DATA the folder that holds run1, run2, run3. The table
stands between `<!-- ablation -->` and `<!-- /ablation -->`.
"""

import json
import re
import sys
import tempfile
from pathlib import Path

from score_corridor import ROOT, RUNS, echoarc

PAGE = ROOT / "docs" / "methods" / "consensus.md"
BLOCK = re.compile(r"(<!-- ablation -->\n).*?(<!-- /ablation -->)", re.S)
KINDS = ("accuracy_10cm", "coverage", "thinned_accuracy_10cm", "thinned_coverage")

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


def scores(command: str, log: Path, settings: list[str]) -> dict[str, float]:
    description = ROOT / "descriptions" / "corridor.toml"
    values = [word for setting in settings for word in ("--set", f"consensus.{setting}")]
    with tempfile.TemporaryDirectory() as scratch:
        maps = Path(scratch) / "maps"
        echoarc(command, "map", log, "--describe", description, "--method", "consensus", *values, "-o", maps)
        answer = echoarc(command, "eval", maps, "--reference", log, "--describe", description, "--json")
        return json.loads(answer)["methods"]["consensus"]


def table(command: str, data: Path) -> str:
    rows = ["| mean of the three runs | points, within 10 cm | coverage | per 5 cm cell, within 10 cm | coverage |",
            "| --- |" + " ---: |" * 4]
    for name, settings in WITHOUT.items():
        runs = [scores(command, data / run, settings) for run in RUNS]
        means = [sum(run[kind] for run in runs) / len(runs) for kind in KINDS]
        rows.append(f"| {name} | " + " | ".join(f"{mean:.3f}" for mean in means) + " |")
    return "\n".join(rows) + "\n"


def main() -> int:
    command, data = sys.argv[1], Path(sys.argv[2])
    text = PAGE.read_text()
    PAGE.write_text(BLOCK.sub(lambda m: m[1] + table(command, data) + m[2], text))
    return 0


if __name__ == "__main__":
    sys.exit(main())

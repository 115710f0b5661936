# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Maps the recorded corridor with tangent consensus, in each of its modes, without each of its parts and with other
constants, and with its grid form, and writes the scores into docs/methods/consensus.md and consensus_evidence.md.

`ablate_consensus.py COMMAND DATA`: COMMAND is the built `echoarc`, DATA the folder that holds run1, run2, run3. The tables
stand between `<!-- corridor:NAME -->` and `<!-- /corridor -->`.
"""

import itertools
import json
import re
import sys
import tempfile
from pathlib import Path

from score_corridor import ROOT, RUNS, echoarc

PAGES = [ROOT / "docs" / "methods" / page for page in ("consensus.md", "consensus_evidence.md")]
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
    "whatever the evidence of all echoes": ["occupied_threshold=0.5", "free_floor=0.499"],
    "no links": ["link_m=0"],
    "no zones": ["zone=0"],
}
# What the constants chosen on logs might be as well.
CANDIDATES = {"search_beams": (0.75, 0.95), "facing": (0.25, 0.3), "independence": (0.18, 0.22, 0.25),
              "accept_p": (0.45, 0.5, 0.55)}
# The grid form, and the evidence grid it is held against: one figure each, for a grid has one point a cell.
GRIDS = {"`evidence`": ("evidence", []), "`consensus_evidence`": ("consensus_evidence", [])}
GRID_OPTIONS = {
    "`no_echo_weight` 0.5, as in `evidence`": ("consensus_evidence", ["consensus_evidence.no_echo_weight=0.5"]),
    "`no_echo_weight` 0.05": ("consensus_evidence", ["consensus_evidence.no_echo_weight=0.05"]),
    "`spread_m` 0.05": ("consensus_evidence", ["consensus_evidence.spread_m=0.05"]),
    "`occupied_threshold` 0.8": ("consensus_evidence", ["consensus_evidence.occupied_threshold=0.8"]),
    "`evidence` with `no_echo_weight` 0.1": ("evidence", ["evidence.no_echo_weight=0.1"]),
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


def held_out(command: str, data: Path) -> str:
    """Each run with the candidates that are best, by the sum of accuracy and coverage per cell, on the other two."""
    tried = {}
    for values in itertools.product(*CANDIDATES.values()):
        settings = [f"consensus.{name}={value}" for name, value in zip(CANDIDATES, values)]
        tried[values] = [scores(command, data / run, "consensus", settings) for run in RUNS]
    shipped = [scores(command, data / run, "consensus", []) for run in RUNS]
    names = ", ".join(f"`{name}`" for name in CANDIDATES)
    rows = [f"| run | {names} by the other two | with these: points; per 5 cm cell | as shipped |", "| --- |" + " --- |" * 3]
    for left, run in enumerate(RUNS):
        def worth(values: tuple[float, ...], left: int = left) -> float:
            return sum(tried[values][k][kind] for k in range(len(RUNS)) if k != left for kind in KINDS[2:])
        best = max(tried, key=worth)
        figures = ["{:.3f} / {:.3f}; {:.3f} / {:.3f}".format(*(found[kind] for kind in KINDS))
                   for found in (tried[best][left], shipped[left])]
        rows.append(f"| {run[3:]} | " + ", ".join(f"{value:g}" for value in best) + " | " + " | ".join(figures) + " |")
    return "\n".join(rows) + "\n"


def grid_rows(command: str, data: Path, variants: dict[str, tuple[str, list[str]]]) -> str:
    rows = ["| | run 1 | run 2 | run 3 |", "| --- |" + " ---: |" * 3]
    for name, (method, settings) in variants.items():
        runs = [scores(command, data / run, method, settings) for run in RUNS]
        rows.append(f"| {name} | " + " | ".join("{:.3f} / {:.3f}".format(*(run[k] for k in KINDS[:2])) for run in runs) + " |")
    return "\n".join(rows) + "\n"


def grids(command: str, data: Path) -> str:
    return grid_rows(command, data, GRIDS)


def grid_options(command: str, data: Path) -> str:
    return grid_rows(command, data, GRID_OPTIONS)


def main() -> int:
    command, data = sys.argv[1], Path(sys.argv[2])
    tables = {"modes": modes, "ablation": ablation, "held": held_out, "grids": grids, "options": grid_options}
    for page in PAGES:
        page.write_text(BLOCK.sub(lambda m: m[1] + tables[m[2]](command, data) + m[3], page.read_text()))
    return 0


if __name__ == "__main__":
    sys.exit(main())

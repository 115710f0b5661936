# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Small trials of docs/methods/consensus.md on simulated scenes: what disturbs the method, and wide beams. Each is a
function (echoarc, option, folder) -> table."""

import json
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
KINDS = ("points", "accuracy_10cm", "coverage", "thinned_accuracy_10cm", "thinned_coverage")
HEAD = "points | within 10 cm | coverage | per 5 cm cell, within 10 cm | coverage |\n"
RULE = "| --- |" + " ---: |" * 5 + "\n"


def row(echoarc, folder: Path, title: str, scene: str, simulated: list[str], mapped: list[str]) -> str:
    """One drive through a scene (its text), scored against the surfaces of the scene."""
    (folder / "trial.toml").write_text(scene)
    echoarc.run("sim", folder / "trial.toml", "-o", folder / "trial.jsonl", "--force", *given(simulated))
    echoarc.run("map", folder / "trial.jsonl", "--method", "consensus", *given(mapped), "-o", folder / "trial-map")
    answer = echoarc.run("eval", folder / "trial-map", "--reference", folder / "trial.toml", "--json")
    scores = json.loads(answer)["methods"]["consensus"]
    cells = [f"{scores[kind]:.0f}" if kind == "points" else f"{scores[kind]:.3f}" for kind in KINDS]
    return f"| {title} | " + " | ".join(cells) + " |\n"


def given(settings: list[str]) -> list[str]:
    return [word for setting in settings for word in ("--set", setting)]


def disturbed(echoarc, _option: dict, folder: Path) -> str:
    """A corridor of brick, a person in it, and a robot that does not know where it is."""
    scene = (ROOT / "scenes" / "person.toml").read_text()
    empty = re.sub(r"\[\[moving\]\]\n(?:.+\n)+", "", scene)
    drifting = ["odometry.perfect=false"]
    return (f"| corridor of the scene `person` | {HEAD}{RULE}" + row(echoarc, folder, "nobody there", empty, [], []) +
            row(echoarc, folder, "someone walks by", scene, [], []) +
            row(echoarc, folder, "nobody there, odometry drifts", empty, drifting, []))


def wide_beams(echoarc, _option: dict, folder: Path) -> str:
    """The cart of the demo, whose sensors hear much more than their nominal beam."""
    scene = (ROOT / "scenes" / "demo.toml").read_text()
    table = f"| scene `demo`, nominal beam 15° | {HEAD}{RULE}"
    never = "wider_growth=1000000"
    table += row(echoarc, folder, "as stated: `wider_growth=1000000`", scene, [], [never])
    table += row(echoarc, folder, "as shipped", scene, [], [])
    for sigma, search in ((0.8, 1.5), (1.2, 2.25)):
        table += row(echoarc, folder, f"`sigma_beams={sigma:g}`, `search_beams={search:g}`, no wider", scene, [],
                     [f"sigma_beams={sigma}", f"search_beams={search}", never])
    return table

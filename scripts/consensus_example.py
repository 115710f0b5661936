# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""The worked example of docs/methods/consensus.md: a robot with one sensor hears a wall. The formulas of step B are
evaluated here, term by term, and compared with what `echoarc explain` answers."""

import json
import sys
from math import cos, exp, log, pi, radians, sin, sqrt
from pathlib import Path

WALL_Y_M = 1.5
BEAM_DEG = 20.0
# (x, y) of the sensor in metres and the direction of its axis in degrees: the wall is at +5 and -7 degrees off it.
ARCS = [(0.0, 0.0, 85.0), (0.3, 0.1, 97.0)]
# Further sensors of the same drive: from 0.35 m on to the right and from -0.1 m on to the left, by turns.
ARCS += [((0.35 + 0.05 * (k // 2)) if k % 2 == 0 else -0.1 - 0.05 * (k // 2), 0.05, (88.0, 93.0, 84.0, 96.0)[k % 4])
         for k in range(30)]
COUNTS = (1, 2, 4, 8, 16, 32)

def write_log(path: Path, count: int) -> None:
    sensor = {"id": 0, "x": 0.0, "y": 0.0, "yaw": 0.0, "beam_width": radians(BEAM_DEG), "range_min": 0.02,
              "range_max": 4.0}
    lines = [{"type": "header", "format": "echoarc-log", "version": 1, "robot": {"name": "example", "sensors": [sensor]}}]
    for k, (x, y, axis_deg) in enumerate(ARCS[:count]):
        lines += [{"type": "odom", "t": float(k), "x": x, "y": y, "yaw": radians(axis_deg)},
                  {"type": "ping", "t": float(k), "tx": 0, "rx": 0, "range": WALL_Y_M - y}]
    path.write_text("".join(json.dumps(line) + "\n" for line in lines))


def terms(option: dict, t_deg: float) -> dict:
    """What the second arc says of the bearing t of the first, under the wall hypothesis, in the first sweep."""
    (x, y, axis), (x2, y2, axis2) = ARCS[:2]
    n = (cos(radians(axis + t_deg)), sin(radians(axis + t_deg)))
    d = (x2 - x, y2 - y)
    e = (WALL_Y_M - y) - (WALL_Y_M - y2) - (n[0] * d[0] + n[1] * d[1])
    s = -n[1] * d[0] + n[0] * d[1]
    other_deg = axis + t_deg - axis2
    sigma_deg = option["sigma_beams"] * BEAM_DEG
    half_deg = option["search_beams"] * BEAM_DEG
    g = exp(-s * s / (2 * option["wall_length_m"] ** 2))
    u = 0.5 * exp(-0.5 * (other_deg / sigma_deg) ** 2) if abs(other_deg) <= half_deg else 0.0
    kappa = option["clutter_m"] / (option["range_sigma_m"] * sqrt(2 * pi))
    says = log(1 + option["detection"] * g * u * kappa * exp(-e * e / (2 * option["range_sigma_m"] ** 2)))
    prior = 0.0 - 0.5 * (t_deg / sigma_deg) ** 2
    return {"e": e, "s": s, "other_deg": other_deg, "g": g, "u": u, "says": says, "prior": 0.0 + prior,
            "L_W": prior + option["independence"] * says}


def two_arcs(echoarc, option: dict, folder: Path) -> str:
    """The terms at some bearings, as a table."""
    write_log(folder / "two.jsonl", 2)
    answer = echoarc.explain(folder / "two.jsonl", 0, "sweeps=1")
    bearings = [round(b) for b in answer["bearings_deg"]]
    logs = [terms(option, b)["L_W"] for b in bearings]
    total = sum(exp(value) for value in logs)
    for value, found in zip(logs, answer["sweeps"][0]["wall"]):
        if abs(exp(value) / total - found) > 1e-4:
            sys.exit(f"the worked example and the code disagree: {exp(value) / total} and {found}")
    rows = ["| t | e, cm | s, cm | t′ | g | u | ln(1 + …) | ℓ₀ | L_W | Q_W, sweep 1 |", "| ---: |" + " ---: |" * 9]
    for t in (-5, 0, 3, 5, 7, 10):
        v = terms(option, t)
        rows.append(f"| {t:+d}° | {100 * v['e']:+.1f} | {100 * v['s']:+.1f} | {v['other_deg']:+.0f}° | {v['g']:.2f} "
                    f"| {v['u']:.2f} | {v['says']:.2f} | {v['prior'] + 0.0:.2f} | {v['L_W']:.2f} "
                    f"| {answer['sweeps'][0]['wall'][bearings.index(t)]:.3f} |")
    return "\n".join(rows) + "\n"


def more_arcs(echoarc, _option: dict, folder: Path) -> str:
    """What more arcs of the same wall make of the first one."""
    rows = ["| arcs | p_w, sweep 1 | p_w, sweep 2 | read out at | p | 90 % bound, cm |", "| ---: |" + " ---: |" * 5]
    for count in COUNTS:
        log_file = folder / f"arcs{count}.jsonl"
        write_log(log_file, count)
        answer = echoarc.explain(log_file, 0)
        shares = [sweep["wall_share"] for sweep in answer["sweeps"]]
        rows.append(f"| {count} | {shares[0]:.2f} | {shares[-1]:.2f} | {answer['bearing_deg']:+.1f}° | {answer['p']:.2f} "
                    f"| {100 * answer['bound_m']:.0f} |")
    return "\n".join(rows) + "\n"

# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Draws the figures of docs/methods/consensus.md and computes the numbers of its example.

`draw_consensus_figures.py COMMAND`: COMMAND is the built `echoarc`. Pictures go to docs/pictures/consensus-*.svg, numbers
between `<!-- example:NAME -->` and `<!-- /example -->` of the page.
"""

import csv
import json
import re
import subprocess
import sys
import tempfile
import tomllib
from bisect import bisect_left
from math import cos, degrees, hypot, pi, radians, sin
from pathlib import Path

import consensus_example
import consensus_schemes
import consensus_trials
from svg_canvas import AMBER, BLUE, GREY, INK, MAGENTA, Canvas, Panel, Point, on_circle

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "methods" / "consensus.md"
PICTURES = ROOT / "docs" / "pictures"
# The room of the demo, and in it a ring of 16 sonars that look a little askew, so that walls are not straight ahead.
SCENE = (ROOT / "scenes" / "demo.toml").read_text().replace('"hc-sr04-row"', '"nomad200"')
SCENE = re.sub(r"(?m)^(frequency_hz|aperture_radius_m).*\n", "", SCENE).replace("[drive]", "[drive]\nfacing_deg = 7")
BLOCK = re.compile(r"(<!-- example:([a-z_0-9]+) -->\n).*?(<!-- /example -->)", re.S)


class Echoarc:
    def __init__(self, command: str):
        self.command = command

    def run(self, *arguments: str | Path) -> str:
        answer = subprocess.run([self.command, *map(str, arguments)], capture_output=True, text=True, check=False)
        if answer.returncode != 0:
            sys.exit(f"{self.command} {arguments[0]}: {answer.stderr.strip()}")
        return answer.stdout

    def explain(self, log: Path, ping: int, *settings: str) -> dict:
        values = [word for setting in settings for word in ("--set", setting)]
        return json.loads(self.run("explain", log, "--ping", str(ping), *values, "--json"))

    def options(self) -> dict:
        return {option["name"]: option["default"]
                for option in json.loads(self.run("methods", "consensus", "--json"))["options"]}


class Ping:
    """An echo of a simulated drive, from where its sensor truly was."""

    def __init__(self, number: int, at: Point, axis_deg: float, range_m: float, beam_deg: float, cause: str):
        self.number, self.at, self.axis_deg, self.range_m, self.beam_deg, self.cause = (number, at, axis_deg, range_m,
                                                                                        beam_deg, cause)


def echoes(log: Path) -> tuple[list[Ping], list[Point]]:
    """Echoes and path of a simulated log."""
    records = [json.loads(line) for line in log.read_text().splitlines()]
    sensors = {sensor["id"]: sensor for sensor in records[0]["robot"]["sensors"]}
    truth = [record for record in records if record["type"] == "truth"]
    times = [record["t"] for record in truth]
    pings = [record for record in records if record["type"] == "ping"]
    found = []
    for number, ping in enumerate(pings):
        if not isinstance(ping["range"], float) or not ping.get("cause"):
            continue
        pose = pose_at(truth, times, ping["t"])
        sensor = sensors[ping["rx"]]
        c, s = cos(pose[2]), sin(pose[2])
        at = (pose[0] + c * sensor["x"] - s * sensor["y"], pose[1] + s * sensor["x"] + c * sensor["y"])
        found.append(Ping(number, at, degrees(pose[2] + sensor["yaw"]), ping["range"], degrees(sensor["beam_width"]),
                          ping["cause"]))
    return found, [(record["x"], record["y"]) for record in truth]


def pose_at(truth: list[dict], times: list[float], t: float) -> tuple[float, float, float]:
    k = min(max(1, bisect_left(times, t)), len(times) - 1)
    a, b = truth[k - 1], truth[k]
    share = min(1.0, max(0.0, (t - a["t"]) / max(1e-9, b["t"] - a["t"])))
    turn = (b["yaw"] - a["yaw"] + pi) % (2 * pi) - pi
    return (a["x"] + share * (b["x"] - a["x"]), a["y"] + share * (b["y"] - a["y"]), a["yaw"] + share * turn)


def outlines(scene: dict) -> list[list[Point]]:
    """Walls, boxes, discs and curves of a scene, as polygons."""
    shapes = [[tuple(p) for p in wall["points"]] for wall in scene.get("wall", [])]
    for box in scene.get("box", []):
        (cx, cy), (w, h), turn = box["centre"], box["size"], radians(box.get("turn_deg", 0.0))
        corners = [(-w / 2, -h / 2), (w / 2, -h / 2), (w / 2, h / 2), (-w / 2, h / 2), (-w / 2, -h / 2)]
        shapes.append([(cx + cos(turn) * x - sin(turn) * y, cy + sin(turn) * x + cos(turn) * y) for x, y in corners])
    shapes += [[on_circle(disc["centre"], disc["radius"], 10 * k) for k in range(37)] for disc in scene.get("disc", [])]
    for curve in scene.get("curve", []):
        step = (curve["to_deg"] - curve["from_deg"]) / 24
        shapes.append([on_circle(curve["centre"], curve["radius"], curve["from_deg"] + k * step) for k in range(25)])
    return shapes


def true_bearing_deg(ping: Ping, shapes: list[list[Point]]) -> float | None:
    """Off the axis, of the outer wall (parallel to x or y) that mirrored the echo of a ping."""
    for (x1, y1), (x2, y2) in zip(shapes[0], shapes[0][1:]):
        foot = (x1, ping.at[1]) if x1 == x2 else (ping.at[0], y1)
        away = (foot[0] - ping.at[0], foot[1] - ping.at[1])
        on_it = min(x1, x2) <= foot[0] <= max(x1, x2) and min(y1, y2) <= foot[1] <= max(y1, y2)
        if on_it and abs(hypot(*away) - ping.range_m) < 0.02:
            direction = 0.0 if away[0] > 1e-9 else 180.0 if away[0] < -1e-9 else 90.0 if away[1] > 0 else -90.0
            return (direction - ping.axis_deg + 180.0) % 360.0 - 180.0
    return None


def well_told(echoarc: Echoarc, log: Path, pings: list[Ping], shapes: list[list[Point]]) -> tuple[Ping, dict, float]:
    """Of the echoes of outer walls heard clearly off the axis and read out within 2 degrees, the surest."""
    best = None
    for ping in pings:
        truth_deg = true_bearing_deg(ping, shapes) if ping.cause == "wall" and 1.5 < ping.range_m < 3.0 else None
        if truth_deg is None or not 4.0 < abs(truth_deg) < 12.0:
            continue
        answer = subprocess.run([echoarc.command, "explain", log, "--ping", str(ping.number), "--json"],
                                capture_output=True, text=True, check=False)
        if answer.returncode != 0:  # it repeats the one before it
            continue
        explained = json.loads(answer.stdout)
        right = abs(explained["bearing_deg"] - truth_deg) < 2.0
        if right and (best is None or explained["p"] > best[1]["p"]):
            best = (ping, explained, truth_deg)
    return best


def posterior(echoarc: Echoarc, log: Path, pings: list[Ping], shapes: list[list[Point]]) -> str:
    """What is believed of the bearing of one echo, before and after each sweep."""
    ping, explained, truth_deg = well_told(echoarc, log, pings, shapes)
    canvas = Canvas(760, 350, "Posterior over the bearing of one echo")
    shares = [("the beam alone: p_w = 0.50", [0.5 * p for p in explained["prior"]], [0.5 * p for p in explained["prior"]])]
    for k, sweep in enumerate(explained["sweeps"], 1):
        wall = sweep["wall_share"]
        shares.append((f"after sweep {k}: p_w = {wall:.2f}", [wall * q for q in sweep["wall"]],
                       [(1 - wall) * q for q in sweep["point"]]))
    for k, (title, wall, point) in enumerate(shares):
        draw_rows(canvas, 30 + 250 * k, title, explained["bearings_deg"], wall, point, truth_deg)
    canvas.label(30, 318, f"An echo at {ping.range_m:.2f} m, weighed with {len(explained['neighbours'])} neighbours. Read out: "
                 f"{explained['bearing_deg']:+.1f}°, p = {explained['p']:.2f}; true: {truth_deg:+.1f}°.")
    canvas.bar(30, 330, 12, 10, BLUE)
    canvas.label(48, 339, "wall")
    canvas.bar(100, 330, 12, 10, MAGENTA)
    canvas.label(118, 339, "point")
    canvas.label(180, 339, "dashed: where the wall truly is")
    return canvas.text()


def draw_rows(canvas: Canvas, left: float, title: str, bearings: list[float], wall: list[float], point: list[float],
              truth_deg: float) -> None:
    """A histogram over bearing: walls, and points on top of them."""
    width, top, height = 220.0, 44.0, 230.0
    each = width / len(bearings)
    highest = max(0.25, *(w + p for w, p in zip(wall, point)))
    canvas.label(left, 30, title, weight="bold")
    for k, (w, p) in enumerate(zip(wall, point)):
        x, hw, hp = left + k * each, height * w / highest, height * p / highest
        canvas.bar(x + 0.5, top + height - hw, each - 1, hw, BLUE, 0.85)
        canvas.bar(x + 0.5, top + height - hw - hp, each - 1, hp, MAGENTA, 0.85)
    canvas.stroke(left, top + height, left + width, top + height)
    step = bearings[1] - bearings[0]
    x_true = left + (truth_deg - bearings[0] + 0.5 * step) / step * each
    canvas.stroke(x_true, top, x_true, top + height, INK, 1.2, "5 4")
    for degree in (-10, -5, 0, 5, 10):
        x = left + (degree - bearings[0] + 0.5 * step) / step * each
        canvas.label(x, top + height + 17, f"{degree:+d}°" if degree else "0°", anchor="middle", size=11)
    canvas.label(left + width, top + 10, f"full height {highest:.2f}", GREY, "end", 11)


def room(folder: Path, pings: list[Ping], path: list[Point], shapes: list[list[Point]]) -> str:
    """All arcs of a drive beside the points that the map makes of them."""
    canvas = Canvas(760, 370, "Arcs, and the points they agree on")
    arcs = Panel(canvas, 40, 44, 82, -0.2, 3.25)
    points = Panel(canvas, 410, 44, 82, -0.2, 3.25)
    canvas.label(30, 26, "What was heard: one arc an echo", weight="bold")
    canvas.label(400, 26, "What the arcs agree on", weight="bold")
    arcs.clip(4.4, 3.55)
    arcs.arcs([(ping.at, ping.range_m, ping.axis_deg, 0.5 * ping.beam_deg) for ping in pings if ping.range_m < 3.0],
              BLUE, 0.7, 0.5)
    arcs.unclip()
    for panel in (arcs, points):
        for shape in shapes:
            panel.path(shape, GREY, 1.0)
        panel.path(path[::20], AMBER, 1.0)
    looks = {"link": (GREY, 1.3), "wall": (BLUE, 2.2), "point": (MAGENTA, 2.2)}
    with open(folder / "consensus" / "points.csv", newline="") as file:
        rows = [(row["label"], float(row["x"]), float(row["y"])) for row in csv.DictReader(file)]
    for label, (colour, radius) in looks.items():
        points.dots([(x, y) for name, x, y in rows if name == label and -0.2 < x < 4.2 and -0.2 < y < 3.3], colour, radius)
    for x, words, colour in ((410, "wall", BLUE), (470, "point: corner, edge, pole", MAGENTA), (650, "link", GREY)):
        canvas.add(f'<circle cx="{x}" cy="350" r="4" fill="{colour}"/>')
        canvas.label(x + 9, 354, words)
    canvas.label(40, 354, "grey: the room; amber: the path")
    return canvas.text()


def main() -> int:
    echoarc = Echoarc(sys.argv[1])
    option = echoarc.options()
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch)
        log = folder / "log.jsonl"
        (folder / "scene.toml").write_text(SCENE)
        echoarc.run("sim", folder / "scene.toml", "-o", log)
        echoarc.run("map", log, "--method", "consensus", "-o", folder / "map")
        pings, path = echoes(log)
        shapes = outlines(tomllib.loads(SCENE))
        pictures = {"idea": consensus_schemes.idea(), "vote": consensus_schemes.vote(option),
                    "link": consensus_schemes.link(option), "posterior": posterior(echoarc, log, pings, shapes),
                    "room": room(folder / "map", pings, path, shapes)}
        for name, picture in pictures.items():
            (PICTURES / f"consensus-{name}.svg").write_text(picture)
        tables = {"two_arcs": consensus_example.two_arcs, "more_arcs": consensus_example.more_arcs,
                  "disturbed": consensus_trials.disturbed, "wide_beams": consensus_trials.wide_beams}
        text = PAGE.read_text()
        PAGE.write_text(BLOCK.sub(lambda m: m[1] + tables[m[2]](echoarc, option, folder) + m[3], text))
    return 0


if __name__ == "__main__":
    sys.exit(main())

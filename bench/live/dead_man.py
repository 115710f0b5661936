#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""How soon a driven robot brakes and stands after its driver is gone.

    bench/live/dead_man.py build/bin/echoarc [--trials 200] [--seed 1]

Every trial drives at a random speed, then the driver vanishes: its socket is closed, its process is killed, or it only
falls silent. The session log tells what the robot did: commands when they arrived, true poses at the odometry's rate.
Prints one JSON object. (A hidden tab is a matter of the page: web/test/browser.)
"""

import argparse
import json
import math
import multiprocessing
import pathlib
import random
import tempfile
import time

from served import Served
from viewer import Viewer

STOP_M_S2 = 1.5
CONTROL_STEP_S = 0.01
HALL = """name = "hall"
robot = "hc-sr04-row"

[[wall]]
points = [[-10, -10], [10, -10], [10, 10], [-10, 10], [-10, -10]]

[drive]
start = [0, 0, 0]

[sonar]
outlier_share = 0.0
floor_share = 0.0
"""  # nothing in the way, nor heard to be: what brakes here is the dead-man
CAUSES = ("socket closed", "process killed", "silent")


def drive_for(viewer, speed, seconds, pause_s=0.05):
    """Circles; every command differs from the one before, so that each is logged."""
    viewer.say({"type": "take"})
    end, count = time.monotonic() + seconds, 0
    while time.monotonic() < end:
        count += 1
        viewer.say({"type": "drive", "v": speed + 1e-6 * count, "w": speed / 0.25, "seq": count})
        time.sleep(pause_s)


def drive_until_killed(port, token, speed, ready):
    viewer = Viewer(port, token=token)
    viewer.wait_for("welcome")
    drive_for(viewer, speed, 1.5)
    ready.set()
    drive_for(viewer, speed, 60)


def vanish(served, cause, speed):
    """Drives, and is gone. What to do after the trial."""
    if cause == "process killed":
        ready = multiprocessing.Event()
        process = multiprocessing.Process(target=drive_until_killed, args=(served.port, served.token, speed, ready), daemon=True)
        process.start()
        ready.wait(20)
        process.kill()
        process.join()
        return lambda: None
    viewer = Viewer(served.port, token=served.token)
    viewer.wait_for("welcome")
    drive_for(viewer, speed, 1.5)
    if cause == "socket closed":
        viewer.close()
        return lambda: None
    return viewer.close


def read_records(log, skip):
    """Complete lines after the first `skip` bytes, and where they end."""
    data = log.read_bytes()
    end = data.rfind(b"\n") + 1
    return [json.loads(line) for line in data[skip:end].splitlines()], end


def judge(records):
    """(from last command to braking, from braking to standing, speed at the last command), s and m/s."""
    last = max(record["t"] for record in records if record["type"] == "command" and record["mode"] == "drive")
    poses = [record for record in records if record["type"] == "truth"]
    intervals = [(a["t"], b["t"], math.hypot(b["x"] - a["x"], b["y"] - a["y"]) / (b["t"] - a["t"]))
                 for a, b in zip(poses, poses[1:]) if b["t"] > a["t"]]
    steady = max((v for _, end, v in intervals if last - 0.3 <= end <= last + 0.2), default=0.0)
    begin = standing = math.inf
    for start, end, v in intervals:
        if end > last and v < steady - 0.005:
            # A mean speed over d that is lower by dv: braking at a began x before its end, dv = a x^2 / (2 d).
            begin = end - min(end - start, math.sqrt(2 * (end - start) * (steady - v) / STOP_M_S2))
            break
    for start, _, v in intervals:
        if start >= begin and v < 1e-4:
            standing = start
            break
    return begin - last, standing - begin, steady


def run(command, trials, seed):
    draw = random.Random(seed)
    results = []
    with tempfile.TemporaryDirectory() as folder:
        session = pathlib.Path(folder) / "session"
        scene = pathlib.Path(folder) / "hall.toml"
        scene.write_text(HALL)
        with Served(command, "--scene", scene, "-o", session) as served:
            log, read = session / "session.jsonl", 0
            for trial in range(trials):
                cause, speed = CAUSES[trial % len(CAUSES)], draw.uniform(0.08, 0.2)
                time.sleep(draw.uniform(0, 0.1))
                clean_up = vanish(served, cause, speed)
                time.sleep(1.2)
                records, read = read_records(log, read)
                clean_up()
                results.append((cause, *judge(records)))
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("--trials", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    results = run(arguments.command, arguments.trials, arguments.seed)
    report = {"trials": len(results)}
    for cause in CAUSES:
        mine = [result for result in results if result[0] == cause]
        if mine:
            report[cause] = {"trials": len(mine), "braking_after_max_s": max(r[1] for r in mine),
                             "standing_late_max_s": max(r[2] - r[3] / STOP_M_S2 for r in mine)}
    report["in_time"] = sum(in_time(result) for result in results)
    print(json.dumps(report, indent=1))


def in_time(result, pose_interval_s=0.05):
    """Braking within 0.6 s, standing within v/a after that, which is seen a control step and a pose later."""
    _, begin, standing, speed = result
    return begin <= 0.6 and standing <= speed / STOP_M_S2 + pose_interval_s + CONTROL_STEP_S and speed > 0.05


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Kills a serving robot at random times and continues its session.

    bench/live/kill_trials.py build/bin/echoarc [--trials 100] [--seed 1]

Of every trial is asked: whether all pings that a viewer had seen 0.15 s before the kill are in the log, and whether the map of
the resumed session equals, byte for byte, the map that `echoarc map` makes of the log as the kill left it. Prints one JSON object.
"""

import argparse
import json
import pathlib
import random
import shutil
import struct
import subprocess
import tempfile
import time

from served import Served
from viewer import Closed, Viewer

GRACE_S = 0.15  # logs are flushed at most 0.1 s apart; the rest is for the viewer's own delay
METHODS = "consensus,evidence"
COMPARED = ("consensus/points.csv", "consensus/segments.csv", "evidence/grid.npy", "evidence/map.pgm")


def watch_until_killed(served, seconds):
    """Newest ping id and when it was seen, for every frame."""
    seen = []
    viewer = Viewer(served.port)

    def note(payload):
        count = struct.unpack_from("<I", payload, 4)[0]
        if payload[0] == 1 and count:
            seen.append((time.monotonic(), struct.unpack_from("<I", payload, 16 + 64 * (count - 1) + 8)[0]))

    viewer.on_binary = note
    end = time.monotonic() + seconds
    viewer.socket.settimeout(0.05)
    while time.monotonic() < end:
        try:
            viewer.pump()
        except TimeoutError:
            pass
        except Closed:
            break
    killed_at = time.monotonic()
    served.kill()
    viewer.close()
    return max((ping for when, ping in seen if when < killed_at - GRACE_S), default=-1)


def pings_of(session):
    """Complete ping lines of all parts of the log."""
    count = 0
    for part in sorted(session.glob("session*.jsonl")):
        data = part.read_bytes()
        count += sum(line.startswith(b'{"type":"ping"') for line in data[:data.rfind(b"\n") + 1].splitlines())
    return count


def run_trial(command, folder, lifetimes):
    """Kills and resumes once per lifetime; (flushed pings lost, maps equal)."""
    session = folder / "session"
    for number, lifetime in enumerate(lifetimes):
        arguments = ["--scene", "demo", "--method", METHODS, "-o", session] if number == 0 else ["--resume", session]
        newest = watch_until_killed(Served(command, *arguments), lifetime)
        logged = pings_of(session)
        if newest >= logged:
            return newest + 1 - logged, False
    log = folder / "log.jsonl"
    log.write_bytes(b"".join(part.read_bytes() for part in sorted(session.glob("session*.jsonl"))))
    subprocess.run([command, "map", log, "--method", METHODS, "-o", folder / "batch"], check=True, capture_output=True)
    subprocess.run([command, "serve", "--resume", session, "--duration", "0"], check=True, capture_output=True, timeout=60)
    equal = all((folder / "batch" / name).read_bytes() == (session / name).read_bytes()
                for name in COMPARED if (folder / "batch" / name).exists())
    return 0, equal


def run(command, trials, seed):
    draw = random.Random(seed)
    lost = unequal = 0
    for _ in range(trials):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="echoarc-kill-"))
        try:
            pings, equal = run_trial(pathlib.Path(command).resolve(), folder, [draw.uniform(0.3, 3.0), draw.uniform(0.3, 2.0)])
            lost += pings
            unequal += not equal
        finally:
            shutil.rmtree(folder)
    return {"trials": trials, "kills": 2 * trials, "flushed_pings_lost": lost, "maps_unequal": unequal}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("--trials", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    print(json.dumps(run(arguments.command, arguments.trials, arguments.seed), indent=1))


if __name__ == "__main__":
    main()

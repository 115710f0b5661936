#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""How long a tick takes to the last of many viewers, with and without viewers that never read, and a driver's command to
the robot under that load.

    bench/live/load.py build/bin/echoarc [--viewers 50] [--stalled 20] [--pairs 5] [--phase-s 15] [--soak-s 600]

The server and all viewers run on this machine; every time is CLOCK_MONOTONIC. Prints one JSON object.
"""

import argparse
import collections
import json
import math
import selectors
import statistics
import struct
import sys
import tempfile
import time

from served import Served
from viewer import Closed, Viewer, monotonic_us

PINGS = 1
STATE = b'{"type":"state"'


def percentile(values, share):
    """The smallest value that `share` of all do not exceed."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, math.ceil(share * len(ordered)) - 1)] if ordered else math.nan


class Phase:
    """What was measured while one set of viewers watched."""

    def __init__(self):
        self.last_read_us = {}  # tick -> latest read
        self.sent_us = {}
        self.readers = collections.Counter()
        self.ping_us = []
        self.drive_us = {}

    def ticks_ms(self, viewers):
        """Of ticks that reached all: from the tick to the last reader."""
        return [(self.last_read_us[tick] - self.sent_us[tick]) / 1000 for tick in self.sent_us if self.readers[tick] == viewers]

    def coalesced(self, viewers):
        """Share of ticks that some viewer was spared."""
        return sum(self.readers[tick] < viewers for tick in self.sent_us) / max(1, len(self.sent_us))


class Crowd:
    """Viewers that read as fast as they can, one of them drives."""

    def __init__(self, served, viewers):
        self.phase = Phase()
        self.selector = selectors.DefaultSelector()
        self.offset_us = None
        self.sent_drive_us = {}
        self.drive_seq = 0
        self.viewers = []
        for i in range(viewers):
            viewer = Viewer(served.port, token=served.token if i == 0 else None)
            viewer.on_text = self._on_state
            viewer.on_binary = self._on_binary
            viewer.socket.setblocking(False)
            self.selector.register(viewer, selectors.EVENT_READ)
            self.viewers.append(viewer)
        self.driver = self.viewers[0]
        self.driver.say({"type": "take"})

    def _on_state(self, payload):
        if not payload.startswith(STATE):
            return
        now = monotonic_us()
        state = json.loads(payload)
        tick, phase = state["tick"], self.phase
        phase.sent_us[tick] = state["mono_us"]
        phase.last_read_us[tick] = max(now, phase.last_read_us.get(tick, 0))
        phase.readers[tick] += 1
        self.offset_us = state["mono_us"] - state["t"] * 1e6
        seq = state["drive_seq"]
        if seq in self.sent_drive_us:
            phase.drive_us[seq] = state["drive_mono_us"] - self.sent_drive_us[seq]

    def _on_binary(self, payload):
        if payload[0] != PINGS or self.offset_us is None or struct.unpack_from("<I", payload, 12)[0] != 0:
            return
        now = monotonic_us()
        count = struct.unpack_from("<I", payload, 4)[0]
        if not struct.unpack_from("<H", payload, 2)[0] & 1:
            for i in range(count):
                time_s = struct.unpack_from("<d", payload, 16 + 64 * i)[0]
                self.phase.ping_us.append(now - self.offset_us - time_s * 1e6)

    def watch(self, seconds):
        """Reads for so long, driving in slow circles; what was measured, the first second left out."""
        self._run(1.0)
        self.phase = Phase()
        self._run(seconds)
        return self.phase

    def _run(self, seconds):
        end = time.monotonic() + seconds
        next_drive = time.monotonic()
        while (now := time.monotonic()) < end:
            if now >= next_drive:
                next_drive = now + 0.05
                self._drive()
            for key, _ in self.selector.select(min(end, next_drive) - now if next_drive > now else 0):
                key.fileobj.pump()

    def _drive(self):
        self.drive_seq += 1
        self.sent_drive_us[self.drive_seq] = monotonic_us()
        self.driver.socket.setblocking(True)
        self.driver.say({"type": "drive", "v": 0.05, "w": 0.5, "seq": self.drive_seq})
        self.driver.socket.setblocking(False)

    def close(self):
        for viewer in self.viewers:
            viewer.close()


class Stalled:
    """Viewers that shake hands and never read again; one that is dropped comes back."""

    def __init__(self, served, count):
        self.served = served
        self.viewers = [Viewer(served.port, receive_buffer=4096) for _ in range(count)]

    def close(self):
        for viewer in self.viewers:
            viewer.close()


def summary(phase, viewers):
    ticks = phase.ticks_ms(viewers)
    return {"ticks": len(ticks), "tick_to_last_p50_ms": percentile(ticks, 0.5), "tick_to_last_p99_ms": percentile(ticks, 0.99),
            "coalesced_share": phase.coalesced(viewers), "ping_to_read_p99_ms": percentile(phase.ping_us, 0.99) / 1000,
            "drive_to_robot_p99_ms": percentile(phase.drive_us.values(), 0.99) / 1000, "drives": len(phase.drive_us)}


def measure_load(command, arguments):
    with tempfile.TemporaryDirectory() as folder, Served(command, "--scene", "demo", "-o", f"{folder}/session") as served:
        crowd = Crowd(served, arguments.viewers)
        crowd.watch(5)
        calm, loaded, ratios = [], [], []
        for _ in range(arguments.pairs):
            calm.append(crowd.watch(arguments.phase_s))
            stalled = Stalled(served, arguments.stalled)
            loaded.append(crowd.watch(min(arguments.phase_s, 9)))  # a stalled viewer is dropped after 10 s
            stalled.close()
            pair = [statistics.median(phase.ticks_ms(arguments.viewers)) for phase in (calm[-1], loaded[-1])]
            ratios.append(pair[1] / pair[0])
        crowd.close()
        return {"calm": merged(calm, arguments.viewers), "with_stalled": merged(loaded, arguments.viewers),
                "stalled_to_calm_ratios": ratios, "stalled_to_calm_median_ratio": statistics.median(ratios),
                "memory_mb": served.resident_mb()}


def merged(phases, viewers):
    """One summary over phases; ticks are told apart by their numbers."""
    whole = Phase()
    for phase in phases:
        whole.last_read_us |= phase.last_read_us
        whole.sent_us |= phase.sent_us
        whole.readers += phase.readers
        whole.ping_us += phase.ping_us
        whole.drive_us |= phase.drive_us
    return summary(whole, viewers)


def measure_soak(command, seconds):
    """Memory of a server that one viewer watches on its tour."""
    with tempfile.TemporaryDirectory() as folder, Served(command, "--scene", "demo", "-o", f"{folder}/session") as served:
        viewer = Viewer(served.port)
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            viewer.pump()
        viewer.close()
        return {"seconds": seconds, "memory_mb": served.resident_mb(), "cpu_share": served.cpu_s() / seconds}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command")
    parser.add_argument("--viewers", type=int, default=50)
    parser.add_argument("--stalled", type=int, default=20)
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--phase-s", type=float, default=9)
    parser.add_argument("--soak-s", type=float, default=0, help="also watch memory for so long")
    arguments = parser.parse_args()
    result = measure_load(arguments.command, arguments)
    if arguments.soak_s:
        result["soak"] = measure_soak(arguments.command, arguments.soak_s)
    print(json.dumps(result, indent=1))


if __name__ == "__main__":
    try:
        main()
    except Closed as closed:
        sys.exit(f"the server closed a connection: {closed}")

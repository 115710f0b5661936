# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Writes the log that `./dev demo` maps, and its truth: `make_demo_log.py [FOLDER]`, `make_demo_log.py --check`.

A robot with the 16-sonar ring of the Nomad 200 drives two loops through a room of 6 x 4.5 m with an L corner, a doorway
and a pillar. The acoustics are about the simplest that are specular at all: a wall answers from the foot of the
perpendicular, or, being plaster, weakly from the nearest point in the beam that is not too slanted; inside corners,
outside edges and the pillar answer from one point; the nearest visible one is the echo; everything else is silence.
Gaussian noise, 1 cm quanta and a few outliers are added. There is neither a beam pattern nor a second reflection: this is
sample data, not a simulator, and a score on it says nothing about real rooms. Seeded; standard library only; the same
bytes on every machine, because everything is rounded far above the last bit.
"""

import json
import math
import random
import sys
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "examples" / "demo"
SEED = 20260101

# Metres, counter-clockwise; the gap between the last and the first vertex is where the passage behind the door is open.
OUTLINE = [(-1.2, 2.0), (0.0, 2.0), (0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (4.2, 3.0), (4.2, 4.5), (0.0, 4.5), (0.0, 2.9),
           (-1.2, 2.9)]
PILLAR_CENTRE, PILLAR_RADIUS = (3.0, 2.1), 0.15
EDGE_RANGE = 2.0  # an outside edge scatters weakly: heard up to here
PLASTER_RANGE, PLASTER_INCIDENCE = 3.5, math.radians(35.0)  # how far, and how slanted, a wall still scatters back

LOOPS = [[(0.9, 0.8), (5.2, 0.8), (5.2, 2.2), (4.0, 2.2), (3.4, 3.0), (3.4, 3.7), (0.9, 3.7), (0.9, 0.8)],
         [(1.2, 1.1), (1.2, 3.3), (2.9, 3.3), (3.6, 2.4), (4.9, 1.9), (4.9, 1.1), (1.2, 1.1)]]
SPEED, TURN_RATE = 0.25, math.radians(45.0)  # m/s, rad/s
FIRING_INTERVAL, ODOMETRY_INTERVAL = 0.04, 0.2  # s

SENSORS, RING_RADIUS, BEAM_WIDTH = 16, 0.23, math.radians(25.0)
RANGE_MIN, RANGE_MAX = 0.15, 10.7
NOISE, QUANTUM = 0.01, 0.01  # m
OUTLIER_SHARE, LOST_SHARE = 0.03, 0.02


def wrap(angle):
    return math.remainder(angle, 2.0 * math.pi)


def drive():
    """Poses (x, y, yaw) every FIRING_INTERVAL: straight legs at SPEED, turns on the spot at TURN_RATE."""
    stops = [point for loop in LOOPS for point in loop]
    x, y, yaw = *stops[0], 0.0
    poses = []
    for target_x, target_y in stops[1:]:
        length = math.hypot(target_x - x, target_y - y)
        heading = bearing((x, y), (target_x, target_y))
        turn = wrap(heading - yaw)
        steps = math.ceil(abs(turn) / (TURN_RATE * FIRING_INTERVAL))
        poses += [(x, y, wrap(yaw + turn * i / steps)) for i in range(steps)]
        steps = math.ceil(length / (SPEED * FIRING_INTERVAL))
        poses += [(x + (target_x - x) * i / steps, y + (target_y - y) * i / steps, heading) for i in range(steps)]
        x, y, yaw = target_x, target_y, heading
    return poses


def walls():
    return list(zip(OUTLINE, OUTLINE[1:]))


def foot(point, wall):
    """The foot of the perpendicular on a wall, which may lie beyond the ends."""
    (ax, ay), (bx, by) = wall
    dx, dy = bx - ax, by - ay
    share = ((point[0] - ax) * dx + (point[1] - ay) * dy) / (dx * dx + dy * dy)
    return (ax + share * dx, ay + share * dy)


def within(point, wall):
    """Whether a point on a wall's line lies between its ends."""
    (ax, ay), (bx, by) = wall
    return (point[0] - ax) * (point[0] - bx) + (point[1] - ay) * (point[1] - by) < 0.0


def slanted_points(sensor, axis, wall):
    """Where the beam's two edges meet a wall no more slanted than plaster scatters back."""
    normal_foot = foot(sensor, wall)
    distance, normal = math.dist(sensor, normal_foot), bearing(sensor, normal_foot)
    for edge in (axis - 0.499 * BEAM_WIDTH, axis + 0.499 * BEAM_WIDTH):
        incidence = wrap(edge - normal)
        if abs(incidence) <= PLASTER_INCIDENCE:
            reach = distance / math.cos(incidence)
            yield (sensor[0] + reach * math.cos(edge), sensor[1] + reach * math.sin(edge))


def bearing(sensor, point):
    return math.atan2(point[1] - sensor[1], point[0] - sensor[0])


def reflectors(sensor, axis):
    """(point, range up to which it is heard) of everything that could send sound back to the sensor."""
    for wall in walls():
        candidates = [(foot(sensor, wall), RANGE_MAX)]
        candidates += [(point, PLASTER_RANGE) for point in slanted_points(sensor, axis, wall)]
        yield from ((point, heard_to) for point, heard_to in candidates if within(point, wall))
    for before, corner, after in zip(OUTLINE, OUTLINE[1:], OUTLINE[2:]):
        turn = (corner[0] - before[0]) * (after[1] - corner[1]) - (corner[1] - before[1]) * (after[0] - corner[0])
        yield corner, RANGE_MAX if turn > 0.0 else EDGE_RANGE
    away = math.dist(sensor, PILLAR_CENTRE)
    yield tuple(c + (s - c) * PILLAR_RADIUS / away for s, c in zip(sensor, PILLAR_CENTRE)), RANGE_MAX


def crosses(a, b, wall):
    """Whether the open segment a-b properly crosses a wall."""
    def side(p, q, r):
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    c, d = wall
    return side(a, b, c) * side(a, b, d) < 0.0 and side(c, d, a) * side(c, d, b) < 0.0


def visible(sensor, point):
    near = tuple(s + (p - s) * 0.999 for s, p in zip(sensor, point))  # stop short of the reflector itself
    if any(crosses(sensor, near, wall) for wall in walls()):
        return False
    dx, dy = near[0] - sensor[0], near[1] - sensor[1]
    share = ((PILLAR_CENTRE[0] - sensor[0]) * dx + (PILLAR_CENTRE[1] - sensor[1]) * dy) / (dx * dx + dy * dy)
    closest = (sensor[0] + min(1.0, max(0.0, share)) * dx, sensor[1] + min(1.0, max(0.0, share)) * dy)
    return math.dist(closest, PILLAR_CENTRE) > PILLAR_RADIUS * 0.999


def true_range(sensor, axis):
    """Range of the nearest reflector that is in the beam and in sight, or None."""
    ranges = [math.dist(sensor, point) for point, heard_to in reflectors(sensor, axis)
              if math.dist(sensor, point) <= heard_to
              and abs(wrap(bearing(sensor, point) - axis)) <= BEAM_WIDTH / 2
              and visible(sensor, point)]
    return min(ranges, default=None)


def measured_range(true, rng):
    """What the hardware reports: a number or a word. Draws the same count of random numbers whatever happens."""
    noise, fate, share = rng.gauss(0.0, NOISE), rng.random(), rng.random()
    if true is None or fate < LOST_SHARE:
        return "no_echo"
    if fate < LOST_SHARE + OUTLIER_SHARE:
        true = true * (0.35 + 0.5 * share) if share < 0.9 else true * (1.2 + 3.0 * (share - 0.9))  # mostly cross-talk
    reported = round((true + noise) / QUANTUM) * QUANTUM
    if reported < RANGE_MIN:
        return "too_close"
    return round(reported, 3) if reported <= RANGE_MAX else "no_echo"


def mounts():
    angles = [2.0 * math.pi * k / SENSORS for k in range(SENSORS)]
    return [(RING_RADIUS * math.cos(angle), RING_RADIUS * math.sin(angle), wrap(angle)) for angle in angles]


def header():
    sensors = [{"id": k, "x": round(x, 6), "y": round(y, 6), "z": 0.6, "roll": 0, "pitch": 0, "yaw": round(yaw, 6),
                "beam_width": round(BEAM_WIDTH, 6), "range_min": RANGE_MIN, "range_max": RANGE_MAX}
               for k, (x, y, yaw) in enumerate(mounts())]
    return {"type": "header", "format": "echoarc-log", "version": 1, "frame": "odom", "temperature_k": 293.0,
            "robot": {"name": "nomad200", "radius_m": 0.225, "sensors": sensors, "lasers": []}}


def records():
    """The log's records in the order of time; one sonar fires every FIRING_INTERVAL, in the order of the ring."""
    rng = random.Random(SEED)
    every = round(ODOMETRY_INTERVAL / FIRING_INTERVAL)
    poses = drive()
    yield header()
    for i, (x, y, yaw) in enumerate(poses):
        t = round(i * FIRING_INTERVAL, 3)
        if i % every == 0 or i == len(poses) - 1:
            yield {"type": "odom", "t": t, "x": round(x, 4), "y": round(y, 4), "yaw": round(yaw, 5)}
        k = i % SENSORS
        mount_x, mount_y, mount_yaw = mounts()[k]
        sensor = (x + math.cos(yaw) * mount_x - math.sin(yaw) * mount_y,
                  y + math.sin(yaw) * mount_x + math.cos(yaw) * mount_y)
        yield {"type": "ping", "t": t, "tx": k, "rx": k,
               "range": measured_range(true_range(sensor, yaw + mount_yaw), rng)}


def log_text():
    return "".join(json.dumps(record, separators=(",", ":")) + "\n" for record in records())


def truth_text():
    """Every wall as `polyline,x,y`; a new number starts a new polyline."""
    angles = [2.0 * math.pi * i / 32 for i in range(33)]
    pillar = [tuple(c + PILLAR_RADIUS * f(a) for c, f in zip(PILLAR_CENTRE, (math.cos, math.sin))) for a in angles]
    rows = [f"{number},{x:.4f},{y:.4f}\n" for number, line in enumerate([OUTLINE, pillar]) for x, y in line]
    return "polyline,x,y\n" + "".join(rows)


def main():
    check = sys.argv[1:] == ["--check"]
    folder = FOLDER if check or len(sys.argv) < 2 else Path(sys.argv[1])
    for name, text in (("room.jsonl", log_text()), ("room-truth.csv", truth_text())):
        path = folder / name
        if not check:
            path.write_text(text)
        elif path.read_text() != text:
            sys.exit(f"{path} is not what scripts/make_demo_log.py writes; run it and commit the result")
    return 0


if __name__ == "__main__":
    sys.exit(main())

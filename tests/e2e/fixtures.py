# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""Small logs made from first principles, so that the tests know what ought to come out.

A robot with a ring of sonars drives along the middle of an empty room. The model of a sonar is the plainest there is:
the nearest wall among rays across its beam. Nothing here is shared with the program under test.
"""

import json
import math

ROOM = (0.0, 0.0, 6.0, 4.0)  # x_min, y_min, x_max, y_max, metres
BEAM = math.radians(25.0)
RANGE_MAX = 3.5
SENSORS = 8
RING_RADIUS = 0.2


def ray_to_wall(x, y, direction):
    """Metres from a point inside the room to its wall."""
    x_min, y_min, x_max, y_max = ROOM
    c, s = math.cos(direction), math.sin(direction)
    along_x = ((x_max if c > 0 else x_min) - x) / c if abs(c) > 1e-12 else math.inf
    along_y = ((y_max if s > 0 else y_min) - y) / s if abs(s) > 1e-12 else math.inf
    return min(along_x, along_y)


def sonar(x, y, axis):
    """The first echo across the beam, rounded to a millimetre; None where it is out of reach."""
    rays = (axis + BEAM * (k / 24.0 - 0.5) for k in range(25))
    nearest = min(ray_to_wall(x, y, ray) for ray in rays)
    return round(nearest, 3) if nearest <= RANGE_MAX else None


def mounts(count=SENSORS):
    """(id, x, y, yaw) of every sonar."""
    angles = [2.0 * math.pi * k / count for k in range(count)]
    return [(k, RING_RADIUS * math.cos(a), RING_RADIUS * math.sin(a), a) for k, a in enumerate(angles)]


def poses(count=40):
    """(t, x, y, yaw): along the room, a little aslant, then back with the robot turned round."""
    half = count // 2
    for k in range(count):
        if k < half:
            yield 0.2 * k, 1.0 + 4.0 * k / half, 1.9 + 0.2 * k / half, 0.0
        else:
            yield 0.2 * k, 5.0 - 4.0 * (k - half) / half, 2.1 - 0.2 * (k - half) / half, math.pi


def pings(count=40):
    """(t, sensor, range or None): every sonar fires once per pose."""
    for t, x, y, yaw in poses(count):
        for number, dx, dy, mount_yaw in mounts():
            c, s = math.cos(yaw), math.sin(yaw)
            yield t, number, sonar(x + c * dx - s * dy, y + s * dx + c * dy, yaw + mount_yaw)


def header(no_echo=None, version=1):
    sensors = []
    for number, x, y, yaw in mounts():
        sensor = {"id": number, "x": x, "y": y, "z": 0.5, "roll": 0, "pitch": 0, "yaw": yaw, "beam_width": BEAM,
                  "range_min": 0.1, "range_max": RANGE_MAX}
        if no_echo is not None:
            sensor["no_echo"] = no_echo
        sensors.append(sensor)
    return {"type": "header", "format": "echoarc-log", "version": version, "frame": "odom", "temperature_k": 293.0,
            "robot": {"name": "tester", "radius_m": 0.2, "sensors": sensors}}


def room_records(count=40, no_echo="no_echo", rule=None):
    """Header, odometry and pings in the order of time. `no_echo` is what stands for silence in the log."""
    yield header(rule)
    every_ping = list(pings(count))
    for k, (t, x, y, yaw) in enumerate(poses(count)):
        yield {"type": "odom", "t": t, "x": x, "y": y, "yaw": yaw}
        for _, sensor, range_m in every_ping[k * SENSORS:(k + 1) * SENSORS]:
            yield {"type": "ping", "t": t, "tx": sensor, "rx": sensor, "range": no_echo if range_m is None else range_m}


def write_records(path, records):
    path.write_text("".join(json.dumps(record) + "\n" for record in records))
    return path


def write_room(path, **options):
    return write_records(path, room_records(**options))


def write_room_csv(readings, odometry, count=40):
    """The same drive as two plain tables; silence is written as inf."""
    rows = ["t,sensor_id,range_m"]
    rows += [f"{t},{sensor},{'inf' if range_m is None else range_m}" for t, sensor, range_m in pings(count)]
    readings.write_text("\n".join(rows) + "\n")
    rows = ["t,x,y,yaw"] + [f"{t},{x},{y},{yaw}" for t, x, y, yaw in poses(count)]
    odometry.write_text("\n".join(rows) + "\n")


def write_walls(path):
    """The room as a polyline reference."""
    x_min, y_min, x_max, y_max = ROOM
    corners = [(x_min, y_min), (x_max, y_min), (x_max, y_max), (x_min, y_max), (x_min, y_min)]
    path.write_text("polyline,x,y\n" + "".join(f"0,{x},{y}\n" for x, y in corners))
    return path


def write_robot(path, no_echo="auto"):
    """The robot of the logs above as robot.toml."""
    path.write_text(f"""name = "tester"
radius_m = 0.2
sensor_defaults = {{ no_echo = "{no_echo}" }}
ring = {{ count = {SENSORS}, radius_m = {RING_RADIUS}, start_deg = 0.0, beam_width_deg = {math.degrees(BEAM)}, """
                    f"""range_min = 0.1, range_max = {RANGE_MAX} }}
""")
    return path


def write_corridor(folder):
    """A folder in the form of the corridor logs: a straight drive between two walls 2 m apart, laser included."""
    folder.mkdir()
    odometry, sonar, laser = [], [], []
    for row in range(30):
        t = 214 * row
        odometry.append(f"{t} {50 * row} 0 0")
        sonar.append(f"{t} 800 1300 5110 5110 5110 5110 1300 800")
        beams = []
        for beam in range(361):
            sine = abs(math.sin(math.radians(-90 + 0.5 * beam)))
            beams.append(str(round(1000 / sine)) if sine > 0.13 else "81910")
        laser.append(f"{t} " + " ".join(beams))
    for name, lines in (("od.txt", odometry), ("sonar.txt", sonar), ("laser.txt", laser)):
        (folder / name).write_text("\n".join(lines) + "\n")

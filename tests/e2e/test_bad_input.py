# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""Input that cannot be meant: a clear error or a counted rejection, no crash, nothing half-done under the final name."""

import json
import math
import resource
import subprocess
import unittest

import fixtures
from harness import COMMAND, TIMEOUT_S, CommandTest


class BrokenFileTest(CommandTest):
    """Files that are no log at all."""

    def assert_file_refused(self, content, *causes, name="log.jsonl"):
        (self.dir / name).write_bytes(content)
        for verb in ("map", "info", "doctor"):
            with self.subTest(verb):
                self.assert_refused(self.run_command(verb, name), name, *causes)
        self.assert_refused(self.run_command("convert", name, "out.jsonl"), name, *causes)
        self.assert_nothing_left(name)

    def test_missing_file(self):
        for verb in (("map", "no.jsonl"), ("info", "no.jsonl"), ("doctor", "no.jsonl"), ("convert", "no.jsonl", "o"),
                     ("map", "no.csv", "--describe", "no.toml"), ("eval", "no-map", "--reference", "no.csv")):
            with self.subTest(verb):
                self.assert_refused(self.run_command(*verb), "no")
        self.assert_nothing_left()

    def test_empty_file(self):
        self.assert_file_refused(b"", "empty")

    def test_binary_junk(self):
        self.assert_file_refused(bytes(range(256)) * 64)

    def test_no_header(self):
        self.assert_file_refused(b'{"type":"odom","t":0,"x":0,"y":0,"yaw":0}\n', ":1")

    def test_newer_version(self):
        self.assert_file_refused(json.dumps(fixtures.header(version=2)).encode() + b"\n", "version", ":1")

    def test_folder_without_description(self):
        (self.dir / "logs").mkdir()
        self.assert_refused(self.run_command("map", "logs"), "logs")
        self.assert_nothing_left("logs")

    def test_unwritable_output(self):
        fixtures.write_room(self.dir / "room.jsonl", count=4)
        self.assert_refused(self.run_command("map", "room.jsonl", "-o", "/proc/echoarc/out"), "/proc")

    def test_many_bad_lines(self):
        records = list(fixtures.room_records())
        text = "".join(json.dumps(record) + "\n" + ('{"type":"ping","t":\n' if k % 10 == 5 else "")
                       for k, record in enumerate(records))
        self.assert_file_refused(text.encode(), ":7")


class BadRecordTest(CommandTest):
    """Logs with records that cannot be used: counted under a reason, with the line."""

    def setUp(self):
        super().setUp()
        self.records = list(fixtures.room_records())

    def map_counted(self, **expected):
        """Maps the records; the run report must hold exactly these rejections."""
        fixtures.write_records(self.dir / "log.jsonl", self.records)
        out = self.succeed("map", "log.jsonl", "-o", "out")
        rejected = json.loads((self.dir / "out" / "run.json").read_text())["rejected"]
        self.assertEqual({name: count for name, count in rejected.items() if count > 0}, expected, out)
        return out

    def insert(self, place, record):
        self.records.insert(place, record)
        return place + 1  # its line, from 1

    def test_truncated_last_line(self):
        fixtures.write_records(self.dir / "log.jsonl", self.records)
        text = (self.dir / "log.jsonl").read_text()
        (self.dir / "log.jsonl").write_text(text[:-20])
        result = self.run_command("map", "log.jsonl", "-o", "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("warning", result.stderr)
        report = json.loads((self.dir / "out" / "run.json").read_text())
        self.assertEqual(report["pings"]["offered"], len(list(fixtures.pings())) - 1)

    def test_one_bad_line(self):
        fixtures.write_records(self.dir / "log.jsonl", self.records)
        lines = (self.dir / "log.jsonl").read_text().splitlines()
        lines[100] = '{"type":"ping","t":"soon"}'
        (self.dir / "log.jsonl").write_text("\n".join(lines) + "\n")
        result = self.run_command("map", "log.jsonl", "-o", "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("line 101", result.stderr)

    def test_unknown_sensor(self):
        t = self.records[20]["t"]
        line = self.insert(20, {"type": "ping", "t": t, "tx": 99, "rx": 99, "range": 1.0})
        out = self.map_counted(unknown_sensor=1)
        self.assertIn(f"line {line}", out)
        info = self.succeed("info", "log.jsonl")
        self.assertIn("unknown_sensor: 1 ping", info)
        doctor = self.succeed("doctor", "log.jsonl")
        self.assertIn("sensor 99", doctor)

    def test_time_running_backwards(self):
        line = self.insert(len(self.records), {"type": "ping", "t": 0.1, "tx": 0, "rx": 0, "range": 1.0})
        self.assertIn(f"line {line}", self.map_counted(time_backwards=1))

    def test_odometry_running_backwards(self):
        line = self.insert(len(self.records), {"type": "odom", "t": 0.1, "x": 0, "y": 0, "yaw": 0})
        self.assertIn(f"line {line}", self.map_counted(**{"odometry.time_backwards": 1}))

    def test_duplicate_sensors(self):
        sensors = self.records[0]["robot"]["sensors"]
        sensors[1]["id"] = 0
        fixtures.write_records(self.dir / "log.jsonl", self.records)
        self.assert_refused(self.run_command("map", "log.jsonl"), "log.jsonl:1")
        self.assert_nothing_left("log.jsonl")

    def test_field_of_view_1e9(self):
        self.records[0]["robot"]["sensors"][3]["beam_width"] = 1e9
        fixtures.write_records(self.dir / "log.jsonl", self.records)
        self.assert_refused(self.run_command("map", "log.jsonl"), "log.jsonl:1")
        self.assert_nothing_left("log.jsonl")

    def test_wrong_units(self):
        for record in self.records:
            if record["type"] == "ping" and record["range"] != "no_echo":
                record["range"] *= 1000
        fixtures.write_records(self.dir / "log.jsonl", self.records)
        result = self.run_command("map", "log.jsonl")
        self.assert_refused(result, "implausible_range", "log.jsonl:")
        self.assertIn("unit", result.stderr.splitlines()[1])
        self.assert_nothing_left("log.jsonl")
        findings = json.loads(self.succeed("doctor", "log.jsonl", "--json"))["findings"]
        [finding] = [finding for finding in findings if finding["name"] == "wrong_unit"]
        self.assertEqual(finding["severity"], "error")
        self.assertIn("millimetres", finding["message"])

    def test_a_few_ranges_in_millimetres(self):
        # A wall 5 km away, now and then.
        for k in (50, 90, 130):
            self.assertEqual(self.records[k]["type"], "ping")
            self.records[k]["range"] = 5000.0
        out = self.map_counted(implausible_range=3)
        self.assertIn("line 51", out)

    def test_nan_pose(self):
        # JSON cannot say NaN, tables can.
        fixtures.write_room_csv(self.dir / "ranges.csv", self.dir / "poses.csv")
        fixtures.write_robot(self.dir / "robot.toml")
        lines = (self.dir / "poses.csv").read_text().splitlines()
        lines[5] = lines[5].split(",")[0] + ",nan,0,0"
        (self.dir / "poses.csv").write_text("\n".join(lines) + "\n")
        result = self.run_command("map", "ranges.csv", "--odometry", "poses.csv", "--robot", "robot.toml", "-o", "out")
        told = result.stdout + result.stderr
        if result.returncode == 0:
            rejected = json.loads((self.dir / "out" / "run.json").read_text())["rejected"]
            self.assertEqual(rejected["odometry.bad_pose"], 1, told)
            for name in ("consensus", "evidence"):
                self.assertNotIn("nan", (self.dir / "out" / name / "points.csv").read_text().split("\n", 1)[1])
        else:
            self.assert_refused(result, "poses.csv:6")

    def test_nan_pose_in_json(self):
        self.records[1 + 9 * 3]["x"] = math.nan  # Python writes it as NaN, which is no JSON
        fixtures.write_records(self.dir / "log.jsonl", self.records)
        result = self.run_command("map", "log.jsonl", "-o", "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("line 29", result.stdout + result.stderr)


class HugeRequestTest(CommandTest):
    """Requests that would need more memory than any machine has."""

    LIMIT_BYTES = 1 << 30  # address space of the whole process

    def run_bounded(self, *arguments):
        limit = (self.LIMIT_BYTES, self.LIMIT_BYTES)
        return subprocess.run([COMMAND, *map(str, arguments)], cwd=self.dir, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=TIMEOUT_S, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, limit))

    def write_spread_log(self, spacing_m, count):
        """A robot that moves `spacing_m` between pings."""
        records = [fixtures.header()]
        for k in range(count):
            records.append({"type": "odom", "t": 0.5 * k, "x": spacing_m * k, "y": 0.0, "yaw": 0.0})
            records.append({"type": "ping", "t": 0.5 * k, "tx": 0, "rx": 0, "range": 3.0})
        fixtures.write_records(self.dir / "log.jsonl", records)

    @unittest.skipIf("asan" in str(COMMAND) or "tsan" in str(COMMAND), "sanitizers need terabytes of address space")
    def test_billion_cells(self):
        # 4 million cells a ping, one ping a kilometre: 200 MB are full after 25 of them.
        self.write_spread_log(spacing_m=1000.0, count=100)
        result = self.run_bounded("map", "log.jsonl", "--method", "evidence", "--set", "evidence.cell_m=0.001",
                                  "--set", "evidence.max_memory_mib=200", "-o", "out")
        self.assert_refused(result, "evidence")
        self.assertIn("cell_m", result.stderr.splitlines()[1])
        self.assert_nothing_left("log.jsonl")

    def test_a_gigabyte_is_the_default(self):
        for group in json.loads(self.succeed("methods", "--json")):
            for option in group["options"]:
                if option["name"] == "max_memory_mib":
                    self.assertEqual(option["default"], 1024, group["name"])

    @unittest.skipIf("asan" in str(COMMAND) or "tsan" in str(COMMAND), "sanitizers need terabytes of address space")
    def test_memory_limit_is_counted(self):
        self.write_spread_log(spacing_m=1.0, count=200)
        result = self.run_bounded("map", "log.jsonl", "--method", "evidence", "--set", "evidence.cell_m=0.05",
                                  "--set", "evidence.max_memory_mib=1", "-o", "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        counters = json.loads((self.dir / "out" / "run.json").read_text())["methods"][0]["counters"]
        self.assertGreater(counters["memory_limit"], 0)
        self.assertEqual(sum(counters.values()), 200)
        self.assertIn("memory limit", result.stdout)


class NothingToMapTest(CommandTest):
    def test_no_odometry(self):
        records = [record for record in fixtures.room_records() if record["type"] != "odom"]
        fixtures.write_records(self.dir / "log.jsonl", records)
        self.assert_refused(self.run_command("map", "log.jsonl"), "no_pose")
        self.assert_nothing_left("log.jsonl")
        self.assertIn("no_odometry", self.succeed("doctor", "log.jsonl"))

    def test_no_pings(self):
        records = [record for record in fixtures.room_records() if record["type"] != "ping"]
        fixtures.write_records(self.dir / "log.jsonl", records)
        self.assert_refused(self.run_command("map", "log.jsonl"), "no pings")
        self.assert_nothing_left("log.jsonl")


if __name__ == "__main__":
    unittest.main()

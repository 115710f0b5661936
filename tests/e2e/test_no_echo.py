# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""Seven ways to write "no echo" in one log: the same map."""

import json
import unittest

import fixtures
from harness import CommandTest, tree

MAX = fixtures.RANGE_MAX
NUMBERS = {"zero": 0, "minus one": -1, "maximum": MAX, "just above": MAX + 0.01, "far above": 10.0}


def write_ranges(path, silence):
    rows = ["t,sensor_id,range_m"]
    rows += [f"{t},{sensor},{silence if range_m is None else range_m}" for t, sensor, range_m in fixtures.pings()]
    path.write_text("\n".join(rows) + "\n")


class NoEchoTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.silent = sum(range_m is None for _, _, range_m in fixtures.pings())
        self.assertGreater(self.silent, 20)

    def map_files(self, name, *arguments):
        """Every file of the maps but those that speak of the log's name or its counters."""
        out = self.succeed("map", *arguments, "--method", "all", "-o", name)
        report = json.loads((self.dir / name / "run.json").read_text())
        self.assertEqual(report["pings"]["no_echo"], self.silent, out)
        self.assertIn("no echo", out)
        return tree(self.dir / name, leave_out=("run.json", "timings.json", "map.png"))

    def assert_all_equal(self, maps):
        (first, expected), *others = maps.items()
        for name, files in others:
            self.assertEqual([path for path in expected if files[path] != expected[path]], [], f"{name} and {first}")

    def test_in_tables(self):
        fixtures.write_room_csv(self.dir / "unused.csv", self.dir / "poses.csv")
        maps = {}
        for name, silence in {"inf": "inf", "nan": "nan", **NUMBERS}.items():
            write_ranges(self.dir / "ranges.csv", silence)
            # NaN means "failed" to most hardware; a description has to say where it means "no echo".
            fixtures.write_robot(self.dir / "robot.toml", no_echo="nan" if silence == "nan" else "auto")
            maps[name] = self.map_files(name, "ranges.csv", "--odometry", "poses.csv", "--robot", "robot.toml")
        self.assertEqual(len(maps), 7)
        self.assert_all_equal(maps)

    def test_in_json_lines(self):
        maps = {"words": self.map_files("words", fixtures.write_room(self.dir / "words.jsonl"))}
        for name, silence in NUMBERS.items():
            log = fixtures.write_room(self.dir / "log.jsonl", no_echo=silence)
            maps[name] = self.map_files(name, log)
        self.assert_all_equal(maps)

    def test_doctor_names_the_encoding(self):
        for name, silence in NUMBERS.items():
            with self.subTest(name):
                log = fixtures.write_room(self.dir / "log.jsonl", no_echo=silence)
                findings = json.loads(self.succeed("doctor", log, "--json"))["findings"]
                sentences = [finding["message"] for finding in findings if finding["name"] == "no_echo"]
                # Sensors that are alike are told together; a few of them are never silent in this room.
                self.assertLessEqual(len(sentences), 2)
                self.assertTrue(any(f": {silence:g}" in sentence for sentence in sentences), sentences)



if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""Robots that explore by themselves: what is written, that it repeats, and how wrong use is answered."""

import csv
import hashlib
import json
import unittest
import xml.etree.ElementTree

from harness import CommandTest, tree

SHORT = ("--limit", "20")


class ExploreTest(CommandTest):
    def test_folder_holds_runs_pictures_and_graphs(self):
        said = self.succeed("explore", "t-world", "--strategy", "gvg", *SHORT, "--seeds", "2", "-o", "out", "--logs")
        self.assertIn("collisions", said)
        with (self.dir / "out" / "runs.csv").open(newline="") as file:
            runs = list(csv.DictReader(file))
        self.assertEqual([run["seed"] for run in runs], ["1", "2"])
        self.assertEqual({run["collisions"] for run in runs}, {"0"})
        report = json.loads((self.dir / "out" / "run.json").read_text())
        self.assertEqual(report["strategy"], "gvg")
        self.assertGreater(report["runs"][0]["travelled_m"], 0.5)
        graph = json.loads((self.dir / "out" / "seed-1-graph.json").read_text())
        self.assertIn("edges", graph)
        xml.etree.ElementTree.parse(self.dir / "out" / "seed-1.graphml")
        self.assertTrue((self.dir / "out" / "seed-2.png").read_bytes().startswith(b"\x89PNG"))
        self.succeed("info", "out/seed-1.jsonl")

    def test_same_seeds_give_the_same_bytes(self):
        for folder, threads in (("a", "1"), ("b", "2")):
            self.succeed("explore", "demo", "--strategy", "frontier", *SHORT, "--seeds", "2", "--threads", threads, "-o", folder)
        digests = [{name: hashlib.sha256(data).hexdigest() for name, data in tree(self.dir / folder).items()} for folder in "ab"]
        self.assertEqual(*digests)

    def test_every_strategy_drives(self):
        for strategy in ("frontier", "gvg", "wall", "wall-right", "manual-script", "goto"):
            with self.subTest(strategy=strategy):
                run = json.loads(self.succeed("explore", "opening-near", "--strategy", strategy, *SHORT, "--json"))["runs"][0]
                self.assertGreater(run["travelled_m"], 0.2, run)
                self.assertEqual(run["collisions"], 0)

    def test_followed_wall_stands_in_the_log(self):
        self.succeed("explore", "room-a", "--robot", "nomad200", "--set", "sonar.listening=own", "--strategy", "wall-right", *SHORT,
                     "-o", "out", "--logs")
        walls = [json.loads(line) for line in (self.dir / "out" / "seed-1.jsonl").read_text().splitlines() if '"wall"' in line]
        self.assertIn("right", [wall.get("side") for wall in walls])

    def test_wrong_use_is_refused(self):
        refused = self.run_command("explore", "demo", "--strategy", "teleport")
        self.assert_refused(refused, "strategy", status=2)
        self.assert_refused(self.run_command("explore", "demo", "--strategy", "goto"), "goal", status=2)
        self.assert_refused(self.run_command("explore", "demo", "--strategy", "gvg", "--method", "no_such"), "method", status=2)
        self.assert_refused(self.run_command("explore", "no_such", "--strategy", "gvg"), "no_such")
        self.assert_refused(self.run_command("explore", "demo", "--strategy", "gvg", "--robot", "no_such"), "no_such")
        (self.dir / "mine").mkdir()
        (self.dir / "mine" / "letter.txt").write_text("dear")
        self.assert_refused(self.run_command("explore", "demo", "--strategy", "gvg", *SHORT, "-o", "mine"), "mine")
        self.assert_nothing_left("mine")


if __name__ == "__main__":
    unittest.main()

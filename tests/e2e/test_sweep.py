# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""`echoarc sweep`: its table, files and errors, on the demo log and on a small scene."""

import csv
import json
import shutil
import unittest

from harness import SOURCE, CommandTest

SCENE = """name = "wall"
title = "A wall"
source = ""
robot = "nomad200_front3"

[[wall]]
points = [[-2.0, 1.505], [3.0, 1.505]]

[drive]
start = [0.0, 0.0, 0.0]
facing_deg = 90
legs = [[0.3, 0.0]]
stop_step_m = 0.05

[scoring]
region = [[-0.5, 0.0], [0.8, 2.0]]
axis_deg = 90
"""


class SweepTest(CommandTest):
    def setUp(self):
        super().setUp()
        demo = SOURCE / "examples" / "demo"
        shutil.copy(demo / "room.jsonl", self.dir)
        shutil.copy(demo / "room-truth.csv", self.dir)
        (self.dir / "wall.toml").write_text(SCENE)

    def sweep_log(self, *arguments):
        return self.run_command("sweep", "room.jsonl", "--reference", "room-truth.csv", *arguments)

    def rows(self, path):
        with open(self.dir / path, newline="") as file:
            return list(csv.DictReader(file))

    def test_table_of_a_log(self):
        text = self.sweep_log("--method", "vt,dm", "--option", "threshold=1:3:1").stdout
        lines = [line.split() for line in text.splitlines()]
        self.assertEqual([line[:2] for line in lines[3:9]],
                         [[method, str(k)] for method in ("vt", "dm") for k in (1, 2, 3)])
        self.assertIn("coverage", lines[2])
        self.assertNotIn("CDR_F", lines[2], "a log without --doi has no directions")

    def test_a_row_equals_map_and_eval(self):
        report = json.loads(self.sweep_log("--method", "vt", "--option", "threshold=2,3", "--json").stdout)
        self.succeed("map", "room.jsonl", "--method", "vt", "--set", "vt.threshold=3", "-o", "maps")
        scores = json.loads(self.succeed("eval", "maps", "--reference", "room-truth.csv", "--json"))["methods"]["vt"]
        row = report["rows"][1]
        self.assertEqual(row["values"], {"threshold": 3})
        for sweep_name, eval_name in (("mae", "mae"), ("within_10cm", "accuracy_10cm"), ("cells", "points")):
            self.assertAlmostEqual(row["scores"][sweep_name]["mean"], scores[eval_name], places=9)

    def test_directions_bring_a_choice(self):
        report = json.loads(self.sweep_log("--method", "vt", "--option", "threshold=1:4:1", "--doi", "axis:90", "--region",
                                           "-1", "-1", "8", "6", "--json").stdout)
        self.assertEqual(len(report["choices"]), 1)
        gaps = [abs(row["scores"]["cdr_full"]["mean"] - row["scores"]["cdr_empty"]["mean"]) for row in report["rows"]]
        self.assertAlmostEqual(gaps[report["choices"][0]["best"]["threshold"] - 1], min(gaps))

    def test_scene_over_seeds_and_threads(self):
        arguments = ["sweep", "wall.toml", "--method", "vt,centerline", "--option", "sonar.range_noise_share=0,0.02",
                     "--set", "vt.threshold=2", "--seeds", "3"]
        for threads in ("1", "3"):
            self.succeed(*arguments, "--threads", threads, "-o", f"out{threads}")
        runs = [self.rows(f"out{threads}/runs.csv") for threads in ("1", "3")]
        for row in runs[0] + runs[1]:
            row.pop("cpu_per_reading")
        self.assertEqual(runs[0], runs[1])
        self.assertEqual(len(runs[0]), 2 * 2 * 3)
        self.assertEqual({row["seed"] for row in runs[0]}, {"1", "2", "3"})
        self.assertNotEqual(runs[0][0]["mae"], "")
        self.assertEqual(len(self.rows("out1/sweep.csv")), 4)
        for chart in ("mae.svg", "cdr.svg", "coverage.svg"):
            text = (self.dir / "out1" / chart).read_text()
            self.assertTrue(text.startswith("<svg ") and text.endswith("</svg>\n"))
            self.assertIn("sonar.range_noise_share", text)
        self.succeed(*arguments, "-o", "out1")  # what echoarc wrote is replaced

    def test_mistakes_of_the_command_line(self):
        for options, cause in (
                (["--option", "treshold=1:3:1"], "treshold"),
                (["--option", "threshold=3:1:1"], "is empty"),
                (["--option", "threshold=1:3"], "is no range"),
                (["--option", "threshold=0,1"], "threshold = 0 is not legal"),
                (["--option", "sonar.threshold_db=30"], "a log has no sonar options"),
                (["--option", "threshold=1:1000:1", "--option", "cell_m=0.01:1:0.001"], "maps"),
                (["--option", "threshold=1", "--option", "threshold=2"], "given twice"),
                (["--set", "threshold=1,2"], "several values")):
            with self.subTest(options):
                self.assert_refused(self.sweep_log("--method", "vt", *options), cause, status=2)
        self.assert_refused(self.run_command("sweep", "room.jsonl", "--method", "vt"), "where the walls are", status=2)
        self.assert_refused(self.run_command("sweep", "wall.toml", "--method", "vt", "--reference", "room-truth.csv"),
                            "a scene says itself", status=2)
        self.assert_refused(self.sweep_log("--method", "vd"), "there is no method vd", status=2)

    def test_missing_and_unjudged_subjects(self):
        self.assert_refused(self.run_command("sweep", "nowhere", "--method", "vt"), "no such scene or log")
        (self.dir / "plain.toml").write_text(SCENE.split("[scoring]")[0])
        self.assert_refused(self.run_command("sweep", "plain.toml", "--method", "vt", "-o", "out"), "judged")
        self.assertFalse((self.dir / "out").exists())


if __name__ == "__main__":
    unittest.main()

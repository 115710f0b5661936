# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""What `map` writes, and when it replaces what is there."""

import json
import unittest

import fixtures
from harness import CommandTest, documented_methods, tree

METHODS = documented_methods()


class MapTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.log = fixtures.write_room(self.dir / "room.jsonl")

    def test_needs_nothing_but_the_log(self):
        out = self.succeed("map", "room.jsonl")
        files = tree(self.dir / "room-map")
        for method in ("consensus", "evidence"):
            for name in ("map.yaml", "map.pgm", "map.png", "points.csv"):
                self.assertIn(f"{method}/{name}", files)
        for name in ("grid.npy", "grid.json"):
            self.assertIn(f"evidence/{name}", files)
        self.assertIn("run.json", files)
        self.assertTrue((self.dir / "room-map" / "timings.json").exists())
        self.assertTrue(out.endswith("  room-map/consensus/map.png\n  room-map/evidence/map.png\n"), out)

    def test_writes_the_documented_tree_and_no_more(self):
        self.succeed("map", "room.jsonl", "--method", "all", "-o", "out")
        expected = {"run.json", "path.csv"}
        for method in METHODS:
            expected |= {f"{method}/{name}" for name in ("map.yaml", "map.pgm", "map.png", "points.csv")}
        for method in (name for name, map_kind in METHODS.items() if not map_kind.startswith("points")):
            expected |= {f"{method}/grid.npy", f"{method}/grid.json"}
        expected.add("consensus/segments.csv")  # the one method with links
        self.assertEqual(set(tree(self.dir / "out")), expected)
        self.assert_nothing_left("out", "room.jsonl")

    def test_point_table_has_the_documented_columns(self):
        self.succeed("map", "room.jsonl", "--method", "centerline", "-o", "out")
        lines = (self.dir / "out" / "centerline" / "points.csv").read_text().splitlines()
        self.assertTrue(lines[0].startswith("x,y,label,bound,t,sensor,ping,support"))
        echoes = sum(range_m is not None for _, _, range_m in fixtures.pings())
        self.assertEqual(len(lines) - 1, echoes)

    def test_path_is_the_odometry(self):
        self.succeed("map", "room.jsonl", "--method", "centerline", "-o", "out")
        lines = (self.dir / "out" / "path.csv").read_text().splitlines()
        self.assertEqual(lines[0], "t,x,y,yaw")
        rows = [tuple(map(float, line.split(","))) for line in lines[1:]]
        for row, pose in zip(rows, fixtures.poses(), strict=True):
            for written, driven in zip(row, pose):
                self.assertAlmostEqual(written, driven, places=12)

    def test_run_report_counts_every_ping(self):
        self.succeed("map", "room.jsonl", "-o", "out")
        report = json.loads((self.dir / "out" / "run.json").read_text())
        silent = sum(range_m is None for _, _, range_m in fixtures.pings())
        self.assertEqual(report["pings"]["offered"], 40 * fixtures.SENSORS)
        self.assertEqual(report["pings"]["no_echo"], silent)
        self.assertEqual(report["pings"]["echo"], 40 * fixtures.SENSORS - silent)
        self.assertEqual(sum(report["rejected"].values()), 0)
        self.assertFalse(report["interrupted"])
        self.assertEqual([method["name"] for method in report["methods"]], ["consensus", "evidence"])
        self.assertEqual(report["inputs"][0]["bytes"], self.log.stat().st_size)

    def test_options_from_file_and_command_line(self):
        (self.dir / "options.toml").write_text("[evidence]\ncell_m = 0.1\n[vt]\nthreshold = 7\n"
                                               "[sensing]\ntrusted_range_m = 1.5\n")
        self.succeed("map", "room.jsonl", "--method", "evidence,vt", "--config", "options.toml", "--set", "cell_m=0.2",
                     "-o", "out")
        report = json.loads((self.dir / "out" / "run.json").read_text())
        options = {method["name"]: method["options"] for method in report["methods"]}
        self.assertEqual(options["evidence"]["cell_m"], 0.2, "--set wins over the file")
        self.assertEqual(options["vt"]["cell_m"], 0.2, "a bare option reaches every method that has it")
        self.assertEqual(options["vt"]["threshold"], 7)
        self.assertEqual(report["sensing"]["trusted_range_m"], 1.5)

    def test_bare_option_of_sensing(self):
        self.succeed("map", "room.jsonl", "--set", "max_pose_gap_s=3", "-o", "out")
        self.assertEqual(json.loads((self.dir / "out" / "run.json").read_text())["sensing"]["max_pose_gap_s"], 3)

    def test_plain_tables(self):
        fixtures.write_room_csv(self.dir / "ranges.csv", self.dir / "poses.csv")
        fixtures.write_robot(self.dir / "robot.toml")
        self.succeed("map", "ranges.csv", "--odometry", "poses.csv", "--robot", "robot.toml", "-o", "csv")
        report = json.loads((self.dir / "csv" / "run.json").read_text())
        self.assertEqual(report["pings"]["offered"], 40 * fixtures.SENSORS)
        self.assertEqual(sum(report["rejected"].values()), 0)

    def test_maps_agree_with_the_room(self):
        fixtures.write_walls(self.dir / "walls.csv")
        self.succeed("map", "room.jsonl", "--method", "dm", "-o", "out")
        scores = json.loads(self.succeed("eval", "out", "--reference", "walls.csv", "--json"))["methods"]["dm"]
        self.assertLess(scores["mae"], 0.10)
        self.assertGreater(scores["accuracy_20cm"], 0.9)


class ReplaceTest(CommandTest):
    def setUp(self):
        super().setUp()
        fixtures.write_room(self.dir / "room.jsonl", count=10)

    def test_replaces_its_own_folder(self):
        self.succeed("map", "room.jsonl", "-o", "out")
        (self.dir / "out" / "stale.txt").write_text("left over")
        self.succeed("map", "room.jsonl", "--method", "vt", "-o", "out")
        self.assertFalse((self.dir / "out" / "stale.txt").exists())
        self.assertFalse((self.dir / "out" / "consensus").exists())
        self.assertTrue((self.dir / "out" / "vt" / "map.yaml").exists())
        self.assert_nothing_left("out", "room.jsonl")

    def test_leaves_other_folders_alone(self):
        theirs = self.dir / "theirs"
        theirs.mkdir()
        (theirs / "thesis.txt").write_text("years of work")
        self.assert_refused(self.run_command("map", "room.jsonl", "-o", "theirs"), "theirs")
        self.assertEqual((theirs / "thesis.txt").read_text(), "years of work")
        self.assert_nothing_left("room.jsonl", "theirs")

    def test_leaves_a_foreign_run_report_alone(self):
        theirs = self.dir / "theirs"
        theirs.mkdir()
        (theirs / "run.json").write_text('{"written_by": "something else"}')
        self.assert_refused(self.run_command("map", "room.jsonl", "-o", "theirs"), "theirs")
        self.assertEqual(len(list(theirs.iterdir())), 1)

    def test_leaves_a_file_alone(self):
        (self.dir / "out").write_text("a file")
        self.assert_refused(self.run_command("map", "room.jsonl", "-o", "out"), "out")
        self.assertEqual((self.dir / "out").read_text(), "a file")

    def test_does_not_swallow_its_own_log(self):
        self.succeed("map", "room.jsonl", "-o", "out")
        log = (self.dir / "room.jsonl").rename(self.dir / "out" / "room.jsonl")
        self.assert_refused(self.run_command("map", log, "-o", "out"), "inside")
        self.assertTrue(log.exists())

    def test_a_failed_run_keeps_the_old_maps(self):
        self.succeed("map", "room.jsonl", "-o", "out")
        before = tree(self.dir / "out", leave_out=())
        (self.dir / "broken.jsonl").write_text("")
        self.assert_refused(self.run_command("map", "broken.jsonl", "-o", "out"))
        self.assertEqual(tree(self.dir / "out", leave_out=()), before)

    def test_convert_and_init_do_not_overwrite(self):
        kept = self.dir / "kept.toml"
        kept.write_text("by hand")
        self.assert_refused(self.run_command("convert", "room.jsonl", kept), "kept.toml")
        self.assert_refused(self.run_command("init", "-o", kept), "kept.toml")
        self.assertEqual(kept.read_text(), "by hand")
        self.succeed("init", "-o", kept, "--force")
        self.assertIn("hc-sr04", kept.read_text())


if __name__ == "__main__":
    unittest.main()

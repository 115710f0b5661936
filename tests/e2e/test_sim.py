# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""`echoarc sim`: from a scene to a log and a picture, and on into maps."""

import json
import unittest

from harness import CommandTest

SCENE = """name = "cell"
robot = "hc-sr04-row"

[[wall]]
points = [[0, 0], [3, 0], [3, 2], [0, 2], [0, 0]]

[drive]
start = [0.6, 1.0, 0]
legs = [[2.2, 1.0]]
"""


class SimTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.dir / "cell.toml").write_text(SCENE)

    def records(self, name):
        return [json.loads(line) for line in (self.dir / name).read_text().splitlines()]

    def test_writes_a_log_with_truth_and_causes_and_a_picture(self):
        text = self.succeed("sim", "cell.toml")
        self.assertIn("wrote cell.jsonl and cell.png", text)
        self.assertTrue((self.dir / "cell.png").read_bytes().startswith(b"\x89PNG"))
        records = self.records("cell.jsonl")
        kinds = {record["type"] for record in records}
        self.assertEqual(kinds, {"header", "odom", "truth", "ping"})
        echoes = [record for record in records if record["type"] == "ping" and not isinstance(record["range"], str)]
        self.assertTrue(echoes and all("cause" in echo for echo in echoes))
        self.assertIn("wall", {echo["cause"] for echo in echoes})
        info = json.loads(self.succeed("info", "cell.jsonl", "--json"))
        self.assertAlmostEqual(info["path_m"], 1.6, places=2)

    def test_the_same_seed_gives_the_same_bytes(self):
        for name, seed in (("a", 7), ("b", 7), ("c", 8)):
            self.succeed("sim", "cell.toml", "-o", f"{name}.jsonl", "--seed", seed)
        read = {name: (self.dir / f"{name}.jsonl").read_bytes() for name in "abc"}
        self.assertEqual(read["a"], read["b"])
        self.assertNotEqual(read["a"], read["c"])
        self.assertEqual((self.dir / "a.png").read_bytes(), (self.dir / "b.png").read_bytes())

    def test_convert_keeps_the_causes(self):
        self.succeed("sim", "cell.toml", "-o", "a.jsonl")
        self.succeed("convert", "a.jsonl", "b.jsonl")
        self.assertEqual((self.dir / "a.jsonl").read_bytes(), (self.dir / "b.jsonl").read_bytes())

    def test_options_and_json(self):
        report = json.loads(self.succeed("sim", "cell.toml", "--json", "--picture", "p.png", "--set",
                                         "sonar.outlier_share=1", "--set", "dropout_share=0"))
        self.assertEqual(report["echoes"]["outlier"], report["windows"])
        self.assertTrue((self.dir / "p.png").exists())

    def test_polled_registers_can_be_mapped(self):
        self.succeed("sim", "cell.toml", "-o", "a.jsonl", "--set", "polling.polled=true")
        self.assertNotIn("ping", {record["type"] for record in self.records("a.jsonl")})
        self.succeed("map", "a.jsonl", "--method", "dm")

    def test_refusals_say_where_and_leave_nothing(self):
        (self.dir / "wall.toml").write_text(SCENE.replace("[2.2, 1.0]", "[2.99, 1.0]"))
        self.assert_refused(self.run_command("sim", "wall.toml"), "wall.toml", "surface")
        self.assert_refused(self.run_command("sim", "nowhere"), "nowhere")
        self.assert_refused(self.run_command("sim", "cell.toml", "--set", "sonar.quantum_m=-1"), status=2)
        self.assert_refused(self.run_command("sim", "cell.toml", "--set", "rate_hz=1"), "odometry", status=2)
        self.assert_refused(self.run_command("sim", "cell.toml", "-o", "cell.png"), "same name")
        self.assert_refused(self.run_command("sim", "cell.toml", "-o", "no/such/folder.jsonl"), "no/such")
        self.assert_nothing_left("cell.toml", "wall.toml")

    def test_results_are_not_replaced_unasked(self):
        self.succeed("sim", "cell.toml")
        self.assert_refused(self.run_command("sim", "cell.toml"), "exists already")
        self.succeed("sim", "cell.toml", "--force")


if __name__ == "__main__":
    unittest.main()

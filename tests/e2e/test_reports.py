# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""What people and programs are told: info, doctor, eval, methods, explain, init, convert."""

import csv
import json
import math
import unittest

import fixtures
from harness import SHARED_DATA, SOURCE, CommandTest, documented_methods


def strict_json(text):
    """JSON as the standard has it: no NaN, no Infinity."""
    def refuse(word):
        raise ValueError(word)
    return json.loads(text, parse_constant=refuse)


class InfoTest(CommandTest):
    def test_numbers_of_the_room(self):
        fixtures.write_room(self.dir / "room.jsonl")
        info = strict_json(self.succeed("info", "room.jsonl", "--json"))
        poses = list(fixtures.poses())
        self.assertEqual(info["poses"], len(poses))
        self.assertEqual(info["pings"], len(poses) * fixtures.SENSORS)
        self.assertAlmostEqual(info["duration_s"], poses[-1][0])
        way = sum(math.hypot(b[1] - a[1], b[2] - a[2]) for a, b in zip(poses, poses[1:]))
        self.assertAlmostEqual(info["path_m"], way, places=9)
        for sensor in info["sensors"]:
            own = [range_m for _, number, range_m in fixtures.pings() if number == sensor["id"]]
            echoes = sorted(range_m for range_m in own if range_m is not None)
            self.assertEqual(sensor["echo"], len(echoes))
            self.assertEqual(sensor["no_echo"], len(own) - len(echoes))
            self.assertAlmostEqual(sensor["rate_hz"], 5.0, places=9)
            if echoes:
                self.assertEqual(sensor["range_min_m"], echoes[0])
                self.assertEqual(sensor["range_max_m"], echoes[-1])
                self.assertEqual(sensor["range_median_m"], echoes[(len(echoes) - 1) // 2])

    def test_text_names_every_sensor(self):
        fixtures.write_room(self.dir / "room.jsonl")
        out = self.succeed("info", "room.jsonl")
        for sensor in range(fixtures.SENSORS):
            self.assertRegex(out, rf"(?m)^  {sensor} +\S+ deg")

    def test_recorded_logs(self):
        corridor = SHARED_DATA / "corridor"
        if not corridor.exists():
            self.skipTest(f"the recorded logs are not here: {corridor}")
        for run, rows in (("run1", 413), ("run2", 214), ("run3", 366)):
            info = strict_json(self.succeed("info", corridor / run, "--describe", SOURCE / "descriptions/corridor.toml",
                                            "--json"))
            self.assertEqual(info["pings"], 8 * rows)
            self.assertEqual(info["scans"], rows)


class DoctorTest(CommandTest):
    def findings(self, *arguments):
        answer = strict_json(self.succeed("doctor", *arguments, "--json"))
        for finding in answer["findings"]:
            self.assertGreater(len(finding["remedy"]), 10, finding)
        return {finding["name"]: finding for finding in answer["findings"]}

    def test_healthy_log(self):
        fixtures.write_room(self.dir / "room.jsonl")
        for finding in self.findings("room.jsonl").values():
            self.assertEqual(finding["severity"], "note", finding)

    def test_gravest_first(self):
        records = [record for record in fixtures.room_records() if record["type"] != "odom"]
        fixtures.write_records(self.dir / "log.jsonl", records)
        order = ["error", "warning", "note"]
        found = [order.index(finding["severity"]) for finding in self.findings("log.jsonl").values()]
        self.assertEqual(found, sorted(found))
        self.assertEqual(found[0], 0)

    def test_sick_sensors(self):
        records = list(fixtures.room_records())
        twins = iter([record["range"] for record in records if record["type"] == "ping" and record["tx"] == 1])
        for record in records:
            if record["type"] != "ping":
                continue
            record["range"] = {2: 1.234, 3: "no_echo", 4: next(twins) if record["tx"] == 4 else 0}.get(
                record["tx"], record["range"])
        records = [record for record in records if record.get("tx") != 5]
        fixtures.write_records(self.dir / "log.jsonl", records)
        findings = self.findings("log.jsonl")
        self.assertIn("sensor 2 ", findings["sensor_stuck"]["message"])
        self.assertIn("sensor 3 ", findings["never_an_echo"]["message"])
        self.assertIn("sensors 1,4 ", findings["sensors_alike"]["message"])
        self.assertIn("sensor 5 ", findings["sensor_missing"]["message"])

    def test_robot_description(self):
        fixtures.write_robot(self.dir / "robot.toml")
        self.assertEqual(self.findings("robot.toml"), {})
        (self.dir / "low.toml").write_text("""name = "low"
[[sensors]]
z = 0.1
beam_width_deg = 30
range_min = 0.02
range_max = 4.0
""")
        # 0.1 m / sin 15 deg
        self.assertIn("0.39 m", self.findings("low.toml")["floor_in_beam"]["message"])

    def test_template_is_in_order(self):
        self.succeed("init", "--preset", "hc-sr04", "--count", "5", "-o", "robot.toml")
        for finding in self.findings("robot.toml").values():
            self.assertEqual(finding["severity"], "note", finding)


class EvalTest(CommandTest):
    def setUp(self):
        super().setUp()
        fixtures.write_room(self.dir / "room.jsonl")
        fixtures.write_walls(self.dir / "walls.csv")
        self.succeed("map", "room.jsonl", "--method", "centerline,dm,evidence", "-o", "out")

    def scores(self, *arguments):
        return strict_json(self.succeed("eval", *arguments, "--json"))["methods"]

    def test_every_method_of_a_folder(self):
        scores = self.scores("out", "--reference", "walls.csv")
        self.assertEqual(list(scores), ["centerline", "dm", "evidence"])
        for figures in scores.values():
            self.assertGreater(figures["points"], 0)
            for share in ("accuracy_5cm", "accuracy_10cm", "accuracy_20cm", "coverage"):
                self.assertTrue(0.0 <= figures[share] <= 1.0)
            self.assertLessEqual(figures["accuracy_5cm"], figures["accuracy_20cm"])
            self.assertLessEqual(figures["thinned_points"], figures["points"])

    def test_centerline_by_hand(self):
        figures = self.scores("out/centerline", "--reference", "walls.csv")["centerline"]
        distances = []
        for line in (self.dir / "out/centerline/points.csv").read_text().splitlines()[1:]:
            x, y = map(float, line.split(",")[:2])
            x_min, y_min, x_max, y_max = fixtures.ROOM
            dx, dy = max(x_min - x, 0, x - x_max), max(y_min - y, 0, y - y_max)
            inside = min(x - x_min, x_max - x, y - y_min, y_max - y)
            distances.append(inside if inside >= 0 else (dx * dx + dy * dy) ** 0.5)
        # The reference is sampled every 2 mm, so it is a little further away than the wall itself.
        self.assertAlmostEqual(figures["mae"], sum(distances) / len(distances), delta=1e-4)

    def test_one_method_and_one_file(self):
        whole = self.scores("out", "--reference", "walls.csv")["dm"]
        self.assertEqual(self.scores("out/dm", "--reference", "walls.csv")["dm"], whole)
        self.assertEqual(self.scores("out/dm/map.yaml", "--reference", "walls.csv")["map"], whole)

    def test_a_map_against_itself(self):
        for reference in ("out/evidence", "out/evidence/map.yaml"):
            figures = self.scores("out/evidence", "--reference", reference)["evidence"]
            self.assertEqual(figures["mae"], 0.0)
            self.assertEqual(figures["accuracy_5cm"], 1.0)
            self.assertEqual(figures["coverage"], 1.0)

    def test_directions_of_interest(self):
        directions = ("--doi", "axis:90", "--doi", "axis:0", "--region", "-0.005", "-0.005", "6.005", "4.005")
        figures = self.scores("out", "--reference", "walls.csv", *directions)
        for method in figures.values():
            self.assertIn("cdr_full", method)
        # Every direction of a closed room is full: nothing to be empty.
        self.assertIsNone(figures["dm"]["cdr_empty"])
        text = self.succeed("eval", "out", "--reference", "walls.csv", *directions)
        self.assertIn("correct detection ratio", text)

    def test_against_the_laser(self):
        corridor = SHARED_DATA / "corridor"
        if not corridor.exists():
            self.skipTest(f"the recorded logs are not here: {corridor}")
        described = ("--describe", SOURCE / "descriptions/corridor.toml")
        self.succeed("map", corridor / "run1", *described, "-o", "run1")
        figures = self.scores("run1", "--reference", corridor / "run1", *described)["consensus"]
        self.assertGreater(figures["accuracy_20cm"], 0.8)
        self.assertGreater(figures["coverage"], 0.5)

    def test_bad_references(self):
        (self.dir / "bad.csv").write_text("polyline,x,y\n0,0,0\n0,here,0\n")
        self.assert_refused(self.run_command("eval", "out", "--reference", "bad.csv"), "bad.csv:3")
        (self.dir / "bad.csv").write_text("a,b\n")
        self.assert_refused(self.run_command("eval", "out", "--reference", "bad.csv"), "bad.csv:1")
        self.assert_refused(self.run_command("eval", "out", "--reference", "room.jsonl"), "room.jsonl")
        (self.dir / "nothing").mkdir()
        self.assert_refused(self.run_command("eval", "nothing", "--reference", "walls.csv"), "nothing")


class ExplainTest(CommandTest):
    def test_says_what_the_map_holds(self):
        fixtures.write_room(self.dir / "room.jsonl")
        self.succeed("map", "room.jsonl", "--method", "consensus", "-o", "out")
        with open(self.dir / "out" / "consensus" / "points.csv", newline="") as file:
            point = next(row for row in csv.DictReader(file) if row["label"] in ("wall", "point"))
        explained = strict_json(self.succeed("explain", "room.jsonl", "--ping", point["ping"], "--json"))
        self.assertAlmostEqual(explained["position"][0], float(point["x"]), places=3)
        self.assertAlmostEqual(explained["position"][1], float(point["y"]), places=3)
        self.assertAlmostEqual(sum(explained["prior"]), 1.0, places=4)
        for sweep in explained["sweeps"]:
            self.assertEqual(len(sweep["wall"]), len(explained["bearings_deg"]))
            self.assertAlmostEqual(sum(sweep["wall"]), 1.0, places=4)
        self.assertGreater(len(explained["neighbours"]), 10)
        self.assertIn("read out", self.succeed("explain", "room.jsonl", "--ping", point["ping"]))

    def test_says_why_there_is_nothing_to_explain(self):
        fixtures.write_room(self.dir / "room.jsonl", count=2)
        self.assert_refused(self.run_command("explain", "room.jsonl", "--ping", "4711"), "ping 4711")
        self.assert_refused(self.run_command("explain", "room.jsonl"), "--ping", status=2)
        self.assert_refused(self.run_command("explain", "room.jsonl", "--ping", "1", "--set", "sweeps=0"), status=2)


class MethodsTest(CommandTest):
    def test_list_and_details(self):
        out = self.succeed("methods")
        catalogue = strict_json(self.succeed("methods", "--json"))
        names = [entry["name"] for entry in catalogue]
        self.assertEqual(names[0], "sensing")
        self.assertEqual(sorted(names[1:-3]), sorted(documented_methods()))
        self.assertEqual(names[-3:], ["tangents", "regions", "lines"])
        for entry in catalogue:
            self.assertIn(entry["name"], out)
            details = self.succeed("methods", entry["name"])
            for option in entry["options"]:
                self.assertIn(f"{entry['name']}.{option['name']} = ", details)
                self.assertIn(option["description"], details)
            self.assertEqual(strict_json(self.succeed("methods", entry["name"], "--json")), entry)

    def test_schema_accepts_the_defaults(self):
        schema = strict_json(self.succeed("methods", "--schema"))
        catalogue = strict_json(self.succeed("methods", "--json"))
        for entry in catalogue:
            properties = schema["properties"][entry["name"]]["properties"]
            self.assertEqual(list(properties), [option["name"] for option in entry["options"]])
            for rule in properties.values():
                default = rule["default"]
                self.assertIn(default, rule.get("enum", [default]))
                if rule["type"] in ("number", "integer"):
                    self.assertTrue(rule.get("minimum", default) <= default <= rule.get("maximum", default))

    def test_every_default_can_be_set(self):
        fixtures.write_room(self.dir / "room.jsonl", count=4)
        settings = []
        for entry in strict_json(self.succeed("methods", "--json")):
            for option in entry["options"]:
                value = option["default"]
                text = str(value).lower() if isinstance(value, bool) else str(value)
                settings += ["--set", f"{entry['name']}.{option['name']}={text}"]
        self.succeed("map", "room.jsonl", "--method", "all", "--features", "all", *settings)


class BenchTest(CommandTest):
    def test_every_method_beside_its_paper(self):
        fixtures.write_room(self.dir / "room.jsonl")
        report = strict_json(self.succeed("bench", "room.jsonl", "--runs", "2", "--json"))
        self.assertEqual({method["name"] for method in report["methods"]}, set(documented_methods()))
        self.assertEqual(report["runs"], 2)
        for method in report["methods"]:
            self.assertGreater(method["per_ping_s"], 0.0)
            self.assertGreaterEqual(method["total_cpu_s"], method["per_ping_s"])
        papers = {method["name"]: method["paper_per_arc_s"] for method in report["methods"]}
        self.assertAlmostEqual(papers["bu"], 0.587 / 738)
        self.assertIsNone(papers["evidence"])

    def test_nothing_to_measure(self):
        fixtures.write_room(self.dir / "room.jsonl")
        self.assert_refused(self.run_command("bench", "room.jsonl", "--method", "nope"), "no method nope", status=2)
        fixtures.write_room(self.dir / "silent.jsonl", count=0)
        self.assert_refused(self.run_command("bench", "silent.jsonl"), "none of its pings")


class ConvertTest(CommandTest):
    def test_keeps_what_it_does_not_know(self):
        records = list(fixtures.room_records(count=4))
        records.insert(3, {"type": "battery", "t": 0.0, "volts": 12.1})
        records[4] = {**records[4], "operator_note": "door open"}
        fixtures.write_records(self.dir / "in.jsonl", records)
        self.succeed("convert", "in.jsonl", "out.jsonl")
        kept = [json.loads(line) for line in (self.dir / "out.jsonl").read_text().splitlines()]
        self.assertEqual(kept, records)

    def test_twice_is_once(self):
        fixtures.write_room(self.dir / "in.jsonl", count=4)
        self.succeed("convert", "in.jsonl", "once.jsonl")
        self.succeed("convert", "once.jsonl", "twice.jsonl")
        self.assertEqual((self.dir / "once.jsonl").read_bytes(), (self.dir / "twice.jsonl").read_bytes())

    def test_converted_log_gives_the_same_map(self):
        fixtures.write_room(self.dir / "room.jsonl", count=10)
        self.succeed("convert", "room.jsonl", "again.jsonl")
        for log in ("room", "again"):
            self.succeed("map", f"{log}.jsonl", "--method", "evidence", "-o", log)
        for name in ("map.pgm", "points.csv", "grid.npy"):
            self.assertEqual((self.dir / "room/evidence" / name).read_bytes(),
                             (self.dir / "again/evidence" / name).read_bytes(), name)


class InitTest(CommandTest):
    def test_every_preset_reads_back(self):
        presets = [line.split()[0] for line in self.succeed("init", "--list").splitlines()[1:]]
        self.assertIn("hc-sr04", presets)
        for preset in presets:
            for layout in ("ring", "row"):
                text = self.succeed("init", "--preset", preset, "--count", "3", "--layout", layout)
                self.assertIn("#", text, "comments say what to edit")
                (self.dir / "robot.toml").write_text(text)
                self.succeed("doctor", "robot.toml")


if __name__ == "__main__":
    unittest.main()

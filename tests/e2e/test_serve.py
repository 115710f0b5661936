# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""The serving command: what it prints, what it answers, what it leaves behind, and what it survives."""

import json
import sys
import unittest
import urllib.error
import urllib.request

from harness import COMMAND, SOURCE, CommandTest

sys.path.insert(0, str(SOURCE / "bench" / "live"))
import dead_man  # noqa: E402
import kill_trials  # noqa: E402
from served import Served  # noqa: E402
from viewer import Viewer  # noqa: E402


class ServeTest(CommandTest):
    def serve(self, *arguments):
        served = Served(COMMAND, *arguments, cwd=self.dir)
        self.addCleanup(served.end)
        return served

    def get(self, served, path, **headers):
        request = urllib.request.Request(f"http://127.0.0.1:{served.port}{path}", headers=headers)
        with urllib.request.urlopen(request, timeout=20) as answer:
            return answer.status, answer.headers, answer.read()

    def watch(self, served, seconds=2.0):
        viewer = Viewer(served.port)
        self.addCleanup(viewer.close)
        viewer.wait_for("welcome")
        states = [viewer.wait_for("state") for _ in range(int(10 * seconds))]
        return viewer, states

    def test_scene_moves_and_is_saved_on_interrupt(self):
        served = self.serve("--scene", "demo", "-o", "session")
        _, states = self.watch(served)
        self.assertGreater(states[-1]["t"], states[0]["t"])
        self.assertGreater(states[-1]["pings"], states[0]["pings"])
        self.assertNotEqual(states[-1]["pose"], states[0]["pose"])
        self.assertEqual(served.end(), 0, served.lines)
        for name in ("session.jsonl", "run.json", "consensus/points.csv", "consensus/map.png", "evidence/map.yaml"):
            self.assertTrue((self.dir / "session" / name).exists(), name)
        self.assertIn("command", {json.loads(line)["type"] for line in (self.dir / "session/session.jsonl").read_text().splitlines()})
        self.succeed("map", "session/session.jsonl", "-o", "again")

    def test_files_over_http(self):
        served = self.serve("--scene", "demo", "-o", "session")
        self.watch(served, 1.0)
        status, headers, page = self.get(served, "/", **{"Accept-Encoding": "gzip"})
        self.assertEqual((status, headers["Content-Encoding"]), (200, "gzip"))
        self.assertLess(len(page), 300_000)
        for path, start in (("/api/map/evidence.png", b"\x89PNG"), ("/api/map/evidence.pgm", b"P5"),
                            ("/api/map/evidence.yaml", b"image: "), ("/api/map/consensus.csv", b"x,y,label"),
                            ("/api/log", b'{"type":"header"'), ("/api/run.json", b"{"), ("/api/state", b"{"),
                            ("/api/parameters", b"{")):
            status, _, body = self.get(served, path)
            self.assertTrue(body.startswith(start), (path, body[:60]))
        for path in ("/api/map/no_such.png", "/nothing", "/api/map/evidence.exe"):
            with self.assertRaises(urllib.error.HTTPError) as refused:
                self.get(served, path)
            self.assertEqual(refused.exception.code, 404)
            refused.exception.close()

    def test_log_is_played_and_sought(self):
        self.succeed("sim", "demo", "-o", "demo.jsonl")
        served = self.serve("--log", "demo.jsonl")
        viewer, states = self.watch(served, 1.0)
        welcome = Viewer(served.port, token=served.token)
        self.addCleanup(welcome.close)
        self.assertEqual(welcome.wait_for("welcome")["source"]["kind"], "log")
        welcome.say({"type": "playback", "seek_s": 20.0, "playing": False})
        self.assertTrue(any(abs(viewer.wait_for("state")["t"] - 20.0) < 0.2 for _ in range(50)))
        welcome.say({"type": "playback", "seek_s": 5.0, "playing": True, "speed": 4.0})
        self.assertTrue(any(5.0 <= viewer.wait_for("state")["t"] < 7.0 for _ in range(50)))
        self.assertFalse((self.dir / "demo-session").exists())

    def test_private_server_asks_for_the_token(self):
        served = self.serve("--scene", "demo", "--private")
        with self.assertRaises(urllib.error.HTTPError) as refused:
            self.get(served, "/api/state")
        self.assertEqual(refused.exception.code, 401)
        refused.exception.close()
        self.assertEqual(self.get(served, "/api/state", Authorization=f"Bearer {served.token}")[0], 200)

    def test_bad_arguments_are_refused(self):
        self.assert_refused(self.run_command("serve", "--scene", "no_such"), "no_such")
        self.assert_refused(self.run_command("serve", "--log", "no_such.jsonl"), "no_such.jsonl")
        self.assert_refused(self.run_command("serve", "--resume", "no_such"), "no_such")
        self.assert_refused(self.run_command("serve", "--scene", "demo", "--method", "no_such"), "no_such", status=2)

    def test_log_limit_stops_the_log_and_not_the_robot(self):
        served = self.serve("--scene", "demo", "-o", "session", "--log-limit", "0.005")
        viewer, _ = self.watch(served, 3.0)
        self.assertEqual(viewer.wait_for("counters")["log"]["state"], "limit")
        before = viewer.wait_for("state")["pings"]
        self.assertTrue(any(viewer.wait_for("state")["pings"] > before for _ in range(20)))
        self.assertLess((self.dir / "session/session.jsonl").stat().st_size, 8_000)

    def test_killed_session_goes_on_with_the_same_map(self):
        result = kill_trials.run(COMMAND, trials=3, seed=7)
        self.assertEqual((result["flushed_pings_lost"], result["maps_unequal"]), (0, 0), result)

    def test_one_method_runs_twice_and_is_saved_and_resumed_so(self):
        served = self.serve("--scene", "demo", "--method", "numakura", "-o", "session")
        driver = Viewer(served.port, token=served.token)
        self.addCleanup(driver.close)
        driver.wait_for("welcome")
        untested = {"consistency_test": False, "geometry_test": False}
        driver.say({"type": "method_add", "method": "numakura-no-test", "name": "numakura", "options": untested})
        running = [method["method"] for method in driver.wait_for("methods")["running"]]
        while len(running) < 2:
            running = [method["method"] for method in driver.wait_for("methods")["running"]]
        self.assertEqual(running, ["numakura", "numakura-no-test"])
        self.watch(served, 2.0)
        self.assertEqual(served.end(), 0, served.lines)
        session = self.dir / "session"

        def check():
            methods = json.loads((session / "run.json").read_text())["methods"]
            self.assertEqual([(method["name"], method.get("method")) for method in methods],
                             [("numakura", None), ("numakura-no-test", "numakura")])
            self.assertEqual({name: methods[1]["options"][name] for name in untested}, untested)
            return [(session / method["name"] / "map.pgm").read_bytes() for method in methods]

        before = check()
        self.assertNotEqual(before[0], before[1])
        for folder in ("numakura", "numakura-no-test"):
            (session / folder / "map.pgm").unlink()
        self.succeed("serve", "--resume", "session", "--duration", "0")
        self.assertEqual(check(), before)

    def test_robot_explores_by_itself_and_stands_when_resumed(self):
        served = self.serve("--scene", "t-world", "--method", "evidence", "--speed", "4", "-o", "session")
        driver = Viewer(served.port, token=served.token)
        self.addCleanup(driver.close)
        modes = driver.wait_for("welcome")["modes"]
        for mode in ("frontier", "gvg", "wall-left", "wall-right", "goto", "home"):
            self.assertIn(mode, modes)
        driver.say({"type": "mode", "mode": "gvg"})
        self.assertEqual(driver.wait_for("plan")["strategy"], "gvg")
        self.assertTrue(any(driver.wait_for("state")["mode"] == "gvg" for _ in range(50)))
        driver.close()
        viewer, states = self.watch(served, 4.0)
        self.assertEqual({state["mode"] for state in states}, {"gvg"}, "it goes on without the one who started it")
        self.assertNotEqual(states[0]["pose"], states[-1]["pose"])
        viewer.close()
        self.assertEqual(served.end(), 0, served.lines)
        lines = [json.loads(line) for line in (self.dir / "session/session.jsonl").read_text().splitlines()]
        self.assertIn("gvg", {line["mode"] for line in lines if line["type"] == "command"})
        _, states = self.watch(self.serve("--resume", "session"), 1.0)
        self.assertEqual({state["mode"] for state in states}, {"stand"})
        self.assertEqual(states[0]["pose"], states[-1]["pose"])

    def test_robot_stops_when_its_driver_is_gone(self):
        for result in dead_man.run(COMMAND, trials=6, seed=7):
            self.assertTrue(dead_man.in_time(result), result)


if __name__ == "__main__":
    unittest.main()

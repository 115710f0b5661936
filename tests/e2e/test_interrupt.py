# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""Ctrl-C ends the mapping, not the maps."""

import json
import os
import pty
import signal
import subprocess
import unittest

import fixtures
from harness import COMMAND, TIMEOUT_S, CommandTest


class InterruptTest(CommandTest):
    def start(self, *arguments):
        """The command with a terminal on stderr: the progress bar tells when the mapping has begun."""
        terminal, inside = pty.openpty()
        process = subprocess.Popen([COMMAND, *map(str, arguments)], cwd=self.dir, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=inside, text=True)
        os.close(inside)
        self.addCleanup(os.close, terminal)
        self.addCleanup(process.kill)
        return process, terminal

    def read_until(self, terminal, text):
        seen = ""
        while text not in seen:
            seen += os.read(terminal, 4096).decode()
        return seen

    def write_long_log(self):
        """The room driven so often that small cells take minutes."""
        with open(self.dir / "long.jsonl", "w", encoding="ascii") as file:
            records = list(fixtures.room_records())
            file.write(json.dumps(records[0]) + "\n")
            for lap in range(150):
                for record in records[1:]:
                    file.write(json.dumps({**record, "t": record["t"] + 10.0 * lap}) + "\n")

    def interrupt(self, number):
        self.write_long_log()
        process, terminal = self.start("map", "long.jsonl", "--method", "evidence,bu", "--set", "cell_m=0.005", "-o", "out")
        self.read_until(terminal, " %")
        process.send_signal(number)
        out, _ = process.communicate(timeout=TIMEOUT_S)
        return process.returncode, out

    def test_maps_are_written(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                status, out = self.interrupt(number)
                self.assertEqual(status, 130, out)
                report = json.loads((self.dir / "out" / "run.json").read_text())
                self.assertTrue(report["interrupted"])
                self.assertGreater(report["pings"]["offered"], 0)
                self.assertLess(report["pings"]["offered"], 150 * 40 * fixtures.SENSORS)
                for method in ("evidence", "bu"):
                    self.assertTrue((self.dir / "out" / method / "map.yaml").exists())
                    self.assertTrue((self.dir / "out" / method / "map.png").exists())
                self.assertIn("out/bu/map.png", out)
                self.assert_nothing_left("long.jsonl", "out")

    def test_no_bar_without_a_terminal(self):
        fixtures.write_room(self.dir / "room.jsonl")
        result = self.run_command("map", "room.jsonl")
        self.assertEqual((result.returncode, result.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()

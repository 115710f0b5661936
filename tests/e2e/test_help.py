# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""Every command line that a help page shows is run, in a folder that holds what it speaks of."""

import pathlib
import re
import shlex
import shutil
import tempfile
import unittest

import fixtures
from harness import SOURCE, CommandTest

VERBS = ["map", "eval", "info", "doctor", "methods", "init", "convert", "sim", "sweep", "explain"]

CARMEN = """PARAM robot_length 0.4
ODOM 0.0 0.0 0.0 0.1 0.0 0.0 0.0 host 0.0
SONAR 0.436 2 1.50 1.20 0.2 0.0 0.0 -0.2 0.0 3.14159 0.5 host 0.5
ODOM 0.1 0.0 0.0 0.1 0.0 0.0 1.0 host 1.0
SONAR 0.436 2 1.40 1.30 0.2 0.0 0.0 -0.2 0.0 3.14159 1.0 host 1.0
ODOM 0.2 0.0 0.0 0.1 0.0 0.0 2.0 host 2.0
"""

DESCRIPTION = SOURCE / "descriptions" / "corridor.toml"


class HelpTest(CommandTest):
    def setUp(self):
        """What the examples speak of, and what an earlier step of a session would have left."""
        super().setUp()
        self.session = self.dir / "session"
        self.session.mkdir()
        demo = SOURCE / "examples" / "demo"
        shutil.copy(demo / "room.jsonl", self.session)
        shutil.copy(demo / "room-truth.csv", self.session)
        shutil.copy(DESCRIPTION, self.session / "corridor.toml")
        fixtures.write_corridor(self.session / "run1")
        fixtures.write_room_csv(self.session / "ranges.csv", self.session / "poses.csv")
        fixtures.write_robot(self.session / "robot.toml")
        (self.session / "drive.clf").write_text(CARMEN)
        self.succeed("map", "room.jsonl", cwd=self.session)
        self.succeed("map", "room.jsonl", "-o", "demo-map", cwd=self.session)
        self.succeed("map", "run1", "--describe", "corridor.toml", cwd=self.session)

    def examples(self, *verb):
        text = self.succeed(*verb, "--help")
        head, _, rest = text.partition("\n\n")
        self.assertTrue(head.startswith("Examples:\n"), "help begins with examples")
        self.assertIn("Usage: echoarc", rest)
        lines = re.findall(r"^  (echoarc .*)$", head, re.MULTILINE)
        self.assertGreaterEqual(len(lines), 3, text)
        return lines

    def run_example(self, line):
        """In a session of its own, so that none lives on what another wrote."""
        with tempfile.TemporaryDirectory(dir=self.dir) as scratch:
            session = pathlib.Path(scratch) / "session"
            shutil.copytree(self.session, session)
            arguments = shlex.split(line)[1:]
            if "-o" in arguments:
                (session / arguments[arguments.index("-o") + 1]).unlink(missing_ok=True)
            self.assertTrue(self.succeed(*arguments, cwd=session).strip())

    def test_every_example_runs(self):
        lines = self.examples()
        for verb in VERBS:
            lines += self.examples(verb)
        for line in lines:
            with self.subTest(line):
                self.run_example(line)

    def test_help_lists_every_verb(self):
        text = self.succeed("--help")
        for verb in VERBS:
            self.assertRegex(text, rf"(?m)^  {verb} ")

    def test_version(self):
        self.assertRegex(self.succeed("--version"), r"^echoarc \d+\.\d+\.\d+\n$")


class UsageTest(CommandTest):
    def test_wrong_usage_is_status_2(self):
        log = fixtures.write_room(self.dir / "log.jsonl", count=2)
        for arguments in (
                (), ("fly",), ("map",), ("map", log, "--no-such-flag"), ("map", log, "--threads", "0"),
                ("map", log, "--threads", "many"), ("map", log, "--method", "magic"),
                ("map", log, "--set", "evidence.cell_m=-1"), ("map", log, "--set", "evidence.cell=1"),
                ("map", log, "--set", "cell_m"), ("map", log, "--set", "nowhere.cell_m=1"),
                ("map", log, "--method", "dm", "--set", "evidence.cell_m=0.1"),
                ("eval", self.dir), ("methods", "magic"), ("methods", "--json", "--schema"),
                ("init", "--layout", "heap"), ("init", "--preset", "bat"), ("init", "--count", "-3"),
                ("eval", self.dir, "--reference", log, "--doi", "axis:90"),
                ("eval", self.dir, "--reference", log, "--doi", "up", "--region", "0", "0", "1", "1")):
            with self.subTest(arguments):
                self.assert_refused(self.run_command(*arguments), status=2)
        self.assert_nothing_left("log.jsonl")

    def test_unknown_option_suggests_the_nearest(self):
        log = fixtures.write_room(self.dir / "log.jsonl", count=2)
        result = self.run_command("map", log, "--set", "evidence.cel_m=0.1")
        self.assert_refused(result, status=2)
        self.assertIn("cell_m", result.stderr.splitlines()[1])


if __name__ == "__main__":
    unittest.main()

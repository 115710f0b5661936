# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""`echoarc compare` on the smallest scene: a page, the same figures as JSON, pictures, tables for the docs."""

import json
import re
import shlex
import unittest

import fixtures
from harness import SOURCE, CommandTest
from test_reproduce import Page

SMALLEST = ("--scenes", "rcd", "--methods", "consensus,centerline", "--seeds", "1")


class CompareTest(CommandTest):
    def compare(self, name, *arguments):
        folder = self.dir / name
        self.succeed("compare", *(arguments or SMALLEST), "-o", folder)
        return folder

    def test_page_is_whole_and_stands_alone(self):
        page = Page()
        page.feed((self.compare("out") / "comparison.html").read_text())
        page.close()
        self.assertEqual(page.problems, [])
        self.assertEqual(page.open, [])
        self.assertEqual(page.targets - page.ids, set())
        self.assertNotIn("script", page.seen)
        self.assertLessEqual({"table", "nav", "svg", "img"}, page.seen)

    def test_figures_do_not_depend_on_threads(self):
        one, three = ((self.compare(f"out{n}", *SMALLEST, "--threads", n) / "comparison.json").read_bytes()
                      for n in ("1", "3"))
        self.assertEqual(one, three)
        report = json.loads(one)
        self.assertEqual([place["name"] for place in report["places"]], ["rcd"])
        self.assertEqual({method["method"] for method in report["methods"]}, {"consensus", "centerline"})
        modes = [label for label in report["places"][0]["methods"] if label.startswith("consensus")]
        self.assertEqual(len(modes), 3)
        for label in modes:
            self.assertIn("calibration", report["places"][0]["methods"][label])

    def test_first_example_runs_and_json_is_the_file(self):
        lines = re.findall(r"^  (echoarc .*)$", self.succeed("compare", "--help"), re.MULTILINE)
        self.assertGreaterEqual(len(lines), 3)
        self.assertIn("comparison.html", self.succeed(*shlex.split(lines[0])[1:], cwd=self.dir))
        printed = self.succeed(*shlex.split(lines[0])[1:], "--json", cwd=self.dir)
        self.assertEqual(json.loads(printed), json.loads((self.dir / "comparison" / "comparison.json").read_text()))
        self.assertTrue((self.dir / "comparison" / "pictures" / "rcd.png").exists())

    def test_without_logs_the_scenes_are_done_and_it_says_so(self):
        result = self.run_command("compare", "--logs", "nowhere", *SMALLEST, "-o", self.dir / "out")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("the logs are absent (nowhere", result.stderr)
        self.assertTrue((self.dir / "out" / "comparison.html").exists())

    def test_recorded_logs_are_held_against_their_laser(self):
        (self.dir / "logs").mkdir()
        fixtures.write_corridor(self.dir / "logs" / "run1")
        folder = self.compare("out", "--logs", self.dir / "logs", "--describe",
                              SOURCE / "descriptions" / "corridor.toml", "--scenes", "none", "--methods", "centerline")
        report = json.loads((folder / "comparison.json").read_text())
        self.assertEqual(report["places"][0]["kind"], "log")
        self.assertIn("laser", report["places"][0]["reference"])

    def test_the_docs_name_tables_that_exist(self):
        page = (SOURCE / "docs" / "comparison.md").read_text()
        folder = self.compare("out")
        written = {path.stem for path in (folder / "tables").iterdir()}
        for name in set(re.findall(r"<!-- comparison:([A-Za-z0-9-]+) -->", page)):
            if not re.search(r"run\d|room|curve|truncated", name):  # those need what is not run here
                self.assertIn(name, written)

    def test_wrong_usage(self):
        for arguments in (("--scenes", "moon"), ("--methods", "magic"), ("--seeds", "0"), ("--threads", "0")):
            with self.subTest(arguments):
                self.assert_refused(self.run_command("compare", *arguments), status=2)
        self.assert_refused(self.run_command("compare", "--scenes", "none"), "neither a log nor a scene")
        (self.dir / "file").write_text("")
        self.assert_refused(self.run_command("compare", *SMALLEST, "-o", self.dir / "file" / "out"))


if __name__ == "__main__":
    unittest.main()

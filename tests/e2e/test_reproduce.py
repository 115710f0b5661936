# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""`echoarc reproduce` on its smallest study: a page that opens anywhere, and the same figures as JSON."""

import html.parser
import json
import shlex
import re
import unittest

from harness import CommandTest

SMALLEST = "yamauchi"
VOID = {"meta", "img", "link", "br", "hr", "input"}


class Page(html.parser.HTMLParser):
    """Every element is closed, every link inside the page arrives, nothing is fetched from elsewhere."""

    def __init__(self):
        super().__init__()
        self.open, self.problems, self.ids, self.targets, self.seen = [], [], set(), set(), set()

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.seen.add(tag)
        if "id" in values:
            if values["id"] in self.ids:
                self.problems.append(f"id {values['id']} twice")
            self.ids.add(values["id"])
        for key in ("href", "src"):
            link = values.get(key, "")
            if link.startswith("#"):
                self.targets.add(link[1:])
            elif link and not link.startswith("data:"):
                self.problems.append(f"{tag} fetches {link}")
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attributes):
        self.seen.add(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.problems.append(f"</{tag}> closes something else")


def without_times(report):
    """The report but for CPU times, which no two runs share."""
    for study in report["studies"]:
        study["sections"] = [part for part in study["sections"] if part["id"] != "times"]
    return report


class ReproduceTest(CommandTest):
    def reproduce(self, name, *arguments):
        folder = self.dir / name
        self.succeed("reproduce", SMALLEST, "--seeds", "1", "-o", folder, *arguments)
        return folder

    def test_page_is_whole_and_stands_alone(self):
        page = Page()
        page.feed((self.reproduce("out") / "report.html").read_text())
        page.close()
        self.assertEqual(page.problems, [])
        self.assertEqual(page.open, [])
        self.assertEqual(page.targets - page.ids, set())
        self.assertNotIn("script", page.seen)
        self.assertLessEqual({"table", "nav", "style"}, page.seen)

    def test_json_does_not_depend_on_threads(self):
        reports = [json.loads((self.reproduce(f"out{n}", "--threads", str(n)) / "report.json").read_text())
                   for n in (1, 3)]
        self.assertEqual(without_times(reports[0]), without_times(reports[1]))
        self.assertEqual(reports[0]["studies"][0]["name"], SMALLEST)
        self.assertTrue(any(part["claims"] for part in reports[0]["studies"][0]["sections"]))

    def test_json_flag_prints_the_same_file(self):
        folder = self.dir / "out"
        printed = self.succeed("reproduce", SMALLEST, "--seeds", "1", "-o", folder, "--json")
        self.assertEqual(json.loads(printed), json.loads((folder / "report.json").read_text()))

    def test_first_example_runs(self):
        lines = re.findall(r"^  (echoarc .*)$", self.succeed("reproduce", "--help"), re.MULTILINE)
        self.assertGreaterEqual(len(lines), 3)
        self.assertIn("report.html", self.succeed(*shlex.split(lines[0])[1:], cwd=self.dir))
        self.assertTrue((self.dir / "reproductions" / "report.html").exists())

    def test_wrong_usage(self):
        for arguments in ((), ("newton1687",), (SMALLEST, "--seeds", "0"), (SMALLEST, "--threads", "0")):
            with self.subTest(arguments):
                self.assert_refused(self.run_command("reproduce", *arguments), status=2)
        (self.dir / "file").write_text("")
        self.assert_refused(self.run_command("reproduce", SMALLEST, "-o", self.dir / "file" / "out"), status=1)


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""Every command that README.md and the pages of docs/ show is run; links between the pages lead somewhere."""

import re
import shlex
import shutil
import unittest

import fixtures
from harness import SOURCE, CommandTest

PAGES = [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", *sorted((SOURCE / "docs").rglob("*.md"))]

FENCED = re.compile(r"^```[a-z]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
INLINE = re.compile(r"`(echoarc [^`\n]+)`")
BARE_VERB = re.compile(r"^echoarc (?!methods$)[a-z]+$")  # speaks of the verb; all but `methods` need an argument
PLACEHOLDER = re.compile(r"(?<![\w./-])[A-Z]{2,}(?![\w.])|<[a-z]+>")
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")


def commands(text):
    """The `echoarc ...` lines of code blocks and the spans that begin so, in order; forms with placeholders left out."""
    found = [(match.start(), match[1]) for match in INLINE.finditer(FENCED.sub(lambda m: "\n" * len(m[0]), text))]
    for block in FENCED.finditer(text):
        for line in re.finditer(r"^echoarc .*$", block[1], re.MULTILINE):
            found.append((block.start(1) + line.start(), line[0]))
    return [command for _, command in sorted(found)
            if not PLACEHOLDER.search(command.split("#")[0]) and not BARE_VERB.match(command)]


def sample_log():
    """The log that the README shows, as a user would paste it."""
    blocks = [block[1] for block in FENCED.finditer((SOURCE / "README.md").read_text()) if block[1].startswith("{")]
    return blocks[0]


class DocumentTest(CommandTest):
    def prepare(self):
        """What the pages speak of."""
        (self.dir / "my.jsonl").write_text(sample_log())
        fixtures.write_walls(self.dir / "walls.csv")
        fixtures.write_room_csv(self.dir / "ranges.csv", self.dir / "poses.csv")
        fixtures.write_robot(self.dir / "robot.toml")
        (self.dir / "corridor").mkdir()
        fixtures.write_corridor(self.dir / "corridor" / "run1")
        shutil.copytree(SOURCE / "descriptions", self.dir / "descriptions")
        shutil.copy(SOURCE / "examples" / "demo" / "room.jsonl", self.dir)
        shutil.copy(SOURCE / "examples" / "demo" / "room-truth.csv", self.dir)

    def test_every_documented_command_runs(self):
        self.prepare()
        count = 0
        for page in PAGES:
            for command in commands(page.read_text()):
                with self.subTest(page=page.name, command=command):
                    arguments = shlex.split(command, comments=True)[1:]
                    if arguments[0] in ("init", "sim") and "-o" in arguments:  # another page may have written it
                        output = self.dir / arguments[arguments.index("-o") + 1]
                        for file in (output, output.with_suffix(".png")):
                            file.unlink(missing_ok=True)
                    if arguments[0] in ("serve", "demo"):  # would go on until Ctrl-C
                        arguments += ["--duration", "2"]
                    self.succeed(*arguments)
                    count += 1
        self.assertGreaterEqual(count, 8, "the pages hardly show a command; is the search broken?")

    def test_readme_log_is_used_in_full(self):
        (self.dir / "my.jsonl").write_text(sample_log())
        self.succeed("map", "my.jsonl", "--method", "centerline", "-o", "out")
        points = (self.dir / "out" / "centerline" / "points.csv").read_text().splitlines()
        self.assertEqual(len(points), 2, "a header and the one echo")

    def test_links_lead_somewhere(self):
        for page in PAGES:
            for target in LINK.findall(page.read_text()):
                if not target.startswith("http"):
                    with self.subTest(page=page.name, target=target):
                        self.assertTrue((page.parent / target).exists())

    def test_documented_dev_verbs_exist(self):
        usage = (SOURCE / "dev").read_text()
        for page in PAGES:
            for verb in re.findall(r"\./dev ([a-z]+)", page.read_text()):
                with self.subTest(page=page.name, verb=verb):
                    self.assertIn(f"\n./dev {verb} ", usage)


if __name__ == "__main__":
    unittest.main()

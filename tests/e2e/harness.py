# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""What every test of the command needs: a scratch directory, and the command run as a user runs it."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

COMMAND = pathlib.Path(os.environ["ECHOARC_COMMAND"]).resolve()
SOURCE = pathlib.Path(os.environ["ECHOARC_SOURCE_DIR"]).resolve()
SHARED_DATA = SOURCE.parent / "shared" / "data"
TIMEOUT_S = 300  # generous: sanitizers and coverage run the same tests


def documented_methods():
    """What the page of the methods lists: name -> the kind of its map."""
    page = (SOURCE / "docs" / "methods" / "README.md").read_text()
    rows = re.findall(r"^\| \[([^\]]*)\]\([^)]*\) \| [^|]* \| ([^|]*) \|", page, re.MULTILINE)
    return {name: kind for names, kind in rows for name in re.findall(r"`(\w+)`", names)}


class CommandTest(unittest.TestCase):
    """Runs `echoarc` inside an empty directory of its own."""

    maxDiff = None

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="echoarc-e2e-")
        self.addCleanup(scratch.cleanup)
        self.dir = pathlib.Path(scratch.name)

    def run_command(self, *arguments, cwd=None):
        """The finished process; stdin is closed, so a program that waits for a key fails at once."""
        return subprocess.run([COMMAND, *map(str, arguments)], cwd=cwd or self.dir, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=TIMEOUT_S, check=False)

    def succeed(self, *arguments, cwd=None):
        """Standard output of a run that must end with status 0."""
        result = self.run_command(*arguments, cwd=cwd)
        self.assertEqual(result.returncode, 0, f"echoarc {arguments}:\n{result.stdout}\n{result.stderr}")
        return result.stdout

    def assert_refused(self, result, *causes, status=1):
        """One line of cause that holds every one of `causes`, one line of remedy, nothing else on stderr."""
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        lines = result.stderr.splitlines()
        self.assertEqual(len(lines), 2, result.stderr)
        self.assertTrue(lines[0].startswith("echoarc: error: "), result.stderr)
        self.assertTrue(lines[1].startswith("echoarc: remedy: ") and len(lines[1]) > 25, result.stderr)
        for cause in causes:
            self.assertIn(cause, lines[0])

    def assert_nothing_left(self, *expected):
        """No output, finished or not, besides the named inputs."""
        left = sorted(path.name for path in self.dir.iterdir())
        self.assertEqual(left, sorted(expected))


def tree(folder, leave_out=("timings.json",)):
    """Relative path -> bytes of every file below a folder."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file() and path.name not in leave_out}

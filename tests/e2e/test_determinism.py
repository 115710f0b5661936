# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""Same input and options: the same bytes, whatever the number of threads."""

import shutil
import unittest

import fixtures
from harness import SHARED_DATA, SOURCE, CommandTest, tree


class DeterminismTest(CommandTest):
    def outputs(self, log, *options):
        for name, threads in (("one", 1), ("two", 2), ("eight", 8), ("again", 8)):
            self.succeed("map", log, "--method", "all", "--threads", threads, "-o", name, *options)
            yield name, tree(self.dir / name)

    def assert_all_equal(self, log, *options):
        (_, first), *others = self.outputs(log, *options)
        self.assertGreater(len(first), 20)
        for name, other in others:
            self.assertEqual(sorted(first), sorted(other), name)
            different = [path for path in first if first[path] != other[path]]
            self.assertEqual(different, [], name)

    def test_synthetic_room(self):
        self.assert_all_equal(fixtures.write_room(self.dir / "room.jsonl"))

    def test_demo(self):
        shutil.copy(SOURCE / "examples" / "demo" / "room.jsonl", self.dir)
        self.assert_all_equal("room.jsonl")

    def test_recorded_corridor(self):
        run = SHARED_DATA / "corridor" / "run1"
        if not run.exists():
            self.skipTest(f"the recorded logs are not here: {run}")
        self.assert_all_equal(run, "--describe", SOURCE / "descriptions" / "corridor.toml")


if __name__ == "__main__":
    unittest.main()

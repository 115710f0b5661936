# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Every lint check is fed a bad sample here and must object to it; and a good one, and must not."""

import io
import json
import sys
import tempfile
import unittest
from contextlib import redirect_stdout
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import check_arrows  # noqa: E402
import check_house  # noqa: E402
import check_sizes  # noqa: E402
import fill_option_tables  # noqa: E402
import run_tidy  # noqa: E402

HEADER = "// SPDX-FileCopyrightText: 2026 The echoarc authors\n// SPDX-License-Identifier: Apache-2.0\n"


class Tree(unittest.TestCase):
    """A scratch project to put samples into."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)

    def write(self, path: str, text: str) -> None:
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)


class Arrows(Tree):
    def problems(self, path: str, text: str) -> list[str]:
        self.write(path, text)
        return check_arrows.check_files(self.root)

    def test_allowed_includes_pass(self):
        self.assertEqual(self.problems("src/mapping/a.cpp", '#include <vector>\n#include "echoarc/maps/b.hpp"\n'), [])
        self.assertEqual(self.problems("apps/cli/a.cpp", '#include <fmt/core.h>\n#include "echoarc/io/b.hpp"\n'), [])

    def test_upward_arrow_fails_and_names_the_line(self):
        problems = self.problems("src/core/a.cpp", '#include <vector>\n#include "echoarc/maps/b.hpp"\n')
        self.assertEqual(len(problems), 1)
        self.assertTrue(problems[0].startswith("src/core/a.cpp:2:"), problems)

    def test_private_form_of_an_arrow_fails(self):
        self.assertTrue(self.problems("src/eval/a.cpp", '#include "mapping/kernel.hpp"\n'))

    def test_sideways_arrow_fails(self):
        self.assertTrue(self.problems("include/echoarc/mapping/a.hpp", '#include "echoarc/eval/b.hpp"\n'))

    def test_io_inside_the_library_fails(self):
        self.assertTrue(self.problems("src/pipeline/a.cpp", '#include "echoarc/io/b.hpp"\n'))

    def test_third_party_in_public_header_fails_outside_io(self):
        self.assertTrue(self.problems("include/echoarc/core/a.hpp", "#include <Eigen/Core>\n"))
        self.assertTrue(self.problems("include/echoarc/core/b.hpp", '#include "vendored.hpp"\n'))

    def test_third_party_in_io_header_passes(self):
        self.assertEqual(self.problems("include/echoarc/io/a.hpp", "#include <nlohmann/json.hpp>\n"), [])

    def test_unknown_part_fails(self):
        self.assertTrue(self.problems("src/gui/a.cpp", "\n"))

    def test_link_dependency_against_the_floors_fails(self):
        self.write("src/core/CMakeLists.txt", "echoarc_part(core\n  SOURCES a.cpp\n  DEPENDS maps)\n")
        self.assertTrue(check_arrows.check_cmake(self.root))
        self.write("src/core/CMakeLists.txt", "echoarc_part(core\n  SOURCES a.cpp)\n")
        self.assertEqual(check_arrows.check_cmake(self.root), [])

    def test_page_stands_on_no_package_and_names_no_host(self):
        for line in ('import { a } from "three";', "export * from '../../test/a.ts';", "const a = await import('left-pad');",
                     "fetch('https://example.org/a');"):
            self.write("web/src/a.ts", line + "\n")
            self.assertEqual(len(check_arrows.check_web(self.root)), 1, line)
        self.write("web/src/a.ts", "import { b } from './net/b.ts';\nconst svg = 'http://www.w3.org/2000/svg';\n")
        self.assertEqual(check_arrows.check_web(self.root), [])

    def test_cycle_in_the_table_fails(self):
        self.assertEqual(check_arrows.check_table(), [])
        check_arrows.ALLOWED["core"].add("pipeline")
        self.addCleanup(check_arrows.ALLOWED["core"].discard, "pipeline")
        self.assertTrue(check_arrows.check_table())


class House(Tree):
    def problems(self, path: str, text: str) -> list[str]:
        self.write(path, text)
        return check_house.check_tree(self.root)

    def test_missing_spdx_header_fails(self):
        self.assertTrue(self.problems("src/core/a.cpp", "int a;\n"))
        self.assertTrue(self.problems("scripts/a.py", "a = 1\n"))

    def test_each_forbidden_act_fails_in_a_library_part(self):
        for act in ("#include <iostream>", "std::cerr << 1;", 'printf("a");', "std::abort();", "exit(1);",
                    "std::ifstream f;", "std::filesystem::path p;", "std::chrono::steady_clock::now();",
                    "std::random_device d;", "std::thread t;", "std::async(f);"):
            with self.subTest(act):
                self.assertEqual(len(self.problems("src/maps/a.cpp", HEADER + act + "\n")), 1)

    def test_the_same_act_passes_in_an_app(self):
        self.assertEqual(self.problems("apps/cli/a.cpp", HEADER + "std::cerr << 1;\n"), [])

    def test_io_may_open_files_but_not_print(self):
        self.assertEqual(self.problems("src/io/a.cpp", HEADER + "std::ifstream f;\n"), [])
        self.assertTrue(self.problems("src/io/b.cpp", HEADER + "std::cout << 1;\n"))

    def test_comments_literals_and_members_pass(self):
        text = HEADER + '// never std::abort()\n/* std::cout */ auto s = "printf(";\nqueue.exit();\ndouble r = rand_m(1);\nstd::thread::id asking;\n'
        self.assertEqual(self.problems("src/maps/a.cpp", text), [])

    def test_leftovers_fail(self):
        for leftover in ("TO" + "DO later", "FIX" + "ME", "see /wo" + "rk/main", "/ro" + "ot/x", "/tmp/w" + "t/a"):
            with self.subTest(leftover):
                self.assertEqual(len(self.problems("docs/a.md", leftover + "\n")), 1)


class Sizes(Tree):
    def run_main(self) -> int:
        argv, sys.argv = sys.argv, ["check_sizes.py", str(self.root)]
        try:
            with redirect_stdout(io.StringIO()):
                return check_sizes.main()
        finally:
            sys.argv = argv

    @staticmethod
    def function(lines: int) -> str:
        return "int f() {\n" + "  g();\n" * (lines - 2) + "}\n"

    def test_short_function_passes(self):
        self.write("src/core/a.cpp", self.function(40))
        self.assertEqual(self.run_main(), 0)

    def test_p95_over_the_limit_fails(self):
        self.write("src/core/a.cpp", self.function(41))
        self.assertEqual(self.run_main(), 1)

    def test_one_function_over_the_maximum_fails(self):
        for i in range(30):
            self.write(f"src/core/short{i}.cpp", self.function(5))
        self.write("src/core/long.cpp", self.function(81))
        self.assertEqual(self.run_main(), 1)

    def test_long_file_fails(self):
        self.write("src/core/a.cpp", "int a;\n" * 301)
        self.assertEqual(self.run_main(), 1)

    def test_percentile_is_nearest_rank(self):
        self.assertEqual(check_sizes.percentile(list(range(1, 101)), 0.95), 95)
        self.assertEqual(check_sizes.percentile([7], 0.95), 7)


class OptionTables(Tree):
    """A stand-in for the command answers `methods --json`."""

    PAGE = "<!-- options:dm -->\n<!-- /options -->\n"

    def setUp(self):
        super().setUp()
        options = [{"name": "cell_m", "type": "number", "unit": "m", "default": 0.01, "minimum": 0.001, "maximum": 10.0,
                    "description": "size | side", "source": ""}]
        answer = json.dumps([{"name": "dm", "options": options}])
        self.write("command", f"#!/bin/sh\ncat <<'END'\n{answer}\nEND\n")
        (self.root / "command").chmod(0o755)
        docs = fill_option_tables.DOCS
        fill_option_tables.DOCS = self.root / "docs"
        self.addCleanup(setattr, fill_option_tables, "DOCS", docs)

    def run_main(self, *arguments: str) -> int:
        argv, sys.argv = sys.argv, ["fill_option_tables.py", str(self.root / "command"), *arguments]
        try:
            with redirect_stdout(io.StringIO()):
                return fill_option_tables.main()
        finally:
            sys.argv = argv

    def test_stale_table_fails_until_it_is_filled(self):
        self.write("docs/dm.md", self.PAGE)
        self.assertEqual(self.run_main("--check"), 1)
        self.assertEqual(self.run_main(), 0)
        self.assertIn("| `cell_m` | 0.01 | m | 0.001 … 10 | size \\| side |  |", (self.root / "docs/dm.md").read_text())
        self.assertEqual(self.run_main("--check"), 0)

    def test_method_without_a_table_fails(self):
        self.write("docs/dm.md", "nothing here\n")
        self.assertEqual(self.run_main("--check"), 1)

    def test_table_of_an_unknown_method_fails(self):
        self.write("docs/dm.md", self.PAGE + self.PAGE.replace("dm", "magic"))
        self.assertEqual(self.run_main(), 1)


class Tidy(unittest.TestCase):
    """How sources are put together to be read by clang-tidy at once."""

    @staticmethod
    def entry(file: str, flags: str = "-Iinclude -O2", launcher: str = "") -> dict:
        command = f"{launcher}/usr/bin/c++ {flags} -MD -MT {file}.o -MF {file}.o.d -o {file}.o -c {file}"
        return {"file": file, "command": command}

    def test_flags_are_without_launcher_compiler_and_file_names(self):
        flags = ["-DA=x y", "-Iinclude", "-isystem", "/usr/include/b", "-std=c++20"]
        given = "'-DA=x y' -Iinclude -isystem /usr/include/b -std=c++20"
        self.assertEqual(run_tidy.flags_of(self.entry("/src/core/a.cpp", given)), flags)
        self.assertEqual(run_tidy.flags_of(self.entry("/src/core/a.cpp", given, launcher="ccache ")), flags)
        precompiled = given + " -Winvalid-pch -include /build/cmake_pch.hxx"
        self.assertEqual(run_tidy.flags_of(self.entry("/src/core/a.cpp", precompiled)), flags)

    def test_a_folder_with_the_same_flags_is_read_together(self):
        entries = [self.entry(f"/src/core/{name}.cpp") for name in "ab"]
        self.assertEqual(run_tidy.batches(entries), [entries])

    def test_other_folders_other_flags_and_kernels_are_read_apart(self):
        entries = [self.entry("/src/core/a.cpp"), self.entry("/src/maps/a.cpp"), self.entry("/src/core/b.cpp", "-O0"),
                   self.entry("/src/core/c_isa.cpp"), self.entry("/src/core/d_isa.cpp")]
        self.assertEqual(run_tidy.batches(entries), [[entry] for entry in entries])

    def test_batches_are_bounded_and_lose_nothing(self):
        entries = [self.entry(f"/src/core/{k}.cpp") for k in range(2 * run_tidy.BATCH + 1)]
        batches = run_tidy.batches(entries)
        self.assertEqual([len(batch) for batch in batches], [run_tidy.BATCH, run_tidy.BATCH, 1])
        self.assertEqual(sum(batches, []), entries)


if __name__ == "__main__":
    unittest.main()

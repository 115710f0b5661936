# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""House rules that a text search can check: licence headers, what the library never does, leftovers.

The computing parts print nothing, open nothing, end no process, read no clock and no global random generator, and start
no thread; `io` opens files but keeps the other rules. Words in comments and string literals do not count.
"""

import re
import sys
from pathlib import Path

from project_files import ROOT, project_files

COMPUTING_PARTS = {"core", "sensing", "maps", "mapping", "eval", "pipeline", "live"}

PRINTS = (r"\b(?:std::)?(?:cout|cerr|clog)\b|\b(?:std::)?(?:v?f?printf|f?puts|putchar|perror)\s*\("
          r"|\b(?:std|fmt)::print(?:ln)?\b|<iostream>", "prints")
ENDS = (r"(?<![\w.>])(?:std::)?(?:abort|_?exit|_Exit|quick_exit|terminate)\s*\(", "ends the process")
OPENS = (r"\b[io]?fstream\b|\bfopen\s*\(|\bfilesystem\b", "opens files")
CLOCK = (r"\b(?:system|steady|high_resolution)_clock\b|\bclock_gettime\b|\bgettimeofday\b"
         r"|\bstd::(?:time|clock)\s*\(|<ctime>", "reads a clock")
RANDOM = (r"\brandom_device\b|\b(?:std::)?s?rand\s*\(|\bmt19937", "draws from a generator it was not given")
THREADS = (r"\bstd::(?:j?thread|async)\b(?!::)|\bpthread_create\b", "starts a thread")

FORBIDDEN = {part: [PRINTS, ENDS, OPENS, CLOCK, RANDOM, THREADS] for part in COMPUTING_PARTS}
FORBIDDEN["io"] = [PRINTS, ENDS, CLOCK, RANDOM, THREADS]

# Assembled from pieces, so that this file does not find itself.
LEFTOVERS = [
    (r"\b(?:TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK)\b", "note to oneself; do it or drop it"),
    (r"(?<![\w.])/(?:wo" r"rk|ro" r"ot|ho" r"me|tmp/w" r"t)/", "path of one machine"),
    (r"deb\.deb" r"ian\.org|registry\.npm" r"js|py" r"pi\.org|files\.python" r"hosted", "host of a package registry"),
]

SPDX = ("SPDX-FileCopyrightText: ", "SPDX-License-Identifier: Apache-2.0")
HEADED_SUFFIXES = {".hpp", ".cpp", ".py", ".sh", ".cmake", ".ts", ".mjs", ".js", ".css"}

# Comments and literals, so that they can be blanked out without moving lines. Include paths stay: <iostream> counts.
COMMENT_OR_LITERAL = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"|(?<![\w])\'(?:\\.|[^\'\\\n])+\'', re.S)


def code_only(text: str) -> str:
    """C++ text with comments and literals replaced by blanks of the same number of lines."""
    return COMMENT_OR_LITERAL.sub(lambda match: " " + "\n" * match[0].count("\n"), text)


def library_part(path: Path) -> str | None:
    parts = path.parts
    if parts[:2] == ("include", "echoarc") and len(parts) > 3:
        return parts[2]
    return parts[1] if parts[0] == "src" and len(parts) > 2 else None


def check_spdx(path: Path, text: str) -> list[str]:
    is_headed = path.suffix in HEADED_SUFFIXES or path.name in {"CMakeLists.txt", "dev"} or path.parts[0] == ".ci"
    if not is_headed:
        return []
    head = "\n".join(text.splitlines()[:3])
    return [f"{path}:1: no SPDX header"] if any(line not in head for line in SPDX) else []


def check_forbidden(path: Path, text: str) -> list[str]:
    rules = FORBIDDEN.get(library_part(path) or "", []) if path.suffix in {".hpp", ".cpp"} else []
    problems = []
    for number, line in enumerate(code_only(text).splitlines(), 1):
        for pattern, what in rules:
            if match := re.search(pattern, line):
                problems.append(f"{path}:{number}: '{match[0]}': a library part never {what}")
    return problems


def check_leftovers(path: Path, text: str) -> list[str]:
    problems = []
    for number, line in enumerate(text.splitlines(), 1):
        for pattern, what in LEFTOVERS:
            if match := re.search(pattern, line):
                problems.append(f"{path}:{number}: '{match[0]}': {what}")
    return problems


def check_tree(root: Path) -> list[str]:
    problems = []
    for path in project_files("all", root):
        try:
            text = (root / path).read_text()
        except UnicodeDecodeError:
            continue  # a picture
        problems += check_spdx(path, text) + check_forbidden(path, text) + check_leftovers(path, text)
    return problems


def main() -> int:
    problems = check_tree(Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT)
    print("\n".join(problems) if problems else "house: licence headers, library rules and leftovers are in order")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

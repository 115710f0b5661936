# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""The project's own files by kind: `project_files.py cpp|python|shell|all` prints one path a line.

Walks the tree instead of asking git, so that an exported archive is checked like a clone.
"""

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SKIPPED_FOLDERS = {"build", ".git", "__pycache__", "node_modules", "dist"}
# Inputs of tests and fuzzers: bytes of any kind, not source.
DATA_FOLDERS = {"fuzz/corpus", "tests/fixtures", "examples/demo", "bench/results"}


def _kind(path: Path) -> str:
    if path.suffix in {".hpp", ".cpp"}:
        return "cpp"
    if path.suffix == ".py":
        return "python"
    if path.suffix == ".sh":
        return "shell"
    if path.suffix == "":
        with path.open("rb") as file:
            first = file.readline(64)
        if first.startswith(b"#!") and b"bash" in first:
            return "shell"
    return "other"


def project_files(kind: str = "all", root: Path = ROOT) -> list[Path]:
    """Files of one kind (cpp, python, shell) or all of them, data left out, relative to `root`, sorted."""
    found = []
    for folder, subfolders, names in os.walk(root):
        relative = Path(folder).relative_to(root)
        subfolders[:] = sorted(
            name for name in subfolders
            if name not in SKIPPED_FOLDERS and (relative / name).as_posix() not in DATA_FOLDERS)
        for name in names:
            path = Path(folder) / name
            if name == ".git" or not path.is_file():
                continue
            if kind in ("all", _kind(path)):
                found.append(relative / name)
    return sorted(found)


if __name__ == "__main__":
    for file in project_files(sys.argv[1] if len(sys.argv) > 1 else "all"):
        print(file)

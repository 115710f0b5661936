# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""`run_tidy.py TREE JOBS`: clang-tidy over the product's sources and, through them, its headers.

TREE is a configured build tree with compile_commands.json. Test programs are left out: GoogleTest's macros multiply the
time by four, and the compiler's warnings cover them. A source is skipped when it, every project header it includes, its
compile command and .clang-tidy are the same as when it was last found clean (stamps in TREE/tidy).
"""

import hashlib
import json
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path

from project_files import ROOT

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
INCLUDE_FOLDERS = [ROOT / "include", ROOT / "src", ROOT / "apps"]
PRODUCT_FOLDERS = [ROOT / "src", ROOT / "apps"]


@cache
def included(path: Path) -> tuple[Path, ...]:
    """The project headers that a file names directly."""
    folders = [path.parent, *INCLUDE_FOLDERS]
    found = (next((folder / name for folder in folders if (folder / name).is_file()), None)
             for name in INCLUDE.findall(path.read_text()))
    return tuple(header for header in found if header is not None)


def closure(source: Path) -> list[Path]:
    """The source and every project header it stands on, sorted."""
    seen, waiting = set(), [source]
    while waiting:
        path = waiting.pop()
        if path not in seen:
            seen.add(path)
            waiting += included(path)
    return sorted(seen)


def fingerprint(entry: dict) -> str:
    digest = hashlib.sha256(entry["command"].encode())
    for path in [ROOT / ".clang-tidy", *closure(Path(entry["file"]))]:
        digest.update(str(path).encode() + path.read_bytes())
    return digest.hexdigest()


def check(entry: dict, tree: Path) -> str:
    """What clang-tidy objects to in one source; empty when it is clean."""
    stamp = tree / "tidy" / fingerprint(entry)
    if stamp.exists():
        return ""
    command = ["clang-tidy-19", "-p", str(tree), "--quiet", "--extra-arg=-Wno-unknown-warning-option", entry["file"]]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode == 0:
        stamp.touch()
        return ""
    return run.stdout or run.stderr


def main() -> int:
    tree, jobs = Path(sys.argv[1]).resolve(), int(sys.argv[2])
    (tree / "tidy").mkdir(exist_ok=True)
    # By file: kernels are compiled once for each instruction set, and once is enough here.
    by_file = {entry["file"]: entry for entry in json.loads((tree / "compile_commands.json").read_text())}
    entries = [entry for file, entry in by_file.items() if any(folder in Path(file).parents for folder in PRODUCT_FOLDERS)]
    with ThreadPoolExecutor(jobs) as pool:
        findings = [text for text in pool.map(lambda entry: check(entry, tree), entries) if text]
    # A finding in a header comes with every source that includes it.
    print("\n".join(dict.fromkeys("\n".join(findings).splitlines())) or f"clang-tidy: {len(entries)} sources are clean")
    return 1 if findings or not entries else 0


if __name__ == "__main__":
    sys.exit(main())

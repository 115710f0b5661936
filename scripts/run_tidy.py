# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""`run_tidy.py TREE JOBS`: clang-tidy over the product's sources and, through them, its headers.

TREE is a configured build tree with compile_commands.json. Test programs are left out: GoogleTest's macros multiply the
time by four, and the compiler's warnings cover them.

Nine tenths of the time go into the headers of the standard library, walked again for every source. So sources of one
folder are read together, as one file that includes them; where the compiler objects to that (two of them have a helper
of the same name) each is read alone. Sources are skipped when they, every project header they include, their compile command
and .clang-tidy are the same as when they were last found clean (stamps in TREE/tidy).
"""

import hashlib
import json
import re
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from itertools import dropwhile
from pathlib import Path

from project_files import ROOT

INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
INCLUDE_FOLDERS = [ROOT / "include", ROOT / "src", ROOT / "apps"]
PRODUCT_FOLDERS = [ROOT / "src", ROOT / "apps"]
BATCH = 8


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


def flags_of(entry: dict) -> list[str]:
    """The compiler's flags without the names of the files of one compilation, a precompiled header's among them."""
    words = dropwhile(lambda word: not word.startswith("-"), shlex.split(entry["command"]))  # [launcher] compiler -...
    kept = []
    for word in words:
        if word in ("-o", "-c", "-MT", "-MF", "-include"):
            next(words)
        elif word not in ("-MD", "-Winvalid-pch"):
            kept.append(word)
    return kept


def batches(entries: list[dict]) -> list[list[dict]]:
    """Sources that can be read together: one folder, the same flags; kernels, compiled in a way of their own, alone."""
    groups: dict[tuple, list[dict]] = {}
    for entry in entries:
        file = Path(entry["file"])
        alone = str(file) if file.stem.endswith("_isa") else ""
        groups.setdefault((file.parent, tuple(flags_of(entry)), alone), []).append(entry)
    return [group[k:k + BATCH] for group in groups.values() for k in range(0, len(group), BATCH)]


def run_tidy(source: Path, entry: dict) -> str:
    """What clang-tidy objects to; empty when all is clean."""
    command = ["clang-tidy-19", "--quiet", "--extra-arg=-Wno-unknown-warning-option",
               "--extra-arg=-Wno-deprecated-declarations", "--extra-arg=-Wno-unknown-pragmas", str(source),
               "--", *flags_of(entry)]
    run = subprocess.run(command, cwd=entry["directory"], capture_output=True, text=True, check=False)
    return "" if run.returncode == 0 else run.stdout or run.stderr or f"clang-tidy failed on {source}"


def check(batch: list[dict], tree: Path) -> str:
    stamp = tree / "tidy" / hashlib.sha256("".join(map(fingerprint, batch)).encode()).hexdigest()
    if stamp.exists():
        return ""
    together = stamp.with_suffix(".cpp")
    together.write_text("".join(f'#include "{entry["file"]}"\n' for entry in batch))
    findings = run_tidy(together, batch[0])
    if "[clang-diagnostic-" in findings and len(batch) > 1:
        findings = "".join(run_tidy(Path(entry["file"]), entry) for entry in batch)
    if not findings:
        stamp.touch()
    return findings


def main() -> int:
    tree, jobs = Path(sys.argv[1]).resolve(), int(sys.argv[2])
    (tree / "tidy").mkdir(exist_ok=True)
    # By file: kernels are compiled once for each instruction set, and once is enough here.
    by_file = {entry["file"]: entry for entry in json.loads((tree / "compile_commands.json").read_text())}
    entries = [entry for file, entry in by_file.items() if any(folder in Path(file).parents for folder in PRODUCT_FOLDERS)]
    with ThreadPoolExecutor(jobs) as pool:
        findings = [text for text in pool.map(lambda batch: check(batch, tree), batches(entries)) if text]
    # A finding in a header comes with every source that includes it.
    print("\n".join(dict.fromkeys("\n".join(findings).splitlines())) or f"clang-tidy: {len(entries)} sources are clean")
    return 1 if findings or not entries else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Checks the dependency arrows between the parts (docs/architecture.md) over #include lines and CMake's DEPENDS.

A part may include itself and the parts listed for it, nothing else: that rules out cycles, keeps `io` out of the
computing parts, and keeps third-party headers out of our public headers.
"""

import re
import sys
from pathlib import Path

from project_files import ROOT, project_files

# What each part may stand on. The computing parts first, floor by floor; then who may use them.
ALLOWED: dict[str, set[str]] = {
    "core": set(),
    "sensing": {"core"},
    "maps": {"core"},
    "sim": {"core", "sensing"},
    "mapping": {"core", "maps"},
    "features": {"core", "maps"},
    "eval": {"core", "maps"},
    "nav": {"core", "maps"},
    "pipeline": {"core", "sensing", "maps", "mapping"},
    "io": {"core", "sensing", "maps", "sim", "mapping", "features", "eval", "nav"},
    "live": {"core", "sensing", "maps", "sim", "mapping", "eval", "nav", "pipeline"},
    "studies": {"core", "sensing", "maps", "sim", "mapping", "features", "eval", "nav", "pipeline", "live"},
}
LIBRARY_PARTS = set(ALLOWED)
OUTER_FOLDERS = {"apps", "bench", "tests", "examples", "fuzz"}  # these may include every part, `io` among them
THIRD_PARTY_ALLOWED_IN_HEADERS = {"io"}

STANDARD_HEADERS = set("""
algorithm any array atomic barrier bit bitset cassert cctype cerrno cfenv cfloat charconv chrono cinttypes climits
clocale cmath codecvt compare complex concepts condition_variable coroutine csetjmp csignal cstdarg cstddef cstdint
cstdio cstdlib cstring ctime cuchar cwchar cwctype deque exception execution filesystem format forward_list fstream
functional future initializer_list iomanip ios iosfwd iostream istream iterator latch limits list locale map memory
memory_resource mutex new numbers numeric optional ostream queue random ranges ratio regex scoped_allocator semaphore
set shared_mutex source_location span sstream stack stdexcept stop_token streambuf string string_view strstream
syncstream system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray
variant vector version""".split())

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
DEPENDS = re.compile(r"echoarc_part\(\s*(\w+)([^)]*)\)", re.S)


def part_of(path: Path) -> str | None:
    """The part a source file belongs to: `core`, ..., or the outer folder it lies in; None for anything else."""
    parts = path.parts
    if parts[:2] == ("include", "echoarc") and len(parts) > 3:
        return parts[2]
    if parts[0] == "src" and len(parts) > 2:
        return parts[1]
    return parts[0] if parts[0] in OUTER_FOLDERS else None


def included_part(name: str) -> str | None:
    """The part an #include names: `echoarc/core/arc.hpp` and the private form `core/detail.hpp` alike."""
    steps = name.split("/")
    if steps[0] == "echoarc" and len(steps) > 1:
        return steps[1]
    if len(steps) > 1 and steps[0] in LIBRARY_PARTS | {"apps"}:
        return steps[0]
    return None


def check_include(path: Path, part: str, bracket: str, name: str) -> str | None:
    """Why this #include is not allowed, or None."""
    target = included_part(name)
    if target is not None:
        if part in OUTER_FOLDERS or target == part:
            return None
        if target in ALLOWED[part]:
            return None
        return f"part '{part}' may not include '{name}'; it may stand on: {', '.join(sorted(ALLOWED[part])) or 'nothing'}"
    is_public = path.parts[0] == "include"
    foreign = bracket == "<" and name not in STANDARD_HEADERS
    if is_public and part not in THIRD_PARTY_ALLOWED_IN_HEADERS and foreign:
        return f"public header includes '{name}', which is neither ours nor the standard library's"
    if is_public and bracket == '"':
        return f"public header includes '{name}', which is not installed; write \"echoarc/...\""
    return None


def check_files(root: Path) -> list[str]:
    problems = []
    for path in project_files("cpp", root):
        part = part_of(path)
        if part is None:
            problems.append(f"{path}:1: lies in no known part or folder")
            continue
        if part not in LIBRARY_PARTS | OUTER_FOLDERS:
            problems.append(f"{path}:1: unknown part '{part}'; add it with its arrows to scripts/check_arrows.py")
            continue
        for number, line in enumerate((root / path).read_text().splitlines(), 1):
            if match := INCLUDE.match(line):
                if problem := check_include(path, part, match[1], match[2]):
                    problems.append(f"{path}:{number}: {problem}")
    return problems


def check_cmake(root: Path) -> list[str]:
    """Link dependencies between parts obey the same arrows."""
    problems = []
    for path in sorted(root.glob("src/*/CMakeLists.txt")):
        for part, arguments in DEPENDS.findall(path.read_text()):
            depends = re.search(r"\bDEPENDS\b((?:\s+[a-z_]+)*)", arguments)
            for target in depends[1].split() if depends else []:
                if target not in ALLOWED.get(part, set()):
                    problems.append(f"{path.relative_to(root)}:1: part '{part}' may not depend on '{target}'")
    return problems


IMPORT = re.compile(r"""^\s*import\s+['"]([^'"]+)['"]|^\s*(?:import|export|\}).*\bfrom\s+['"]([^'"]+)['"]|\bimport\(\s*['"]([^'"]+)['"]""")
NETWORK = re.compile(r"https?://(?!www\.w3\.org/)")  # name spaces are no addresses


def check_web(root: Path) -> list[str]:
    """What is shipped of the page imports its own files alone and names no host: it works without any network."""
    problems = []
    home = root / "web" / "src"
    for path in sorted(home.rglob("*.ts")):
        for number, line in enumerate(path.read_text().splitlines(), 1):
            where = f"{path.relative_to(root)}:{number}"
            if match := IMPORT.search(line):
                name = match[1] or match[2] or match[3]
                if not name.startswith("."):
                    problems.append(f"{where}: the page imports the package '{name}'; it stands on no package")
                elif not (path.parent / name).resolve().is_relative_to(home.resolve()):
                    problems.append(f"{where}: '{name}' lies outside web/src")
            if NETWORK.search(line):
                problems.append(f"{where}: names a host; the page talks to its server alone")
    return problems


def check_table() -> list[str]:
    """The table itself is free of cycles: every part can be built after what it stands on."""
    built: set[str] = set()
    while ready := {part for part, below in ALLOWED.items() if part not in built and below <= built}:
        built |= ready
    return [f"scripts/check_arrows.py:1: cycle through {sorted(LIBRARY_PARTS - built)}"] if built != LIBRARY_PARTS else []


def main() -> int:
    root = Path(sys.argv[1]).resolve() if len(sys.argv) > 1 else ROOT
    problems = check_table() + check_files(root) + check_cmake(root) + check_web(root)
    print("\n".join(problems) if problems else "arrows: every #include and DEPENDS obeys the floors")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

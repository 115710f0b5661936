# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Puts what `echoarc compare -o DIR` wrote into docs/comparison.md: `fill_comparison.py DIR`.

Tables stand between `<!-- comparison:NAME -->` and `<!-- /comparison -->`; NAME is that of a file in DIR/tables. A table
that DIR does not have (recorded logs were absent) stays as it is, and is named. Pictures that the page shows are copied
to docs/pictures.
"""

import re
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "comparison.md"
BLOCK = re.compile(r"(<!-- comparison:([A-Za-z0-9-]+) -->\n).*?(<!-- /comparison -->)", re.S)
PICTURE = re.compile(r"\]\(pictures/comparison-([A-Za-z0-9-]+\.(?:png|svg))\)")


def fill(text: str, tables: Path) -> tuple[str, list[str]]:
    """The page with its tables, and the names of those that are missing."""
    missing = []

    def block(match: re.Match) -> str:
        table = tables / f"{match[2]}.md"
        if not table.exists():
            missing.append(match[2])
            return match[0]
        return match[1] + table.read_text() + match[3]

    return BLOCK.sub(block, text), missing


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    folder = Path(sys.argv[1])
    text, missing = fill(PAGE.read_text(), folder / "tables")
    PAGE.write_text(text)
    for name in PICTURE.findall(text):
        if (folder / "pictures" / name).exists():
            shutil.copyfile(folder / "pictures" / name, PAGE.parent / "pictures" / f"comparison-{name}")
        else:
            missing.append(name)
    for name in missing:
        print(f"{folder} has no {name}: left as it was")
    return 0


if __name__ == "__main__":
    sys.exit(main())

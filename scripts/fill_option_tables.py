# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Keeps the option tables of the docs equal to the option fields in the code.

`fill_option_tables.py COMMAND [--check]` asks the built command (`COMMAND methods --json`) for the options of every
name between `<!-- options:NAME -->` and `<!-- /options -->` in docs/, and writes the table in between. With --check it
writes nothing and fails where a table is stale. Either way it fails when a method of the catalogue has no table.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent / "docs"
BLOCK = re.compile(r"(<!-- options:([a-z_]+) -->\n).*?(<!-- /options -->)", re.S)


def catalogue(command: str) -> dict[str, list[dict]]:
    """The options of every method, by name, and those of `sensing`."""
    answer = subprocess.run([command, "methods", "--json"], capture_output=True, text=True, check=False)
    if answer.returncode != 0:
        sys.exit(f"{command} methods --json: {answer.stderr.strip()}")
    return {method["name"]: method["options"] for method in json.loads(answer.stdout)}


def spell(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else f"{value:.15g}" if isinstance(value, float) else str(value)


def legal_values(option: dict) -> str:
    if "enum" in option:
        return ", ".join(f"`{choice}`" for choice in option["enum"])
    if option["type"] == "boolean":
        return "true, false"
    low, high = option.get("minimum"), option.get("maximum")
    if low is None and high is None:
        return "any"
    if low is None or high is None:
        return f"≥ {spell(low)}" if high is None else f"≤ {spell(high)}"
    return f"{spell(low)} … {spell(high)}"


def table(options: list[dict]) -> str:
    """The Markdown table of one method; a bar inside a text would end its cell."""
    rows = [["option", "default", "unit", "legal", "meaning", "source"]]
    rows += [[f"`{option['name']}`", spell(option["default"]), option.get("unit", ""), legal_values(option),
              option["description"], option.get("source", "")] for option in options]
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    return "\n".join([lines[0], "| --- | --- | --- | --- | --- | --- |", *lines[1:]]) + "\n"


def main() -> int:
    command, check = sys.argv[1], "--check" in sys.argv[2:]
    options = catalogue(command)
    problems, documented = [], set()

    def fill(match: re.Match) -> str:
        documented.add(match[2])
        if match[2] not in options:
            problems.append(f"there is no method '{match[2]}' to fill a table of")
            return match[0]
        return match[1] + table(options[match[2]]) + match[3]

    for page in sorted(DOCS.rglob("*.md")):
        text = page.read_text()
        new = BLOCK.sub(fill, text)
        if new != text and check:
            problems.append(f"{page.relative_to(DOCS.parent)}: option table is stale; run ./dev docs")
        elif new != text:
            page.write_text(new)
            print(f"filled {page.relative_to(DOCS.parent)}")
    problems += [f"'{name}' has options but no table in docs/" for name in options if name not in documented]
    print("\n".join(problems) if problems else f"option tables: {len(documented)} are current")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

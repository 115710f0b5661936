# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
"""Keeps the key tables of docs/scenes.md equal to schema/scene.schema.json, and the list of scenes to scenes/*.toml.

`fill_scene_tables.py [--check]` writes what belongs between `<!-- scene:TABLE -->` and `<!-- /scene -->`: the keys of
that table, for `scenes` the list of all scenes, for `robots` that of the robots, for `pictures` all pictures. With
--check it writes nothing and fails where the page is stale.
"""

import json
import re
import sys
import tomllib
from pathlib import Path

from fill_option_tables import legal_values, spell

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "scenes.md"
BLOCK = re.compile(r"(<!-- scene:([a-z]+) -->\n).*?(<!-- /scene -->)", re.S)


def markdown(rows: list[list[str]]) -> str:
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    return "\n".join([lines[0], "|" + " --- |" * len(rows[0]), *lines[1:]]) + "\n"


def legal(key: dict) -> str:
    if key.get("$ref") == "#/$defs/point":
        return "[x, y]"
    if key.get("type") == "array":
        item = key["items"]
        return f"[{legal(item)}, ...]" if item.get("$ref") or item.get("type") == "array" else "list"
    if "anyOf" in key:
        return "tables"
    if key.get("type") == "number" and "minimum" not in key:
        return ""
    return legal_values(key) if key.get("type") in ("number", "integer", "boolean") or "enum" in key else "text"


def key_rows(table: dict) -> list[list[str]]:
    rows = [["key", "default", "unit", "legal", "meaning", "source"]]
    keys = table["properties"]
    for name, key in keys.items():
        if name.endswith(("_m", "_deg")) and name.rsplit("_", 1)[0] in keys:
            continue  # the same under its other name
        names = [name] + [name + ending for ending in ("_m", "_deg") if name + ending in keys]
        unit = keys[names[-1]].get("unit", "")
        rows.append([" or ".join(f"`{each}`" for each in names), spell(key["default"]) if "default" in key else "", unit,
                     legal(key), key.get("description", ""), key.get("source", "")])
    return rows


def without_empty_columns(rows: list[list[str]]) -> list[list[str]]:
    kept = [i for i in range(len(rows[0])) if i == 0 or any(row[i] for row in rows[1:])]
    return [[row[i] for i in kept] for row in rows]


def file_rows(head: list[str], folder: Path, keys: list[str]) -> list[list[str]]:
    rows = [head]
    for path in sorted(folder.glob("*.toml")):
        values = tomllib.loads(path.read_text())
        link = f"[`{path.stem}`](../{path.relative_to(ROOT)})"
        comment = re.match(r"# (.*?)[.:;](?=\s)", path.read_text().replace("\n# ", " "))[1]
        rows.append([link, *(comment if key == "comment" else values.get(key, "") for key in keys)])
    return rows


def gallery() -> str:
    lines = []
    for path in sorted((ROOT / "docs" / "pictures" / "scenes").glob("*.png")):
        title = tomllib.loads((ROOT / "scenes" / f"{path.stem}.toml").read_text())["title"]
        lines.append(f"`{path.stem}`: {title}\n\n![{title}]({path.relative_to(PAGE.parent)})\n")
    return "\n".join(lines)


def block(name: str, schema: dict) -> str:
    if name == "pictures":
        return gallery()
    if name == "scenes":
        return markdown(file_rows(["scene", "what it is", "after"], ROOT / "scenes", ["title", "source"]))
    if name == "robots":
        return markdown(file_rows(["robot", "what it is"], ROOT / "scenes" / "robots", ["comment"]))
    definitions = schema["$defs"]
    table = definitions.get(name) or schema["properties"][name]
    if name == "materials":
        table = table["additionalProperties"]
    return markdown(without_empty_columns(key_rows(table)))


def main() -> int:
    schema = json.loads((ROOT / "schema" / "scene.schema.json").read_text())
    text = PAGE.read_text()
    new = BLOCK.sub(lambda match: match[1] + block(match[2], schema) + match[3], text)
    shown = {match[2] for match in BLOCK.finditer(text)}
    missing = (set(schema["properties"]) | set(schema["$defs"])) - shown - {"name", "title", "source", "robot", "point"}
    if missing:
        print("docs/scenes.md has no table of " + ", ".join(sorted(missing)))
        return 1
    if new == text:
        print(f"docs/scenes.md: {len(shown)} tables are current")
        return 0
    if "--check" in sys.argv[1:]:
        print("docs/scenes.md is stale; run scripts/fill_scene_tables.py")
        return 1
    PAGE.write_text(new)
    print("filled docs/scenes.md")
    return 0


if __name__ == "__main__":
    sys.exit(main())

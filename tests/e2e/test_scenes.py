# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""The schema of scenes takes every scene of the project, and refuses what the reader refuses."""

import copy
import json
import tomllib
import unittest

from harness import SOURCE

SCHEMA = json.loads((SOURCE / "schema" / "scene.schema.json").read_text())
TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float)}


def fits(value, schema):
    """The part of JSON Schema that the scenes' schema uses."""
    if "$ref" in schema:
        return fits(value, SCHEMA["$defs"][schema["$ref"].rsplit("/", 1)[1]])
    if "type" in schema and (not isinstance(value, TYPES[schema["type"]])
                             or (isinstance(value, bool) and schema["type"] != "boolean")):
        return False
    checks = [
        value in schema.get("enum", [value]),
        all(fits(value, each) for each in schema.get("allOf", [])),
        "anyOf" not in schema or any(fits(value, each) for each in schema["anyOf"]),
        "oneOf" not in schema or sum(fits(value, each) for each in schema["oneOf"]) == 1,
    ]
    if isinstance(value, (int, float)):
        checks.append(schema.get("minimum", value) <= value <= schema.get("maximum", value))
    if isinstance(value, list):
        checks.append(schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)))
        checks += [fits(item, schema.get("items", {})) for item in value]
    if isinstance(value, dict):
        checks += [key in value for key in schema.get("required", [])]
        known, others = schema.get("properties", {}), schema.get("additionalProperties", True)
        checks += [fits(item, known[key]) if key in known else others is not False and (others is True or fits(item, others))
                   for key, item in value.items()]
    return all(checks)


class SceneTest(unittest.TestCase):
    def test_every_scene_fits_the_schema(self):
        paths = sorted((SOURCE / "scenes").glob("*.toml"))
        self.assertGreater(len(paths), 15)
        for path in paths:
            with self.subTest(path.name):
                self.assertTrue(fits(tomllib.loads(path.read_text()), SCHEMA))

    def test_the_schema_refuses_what_the_reader_refuses(self):
        scene = tomllib.loads((SOURCE / "scenes" / "room-a.toml").read_text())
        self.assertTrue(fits(scene, SCHEMA))

        def spoilt(change):
            other = copy.deepcopy(scene)
            change(other)
            return fits(other, SCHEMA)

        self.assertFalse(spoilt(lambda s: s.update(colour="red")))
        self.assertFalse(spoilt(lambda s: s.pop("robot")))
        self.assertFalse(spoilt(lambda s: s.update(robot="nomad20")))
        self.assertFalse(spoilt(lambda s: s["sonar"].update(max_order=20)))
        self.assertFalse(spoilt(lambda s: s["sonar"].update(range_noise_share=-0.1)))
        self.assertFalse(spoilt(lambda s: s["wall"][0].pop("points")))
        self.assertFalse(spoilt(lambda s: s["wall"][0]["points"].append([1, 2, 3])))
        self.assertFalse(spoilt(lambda s: s["slats"][0].pop("width")))
        self.assertFalse(spoilt(lambda s: s["drive"]["legs"].append({"turn": True})))
        self.assertFalse(spoilt(lambda s: s["scoring"].update(cell_m=0)))


if __name__ == "__main__":
    unittest.main()

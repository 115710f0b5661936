# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0

"""What `map --features` writes."""

import json
import unittest

import fixtures
from harness import CommandTest, tree


class FeaturesTest(CommandTest):
    def setUp(self):
        super().setUp()
        fixtures.write_room(self.dir / "room.jsonl")

    def collection(self, name):
        return json.loads((self.dir / "out" / "features" / name).read_text())

    def test_all_are_written_as_geojson(self):
        out = self.succeed("map", "room.jsonl", "--method", "centerline,vt", "--features", "all",
                           "--set", "vt.threshold=1", "-o", "out")
        names = {"tangents.geojson", "regions.geojson", "lines-centerline.geojson", "lines-vt.geojson"}
        self.assertEqual({name for name in tree(self.dir / "out") if name.startswith("features/")},
                         {f"features/{name}" for name in names})
        kinds = {"tangents.geojson": {"tangent"}, "regions.geojson": {"wall", "corner", "edge", "region"}}
        for name in names:
            collection = self.collection(name)
            self.assertEqual(collection["type"], "FeatureCollection")
            self.assertEqual(collection["echoarc"]["unit"], "m")
            self.assertTrue(collection["echoarc"]["frame"])
            for feature in collection["features"]:
                self.assertEqual(feature["type"], "Feature")
                self.assertIn(feature["properties"]["kind"], kinds.get(name, {"line"}))
                geometry = feature["geometry"]
                positions = [geometry["coordinates"]] if geometry["type"] == "Point" else geometry["coordinates"]
                for position in positions:
                    self.assertEqual(len(position), 2)
        self.assertGreater(len(self.collection("lines-centerline.geojson")["features"]), 0)
        self.assertIn("tangents: ", out)
        command = json.loads((self.dir / "out" / "run.json").read_text())["command"]
        self.assertIn("--features tangents,regions,lines", command)

    def test_only_what_is_asked_for(self):
        self.succeed("map", "room.jsonl", "--method", "centerline", "--features", "tangents", "-o", "out")
        self.assertEqual([name for name in tree(self.dir / "out") if name.startswith("features/")],
                         ["features/tangents.geojson"])
        self.succeed("map", "room.jsonl", "--method", "centerline", "-o", "out")
        self.assertFalse((self.dir / "out" / "features").exists())

    def test_options_are_set_like_those_of_methods(self):
        self.succeed("map", "room.jsonl", "--method", "centerline", "--features", "lines",
                     "--set", "lines.points_min=100000", "-o", "out")
        self.assertEqual(self.collection("lines-centerline.geojson")["features"], [])

    def test_mistakes_are_named(self):
        for arguments, remedy in ((["--features", "corners"], "tangents,regions,lines"),
                                  (["--set", "lines.link_m=1"], "--features lines"),
                                  (["--features", "lines", "--set", "lines.link_m=-1"], "link_m")):
            result = self.run_command("map", "room.jsonl", *arguments, "-o", "out")
            self.assertNotEqual(result.returncode, 0)
            self.assertIn(remedy, result.stderr)

    def test_a_verb_without_features_does_not_suggest_them(self):
        result = self.run_command("bench", "room.jsonl", "--set", "tangents.gap_m=1")
        self.assertEqual(result.returncode, 2)
        self.assertIn("`echoarc map` extracts features", result.stderr)
        self.assertNotIn("--features", result.stderr)

    def test_pictures_show_them(self):
        self.succeed("map", "room.jsonl", "--method", "centerline", "-o", "plain")
        self.succeed("map", "room.jsonl", "--method", "centerline", "--features", "all", "-o", "out")
        pictures = [(self.dir / name / "centerline" / "map.png").read_bytes() for name in ("plain", "out")]
        self.assertNotEqual(*pictures)


if __name__ == "__main__":
    unittest.main()

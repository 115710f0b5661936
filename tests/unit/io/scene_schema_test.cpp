// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/scene_schema.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

TEST(SceneSchema, TheCommittedFileIsCurrent) {
  const std::string current = scene_schema();
  if (test::contents(ECHOARC_SOURCE_DIR "/schema/scene.schema.json") == current) return;
  const std::string fresh = testing::TempDir() + "scene.schema.json";
  test::put(fresh, current);
  FAIL() << "schema/scene.schema.json is stale: copy " << fresh << " over it, then run scripts/fill_scene_tables.py";
}

}  // namespace
}  // namespace echoarc::io

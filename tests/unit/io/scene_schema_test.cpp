// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/scene_schema.hpp"

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

TEST(SceneSchema, TheCommittedFileIsCurrent) {
  EXPECT_TRUE(test::contents(std::string(ECHOARC_SOURCE_DIR) + "/schema/scene.schema.json") == scene_schema())
      << "schema/scene.schema.json is stale; run `echoarc sim --schema > schema/scene.schema.json`";
}

}  // namespace
}  // namespace echoarc::io

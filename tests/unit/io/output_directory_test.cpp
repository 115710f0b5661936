// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/output_directory.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "echoarc/io/run_report.hpp"
#include "io/files.hpp"
#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

namespace fs = std::filesystem;
using test::put;

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}
using Names = std::vector<std::string>;

void write_result(const fs::path& final_path, std::string_view text) {
  auto output = OutputDirectory::create(final_path);
  ASSERT_TRUE(output) << output.error().message;
  ASSERT_TRUE(write_run_report(output->path(), {}));
  put(output->path() / "result", text);
  ASSERT_TRUE(output->commit());
}

TEST(OutputDirectory, AppearsAtCommit) {
  const test::TempFolder folder;
  auto output = OutputDirectory::create(folder / "out/");
  ASSERT_TRUE(output);
  put(output->path() / "result", "1");
  EXPECT_FALSE(fs::exists(folder / "out"));
  ASSERT_TRUE(output->commit());
  EXPECT_EQ(test::contents(folder / "out/result"), "1");
  EXPECT_EQ(names_in(folder.path()), Names{"out"});
}

TEST(OutputDirectory, AbandonedLeavesNothing) {
  const test::TempFolder folder;
  {
    auto output = OutputDirectory::create(folder / "out");
    ASSERT_TRUE(output);
    put(output->path() / "result", "1");
    const OutputDirectory moved = std::move(*output);
    EXPECT_EQ(names_in(folder.path()), Names{".out.partial-1"});
  }
  EXPECT_EQ(names_in(folder.path()), Names{});
}

TEST(OutputDirectory, MakesMissingParents) {
  const test::TempFolder folder;
  write_result(folder / "a/b/out", "1");
  EXPECT_EQ(test::contents(folder / "a/b/out/result"), "1");
}

TEST(OutputDirectory, ReplacesItsOwnOutputAsAWhole) {
  const test::TempFolder folder;
  write_result(folder / "out", "old");
  put(folder / "out/extra", "x");
  write_result(folder / "out", "new");
  EXPECT_EQ(names_in(folder / "out"), (Names{"result", "run.json"}));
  EXPECT_EQ(test::contents(folder / "out/result"), "new");
  EXPECT_EQ(names_in(folder.path()), Names{"out"});
}

TEST(OutputDirectory, KeepsTheOldOutputUntilCommit) {
  const test::TempFolder folder;
  write_result(folder / "out", "old");
  {
    ASSERT_TRUE(OutputDirectory::create(folder / "out"));
  }
  EXPECT_EQ(test::contents(folder / "out/result"), "old");
}

TEST(OutputDirectory, ReplacesAnEmptyFolder) {
  const test::TempFolder folder;
  fs::create_directory(folder / "out");
  write_result(folder / "out", "1");
  EXPECT_EQ(test::contents(folder / "out/result"), "1");
}

TEST(OutputDirectory, FollowsALinkToTheFolderItStandsFor) {
  const test::TempFolder folder;
  write_result(folder / "real", "old");
  fs::create_directory_symlink(folder / "real", folder / "out");
  write_result(folder / "out", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "out"));
  EXPECT_EQ(test::contents(folder / "real/result"), "new");
}

TEST(OutputDirectory, RefusesWhatIsNotItsOwn) {
  const test::TempFolder folder;
  put(folder / "file", "precious");
  fs::create_directory(folder / "thesis");
  put(folder / "thesis/chapter1", "precious");
  fs::create_directory(folder / "other");
  put(folder / "other/run.json", R"({"written_by": "somebody else"})");
  fs::create_directory(folder / "junk");
  put(folder / "junk/run.json", "[1, 2");
  for (const char* name : {"file", "thesis", "other", "junk", "file/below"}) {
    const auto output = OutputDirectory::create(folder / name);
    ASSERT_FALSE(output) << name;
    EXPECT_EQ(output.error().code, ErrorCode::unwritable) << name;
    EXPECT_FALSE(output.error().remedy.empty());
  }
  EXPECT_FALSE(OutputDirectory::create(""));
  EXPECT_FALSE(OutputDirectory::create("/"));
  EXPECT_EQ(test::contents(folder / "thesis/chapter1"), "precious");
  EXPECT_EQ(names_in(folder.path()), (Names{"file", "junk", "other", "thesis"}));
}

TEST(OutputDirectory, RefusesWhatCameInBetween) {
  const test::TempFolder folder;
  auto output = OutputDirectory::create(folder / "out");
  ASSERT_TRUE(output);
  fs::create_directory(folder / "out");
  put(folder / "out/chapter1", "precious");
  EXPECT_FALSE(output->commit());
  EXPECT_EQ(test::contents(folder / "out/chapter1"), "precious");
  EXPECT_EQ(names_in(folder.path()), Names{"out"});
}

TEST(Files, AFullDiskIsAnErrorAndLeavesNoFile) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full to stand for a full disk";
  const test::TempFolder folder;
  fs::create_symlink("/dev/full", folder / "map.pgm.part");  // where the bytes go until the file is complete
  const auto written = write_file(folder / "map.pgm", "P5 1 1 255\nx");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::unwritable);
  EXPECT_NE(written.error().message.find("No space left"), std::string::npos) << written.error().message;
  EXPECT_FALSE(fs::exists(folder / "map.pgm"));
}

TEST(Files, ReadingIsBounded) {
  const test::TempFolder folder;
  put(folder / "big", std::string(1001, 'x'));
  EXPECT_FALSE(read_file(folder / "big", 1000));
  EXPECT_TRUE(read_file(folder / "big", 1001));
  EXPECT_FALSE(read_file("/dev/zero", 1000));
}

}  // namespace
}  // namespace echoarc::io

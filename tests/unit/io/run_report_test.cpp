// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#include "echoarc/io/run_report.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/temp_folder.hpp"

namespace echoarc::io {
namespace {

std::uint64_t hash_of(std::string_view bytes) {
  Fnv1a64 hash;
  hash.add(bytes);
  return hash.value();
}

TEST(Fnv1a64, PublishedValues) {
  EXPECT_EQ(hash_of(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(hash_of("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(hash_of("foobar"), 0x85944171f73967e8ULL);
}

TEST(RunReport, InputIsHashedInPieces) {
  const test::TempFolder folder;
  const std::string bytes(200'000, 'x');  // more than one piece
  test::put(folder / "log.jsonl", bytes);
  const auto input = describe_input(folder / "log.jsonl");
  ASSERT_TRUE(input);
  EXPECT_EQ(input->bytes, bytes.size());
  EXPECT_EQ(input->fnv1a64, hash_of(bytes));
  EXPECT_FALSE(describe_input(folder / "absent"));
  EXPECT_FALSE(describe_input(folder.path()));
}

RunReport sample() {
  RunReport report;
  report.version = "0.1.0";
  report.command = "echoarc map log.jsonl";
  report.inputs = {{"log.jsonl", 6, 0x85944171f73967e8ULL}};
  report.seed = 3;
  report.sensing = {{"range_jump_m", 0.5}};
  report.pings = {{"echo", 4}, {"no_echo", 2}};
  report.rejected = {{"too_far", 1}, {"no_pose", 0}};
  report.notes = {"5.11 m is no echo"};
  report.methods = {{.name = "dm",
                     .options = {{"cell_m", 0.01}, {"threshold", std::int64_t{2}}, {"thin", true}},
                     .counters = {.used = 4, .no_information = 2},
                     .tallies = {{"removed_full", 3}, {"removed_split", 0}},
                     .points = 9,
                     .cells_occupied = 9}};
  return report;
}

TEST(RunReport, SaysEverythingInAFixedOrder) {
  EXPECT_EQ(run_report_json(sample()), R"({
  "written_by": "echoarc",
  "version": "0.1.0",
  "command": "echoarc map log.jsonl",
  "inputs": [
    {
      "path": "log.jsonl",
      "bytes": 6,
      "fnv1a64": "85944171f73967e8"
    }
  ],
  "seed": 3,
  "interrupted": false,
  "sensing": {
    "range_jump_m": 0.5
  },
  "pings": {
    "echo": 4,
    "no_echo": 2
  },
  "rejected": {
    "no_pose": 0,
    "too_far": 1
  },
  "notes": [
    "5.11 m is no echo"
  ],
  "methods": [
    {
      "name": "dm",
      "options": {
        "cell_m": 0.01,
        "thin": true,
        "threshold": 2
      },
      "counters": {
        "used": 4,
        "no_information": 2,
        "no_arc": 0,
        "bistatic": 0,
        "passed_over": 0,
        "memory_limit": 0
      },
      "points": 9,
      "cells": {
        "free": 0,
        "occupied": 9
      },
      "tallies": {
        "removed_full": 3,
        "removed_split": 0
      }
    }
  ]
}
)");
}

TEST(RunReport, ACommandLineThatIsNoUtf8DoesNotBreakIt) {
  RunReport report;
  report.command = "echoarc map \xff.csv";
  EXPECT_NE(run_report_json(report).find("echoarc map \xEF\xBF\xBD.csv"), std::string::npos);
}

TEST(RunReport, TimesLieInAFileOfTheirOwn) {
  const test::TempFolder folder;
  ASSERT_TRUE(write_run_report(folder.path(), sample()));
  ASSERT_TRUE(write_timings(folder.path(), {.threads = 2, .seconds = {{"read", 0.25}, {"dm.cpu", 1.5}}}));
  EXPECT_EQ(test::contents(folder / "run.json"), run_report_json(sample()));
  EXPECT_EQ(test::contents(folder / "timings.json"),
            "{\n  \"threads\": 2,\n  \"seconds\": {\n    \"read\": 0.25,\n    \"dm.cpu\": 1.5\n  }\n}\n");
}

}  // namespace
}  // namespace echoarc::io

// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <filesystem>

#include "echoarc/core/result.hpp"

namespace echoarc::io {

/// A folder of results that appears under its name complete or not at all.
///
/// Results are written into a hidden folder beside the final one (`.NAME.partial-1`); `commit` gives it its name. A
/// folder that already stands there is replaced only if it is empty or holds a run.json of echoarc. An object that is
/// destroyed without `commit` removes what it wrote.
class OutputDirectory {
 public:
  /// Makes the hidden folder, and missing parents of `final_path`. Errors: a file or a folder of somebody else's under
  /// that name, a parent that cannot be written to.
  [[nodiscard]] static Result<OutputDirectory> create(const std::filesystem::path& final_path);

  OutputDirectory(OutputDirectory&& other) noexcept;
  OutputDirectory& operator=(OutputDirectory&& other) noexcept;
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;
  ~OutputDirectory();

  /// Where to write until `commit`.
  [[nodiscard]] const std::filesystem::path& path() const { return partial_; }
  /// The name the user knows.
  [[nodiscard]] const std::filesystem::path& final_path() const { return final_; }

  /// Gives the folder its final name. The old folder is exchanged for it in one step where the file system can do so.
  /// After an error the old folder is still there and nothing of the new one.
  [[nodiscard]] Result<void> commit();

 private:
  OutputDirectory(std::filesystem::path partial, std::filesystem::path final_path);
  void discard() noexcept;

  std::filesystem::path partial_;  ///< empty once committed or moved from
  std::filesystem::path final_;
};

}  // namespace echoarc::io

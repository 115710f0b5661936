// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "echoarc/core/result.hpp"
#include "echoarc/io/delimited.hpp"

namespace echoarc::io {

/// Whether the columns of a table make sense together: whole poses, ranges that belong to a sensor, something to read.
/// The error has no place.
[[nodiscard]] Result<void> check_table(const DelimitedTable& table);

/// Whether the tables of a description make sense together: rows that know their time.
[[nodiscard]] Result<void> check_tables(const DelimitedDescription& description);

}  // namespace echoarc::io

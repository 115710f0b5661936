// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace echoarc::doi {

/// Sorts by an integer key and, where keys agree, by `less`. Keys that lie close together, as the rows of a map do,
/// cost one pass into buckets.
template <class T, class Key, class Less>
void sort_by_key(std::vector<T>& items, Key&& key, Less&& less) {
  if (items.size() < 2) return;
  std::int64_t low = key(items.front());
  std::int64_t high = low;
  for (const T& item : items) {
    low = std::min<std::int64_t>(low, key(item));
    high = std::max<std::int64_t>(high, key(item));
  }
  if (double(high) - double(low) > 4.0 * double(items.size())) {
    std::ranges::sort(items, [&](const T& a, const T& b) { return key(a) != key(b) ? key(a) < key(b) : less(a, b); });
    return;
  }
  std::vector<std::size_t> begins(std::size_t(high - low) + 2);  // of the bucket after
  const auto bucket = [&](const T& item) { return std::size_t(key(item) - low); };
  for (const T& item : items) ++begins[bucket(item) + 1];
  for (std::size_t k = 1; k < begins.size(); ++k) begins[k] += begins[k - 1];
  std::vector<T> sorted(items.size());
  for (const T& item : items) sorted[begins[bucket(item)]++] = item;  // each now ends where the next began
  auto begin = sorted.begin();
  for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
    const auto end = sorted.begin() + std::ptrdiff_t(begins[k]);
    std::sort(begin, end, less);
    begin = end;
  }
  items.swap(sorted);
}

}  // namespace echoarc::doi

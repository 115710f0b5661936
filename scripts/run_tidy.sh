#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/run_tidy.sh JOBS: clang-tidy over the product's sources and, through them, its headers. Test programs are left
# out: GoogleTest's macros alone multiply the time by four, and the compiler's warnings cover them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tree=build/dev
[ -f $tree/compile_commands.json ] || { echo "run ./dev lint: $tree is not configured" >&2; exit 1; }

log=$(mktemp)
trap 'rm -f "$log"' EXIT
find src apps -name '*.cpp' | sort |
  xargs -P "$1" -n 2 clang-tidy-19 -p $tree --quiet --extra-arg=-Wno-unknown-warning-option >"$log" 2>/dev/null && status=0 || status=1
grep -v '^\[[0-9]*/[0-9]*\]' "$log" || true
exit "$status"

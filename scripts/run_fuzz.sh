#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/run_fuzz.sh SECONDS JOBS: runs every fuzz target of the asan-ubsan tree for so long, JOBS at a time. A target starts from
# fuzz/corpus/NAME and collects new inputs in build/fuzz/found/NAME; an input that crashes it stays in
# build/fuzz/crashes, and the run fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

mkdir -p build/fuzz/crashes
shopt -s nullglob
targets=(build/asan-ubsan/fuzz/bin/*_fuzz)
[ ${#targets[@]} -gt 0 ] || { echo "no fuzz targets in build/asan-ubsan/fuzz/bin" >&2; exit 1; }

run_one() {
  local name seconds=$2 seeds=()
  name=$(basename "$1")
  mkdir -p "build/fuzz/found/$name"
  if [ -d "fuzz/corpus/$name" ]; then seeds=("fuzz/corpus/$name"); fi
  if "$1" "build/fuzz/found/$name" "${seeds[@]}" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -max_len=65536 -print_final_stats=1 -artifact_prefix="build/fuzz/crashes/$name-" >"build/fuzz/$name.log" 2>&1; then
    echo "fuzz: $name: clean, $(sed -n 's/^stat::number_of_executed_units: *//p' "build/fuzz/$name.log") inputs in $seconds s"
  else
    tail -n 40 "build/fuzz/$name.log"
    echo "fuzz: $name: FAILED, see build/fuzz/crashes"
    return 1
  fi
}
export -f run_one

printf '%s\n' "${targets[@]}" | xargs -P "$2" -I{} bash -c 'run_one "$@"' run_one {} "$1"

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
#
# scripts/lint.sh JOBS: every check that needs no build. Expects the dev tree configured (its compile commands are what
# clang-tidy reads); `./dev lint` sees to that. All checks run; the exit status says whether one failed.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit

jobs=$1
python=/usr/bin/python3
failed=()

check() {
  local name=$1 start=$SECONDS
  shift
  echo "--- $name"
  "$@" || failed+=("$name")
  if [ $((SECONDS - start)) -gt 5 ]; then echo "    $((SECONDS - start)) s"; fi
}

format() { "$python" scripts/project_files.py cpp | xargs clang-format-19 --dry-run -Werror; }
shell_scripts() { "$python" scripts/project_files.py shell | xargs shellcheck -x; }

check "the checks themselves can fail" "$python" -m unittest discover -q -s scripts/tests
check "format" format
check "dependency arrows" "$python" scripts/check_arrows.py
check "house rules" "$python" scripts/check_house.py
check "sizes" "$python" scripts/check_sizes.py
check "shell scripts" shell_scripts
check "clang-tidy" "$python" scripts/run_tidy.py build/dev "$jobs"

if [ ${#failed[@]} -gt 0 ]; then
  printf 'lint FAILED: %s\n' "${failed[@]}"
  exit 1
fi
echo "lint: clean"

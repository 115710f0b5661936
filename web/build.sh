#!/bin/sh
# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
# Bundles the page into dist/ with Debian's esbuild. `build.sh demo|bench` bundles the map alone, to look at or to measure.
set -eu
cd "$(dirname "$0")"
esbuild=${ESBUILD:-/usr/bin/esbuild}
options="--bundle --minify --target=es2022 --format=esm --log-level=warning --legal-comments=none"
if [ "${1:-}" = demo ] || [ "${1:-}" = bench ]; then
  out=${2:-dist/$1}
  mkdir -p "$out"
  # shellcheck disable=SC2086 # a list of options
  "$esbuild" $options --outfile="$out/main.js" "test/$1/main.ts"
  # shellcheck disable=SC2086
  "$esbuild" $options --outfile="$out/demo.css" test/demo/demo.css
  cp test/demo/index.html "$out/"
  exit
fi
out=${1:-dist}
rm -rf "$out"
mkdir -p "$out"
# shellcheck disable=SC2086
"$esbuild" $options --outfile="$out/main.js" src/main.ts
# shellcheck disable=SC2086
"$esbuild" $options --outfile="$out/style.css" style/page.css
cp index.html public/* "$out/"

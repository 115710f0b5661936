# SPDX-FileCopyrightText: 2026 The echoarc authors
# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
#
# What each verb of ./dev needs, as names of Debian 12 packages, and how it gets there. Sourced by ./dev.

packages_for() {
  local build=(g++ cmake ninja-build pkg-config python3
    esbuild libboost-dev libcli11-dev libfmt-dev libnanoflann-dev libpng-dev libsimdjson-dev libtomlplusplus-dev nlohmann-json3-dev)
  local test=(libgtest-dev librapidcheck-dev)
  local sanitizer=(clang-19 libclang-rt-19-dev)
  case "$1" in
    build) echo "${build[@]}" ;;
    test) echo "${build[@]}" "${test[@]}" ;;
    sanitize) echo "${build[@]}" "${test[@]}" "${sanitizer[@]}" ;;
    lint) echo "${build[@]}" "${test[@]}" clang-format-19 clang-tidy-19 shellcheck universal-ctags ;;
    fmt) echo clang-format-19 ;;
    web) echo esbuild chromium "$(node_packages)" ;;
    bench) echo "${build[@]}" libbenchmark-dev "$(optional libmrpt-maps-dev libmrpt-obs-dev)" ;;
    docs) echo "${build[@]}" doxygen ;;
    *) echo "no package list for '$1'" >&2; return 1 ;;
  esac
}

# Node.js with npm for the page's tests; a Node.js that is there already will do.
node_packages() {
  if ! command -v npm >/dev/null; then echo nodejs npm; fi
}

# Those of the named packages that this system's lists know or that are installed: for what can be left out.
optional() {
  local package
  for package in "$@"; do
    if is_installed "$package" || apt-cache show "$package" >/dev/null 2>&1; then echo -n "$package "; fi
  done
}

is_installed() {
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Installs what the verb needs and this system lacks. Says what, asks nothing; does nothing when nothing is missing.
require_packages() {
  if ! command -v apt-get >/dev/null; then
    say "no apt-get here; assuming these are installed (Debian's names): $(packages_for "$1")"
    return
  fi
  local package missing=()
  for package in $(packages_for "$1"); do
    is_installed "$package" || missing+=("$package")
  done
  if [ ${#missing[@]} -eq 0 ]; then return; fi

  say "installing from Debian: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "not root and no sudo; install these as root: ${missing[*]}"
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get -qq -o Acquire::Retries=3 update || say "apt-get update failed; going on with the lists there are"
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o Acquire::Retries=3 \
    install --no-install-recommends "${missing[@]}" >/dev/null
}

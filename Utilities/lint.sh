#!/usr/bin/env bash
# Checks the names in the C++ with clang-tidy: Utilities/lint.sh [build folder, default build]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build}
find Filters Plugin -name '*.cxx' -print0 |
  xargs -0 -n 1 -P "$(nproc)" clang-tidy-14 --quiet -p "$build"

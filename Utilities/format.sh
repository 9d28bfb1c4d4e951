#!/usr/bin/env bash
# Lays the C++ out in VTK's style. With --check it changes nothing and fails where a file differs.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mapfile -t files < <(find Filters Plugin Testing Examples -name '*.h' -o -name '*.cxx')
if [ "${1:-}" = --check ]; then
  exec clang-format-14 --dry-run --Werror "${files[@]}"
fi
exec clang-format-14 -i "${files[@]}"

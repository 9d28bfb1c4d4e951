#!/usr/bin/env bash
# Sets up, then runs the whole test suite under one X display. Arguments go to ctest:
# Utilities/test.sh -L kernel
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
Utilities/setup.sh
# One more than there are cores, because tests of the window also wait.
exec xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" \
  ctest --test-dir build --output-on-failure -j "$(($(nproc) + 1))" "$@"

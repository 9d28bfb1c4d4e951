#!/usr/bin/env bash
# Sets up, then fills the Stanford bunny with hexahedra, maps them into a ball and draws it:
# Utilities/demo.sh [folder for the results, default build/demo]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=${1:-$root/build/demo}
mkdir -p "$out"
"$root/Utilities/setup.sh" plugin
exec "$root/Utilities/pvpython.sh" "$root/Utilities/demo.py" "$root/build/models/bunny00.off" "$out"

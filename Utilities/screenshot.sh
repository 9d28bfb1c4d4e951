#!/usr/bin/env bash
# A picture of the ParaView window with a mapped solid and the menu Filters > ShapeMap unfolded, taken
# on a display of its own: Utilities/screenshot.sh OUT.png
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
[ $# = 1 ] || { echo "usage: Utilities/screenshot.sh OUT.png" >&2; exit 1; }
unset DISPLAY
PYTHONPATH=Testing exec Utilities/pvpython.sh Testing/GUI/screenshot.py "$(cd "$OLDPWD" && realpath "$1")"

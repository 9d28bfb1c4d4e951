#!/usr/bin/env bash
# pvpython with the built plugin loaded, the Python package shapemap on its path, and an X display
# where there is none: Utilities/pvpython.sh script.py [arguments]
# SHAPEMAP_PREFIX names another build or installation than build/, SHAPEMAP_PVPYTHON another command
# than pvpython, such as "mpiexec -n 2 pvbatch --sym".
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
prefix=${SHAPEMAP_PREFIX:-$root/build}
plugin=$(find "$prefix" -name ShapeMap.so -path '*plugins*' -print -quit 2>/dev/null || true)
if [ -z "$plugin" ]; then
  echo "pvpython.sh: there is no plugin below $prefix; run Utilities/setup.sh first" >&2
  exit 1
fi
export PV_PLUGIN_PATH=${plugin%/*}${PV_PLUGIN_PATH:+:$PV_PLUGIN_PATH}
export PYTHONPATH=$prefix/lib/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}
read -ra command <<<"${SHAPEMAP_PVPYTHON:-pvpython}"
if [ -z "${DISPLAY:-}" ]; then
  exec xvfb-run -a -s "-screen 0 1600x1000x24 -noreset" "${command[@]}" "$@"
fi
exec "${command[@]}" "$@"

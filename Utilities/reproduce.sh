#!/usr/bin/env bash
# Sets up, then measures and draws, on models at hand, what two papers and a lecture report: on harmonic volume maps
# (tables, features, figures and drawn; Li, Xu, Wan, Yin and Yu, "Feature-aligned harmonic volumetric mapping
# using MFS", 2010) and on features dragged and dropped (composition; Schmidt and Singh, "Drag-and-drop
# surface composition", 2010), and methods of correspondence side by side (lecture; Solomon, "Shape
# analysis", 2021):
# Utilities/reproduce.sh [folder, default build/reproduce] [tables] [features] [figures] [drawn]
#                        [composition] [lecture]
# Every part runs, even after one whose claims did not hold; then the command fails.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=${1:-$root/build/reproduce}
parts=("${@:2}")
[ "${#parts[@]}" -gt 0 ] || parts=(tables features figures drawn composition lecture)
mkdir -p "$out"
"$root/Utilities/setup.sh"
failed=()
for part in "${parts[@]}"; do
  begin=$SECONDS
  "$root/Utilities/pvpython.sh" "$root/Utilities/reproduce/$part.py" "$out" || failed+=("$part")
  printf 'reproduce: %s took %d s\n' "$part" $((SECONDS - begin))
done
if [ "${#failed[@]}" -gt 0 ]; then
  printf 'reproduce: failed: %s\n' "${failed[*]}" >&2
  exit 1
fi
printf 'reproduce: the results are in %s\n' "$out"

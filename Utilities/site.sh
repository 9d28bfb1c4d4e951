#!/usr/bin/env bash
# Makes the documentation site: Utilities/site.sh [folder, default build/site]; open its index.html.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
out=${1:-$root/build/site}
/usr/bin/python3 -B "$root/Utilities/pages.py" site "$out"

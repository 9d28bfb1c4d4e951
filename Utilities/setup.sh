#!/usr/bin/env bash
# Installs what is missing (Debian 12, apt), builds ShapeMap in build/ and unpacks the real models
# into build/models. Does only what is still to do, and says what it does.
#   Utilities/setup.sh           everything: the plugin, the Python package, the tests
#   Utilities/setup.sh plugin    what the demo needs: no tests, and not their packages
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
what=${1:-all}

packages=(
  # tools
  g++ cmake ninja-build ccache git ca-certificates
  # ParaView, the icons of its window, and what its CMake package asks for
  paraview paraview-dev python3-paraview libqt5svg5 qtbase5-dev qttools5-dev
  qtxmlpatterns5-dev-tools libqt5opengl5-dev libopenmpi-dev libdouble-conversion-dev libglew-dev
  # libraries
  libeigen3-dev libtbb-dev libopenblas-dev liblapacke-dev libhwy-dev libnanoflann-dev
  libsuitesparse-dev libtet1.5-dev libocct-data-exchange-dev libopencv-dnn-dev
  libprotobuf-dev libinsighttoolkit5-dev libboost-dev zlib1g-dev libxcb1-dev
  ocl-icd-opencl-dev opencl-c-headers opencl-clhpp-headers
  # a display and real models
  xvfb xauth libcgal-demo
  # pages of the help and of the site
  python3-markdown python3-pygments
)
test_packages=(
  # frameworks, style, types, keys and pictures of a window, a browser, readers of what is written,
  # an OpenCL device
  libgtest-dev clang-format-14 universal-ctags mypy python3-venv unzip xdotool imagemagick chromium
  gmsh calculix-ccx pocl-opencl-icd
  # peers of the reproduced figures
  python3-scipy
)
targets=(ShapeMap vtkShapeFiltersPython)
if [ "$what" = all ]; then
  packages+=("${test_packages[@]}")
  targets=(all)
fi

say() { printf 'setup: %s\n' "$*"; }

missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
    missing+=("$package")
done
if [ "${#missing[@]}" -gt 0 ]; then
  if [ "$(id -u)" -ne 0 ]; then
    say "these packages are missing; install them as root and run this again:"
    say "apt-get install --no-install-recommends ${missing[*]}"
    exit 1
  fi
  say "installing ${#missing[@]} packages with apt: ${missing[*]}"
  export DEBIAN_FRONTEND=noninteractive
  log=$(mktemp)
  if ! { apt-get update && apt-get install -y --no-install-recommends "${missing[@]}"; } \
    >"$log" 2>&1; then
    tail -n 30 "$log"
    say "apt failed; its whole output is in $log"
    exit 1
  fi
  rm -f "$log"
fi

# A build that was set up for the plugin alone gets its tests once they are asked for.
if [ ! -f build/build.ninja ] ||
  { [ "$what" = all ] && grep -q '^SHAPEMAP_TESTS:BOOL=OFF' build/CMakeCache.txt; }; then
  say "configuring build/"
  mkdir -p build
  # Files of one room are compiled together: half the time for a build from nothing.
  cmake --preset release -DCMAKE_UNITY_BUILD=ON \
    -DSHAPEMAP_TESTS="$([ "$what" = all ] && echo ON || echo OFF)" \
    >build/configure.log 2>&1 || { tail -n 30 build/configure.log; exit 1; }
fi
say "building build/ (${targets[*]})"
cmake --build --preset release --target "${targets[@]}" >build/build.log 2>&1 ||
  { tail -n 60 build/build.log; exit 1; }

if [ ! -f build/models/bunny00.off ]; then
  say "unpacking the models of libcgal-demo into build/models"
  mkdir -p build/models
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C build/models --strip-components=2 data/meshes
fi
say "done"

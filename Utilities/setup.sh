#!/usr/bin/env bash
# Installs what is missing (Debian 12, apt), builds ShapeMap into build/ and unpacks the real models
# into build/models. Does only what is still to do, and says what it does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(
  # tools
  g++ cmake ninja-build ccache git ca-certificates
  # ParaView and what its CMake package asks for
  paraview paraview-dev python3-paraview qtbase5-dev qttools5-dev qtxmlpatterns5-dev-tools
  libqt5opengl5-dev libqt5svg5 libopenmpi-dev libdouble-conversion-dev libglew-dev
  # libraries
  libeigen3-dev libtbb-dev libopenblas-dev liblapacke-dev libhwy-dev libnanoflann-dev
  libsuitesparse-dev libtet1.5-dev libboost-dev
  # tests: frameworks, style, a display, real models, readers of what is written
  libgtest-dev clang-format-14 clang-tidy-14 xvfb xauth xdotool imagemagick libcgal-demo
  gmsh calculix-ccx
)

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

if [ ! -f build/build.ninja ]; then
  say "configuring build/"
  mkdir -p build
  cmake --preset release -DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
    >build/configure.log 2>&1 || { tail -n 30 build/configure.log; exit 1; }
fi
say "building build/"
cmake --build --preset release >build/build.log 2>&1 || { tail -n 60 build/build.log; exit 1; }

if [ ! -f build/models/bunny00.off ]; then
  say "unpacking the models of libcgal-demo into build/models"
  mkdir -p build/models
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C build/models --strip-components=2 data/meshes
fi
say "done"

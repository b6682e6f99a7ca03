#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# test_install.sh SCRATCH: installs build/release the way a user and the way a packager does, then builds and runs
# tests/install on it, through the CMake package and through pkg-config. Exit status: 0 all of it works.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.."
scratch=$PWD/$1
rm -rf "$scratch"
prefix=$scratch/prefix

DESTDIR='' cmake --install build/release --prefix "$prefix" >"$scratch.log"
DESTDIR=$scratch/stage cmake --install build/release --prefix /usr >>"$scratch.log"
if ! diff <(cd "$prefix" && find . -type f | sort) <(cd "$scratch/stage/usr" && find . -type f | sort); then
    echo "test_install: DESTDIR=$scratch/stage PREFIX=/usr holds other files than PREFIX=$prefix" >&2
    exit 1
fi

"$prefix/bin/sheen" --version

cmake -G Ninja -S tests/install -B "$scratch/consumer" -DCMAKE_CXX_COMPILER="${CXX:-g++}" \
    -DCMAKE_PREFIX_PATH="$prefix" >>"$scratch.log"
cmake --build "$scratch/consumer" >>"$scratch.log"
echo -n "with find_package(sheen): " && "$scratch/consumer/consumer"

export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
read -ra flags < <(pkg-config --cflags --libs --static sheen)
"${CXX:-g++}" -std=c++17 tests/install/consumer.cpp -o "$scratch/consumer/by_pkg_config" "${flags[@]}"
echo -n "with pkg-config sheen: " && "$scratch/consumer/by_pkg_config"
echo "test_install: $(find "$prefix" -type f | wc -l) files installed; CMake package and pkg-config file work"

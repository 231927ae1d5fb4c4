#!/usr/bin/env bash
# Installs what is missing, builds everything and runs all tests without a screen. Ends with the summary of ctest.
# Run it as root or as a user with sudo, as often as you like.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install.sh

install_missing "${build_packages[@]}" "${format_packages[@]}"

say "Configuring in build/release"
cmake --preset release -DCMAKE_UNITY_BUILD=ON

say "Building programs and tests"
cmake --build --preset release

say "Running all tests"
export QT_QPA_PLATFORM=offscreen
ctest --test-dir build/release --output-on-failure -j2

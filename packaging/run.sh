#!/usr/bin/env bash
# Installs what is missing, builds the command line and runs the main job on the shipped lambda-sensor study:
# fit, find what the model lacks, add it, refit, report. With a display the window is built after that, and opened.
# Run it as root or as a user with sudo, as often as you like.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install.sh

study=examples/lambda-sensor-heating
out=out/lambda-sensor-heating

install_missing "${build_packages[@]}"

say "Configuring in build/release"
cmake --preset release -DCMAKE_UNITY_BUILD=ON

say "Building the command line"
cmake --build --preset release --target analogon-cli

cli=$(find build/release -name analogon-cli -type f -perm -u+x | head -n 1)

say "Searching for what the model of $study lacks"
"$cli" discover "$study" --out "$out"

say "The report: file://$PWD/$out/report.html"
echo "    The completed study: $PWD/$out/study"

if [ -n "${DISPLAY:-}" ] || [ -n "${WAYLAND_DISPLAY:-}" ]; then
    say "Building the window"
    cmake --build --preset release --target analogon
    say "Opening the completed study; close the window to end"
    build/release/app/analogon "$out/study"
else
    say "No display: the window is left out ('cmake --build --preset release --target analogon' builds it)"
fi

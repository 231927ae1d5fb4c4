#!/usr/bin/env bash
# Installs what is missing, builds the programs and makes build/package/analogon_VERSION_amd64.deb, with man pages,
# completions, desktop entry, MIME type and a list of what it is linked of. Ends with what lintian says where it is here.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install.sh

install_missing "${build_packages[@]}" dpkg-dev file
say "Building the programs"
cmake --preset release -DCMAKE_UNITY_BUILD=ON
cmake --build --preset release --target analogon analogon-cli
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' build/release/CMakeCache.txt)
packaging/sbom.sh "$version" build/release/app/analogon build/release/app/analogon-cli >build/release/analogon.spdx.json

say "Making the package"
rm -f build/package/analogon_*.deb
cpack --config build/release/CPackConfig.cmake -G DEB -B build/package
package=$(ls build/package/analogon_*.deb)
if command -v lintian >/dev/null; then
    say "What lintian says"
    lintian --fail-on error "$package"
fi
say "The package: $package"

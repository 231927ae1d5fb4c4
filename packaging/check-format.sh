#!/usr/bin/env bash
# Holds every C++ file against .clang-format. Exit status 77 (skipped) without clang-format 14, the one of Debian 12:
# other versions break lines differently.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tool=$(command -v clang-format-14 || command -v clang-format || true)
if [ -z "$tool" ] || ! "$tool" --version | grep -q 'version 14\.'; then
    echo "skipped: clang-format 14 is not installed"
    exit 77
fi
find app core ui tests -name '*.cpp' -print0 -o -name '*.hpp' -print0 |
    xargs -0 -r "$tool" --dry-run --Werror --style=file
echo "every file follows .clang-format"

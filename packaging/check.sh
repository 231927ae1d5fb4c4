#!/usr/bin/env bash
# Checks beside the gate (test.sh), by how long they take:
#   packaging/check.sh fast               layout, and the tests labelled unit
#   packaging/check.sh full [FOLDER]      fast; a build without the headers that are parsed once, as far as the syntax;
#                                         clang-tidy (core/effect without FOLDER)
#   packaging/check.sh tidy [FOLDER]      clang-tidy alone
#   packaging/check.sh coverage [STAGES]  lines that the tests of a stage of core reach, against tests/coverage.txt
#   packaging/check.sh bench              twelve cases of the bench, against tests/bench/score.txt
#   packaging/check.sh sanitize [TESTS]   tests under the address and undefined-behaviour, then the thread sanitizer
#   packaging/check.sh campaign [UNITS]   1000 units of a water pump, killed ten times, here and on a Slurm of its own;
#                                         the tests of that Slurm
#   packaging/check.sh nightly            full, sanitize, coverage, bench, campaign, and the soak with few repetitions
# FOLDER: only sources below it, core/effect, say. TESTS: programs, "test_fit test_ui"; all of core and the window else.
# CTEST_ARGS: further options of ctest ("-R ^Fit"); GTEST_FILTER: chooses tests of a sanitize run.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install.sh

export QT_QPA_PLATFORM=offscreen
jobs=$(nproc)
unity=(-DCMAKE_UNITY_BUILD=ON)  # several sources at once, as the gate builds them
core_tests="test_base test_syntax test_signal test_library test_diagram test_flat test_structure test_eval test_simulate
    test_measure test_fit test_residual test_effect test_report test_study test_archive test_campaign test_export"

fast() {
    install_missing "${build_packages[@]}" "${format_packages[@]}"
    say "Layout"
    packaging/check-format.sh
    say "Building everything in build/release"
    cmake --preset release "${unity[@]}"
    cmake --build --preset release
    say "Tests labelled unit"
    # shellcheck disable=SC2086  # options are words
    ctest --test-dir build/release --output-on-failure -j"$jobs" -L unit --no-tests=error ${CTEST_ARGS:-}
}

# Every source with its own includes alone: as far as the syntax, which is where a missing include shows.
own_includes() {
    python3 - build/plain "$jobs" "$1" <<'PYTHON'
import concurrent.futures, json, os, shlex, subprocess, sys
build, jobs, folder = sys.argv[1], int(sys.argv[2]), os.path.abspath(sys.argv[3])
def lacks(entry):
    words = shlex.split(entry["command"])
    words[words.index("-o") + 1] = "/dev/null"
    run = subprocess.run(words + ["-fsyntax-only"], cwd=entry["directory"], stderr=subprocess.PIPE, text=True)
    return run.stderr if run.returncode else ""
entries = [e for e in json.load(open(f"{build}/compile_commands.json"))
           if e["file"].startswith(folder + "/") and not e["file"].startswith(os.path.abspath(build) + "/")]
with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
    faults = [text for text in pool.map(lacks, entries) if text]
print("\n".join(faults) + f"{len(entries)} sources, {len(faults)} of them at fault")
sys.exit(bool(faults) or not entries)
PYTHON
}

full() {
    local folder=${1:-.}
    install_missing "${build_packages[@]}"
    say "Sources with their own includes alone, below $folder"
    cmake --preset release -B build/plain -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
    # what moc writes and what is embedded
    cmake --build build/plain --target analogon_ui_autogen
    own_includes "$folder"
}

# clang-tidy 16: 14 knows no parentheses around the members of an aggregate (C++20).
tidy() {
    local folder=${1:-core/effect} files
    install_missing "${build_packages[@]}" clang-tidy-16
    say "clang-tidy, below $folder"
    cmake --preset release -B build/plain -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
    files=$(find "$folder" -name '*.cpp' | sort)
    [ -n "$files" ] || { echo "error: no source below $folder" >&2; return 1; }
    xargs -P "$jobs" -n 1 timeout 600 clang-tidy-16 --quiet -p build/plain \
        --extra-arg=-Wno-unknown-warning-option <<<"$files"
}

# Of the stages that have a floor; those without one are told.
coverage() {
    local stages=${1:-$(sed -n 's/^\([a-z]\+\) .*/\1/p' tests/coverage.txt)} stage targets=()
    install_missing "${build_packages[@]}" gcovr
    for stage in $stages; do targets+=("test_$stage"); done
    say "Coverage of" $stages
    cmake --preset coverage "${unity[@]}" >/dev/null
    cmake --build --preset coverage --target "${targets[@]}"
    # shellcheck disable=SC2086  # stages are words
    python3 tests/coverage.py build/coverage tests/coverage.txt $stages
    for stage in core/*/; do
        stage=$(basename "$stage")
        grep -q "^$stage " tests/coverage.txt || say "core/$stage has no floor in tests/coverage.txt yet"
    done
}

bench() {
    install_missing "${build_packages[@]}"
    say "Twelve cases of the bench"
    cmake --preset release "${unity[@]}" >/dev/null
    cmake --build --preset release --target analogon-cli
    tests/bench/run_bench.sh build/release/app/analogon-cli build/bench -n 12 -s 2026 -t 900 -j "$jobs"
    say "Against the stored score"
    python3 tests/bench/score.py build/bench/results build/bench/cases --floor tests/bench/score.txt
}

# Fits and searches of all units; on Slurm where it is installed and this is root.
campaign() {
    local units=${1:-1000} run=(python3 tests/bench/thousand_units.py build/release/app/analogon-cli)
    install_missing "${build_packages[@]}"
    cmake --preset release "${unity[@]}" >/dev/null
    cmake --build --preset release --target analogon-cli test_app test_ui
    rm -rf build/campaign
    mkdir -p build/campaign
    say "A campaign of $units units, killed ten times"
    "${run[@]}" build/campaign/fits --units "$units"
    say "Searches of $units units, killed ten times"
    "${run[@]}" build/campaign/searches --units "$units" --alone "$((units / 16))" --command discover
    say "The same on Slurm"
    MAX_ARRAY=201 tests/slurm/start.sh "${run[@]}" build/campaign/cluster --units "$units" --slurm || [ $? -eq 77 ]
    say "Tests of the command line and of the window with that Slurm"
    tests/slurm/start.sh build/release/tests/test_app --gtest_filter='CampaignOnSlurm.*' || [ $? -eq 77 ]
    tests/slurm/start.sh build/release/tests/test_ui --gtest_filter='CampaignOnACluster.*' || [ $? -eq 77 ]
}

# In a shell of its own: what is set for the sanitizers is not for the parts that follow.
sanitize() (
    local tests=${1:-$core_tests test_ui} preset program
    local failed=()
    install_missing "${build_packages[@]}"
    # the sanitizers have a heap of their own in the place of the one that LargeMemory is about
    export GTEST_FILTER=${GTEST_FILTER:--LargeMemory.*}
    export UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_leaks=0 TSAN_OPTIONS=second_deadlock_stack=1
    for preset in asan tsan; do
        say "Building build/$preset: $tests"
        cmake --preset "$preset" "${unity[@]}" >/dev/null
        # shellcheck disable=SC2086  # targets are words
        cmake --build --preset "$preset" --target $tests
        for program in $tests; do
            say "$program, $preset"
            "build/$preset/tests/$program" --gtest_brief=1 || failed+=("$program ($preset)")
        done
    done
    [ ${#failed[@]} -eq 0 ] || { say "At fault: ${failed[*]}"; return 1; }
)

case "${1:-}" in
    fast) fast ;;
    full) [ $# -gt 1 ] || fast; full "${2:-.}"; tidy "${2:-core/effect}" ;;
    tidy) tidy "${2:-core/effect}" ;;
    coverage) coverage "${2:-}" ;;
    bench) bench ;;
    campaign) campaign "${2:-}" ;;
    sanitize) sanitize "${2:-}" ;;
    nightly) fast; full .; tidy; sanitize; coverage; bench; campaign; packaging/soak.sh --quick ;;
    *) sed -n '2,14s/^# \{0,1\}//p' "$0"; exit 2 ;;
esac
say "check.sh $1 has found no fault"

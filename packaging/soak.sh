#!/usr/bin/env bash
# The long runs that are too long for every change: random events on the window with a watch on every memory access,
# random editing undone and redone, and kills while a study is saved. About two hours on two cores.
#   packaging/soak.sh [SEEDS] [EVENTS] [SEQUENCES] [KILLS]     (20 50000 2000 3000)
# Writes build/soak/summary.log and one log for each run; fails where one of them does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install.sh
seeds=${1:-20} events=${2:-50000} sequences=${3:-2000} kills=${4:-3000}

install_missing "${build_packages[@]}"
say "Building with the address sanitizer in build/asan, and plainly in build/release"
cmake --preset asan
cmake --build --preset asan --target test_ui
cmake --preset release
cmake --build --preset release --target test_ui test_archive

export QT_QPA_PLATFORM=offscreen ASAN_OPTIONS=detect_leaks=0:malloc_context_size=3:quarantine_size_mb=64
logs=build/soak failed=0
mkdir -p "$logs"
: >"$logs/summary.log"

# run NAME TEST FILTER [VARIABLE=VALUE…]
run() {
    local name=$1 program=$2 filter=$3 status=0
    shift 3
    env "$@" "$program" --gtest_filter="$filter" >"$logs/$name.log" 2>&1 || status=$?
    [ "$status" -eq 0 ] || failed=1
    printf '%s: exit %s; %s\n' "$name" "$status" "$(grep -m1 'events of seed' "$logs/$name.log" || true)" |
        tee -a "$logs/summary.log"
}

say "Random events: $seeds times $events"
for seed in $(seq 1 "$seeds"); do
    run "events-$seed" build/asan/tests/test_ui Panels.SurvivesRandomEvents \
        ANALOGON_EVENTS="$events" ANALOGON_SEED="$seed"
done
say "Random editing: $sequences sequences; kills while saving: $kills"
run editing build/release/tests/test_ui 'RandomEditing.*' ANALOGON_SEQUENCES="$sequences"
run kills build/release/tests/test_archive Archive.IsOldOrNewWhenTheProgramIsKilled ANALOGON_KILLS="$kills"
run kills-directory build/release/tests/test_study StudyFiles.SurviveKills ANALOGON_KILLS="$kills"
exit "$failed"

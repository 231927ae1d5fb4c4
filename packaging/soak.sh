#!/usr/bin/env bash
# The long runs that are too long for every change: random events on the window with a watch on every memory access,
# random editing undone and redone, kills while studies, results, archives and directories are written, two programs on
# one place, and a disk that runs full at every write, as many at once as there are cores. About an hour and a half on
# two.
#   packaging/soak.sh [SEEDS] [EVENTS] [SEQUENCES] [KILLS] [INTERRUPTS]     (20 50000 2000 3000 200)
# Writes build/soak/summary.log and one log for each run; fails where one of them does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install.sh
seeds=${1:-20} events=${2:-50000} sequences=${3:-2000} kills=${4:-3000} interrupts=${5:-200}

install_missing "${build_packages[@]}"
say "Building with the address sanitizer in build/asan, and plainly in build/release"
cmake --preset asan
cmake --build --preset asan --target test_ui
cmake --preset release
cmake --build --preset release --target test_ui test_archive test_study test_base test_app

export QT_QPA_PLATFORM=offscreen ASAN_OPTIONS=detect_leaks=0:malloc_context_size=3:quarantine_size_mb=64
logs=build/soak
mkdir -p "$logs"
: >"$logs/summary.log"

# run NAME TEST FILTER [VARIABLE=VALUE…]
run() {
    local name=$1 program=$2 filter=$3 status=0
    shift 3
    env "$@" "$program" --gtest_filter="$filter" >"$logs/$name.log" 2>&1 || status=$?
    printf '%s: exit %s; %s\n' "$name" "$status" "$(grep -m1 'events of seed' "$logs/$name.log" || true)" |
        tee -a "$logs/summary.log"
}

# The same beside the others, once a core is free for it.
start() {
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do
        wait -n || true
    done
    run "$@" &
}

# Kills that leave something, or something mixed: NAME PROGRAM TEST
writes=(
    "kills test_archive Archive.IsOldOrNewWhenTheProgramIsKilled"
    "kills-history test_archive Archive.AndItsHistoryAreWholeWhenTheProgramIsKilled"
    "kills-unpack test_archive Archive.IsUnpackedWholeOrNotAtAllWhenTheProgramIsKilled"
    "kills-directory test_study StudyFiles.SurviveKills"
    "kills-results test_study Results.AreOldOrNewWhenTheProgramIsKilled"
    "kills-own test_base OwnedDirectories.LeaveNothingWhereverTheirMakerIsKilled"
)

say "Random events: $seeds times $events; random editing: $sequences sequences; kills while writing: $kills of each kind"
for write in "${writes[@]}"; do
    read -r name program filter <<<"$write"
    start "$name" "build/release/tests/$program" "$filter" ANALOGON_KILLS="$kills"
done
start two-programs build/release/tests/test_study '*TwoPrograms*' GTEST_REPEAT=20
if [ "$(id -u)" -eq 0 ]; then
    start full-disk build/release/tests/test_archive 'FullDisk.*' ANALOGON_DISK_STEP=512
else
    say "A disk that runs full is left out: root alone can make a small one"
fi
start editing build/release/tests/test_ui 'RandomEditing.*' ANALOGON_SEQUENCES="$sequences"
for seed in $(seq 1 "$seeds"); do
    start "events-$seed" build/asan/tests/test_ui Panels.SurvivesRandomEvents \
        ANALOGON_EVENTS="$events" ANALOGON_SEED="$seed"
done
# Interrupts of the command line at random moments, judged by processor time.
for seed in 1 2 3 4; do
    start "interrupts-$seed" build/release/tests/test_app Interrupts.EndTheProgramSoonWhereverItIs \
        ANALOGON_INTERRUPTS="$interrupts" ANALOGON_SEED="$seed"
done
wait
! grep -v ': exit 0;' "$logs/summary.log"
[ "$(wc -l <"$logs/summary.log")" -ge $((seeds + ${#writes[@]} + 6)) ]

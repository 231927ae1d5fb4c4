#!/usr/bin/env bash
# The long runs that are too long for every change: random events on the window with a watch on every memory access,
# random editing undone and redone, kills while studies, results, archives, directories and campaigns are written, a
# cluster that is killed under its campaigns, two programs on one place, a disk that runs full at every write, interrupts
# at random moments, and files that are nearly sound under the address and undefined-behaviour sanitizers. As many at once
# as there are cores; about two hours on two.
#   packaging/soak.sh [SEEDS] [EVENTS] [SEQUENCES] [KILLS] [INTERRUPTS] [MUTANTS]     (20 50000 2000 3000 200 10000)
#   packaging/soak.sh --quick                                                         (1 500 20 20 20 300)
# Writes build/soak/summary.log and one log for each run; fails where one of them fails or did not run its tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source packaging/install.sh
[ "${1:-}" != --quick ] || set -- 1 500 20 20 20 300
seeds=${1:-20} events=${2:-50000} sequences=${3:-2000} kills=${4:-3000} interrupts=${5:-200} mutants=${6:-10000}

install_missing "${build_packages[@]}"
say "Building with the sanitizers in build/asan, and plainly in build/release"
cmake --preset asan -DCMAKE_UNITY_BUILD=ON
cmake --build --preset asan --target test_ui test_study test_archive test_measure test_campaign
cmake --preset release -DCMAKE_UNITY_BUILD=ON
cmake --build --preset release --target test_ui test_archive test_study test_base test_app test_export

export QT_QPA_PLATFORM=offscreen
export ASAN_OPTIONS=detect_leaks=0:malloc_context_size=3:quarantine_size_mb=64
export UBSAN_OPTIONS=print_stacktrace=1
logs=build/soak
rm -rf "$logs"
mkdir -p "$logs"
: >"$logs/summary.log"
started=0

# run NAME PROGRAM FILTER [VARIABLE=VALUE…]: a run that chose no test, or left one out, counts as failed. PROGRAM may be
# words: what starts the tests, then they.
run() {
    local name=$1 program=$2 filter=$3 status=0 begin=$SECONDS
    shift 3
    # shellcheck disable=SC2086  # words
    env "$@" $program --gtest_filter="$filter" >"$logs/$name.log" 2>&1 || status=$?
    if [ "$status" -eq 0 ]; then
        grep -q '^\[  PASSED  \] [1-9]' "$logs/$name.log" || status='0, but no test was run'
        ! grep -q '^\[  SKIPPED \]' "$logs/$name.log" || status='0, but a test was left out'
    fi
    printf '%s: exit %s; %s s; %s\n' "$name" "$status" $((SECONDS - begin)) \
        "$(grep -m1 -E 'events of seed|runs were interrupted|mutants,' "$logs/$name.log" || true)" |
        tee -a "$logs/summary.log"
}

# The same beside the others, once a core is free for it.
start() {
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do
        wait -n || true
    done
    started=$((started + 1))
    run "$@" &
}

# Kills that leave something, or something mixed: NAME PROGRAM TEST
writes=(
    "kills test_archive Archive.IsOldOrNewWhenTheProgramIsKilled"
    "kills-history test_archive Archive.AndItsHistoryAreWholeWhenTheProgramIsKilled"
    "kills-unpack test_archive Archive.IsUnpackedWholeOrNotAtAllWhenTheProgramIsKilled"
    "kills-directory test_study StudyFiles.SurviveKills"
    "kills-results test_study Results.AreOldOrNewWhenTheProgramIsKilled"
    "kills-discover test_app DiscoverThatIsKilled.IsOldOrNew"
    "kills-campaign test_app CampaignCommandLine.LosesNothingAndDoesNothingTwiceWhenItIsKilled"
    "kills-window test_ui WindowSaves.OldOrNewWhereverItIsKilled"
    "kills-own test_base OwnedDirectories.LeaveNothingWhereverTheirMakerIsKilled"
)
# Files that are nearly sound: NAME PROGRAM TEST
nearly=(
    "mutants-study test_study Mutants.OfStudiesEndInATaskOrInMessages"
    "mutants-model test_study Mutants.OfModelsEndInATaskOrInMessages"
    "mutants-table test_study Mutants.OfMeasurementsEndInATaskOrInMessages"
    "mutants-text test_measure RecordingMutants.OfTextEndInValuesOrInMessages"
    "mutants-mdf4 test_measure RecordingMutants.OfMdf4EndInValuesOrInMessages"
    "mutants-mdf3 test_measure RecordingMutants.OfMdf3EndInValuesOrInMessages"
    "mutants-tdms test_measure RecordingMutants.OfTdmsEndInValuesOrInMessages"
    "mutants-mat4 test_measure RecordingMutants.OfMatlab4EndInValuesOrInMessages"
    "mutants-mat5 test_measure RecordingMutants.OfMatlab5EndInValuesOrInMessages"
    "mutants-mat7 test_measure RecordingMutants.OfMatlab7EndInValuesOrInMessages"
    "mutants-mat73 test_measure RecordingMutants.OfMatlab73EndInValuesOrInMessages"
    "mutants-xlsx test_measure RecordingMutants.OfArchivesOfSheetsEndInValuesOrInMessages"
    "mutants-sheets test_measure RecordingMutants.OfSheetsEndInValuesOrInMessages"
    "mutants-archive test_archive Mutants.OfArchivesEndInAStudyOrInMessages"
    "mutants-archived test_archive Mutants.InArchivesEndInAStudyOrInMessages"
    "mutants-campaign test_campaign CampaignMutants.EndInATableOrInMessages"
)

say "Random events: $seeds times $events; random editing: $sequences sequences; kills while writing: $kills of each
kind; interrupts: 4 times $interrupts; mutants: $mutants of each kind"
for each in "${nearly[@]}"; do
    read -r name program filter <<<"$each"
    start "$name" "build/asan/tests/$program" "$filter" ANALOGON_MUTANTS="$mutants" \
        ASAN_OPTIONS="$ASAN_OPTIONS:abort_on_error=1:hard_rss_limit_mb=1024:allocator_may_return_null=1"
done
for each in "${writes[@]}"; do
    read -r name program filter <<<"$each"
    start "$name" "build/release/tests/$program" "$filter" ANALOGON_KILLS="$kills"
done
start two-programs build/release/tests/test_study '*TwoPrograms*' GTEST_REPEAT=20
if [ "$(id -u)" -eq 0 ]; then
    for program in test_archive test_export test_app test_ui; do
        start "full-disk-$program" "build/release/tests/$program" 'FullDisk.*' ANALOGON_DISK_STEP=4096
    done
else
    say "A disk that runs full is left out: root alone can make a small one"
fi
# Campaigns on a Slurm of its own, whose nodes and controller are killed while they run.
if [ "$(id -u)" -eq 0 ] && PATH=$PATH:/usr/sbin command -v slurmctld >/dev/null; then
    start kills-cluster "tests/slurm/start.sh build/release/tests/test_app" 'CampaignOnSlurm.*' \
        GTEST_REPEAT=$(((kills + 299) / 300))
else
    say "Campaigns on a cluster are left out: they need root, slurm-wlm and munge"
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
say "$(grep -c ': exit 0; ' "$logs/summary.log" || true) of $started runs have ended well"
if grep -v ': exit 0; ' "$logs/summary.log"; then exit 1; fi
[ "$(wc -l <"$logs/summary.log")" -eq "$started" ]

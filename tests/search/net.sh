#!/usr/bin/env bash
# What the search decides on a fixed set of studies, on one and on four threads.
#
#   net.sh prepare STUDIES            writes the studies of studies.txt
#   net.sh record STUDIES DIR         searches each of them; goes on where it was stopped
#   net.sh compare BEFORE AFTER       prints each difference; exit status 1 where there is one
#   net.sh condense DIR OUT           the same for a repository: small, and still readable where it differs
#
# BUILD (default: build/release) holds the programs. The shared recordings are read from SHARED (default: ../shared
# beside the repository); without them their studies are left out, and said.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
build=${BUILD:-$root/build/release}
shared=${SHARED:-$root/../shared}
threads=(1 4)

usage() { sed -n '2,10p' "${BASH_SOURCE[0]}"; exit 2; }

# What a study may be searched with: never its truth.
copyStudy() { # FROM TO
    mkdir -p "$2"
    find "$1" -maxdepth 1 -type f \( -name 'study.json' -o -name '*.mo' -o -name '*.csv' \) -exec cp {} "$2/" \;
}

# Hidden effects by the bench; the name is that of the series and the number in it.
prepareBench() { # STUDIES SEED COUNT CLASS
    local made
    made=$(mktemp -d)
    cmake -S "$root/tests/bench" -B "$1/.bench" -DCMAKE_BUILD_TYPE=Release > /dev/null
    cmake --build "$1/.bench" > /dev/null
    "$1/.bench/generate_cases" --out "$made" --seed "$2" --count "$3" --class "$4" --no-twins > /dev/null
    for case in "$made"/*/; do copyStudy "$case" "$1/$(basename "$case")"; done
    rm -rf "$made"
}

# The recordings that the discovery tests make: each leaves its study behind, and need not search it.
prepareTest() { # STUDIES TEST
    ANALOGON_KEEP_STUDIES=$1/.kept "$build/tests/test_study" --gtest_filter="$2" > /dev/null || true
    local kept=$1/.kept/$2
    [ -d "$kept" ] || { echo "$2: it left no study" >&2; return; }
    copyStudy "$kept" "$1/$2"
}

prepare() { # STUDIES
    mkdir -p "$1"
    local studies what name more
    studies=$(realpath "$1")
    while read -r what name more; do
        case $what in
            '' | '#'*) ;;
            bench) prepareBench "$studies" "$name" $more ;;
            test) prepareTest "$studies" "$name" ;;
            example) copyStudy "$root/examples/$name" "$studies/$name" ;;
            shared)
                if [ -d "$shared/$name" ]; then copyStudy "$shared/$name" "$studies/$(basename "$name")"
                else echo "$name: not there, left out" >&2; fi ;;
            *) echo "studies.txt: $what is unknown" >&2; exit 2 ;;
        esac
    done < "$here/studies.txt"
}

# Work is limited, not time: the same on any machine. Millions of steps of the trials.
limit=${MOST_WORK:-400}

record() { # STUDIES DIR
    mkdir -p "$2"
    for study in "$1"/*/; do
        local name
        name=$(basename "$study")
        for t in "${threads[@]}"; do
            [ -f "$2/$name-$t.txt" ] && continue
            local run="$2/runs/$name-$t" status=0
            mkdir -p "$2/runs"
            "$build/app/analogon-cli" discover "$study" --out "$run" --threads "$t" --most-work "$limit" \
                --trace "$run.jsonl" > "$run.log" 2>&1 || status=$?
            if [ $status -ne 0 ]; then
                echo "$name on $t threads: exit status $status ($(tail -n 1 "$run.log"))"
                continue
            fi
            "$build/tests/search/search_net" summarise "$run/report.json" "$run.jsonl" "$2/$name-$t.txt"
            rm -rf "$run" "$run.jsonl" "$run.log"
            echo "$name on $t threads"
        done
    done
}

[ $# -ge 1 ] || usage
case $1 in
    prepare) [ $# -eq 2 ] || usage; prepare "$2" ;;
    record) [ $# -eq 3 ] || usage; record "$2" "$3" ;;
    compare | condense) [ $# -eq 3 ] || usage; "$build/tests/search/search_net" "$@" ;;
    *) usage ;;
esac

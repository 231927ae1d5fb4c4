#!/bin/sh
# Generates fresh cases, lets the program search each for its missing effect, and scores the reports.
#
#   run_bench.sh CLI DIR [-n COUNT] [-s SEED] [-t SECONDS] [-j JOBS] [-- OPTIONS OF generate_cases]
#
# CLI is analogon-cli; DIR receives build/, cases/, results/ and score.txt. A case is not run again when its report is
# there and newer than CLI, so that an interrupted bench goes on where it stopped.
set -eu

[ $# -ge 2 ] || { sed -n '2,8p' "$0"; exit 2; }
here=$(cd "$(dirname "$0")" && pwd)
cli=$(realpath "$1")
mkdir -p "$2"
dir=$(realpath "$2")
shift 2
count=100 seed=1 limit=300 jobs=2
while [ $# -gt 0 ]; do
    case $1 in
        -n) count=$2; shift 2 ;;
        -s) seed=$2; shift 2 ;;
        -t) limit=$2; shift 2 ;;
        -j) jobs=$2; shift 2 ;;
        --) shift; break ;;
        *) echo "run_bench.sh: unknown option $1" >&2; exit 2 ;;
    esac
done

cmake -S "$here" -B "$dir/build" -DCMAKE_BUILD_TYPE=Release > /dev/null
cmake --build "$dir/build" > /dev/null
request="$count $seed $*"
if [ "$(cat "$dir/request.txt" 2> /dev/null || true)" != "$request" ]; then
    rm -rf "$dir/cases" "$dir/results"
    mkdir -p "$dir/cases" "$dir/results"
    "$dir/build/generate_cases" --out "$dir/cases" --seed "$seed" --count "$count" "$@" > "$dir/cases.txt"
    echo "$request" > "$dir/request.txt"
fi

# One case; the truth stays out of the folder that the program sees.
cat > "$dir/one.sh" <<'ONE'
set -u
cli=$1 dir=$2 limit=$3 name=$4
out="$dir/results/$name"
[ -f "$out/report.json" ] && [ "$out/report.json" -nt "$cli" ] && exit 0
rm -rf "$out"
mkdir -p "$out"
study=$(mktemp -d)
for f in study.json model.mo train.csv validation.csv; do cp "$dir/cases/$name/$f" "$study/"; done
begin=$(date +%s.%N)
timeout -k 15 "$limit" "$cli" discover "$study" --out "$out" > "$out/log.txt" 2>&1
echo $? > "$out/status.txt"
echo "$(date +%s.%N) $begin" | awk '{ printf "%.2f\n", $1 - $2 }' > "$out/seconds.txt"
rm -rf "$study"
ONE

ls "$dir/cases" | xargs -P "$jobs" -I NAME sh "$dir/one.sh" "$cli" "$dir" "$limit" NAME
python3 "$here/score.py" "$dir/results" "$dir/cases" --list > "$dir/score.txt"
cat "$dir/score.txt"

"""Holds the line coverage of core against its stored floor.

    coverage.py BUILD FLOORS [--store] STAGE...

Runs BUILD/tests/test_STAGE, compiled with --coverage, and counts by gcovr the lines of core/STAGE that it reaches: what
a stage's own tests reach, not what others happen to pass through. FLOORS holds a line "STAGE PERCENT" a stage. A stage
below its floor, or without one, fails the run; --store writes what is measured, rounded down to whole percent. Tests
that fail are told and counted all the same: this build is many times slower than the one that limits of time are for,
and whether tests pass is for the gate. A program that does not come to its end leaves no counts, and fails the run.
"""
import json
import os
import subprocess
import sys


def floors_of(path):
    with open(path, encoding="utf-8") as f:
        lines = [line.split("#")[0].split() for line in f]
    return {words[0]: float(words[1]) for words in lines if words}


def forget(build):
    for folder, _, files in os.walk(build):
        for name in files:
            if name.endswith(".gcda"):
                os.remove(os.path.join(folder, name))


def percent_reached(build, stage):
    forget(build)
    test = subprocess.run([f"{build}/tests/test_{stage}", "--gtest_brief=1"], stdout=subprocess.PIPE, text=True,
                          check=False)
    if test.returncode not in (0, 1):
        sys.exit(f"{test.stdout}error: test_{stage} ended with {test.returncode}; its coverage says nothing")
    failed = sorted({line.split()[3] for line in test.stdout.splitlines() if line.startswith("[  FAILED  ] ") and "." in line})
    if failed:
        print(f"test_{stage}: failed here, which is not judged: {', '.join(failed)}", flush=True)
    folders = [f"{build}/core/CMakeFiles/analogon_{stage}.dir", f"{build}/tests/CMakeFiles/test_{stage}.dir"]
    # gcov writes some numbers of branches below zero, which gcovr takes for a fault; lines alone count here
    gcovr = subprocess.run(["gcovr", "--root", ".", "--filter", f"core/{stage}/", "--gcov-ignore-parse-errors",
                            "--json-summary", "-", *folders],
                           stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if gcovr.returncode:
        sys.exit(f"{gcovr.stderr[-2000:]}error: gcovr cannot read what test_{stage} left")
    summary = json.loads(gcovr.stdout)
    if not summary["line_total"]:
        sys.exit(f"error: no line of core/{stage} was counted")
    return 100.0 * summary["line_covered"] / summary["line_total"], summary["line_total"]


def store(path, floors):
    with open(path, encoding="utf-8") as f:
        comments = [line for line in f if line.startswith("#")]
    with open(path, "w", encoding="utf-8") as f:
        f.writelines(comments + [f"{stage} {floor:.0f}\n" for stage, floor in floors.items()])


def main(arguments):
    words = [a for a in arguments if a != "--store"]
    if len(words) < 3:
        print(__doc__)
        return 2
    build, path, stages = words[0], words[1], words[2:]
    floors = floors_of(path)
    fallen = []
    for stage in stages:
        percent, lines = percent_reached(build, stage)
        floor = floors.get(stage)
        told = "-" if floor is None else f"{floor:.0f} %"
        print(f"core/{stage:<10} {percent:5.1f} % of {lines} lines, floor {told}", flush=True)
        if floor is None or percent < floor:
            fallen.append(stage)
        if "--store" in arguments:
            floors[stage] = float(int(percent))
    if "--store" in arguments:
        store(path, floors)
        return 0
    if fallen:
        print(f"error: below the floor of {path}, or without one there: {' '.join(fallen)}. "
              f"Test what is new, or write the floor with --store")
    return 1 if fallen else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/env python3
"""Which test notices when a threshold of the search is off: each is set to a multiple of its value, one at a time.

  cmake --preset release -B build/thresholds -DANALOGON_SETTABLE_THRESHOLDS=ON && cmake --build build/thresholds --target test_effect
  tests/thresholds.py build/thresholds [--only GROUP.NAME,…] [--factors 3,0.333] [--jobs 2] [--tests SUITE.*:…] [--skip SUITE.*:…]

Prints a row "GROUP.NAME FACTOR TEST" for each: the first test that fails, and at which multiple; "-" where none of
test_effect does. The tests beside the sources
that use a threshold are asked first. What is found belongs into the last column of core/effect/thresholds.def.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent


def rows():
    table = (ROOT / "core/effect/thresholds.def").read_text()
    return re.findall(r"^THRESHOLD\((\w+), [\w:]+, (\w+),", table, re.M)


def suites_beside(name):
    """Suites of the test files that mirror the sources in which a threshold is named."""
    found = set()
    for source in (ROOT / "core/effect").rglob("*.cpp"):
        if not re.search(rf"\b{name}\b", source.read_text()):
            continue
        test = ROOT / "tests" / source.relative_to(ROOT).with_name(source.stem + "_test.cpp")
        if test.exists():
            found |= set(re.findall(r"^TEST(?:_F|_P)?\((\w+),", test.read_text(), re.M))
    return found


def first_failure(program, threshold, factor, tests, seconds):
    """The first test that fails, "-" for none, "(…)" where the program ends otherwise."""
    command = [program, "--gtest_fail_fast", "--gtest_brief=1", "--gtest_filter=" + tests]
    environment = {**os.environ, "ANALOGON_THRESHOLD": f"{threshold} {factor}"}
    try:
        run = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return "(time)"
    if run.returncode == 0:
        return "-"
    failed = re.search(r"\[  FAILED  \] ([\w/]+\.[\w/]+)", run.stdout)
    return failed.group(1) if failed else f"(ended with {run.returncode})"


def examine(program, tests, skip, seconds, threshold, factors):
    """The first factor of which a test takes notice, and that test."""
    beside = sorted(suites_beside(threshold.split(".")[1]))
    asked = [f"{tests}-{skip}"]
    if beside and tests == "*":
        first = ":".join(s + ".*" for s in beside)
        asked = [f"{first}-{skip}", f"*-{skip}:{first}"]
    for wanted in asked:
        for factor in factors:
            found = first_failure(program, threshold, factor, wanted, seconds)
            if found != "-":
                return factor, found
    return "-", "-"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build")
    parser.add_argument("--only", default="")
    parser.add_argument("--factors", default="3,0.333")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--tests", default="*")
    parser.add_argument("--skip", default="Thresholds.*")
    parser.add_argument("--seconds", type=float, default=600)
    given = parser.parse_args()
    program = str(pathlib.Path(given.build).resolve() / "tests/test_effect")
    only = set(filter(None, given.only.split(",")))
    wanted = [f"{g}.{n}" for g, n in rows() if not only or f"{g}.{n}" in only]
    factors = given.factors.split(",")
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        results = pool.map(lambda name: examine(program, given.tests, given.skip, given.seconds, name, factors), wanted)
        for name, (factor, found) in zip(wanted, results):
            print(name, factor, found, flush=True)


if __name__ == "__main__":
    main()

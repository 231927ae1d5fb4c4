#!/usr/bin/env python3
"""A campaign of water pumps that is killed again and again, against one that is left alone.

    thousand_units.py CLI DIR [--units N] [--alone N] [--command fit|discover] [--kills N] [--jobs N] [--seed N]
                      [--slurm]

Makes the units (pump_units.py: own equations; 5 % with dry friction, three odd), runs their campaign undisturbed on
this machine, and once more with kills (signal 9) at random moments: of the program and of a process that works on
units; with --slurm, under tests/slurm/start.sh, of the program, of a node and of the controller. With --alone so many
of the units only (the odd ones, up to a third with friction, the first of the others) are undisturbed, as a campaign
of their own and one after another. Fails unless

  - results.csv of both is the same byte by byte (with --alone what it says of each of those units), and no record of a
    unit that was done is lost or written again;
  - each odd unit is named, and at most 1 % of the others (of those without friction where fits alone are made, which
    lack it);
  - a fit with all that a campaign does for it takes at most 50 ms of a processor (undisturbed, on this machine);
  - with discover, friction is found in nine of ten units that have it, and nothing in 98 of a hundred that have none. A
    pump that never turns back does not tell it from a constant torque: as in score.py it is found where it is named or
    is among the effects that the report calls equivalent.

Needs only the standard library. DIR must not be there.
"""
import argparse
import csv
import json
import os
import random
import resource
import signal
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
MOST_MILLISECONDS = 50


def records(out):
    """Of each unit that is done: when its record was written, and which file it is."""
    found = {}
    folder = os.path.join(out, "units")
    for unit in os.listdir(folder) if os.path.isdir(folder) else []:
        path = os.path.join(folder, unit, "unit.json")
        try:
            with open(path, encoding="utf-8") as stream:
                if json.load(stream)["fault"] == "":
                    status = os.stat(path)
                    found[unit] = (status.st_mtime_ns, status.st_ino)
        except FileNotFoundError:
            pass
    return found


def content(path):
    with open(path, "rb") as stream:
        return stream.read()


def children(pid):
    try:
        with open(f"/proc/{pid}/task/{pid}/children", encoding="utf-8") as stream:
            return [int(child) for child in stream.read().split()]
    except OSError:
        return []


def running_on(node):
    """What runs on a node of this Slurm, with the process of Slurm above it."""
    found = set()
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            environment = content(f"/proc/{name}/environ").split(b"\0")
            if (b"SLURMD_NODENAME=" + node.encode() not in environment
                    or b"SLURM_CONF=" + os.environ["SLURM_CONF"].encode() not in environment):
                continue
            found.add(int(name))
            status = content(f"/proc/{name}/status").decode()
            above = status.split("\nPPid:")[1].split()[0]
            if content(f"/proc/{above}/comm").startswith(b"slurmstepd"):
                found.add(int(above))
        except (FileNotFoundError, ProcessLookupError, PermissionError):
            pass  # it has ended
    return found


def kill(pid):
    try:
        os.kill(pid, signal.SIGKILL)
        return True
    except ProcessLookupError:
        return False


class Campaign:
    """The campaign that is killed, and what is known of its units so far."""

    def __init__(self, options, units):
        self.options, self.units = options, units
        self.out = os.path.join(options.directory, "killed")
        self.log = open(os.path.join(options.directory, "killed.log"), "a", encoding="utf-8")
        self.known, self.kills, self.faults = {}, {}, []
        self.process = None

    def start(self, *more):
        o = self.options
        self.begin = os.path.getsize(self.log.name)
        where = ["--slurm"] if o.slurm else ["--jobs", str(o.jobs)]
        words = [o.cli, "campaign", os.path.join(o.directory, "campaign.json"), "--out", self.out, *where,
                 "--progress", "none", *more]
        self.process = subprocess.Popen(words, stdout=self.log, stderr=self.log)

    def said(self):
        with open(self.log.name, encoding="utf-8") as stream:
            return stream.read()[self.begin:]

    def look(self):
        """Holds what is on disk against what was seen before."""
        now = records(self.out)
        for unit, record in self.known.items():
            if unit not in now:
                self.faults.append(f"{unit} was done and is lost")
            elif now[unit] != record:
                self.faults.append(f"{unit} was done and is done again")
        self.known = now

    def wait_for(self, count):
        """Until so many units are done; False: the program has ended before."""
        while len(records(self.out)) < count:
            if self.process.poll() is not None:
                return False
            time.sleep(0.05 + 0.0005 * count)
        return True

    def strike(self, victim, draw):
        self.kills[victim] = self.kills.get(victim, 0) + 1
        slurm = os.environ.get("ANALOGON_SLURM", "")
        if victim == "program":
            kill(self.process.pid)
            self.process.wait()
            time.sleep(0.2)  # its own processes end with it
            self.look()
            self.start()
        elif victim == "worker":
            workers = children(self.process.pid)
            if workers:
                kill(draw.choice(workers))
            self.look()
        else:
            number = draw.choice("12") if victim == "node" else ""
            daemon = int(content(os.path.join(slurm, f"{victim}{number}.pid")))
            for pid in [daemon, *(running_on(f"node{number}") if number else [])]:  # as if its power failed
                kill(pid)
            self.look()
            time.sleep(2)
            subprocess.run([os.environ["ANALOGON_SLURM_START"], victim, number], check=False)
            subprocess.run([os.environ["ANALOGON_SLURM_START"], "resume"], check=False)

    def run(self):
        draw = random.Random(self.options.seed)
        victims = ["program", "node", "controller"] if self.options.slurm else ["program", "worker"]
        moments = sorted(draw.sample(range(1, max(2, int(0.95 * self.units))), self.options.kills))
        self.start()
        for n, moment in enumerate(moments):
            if not self.wait_for(moment):
                self.faults.append(f"the program ended before {moment} units were done")
                break
            time.sleep(draw.uniform(0, 0.1))
            self.strike(victims[n % len(victims)], draw)
        status = self.process.wait()
        self.look()
        if status == 0 and len(self.known) < self.units:  # units whose process was killed have failed
            self.start("--retry")
            status = self.process.wait()
            self.look()
        if status:
            self.faults.append(f"the program ended with {status}")


def undisturbed(options, name="campaign.json", jobs=None):
    """The processor time [s] of the program and its processes."""
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    before = used()
    run = subprocess.run([options.cli, "campaign", os.path.join(options.directory, name), "--out",
                          os.path.join(options.directory, "whole"), "--jobs", str(jobs or options.jobs),
                          "--progress", "none"],
                         stdout=subprocess.PIPE, text=True, check=False)
    if run.returncode:
        sys.exit(f"{run.stdout}error: the undisturbed campaign ended with {run.returncode}")
    return used() - before


def read_table(path):
    with open(path, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def write_alone(options):
    """The campaign of the units that are left alone."""
    truth = read_table(os.path.join(options.directory, "truth.csv"))
    rank = {row["serial"]: (0 if row["odd"] else 1 if float(row["tau_c"]) > 0 else 2) for row in truth}
    odd, friction, others = ([unit for unit in rank if rank[unit] == r] for r in range(3))
    kept = set((odd + friction[:options.alone // 3] + others)[:options.alone])
    rows = [row for row in read_table(os.path.join(options.directory, "units.csv")) if row["serial"] in kept]
    with open(os.path.join(options.directory, "alone.csv"), "w", newline="", encoding="utf-8") as stream:
        table = csv.DictWriter(stream, list(rows[0]))
        table.writeheader()
        table.writerows(rows)
    with open(os.path.join(options.directory, "campaign.json"), encoding="utf-8") as stream:
        campaign = json.load(stream)
    with open(os.path.join(options.directory, "alone.json"), "w", encoding="utf-8") as stream:
        json.dump(campaign | {"units": "alone.csv"}, stream, indent=2)


def differing(options, out):
    """The units of which the undisturbed campaign says something else; "all" where it has all units, and bytes differ."""
    whole, killed = (os.path.join(folder, "results.csv") for folder in (os.path.join(options.directory, "whole"), out))
    if options.alone == options.units:
        return [] if content(whole) == content(killed) else ["all"]
    def told(path):  # not every column is in both: a parameter of an effect has one where a unit has the effect
        return {row["unit"]: {name: text for name, text in row.items() if text} for row in read_table(path)}
    of_all = told(killed)
    return [unit for unit, row in told(whole).items() if of_all.get(unit) != row]


def kinds_in_report(out, unit):
    """Of the effects of a unit, and of those that its data cannot tell from them."""
    with open(os.path.join(out, "units", unit, "report.json"), encoding="utf-8") as stream:
        effects = json.load(stream)["effects"]
    chosen = {e["kind"] for e in effects}
    return chosen, {a["kind"] for e in effects for a in e.get("alternatives") or [] if a.get("equivalent") is True}


def judge(options, seconds, campaign):
    """The faults, after what was measured has been printed."""
    faults = campaign.faults[:20]
    truth = {row["serial"]: row for row in read_table(os.path.join(options.directory, "truth.csv"))}
    rows = {row["unit"]: row for row in read_table(os.path.join(campaign.out, "results.csv"))}
    searched = options.command == "discover"
    has_friction = {unit: float(row["tau_c"]) > 0 for unit, row in truth.items()}
    named = {line.split(":")[1].strip() for line in campaign.said().splitlines() if line.startswith("odd: ")}
    odd = {unit for unit, row in truth.items() if row["odd"]}
    others = {unit for unit in truth if unit not in odd and (searched or not has_friction[unit])}
    print(f"odd units named: {len(odd & named)} of {len(odd)}; others: {len(others & named)} of {len(others)}")
    if odd - named:
        faults.append(f"odd and not named: {' '.join(sorted(odd - named))}")
    if len(others & named) > 0.01 * len(others):
        faults.append(f"named without being odd: {' '.join(sorted(others & named))}")
    if searched:
        wrong = {unit for unit, row in rows.items() if row["effects"] and not has_friction[unit]}
        with_friction = {unit for unit, has in has_friction.items() if has}
        kinds = {unit: kinds_in_report(campaign.out, unit) for unit in with_friction}
        named_so = {unit for unit in with_friction if "friction.coulomb" in kinds[unit][0]}
        told = named_so | {unit for unit in with_friction if "friction.coulomb" in kinds[unit][1]}
        print(f"friction found in {len(told)} of {len(with_friction)} units that have it, in {len(named_so)} by name, "
              f"else as equivalent; effects in {len(wrong)} of {len(truth) - len(with_friction)} that have none")
        if len(told) < 0.9 * len(with_friction):
            faults.append(f"friction was not found: {' '.join(sorted(with_friction - told))}")
        if len(wrong) > 0.02 * (len(truth) - len(with_friction)):
            faults.append(f"effects that are none: {' '.join(sorted(wrong))}")
    each = 1000 * seconds / options.alone
    print(f"processor time: {seconds:.1f} s, {each:.1f} ms a unit with all that a campaign does")
    if not searched and each > MOST_MILLISECONDS:
        faults.append(f"{each:.1f} ms a unit, more than {MOST_MILLISECONDS}")
    if any(row["state"] != "done" for row in rows.values()):
        faults.append("not all units are done")
    differ = differing(options, campaign.out)
    kills = ", ".join(f"{count} of a {victim}" for victim, count in campaign.kills.items())
    print(f"kills: {kills}; units lost or done twice: {len(campaign.faults)}; "
          f"results.csv {'differs' if differ else 'is the same'} for {options.alone} units that were left alone")
    if differ:
        faults.append(f"results.csv differs: {' '.join(differ)}")
    if sum(campaign.kills.values()) < options.kills:
        faults.append("it was killed less often than was asked for")
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cli")
    parser.add_argument("directory")
    parser.add_argument("--units", type=int, default=1000)
    parser.add_argument("--alone", type=int)
    parser.add_argument("--command", choices=["fit", "discover"], default="fit")
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--slurm", action="store_true")
    o = parser.parse_args()
    o.cli, o.directory = os.path.abspath(o.cli), os.path.abspath(o.directory)
    if o.slurm and "ANALOGON_SLURM" not in os.environ:
        sys.exit("error: --slurm needs tests/slurm/start.sh around this command")
    os.makedirs(o.directory)
    subprocess.run([sys.executable, os.path.join(HERE, "pump_units.py"), o.directory, "--units", str(o.units), "--seed",
                    str(o.seed), "--command", o.command], check=True)
    o.alone = min(o.alone or o.units, o.units)
    if o.alone < o.units:
        write_alone(o)
        seconds = undisturbed(o, "alone.json", 1)
    else:
        seconds = undisturbed(o)
    campaign = Campaign(o, o.units)
    campaign.run()
    faults = judge(o, seconds, campaign)
    for fault in faults:
        print(f"error: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

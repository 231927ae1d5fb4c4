"""Scores reports against the truth of generated cases.

    score.py RESULTS CASES [--json] [--list] [--floor FILE]

RESULTS holds one folder a case with report.json (and, if there, seconds.txt with the wall time and status.txt with the
exit status); CASES one a case with truth.json. An effect counts as found when its kind and place are among the pairs
that the truth accepts; a report may also name it among the alternatives that it calls equivalent. Whatever stands in a
report beyond that is a wrong extra, unless the truth tolerates it. Intervals are Wilson's, 95 %. FILE holds the score
that is stored for these cases, "cases", "right", "alarms" and "extras" a line each; a worse one ends with status 1.
"""
import json
import math
import os
import sys
from collections import defaultdict

RHO_CLASSES = [(0.0, 0.4, "0.3"), (0.4, 0.75, "0.5"), (0.75, 1.5, "1"), (1.5, 3.0, "2"), (3.0, math.inf, "4")]


def wilson(hits, n, z=1.96):
    """Interval of a proportion (E. B. Wilson 1927)."""
    if n == 0:
        return 0.0, 1.0
    p = hits / n
    centre = p + z * z / (2 * n)
    half = z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
    return max(0.0, (centre - half) / (1 + z * z / n)), min(1.0, (centre + half) / (1 + z * z / n))


def rate(hits, n):
    if n == 0:
        return "-"
    low, high = wilson(hits, n)
    return "%4d/%-4d %5.1f %%  [%.0f, %.0f]" % (hits, n, 100.0 * hits / n, 100.0 * low, 100.0 * high)


def quantile(values, q):
    values = sorted(v for v in values if v is not None)
    if not values:
        return math.nan
    place = q * (len(values) - 1)
    below = int(place)
    above = min(below + 1, len(values) - 1)
    return values[below] + (place - below) * (values[above] - values[below])


def read(path):
    try:
        with open(path, encoding="utf-8") as f:
            return json.load(f)
    except (OSError, ValueError):
        return None


def text_of(path):
    try:
        with open(path, encoding="utf-8") as f:
            return f.read().strip()
    except OSError:
        return ""


def validation_error(block):
    """Root mean square of error_percent over the validation experiments."""
    squares = []
    for e in ((block or {}).get("experiments") or {}).values():
        if e.get("role") == "validate":
            value = e.get("error_percent")
            if not isinstance(value, (int, float)) or not math.isfinite(value):
                return None
            squares.append(value * value)
    return math.sqrt(sum(squares) / len(squares)) if squares else None


def accepted(pairs, kind, at):
    at = " ".join(str(at).split())
    return any(p["kind"] == kind and at in p["at"] for p in pairs)


def named(effect, with_equivalents):
    out = [(effect.get("kind"), effect.get("at"))]
    if with_equivalents:
        out += [(a.get("kind"), a.get("at")) for a in effect.get("alternatives") or [] if a.get("equivalent") is True]
    return out


def assign(hidden, effects, fits):
    """Which hidden effect is matched by which reported one: augmenting paths, so that the number is largest."""
    owner = {}

    def place(h, seen):
        for k, e in enumerate(effects):
            if k in seen or not fits(h, e):
                continue
            seen.add(k)
            if k not in owner or place(owner[k], seen):
                owner[k] = h_index[id(h)]
                return True
        return False

    h_index = {id(h): h for h in hidden}
    return owner, sum(place(h, set()) for h in hidden)


def judge(truth, report):
    row = {"case": truth["case"], "class": truth["class"], "variant": truth.get("variant", ""),
           "system": truth["system"], "hidden": [h["kind"] for h in truth["hidden"]],
           "rhos": [h.get("rho", 0.0) for h in truth["hidden"]], "failed": report is None,
           "top": 0, "found": 0, "kind_only": 0, "extra": 0, "right": False, "alarm": False}
    if report is None:
        return row
    effects = [e for e in report.get("effects") or [] if isinstance(e, dict)]
    pairs = truth["pairs_accepted"]
    row["finding"] = report.get("finding")
    row["chosen"] = ["%s @ %s" % (e.get("kind"), e.get("at")) for e in effects]
    row["top"] = assign(pairs, effects, lambda h, e: accepted(h, *named(e, False)[0]))[1]
    owner, row["found"] = assign(pairs, effects, lambda h, e: any(accepted(h, *n) for n in named(e, True)))
    row["kind_only"] = assign(pairs, effects, lambda h, e: any(p["kind"] == e.get("kind") for p in h))[1]
    found = [any(owner.get(k) is h for k in range(len(effects))) for h in pairs]
    row["each"] = found
    tolerated = truth.get("tolerated", [])
    row["extra"] = sum(k not in owner and not accepted(tolerated, e.get("kind"), e.get("at")) for k, e in enumerate(effects))
    row["before"], row["after"] = validation_error(report.get("baseline")), validation_error(report.get("final"))
    if row["after"] is None and not effects:
        row["after"] = row["before"]
    if row["after"] is not None:
        row["ratio"] = row["after"] / truth["floor"]["validation"]
    if row["before"] is not None and truth.get("baseline"):
        row["baseline_ratio"] = row["before"] / truth["baseline"]["validation"]
    if truth["class"] == "none":
        row["alarm"] = bool(effects)
        row["right"] = not effects and row["finding"] in truth.get("findings_accepted", ["adequate"])
    elif truth["class"] == "outside":
        worse = row["before"] is not None and row["after"] is not None and row["after"] > 1.02 * row["before"]
        halved = row["before"] is not None and row["after"] is not None and row["after"] <= 0.5 * row["before"]
        places = [at for h in truth["hidden"] for at in h.get("at", [])]
        remainder = report.get("remainder") or {}
        node = remainder.get("node", "")
        proposed = (remainder.get("error_percent_with_proposal") or {}).get("validate")
        if proposed is not None:
            row["proposed"] = proposed / truth["floor"]["validation"]
        if places:  # a component stands for its connectors
            row["node"] = bool(node) and any(at == node or at.startswith(node + ".") for at in places)
        row["right"] = halved or (row["finding"] in ("partial", "unexplained") and not worse)
    else:
        row["right"] = row["found"] == len(pairs) and row["extra"] == 0
    return row


def gather(results, cases):
    rows = []
    for name in sorted(os.listdir(cases)):
        truth = read(os.path.join(cases, name, "truth.json"))
        if truth is None:
            continue
        row = judge(truth, read(os.path.join(results, name, "report.json")))
        seconds = text_of(os.path.join(results, name, "seconds.txt"))
        row["seconds"] = float(seconds) if seconds else None
        row["status"] = text_of(os.path.join(results, name, "status.txt"))
        rows.append(row)
    return rows


def by_effect(rows, key):
    """Found and all, grouped by key(row, index of the hidden effect)."""
    groups = defaultdict(lambda: [0, 0])
    for r in rows:
        for k in range(len(r["hidden"])):
            g = groups[key(r, k)]
            g[0] += bool(r.get("each", [False] * len(r["hidden"]))[k])
            g[1] += 1
    return groups


def rho_class(rho):
    return next(name for low, high, name in RHO_CLASSES if low <= rho < high)


def spread(values, form="%.3f"):
    values = [v for v in values if v is not None]
    if not values:
        return "-"
    return ("median " + form + ", 90th percentile " + form + ", largest " + form) % (
        quantile(values, 0.5), quantile(values, 0.9), max(values))


def worsened(row):
    return None not in (row.get("before"), row.get("after")) and row["after"] > 1.05 * row["before"]


def show(rows):
    beside = [r for r in rows if r["class"] == "single" and r["variant"] == "disturbed" and not r["failed"]]
    effect = [r for r in rows if r["class"] in ("single", "double") and r["variant"] == ""]
    n = sum(len(r["hidden"]) for r in effect)
    late = sum(r["status"] in ("124", "130", "137") for r in rows)
    print("cases %d, without a report %d, stopped at the time limit %d" % (len(rows), sum(r["failed"] for r in rows), late))
    print("\nidentification (kind and place)")
    print("  chosen first             " + rate(sum(r["top"] for r in effect), n))
    print("  chosen or equivalent     " + rate(sum(r["found"] for r in effect), n))
    print("  kind alone               " + rate(sum(r["kind_only"] for r in effect), n))
    print("  whole case, no extra     " + rate(sum(r["right"] for r in effect), len(effect)))
    print("  cases with wrong extras  " + rate(sum(r["extra"] > 0 for r in effect), len(effect)))
    for cls in ("single", "double"):
        some = [r for r in effect if r["class"] == cls]
        print("  %-25s" % cls + rate(sum(r["right"] for r in some), len(some)))
    for title, key in (("rho", lambda r, k: rho_class(r["rhos"][k])), ("system", lambda r, k: r["system"]),
                       ("kind", lambda r, k: r["hidden"][k])):
        print("\nfound (chosen or equivalent) by " + title)
        for name, (hits, total) in sorted(by_effect(effect, key).items()):
            print("  %-33s " % name + rate(hits, total))
    print("\nnothing in the library is missing: false alarms")
    for variant in ("", "coloured", "disturbed"):
        # a search that failed gave no alarm because it gave nothing
        some = [r for r in rows if r["class"] == "none" and r["variant"] == variant and not r["failed"]]
        print("  %-25s" % (variant or "white noise") + rate(sum(r["alarm"] for r in some), len(some)) +
              ", of them right " + rate(sum(r["right"] for r in some), len(some)))
    print("\nan effect beside an unmeasured flow that leaves as much")
    print("  named, or equivalent     " + rate(sum(r["found"] for r in beside), len(beside)))
    print("  kind alone               " + rate(sum(r["kind_only"] for r in beside), len(beside)))
    print("  with a wrong extra       " + rate(sum(r["extra"] > 0 for r in beside), len(beside)))
    print("  nothing named            " + rate(sum(not r.get("chosen") for r in beside), len(beside)))
    print("  validation worse by 5 %  " + rate(sum(worsened(r) for r in beside), len(beside)))
    print("  error after / that of the true model: " + spread([r.get("ratio") for r in beside]))
    outside = [r for r in rows if r["class"] == "outside" and not r["failed"]]
    print("\noutside the library: judged honestly " + rate(sum(r["right"] for r in outside), len(outside)))
    print("  given a library name     " + rate(sum(bool(r.get("chosen")) for r in outside), len(outside)))
    placed = [r for r in outside if "node" in r]
    print("  its place is told        " + rate(sum(r["node"] for r in placed), len(placed)))
    print("\nvalidation error after / floor")
    print("  cases with an effect: " + spread([r.get("ratio") for r in effect]))
    print("  all found:            " + spread([r.get("ratio") for r in effect if r["right"]]))
    print("  no effect:            " + spread([r.get("ratio") for r in rows if r["class"] == "none"]))
    equations = [r["proposed"] for r in outside if "proposed" in r]
    print("  with the equation proposed for what the library lacks (%d of %d): " % (len(equations), len(outside)) +
          spread(equations))
    print("own fit of the base model, validation error over ours: " + spread([r.get("baseline_ratio") for r in rows]))
    print("time [s]: " + spread([r["seconds"] for r in rows], "%.1f"))


def list_cases(rows):
    for r in rows:
        mark = "FAILED" if r["failed"] else "ok" if r["right"] else "MISS"
        hidden = ", ".join("%s (%.2g)" % pair for pair in zip(r["hidden"], r["rhos"]))
        print("%-16s %-6s %-9s %-18s %-44s -> %-11s %s%s%s" % (
            r["case"], mark, r["class"] + ("-" + r["variant"] if r["variant"] else ""), r["system"][:18], hidden or "-",
            r.get("finding", "status " + r["status"]), "; ".join(r.get("chosen", [])),
            "  x%.3f" % r["ratio"] if r.get("ratio") else "", "  %.1f s" % r["seconds"] if r["seconds"] else ""))


def falls_below(rows, path):
    """What is worse than the stored score, as lines; other cases than those it is for are worse, too."""
    with open(path, encoding="utf-8") as f:
        stored = {words[0]: int(words[1]) for words in (line.split("#")[0].split() for line in f) if words}
    now = {"cases": len(rows), "right": sum(r["right"] for r in rows), "alarms": sum(r["alarm"] for r in rows),
           "extras": sum(r["extra"] for r in rows)}
    worse = {"cases": now["cases"] != stored["cases"], "right": now["right"] < stored["right"],
             "alarms": now["alarms"] > stored["alarms"], "extras": now["extras"] > stored["extras"]}
    return ["%s: %d, stored %d" % (name, now[name], stored[name]) for name in worse if worse[name]]


def main(arguments):
    floor = None
    if "--floor" in arguments:
        place = arguments.index("--floor")
        floor = arguments[place + 1]
        arguments = arguments[:place] + arguments[place + 2:]
    folders = [a for a in arguments if not a.startswith("--")]
    if len(folders) != 2:
        print(__doc__)
        return 2
    rows = gather(*folders)
    if "--json" in arguments:
        print(json.dumps(rows, indent=1))
        return 0
    if "--list" in arguments:
        list_cases(rows)
        print()
    show(rows)
    worse = falls_below(rows, floor) if floor else []
    for line in worse:
        print("error: worse than the stored score of %s: %s" % (floor, line))
    return 1 if worse else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

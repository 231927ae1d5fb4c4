"""Compares the generator's own equations with recordings that others made.

    check_public.py CASES GENERATOR [ID ...]

CASES holds studies with a truth.json; GENERATOR is the built generate_cases. Every case is simulated with its true
values and its hidden effect; the residual is printed as a part of the stated noise (1.00: the equations agree).
"""
import csv
import json
import math
import os
import subprocess
import sys
import tempfile


def to_model_unit(value, unit):
    scale = {"mA": 1e-3, "mV": 1e-3, "rpm": math.pi / 30, "deg": math.pi / 180, "%": 0.01}
    return value + 273.15 if unit == "degC" else value * scale.get(unit, 1.0)


def table(path):
    """Columns by name, in the model's units."""
    with open(path, encoding="utf-8") as f:
        text = f.read().splitlines()
    semicolon = ";" in text[0]
    rows = list(csv.reader(text, delimiter=";" if semicolon else ","))
    if semicolon:
        head, units, rows = rows[0], rows[1], [[x.replace(",", ".") for x in r] for r in rows[2:]]
    else:
        head = [h.split(" [")[0] for h in rows[0]]
        units = [h.split("[")[1].rstrip("]") for h in rows[0]]
        rows = rows[1:]
    return {h: [to_model_unit(float(r[k]), u) for r in rows] for k, (h, u) in enumerate(zip(head, units))}


def signals(model):
    names = {"RealInput": [], "RealOutput": []}
    for line in model.splitlines():
        words = line.split()
        if words and words[0].startswith("Analogon.Interfaces."):
            names[words[0].split(".")[2]].append(words[1].split("(")[0])
    return names["RealInput"], names["RealOutput"]


def simulated(folder, study, experiment, truth, data, generator):
    with open(os.path.join(folder, "model.mo"), encoding="utf-8") as f:
        inputs, outputs = signals(f.read())
    lines = ["model " + os.path.join(folder, "model.mo")]
    lines += ["set %s %.12g" % kv for kv in truth["parameters"].items()]
    for value in experiment.get("initial", {}).values():
        lines.append("start %.12g" % (data[value][0] if isinstance(value, str) else value))
    flow = []
    for h in truth["hidden"]:
        p = {k: v for k, v in h["parameters"].items() if isinstance(v, (int, float))}
        if h["kind"] == "convection.flow":
            flow = [data[h["parameters"]["channel"]]]
        at = h.get("at", ["-"])[0].replace("_", " ").replace(" ", "_")
        lines.append(" ".join(["effect", h["kind"], at] + ["%s=%.12g" % kv for kv in p.items()]))
    t = data[experiment["time"]]
    columns = [data[experiment["inputs"][i]] for i in inputs] + flow
    lines.append("series %d %.12g" % (len(t), (t[-1] - t[0]) / (len(t) - 1)))
    lines += [" ".join("%.12g" % c[k] for c in columns) for k in range(len(t))]
    with tempfile.NamedTemporaryFile("w", suffix=".txt", delete=False) as f:
        f.write("\n".join(lines) + "\n")
    run = subprocess.run([generator, "--replay", f.name], capture_output=True, text=True)
    os.unlink(f.name)
    if run.returncode:
        raise RuntimeError(run.stderr.strip())
    rows = [[float(x) for x in line.split()] for line in run.stdout.splitlines()]
    return {o: [r[k] for r in rows] for k, o in enumerate(outputs)}, run.stderr.strip().split()[-1]


def main():
    cases, generator, only = sys.argv[1], sys.argv[2], sys.argv[3:]
    for name in sorted(os.listdir(cases)):
        folder = os.path.join(cases, name)
        if not os.path.isfile(os.path.join(folder, "truth.json")) or (only and name not in only):
            continue
        with open(os.path.join(folder, "truth.json"), encoding="utf-8") as f:
            truth = json.load(f)
        with open(os.path.join(folder, "study.json"), encoding="utf-8") as f:
            study = json.load(f)
        kinds = "+".join(h["kind"] for h in truth["hidden"]) or "-"
        text = []
        for experiment in study["experiments"]:
            data = table(os.path.join(folder, experiment["file"]))
            try:
                model, step = simulated(folder, study, experiment, truth, data, generator)
            except RuntimeError as e:
                text.append(str(e))
                continue
            for (output, column), sigma in zip(experiment["outputs"].items(), truth["noise_std"].values()):
                r = [a - b for a, b in zip(data[column], model[output])]
                text.append("%s %.3f" % (output, math.sqrt(sum(x * x for x in r) / len(r)) / sigma))
            text.append("(step %s)" % step)
        print("%-16s %-8s %-40s %s" % (name, truth["class"], kinds, "  ".join(text)))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Makes a campaign of water pumps: a study, a recording for each unit, units.csv, campaign.json and truth.csv.

    pump_units.py DIR [--units N] [--samples N] [--friction SHARE] [--odd N] [--seed N] [--command fit|discover]

Each unit has parameters of its own (log-normal, 3 %; the resistance of supplier B is 4 % above that of A); a share of
them has dry friction, and a few are odd: one parameter lies 40 % off. The script has its own equations and integrator
(classical Runge-Kutta, Coulomb friction that holds and breaks away) and shares nothing with the program:

    L*i' = u - R*i - k*w
    J*w' = k*i - k_q*w*|w| - friction

Needs only the standard library; the same seed gives the same files.
"""
import argparse
import csv
import json
import math
import os
import random

NOMINAL = {"motor.R": 0.42, "motor.k": 0.0285, "rotor.J": 4.1e-5, "load.k_q": 1.35e-6}
J_IMPELLER, L = 1.4e-5, 3.5e-4
STEP, SUBSTEPS, NOISE, TAU_C = 0.01, 16, 0.003, 0.03

MODEL = """model WaterPump "Electric water pump: motor, rotor, impeller"
  Analogon.Interfaces.RealInput v_cmd(unit="V");
  Analogon.Interfaces.RealOutput i_mot(unit="A");
  Analogon.Interfaces.RealOutput w_pump(unit="rad/s");
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.5, L=3.5e-4, k=0.025);
  Analogon.Mechanics.Inertia rotor(J=5e-5);
  Analogon.Mechanics.Inertia impeller(J=1.4e-5);
  Analogon.Mechanics.QuadraticLoad load(k_q=2e-6);
  Analogon.Sensors.SpeedSensor speed;
equation
  connect(v_cmd, motor.v);
  connect(motor.flange, rotor.flange_a);
  connect(rotor.flange_b, impeller.flange_a);
  connect(impeller.flange_b, load.flange);
  connect(impeller.flange_b, speed.flange);
  connect(motor.i, i_mot);
  connect(speed.w, w_pump);
end WaterPump;
"""

STUDY = {
    "format": "analogon-study-1", "class": "WaterPump",
    "experiments": [{"name": "run-up", "role": "fit", "file": "nominal.csv", "time": "t",
                     "inputs": {"v_cmd": "u"}, "outputs": {"i_mot": "i", "w_pump": "n"}}],
    "parameters": {"motor.R": {"fit": True, "min": 0.01, "max": 10, "scale": "log"},
                   "motor.k": {"fit": True, "min": 0.001, "max": 0.5, "scale": "log"},
                   "rotor.J": {"fit": True, "min": 1e-6, "max": 0.001, "scale": "log"},
                   "load.k_q": {"fit": True, "min": 1e-8, "max": 0.0001, "scale": "log"}},
}


def voltage(samples):
    """Up and down again, as a bench drives a pump; the same for every unit."""
    course, level = random.Random(7), 0.0
    held, values = 0, []
    for _ in range(samples):
        if held == 0:
            level, held = course.choice([2.0, 4.0, 6.0, 9.0, 12.0]), course.randint(15, 45)
        held -= 1
        values.append(level if not values else values[-1] + 0.5 * (level - values[-1]))
    return values


def simulate(p, tau_c, u):
    r, k, k_q, j = p["motor.R"], p["motor.k"], p["load.k_q"], p["rotor.J"] + J_IMPELLER
    h, i, w = STEP / SUBSTEPS, 0.0, 0.0
    currents, speeds = [i], [w]

    def rates(i_, w_, u_, friction, holds):
        di = (u_ - r * i_ - k * w_) / L
        return di, 0.0 if holds else (k * i_ - k_q * w_ * abs(w_) - friction) / j
    for n in range(len(u) - 1):
        for s in range(SUBSTEPS):
            u0 = u[n] + (u[n + 1] - u[n]) * s / SUBSTEPS
            u1 = u[n] + (u[n + 1] - u[n]) * (s + 1) / SUBSTEPS
            um = 0.5 * (u0 + u1)
            holds = w == 0.0 and abs(k * i) <= tau_c
            way = math.copysign(1.0, k * i if w == 0.0 else w)
            f = way * tau_c
            a1, b1 = rates(i, w, u0, f, holds)
            a2, b2 = rates(i + 0.5 * h * a1, w + 0.5 * h * b1, um, f, holds)
            a3, b3 = rates(i + 0.5 * h * a2, w + 0.5 * h * b2, um, f, holds)
            a4, b4 = rates(i + h * a3, w + h * b3, u1, f, holds)
            i += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
            after = w + h / 6 * (b1 + 2 * b2 + 2 * b3 + b4)
            w = 0.0 if tau_c > 0 and after * way < 0 else after
        currents.append(i)
        speeds.append(w)
    return currents, speeds


def write_recording(path, u, currents, speeds, noise):
    size_i, size_w = max(currents) - min(currents), max(speeds) - min(speeds)
    with open(path, "w", newline="") as stream:
        stream.write("t [s],u [V],i [A],n [rpm]\n")
        for n, (v, i, w) in enumerate(zip(u, currents, speeds)):
            i += noise.gauss(0, NOISE * size_i)
            w += noise.gauss(0, NOISE * size_w)
            stream.write(f"{n * STEP:.3f},{v:.6g},{i:.5f},{w * 30 / math.pi:.3f}\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("directory")
    parser.add_argument("--units", type=int, default=1000)
    parser.add_argument("--samples", type=int, default=200)
    parser.add_argument("--friction", type=float, default=0.05)
    parser.add_argument("--odd", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--command", default="discover")
    o = parser.parse_args()
    draw = random.Random(o.seed)
    os.makedirs(os.path.join(o.directory, "pump"), exist_ok=True)
    os.makedirs(os.path.join(o.directory, "recordings"), exist_ok=True)
    u = voltage(o.samples)
    with open(os.path.join(o.directory, "pump", "model.mo"), "w") as stream:
        stream.write(MODEL)
    with open(os.path.join(o.directory, "pump", "study.json"), "w") as stream:
        json.dump(STUDY, stream, indent=2)
    write_recording(os.path.join(o.directory, "pump", "nominal.csv"), u, *simulate(NOMINAL, 0.0, u), draw)
    odd = dict(zip(draw.sample(range(o.units), o.odd), ["motor.R", "motor.k", "load.k_q"] * o.odd))
    rows, truths = [], []
    for n in range(o.units):
        name, supplier = f"P{n + 1:05d}", draw.choice("AB")
        p = {key: value * math.exp(draw.gauss(0, 0.03)) for key, value in NOMINAL.items()}
        if supplier == "B":
            p["motor.R"] *= 1.04
        if n in odd:
            p[odd[n]] *= 1.4
        tau_c = TAU_C if draw.random() < o.friction and n not in odd else 0.0
        file = f"recordings/{name}.csv"
        write_recording(os.path.join(o.directory, file), u, *simulate(p, tau_c, u), random.Random(o.seed * 1000003 + n))
        rows.append([name, file, supplier, 1 + n * 12 // o.units, f"{draw.gauss(23, 2):.1f}"])
        truths.append([name, tau_c, odd.get(n, "")] + [f"{p[key]:.8g}" for key in NOMINAL])
    with open(os.path.join(o.directory, "units.csv"), "w", newline="") as stream:
        csv.writer(stream).writerows([["serial", "file_run_up", "supplier", "week", "T_amb [degC]"]] + rows)
    with open(os.path.join(o.directory, "truth.csv"), "w", newline="") as stream:
        csv.writer(stream).writerows([["serial", "tau_c", "odd"] + list(NOMINAL)] + truths)
    campaign = {"format": "analogon-campaign-1", "study": "pump", "command": o.command, "units": "units.csv",
                "columns": {"unit": "serial", "files": {"run-up": "file_run_up"},
                            "attributes": ["supplier", "week", "T_amb [degC]"]}}
    with open(os.path.join(o.directory, "campaign.json"), "w") as stream:
        json.dump(campaign, stream, indent=2)


if __name__ == "__main__":
    main()

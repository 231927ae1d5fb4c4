#!/usr/bin/env python3
"""Makes train.csv, validation.csv and expected.json of this study.

An electric water pump: direct-current motor, rotor and impeller on one shaft. This script has its own equations and
its own integrator and shares nothing with the program that analyses the recordings:

    L*i' = u - R*i - k*w
    J*w' = k*i - k_q*w*|w| - friction

The friction is dry, and hard: tau_c against the motion while the shaft turns; while it stands, whatever it takes up
to tau_c to hold it. The integrator is classical Runge-Kutta with fixed steps in either phase; a step in which the
speed passes zero is cut there. The model that is analysed has no dry friction.
Inputs run linearly between samples; white noise of 0.5 % of the range is added to the measured channels.
Needs only the standard library; the seed is fixed, so the files come out the same every time.
"""
import csv
import json
import math
import os
import random

HERE = os.path.dirname(os.path.abspath(__file__))
STEP = 0.005       # [s] between samples
SUBSTEPS = 20      # integration steps per sample
NOISE = 0.005      # of the range of a channel

TRUTH = {"motor.R": 0.42, "motor.k": 0.0285, "rotor.J": 4.1e-5, "load.k_q": 1.35e-6}
J_IMPELLER = 1.4e-5  # [kg.m2], known from its drawing
J = TRUTH["rotor.J"] + J_IMPELLER
L = 3.5e-4         # [H], known from the data sheet
TAU_C = 0.032      # [N.m]


def rates(i, w, u, friction):
    back = TRUTH["motor.k"] * w
    return ((u - TRUTH["motor.R"] * i - back) / L,
            (TRUTH["motor.k"] * i - TRUTH["load.k_q"] * w * abs(w) - friction) / J)


def runge_kutta(i, w, u0, u1, h, friction, holds):
    """One step; a held shaft keeps its speed of 0."""
    um = 0.5 * (u0 + u1)

    def f(i_, w_, u_):
        di, dw = rates(i_, w_, u_, friction)
        return di, 0.0 if holds else dw
    a1, b1 = f(i, w, u0)
    a2, b2 = f(i + 0.5 * h * a1, w + 0.5 * h * b1, um)
    a3, b3 = f(i + 0.5 * h * a2, w + 0.5 * h * b2, um)
    a4, b4 = f(i + h * a3, w + h * b3, u1)
    return i + h / 6.0 * (a1 + 2 * a2 + 2 * a3 + a4), w + h / 6.0 * (b1 + 2 * b2 + 2 * b3 + b4)


def advance(i, w, u0, u1, h):
    """One step with dry friction: sticks, breaks away, or slides until the speed passes zero."""
    if w == 0.0:
        drive = TRUTH["motor.k"] * i
        if abs(drive) <= TAU_C:
            return runge_kutta(i, 0.0, u0, u1, h, 0.0, True)
        direction = math.copysign(1.0, drive)
    else:
        direction = math.copysign(1.0, w)
    i_new, w_new = runge_kutta(i, w, u0, u1, h, direction * TAU_C, False)
    if w_new * direction >= 0.0:
        return i_new, w_new
    share = w / (w - w_new) if w != 0.0 else 0.0
    u_zero = u0 + share * (u1 - u0)
    i_zero, _ = runge_kutta(i, w, u0, u_zero, share * h, direction * TAU_C, False)
    if share >= 1.0 - 1e-12:
        return i_zero, 0.0
    if abs(TRUTH["motor.k"] * i_zero) <= TAU_C:
        return runge_kutta(i_zero, 0.0, u_zero, u1, (1.0 - share) * h, 0.0, True)
    onward = math.copysign(TAU_C, TRUTH["motor.k"] * i_zero)
    return runge_kutta(i_zero, 0.0, u_zero, u1, (1.0 - share) * h, onward, False)


def simulate(u):
    i, w, h = 0.0, 0.0, STEP / SUBSTEPS
    currents, speeds = [i], [w]
    for k in range(len(u) - 1):
        slope = (u[k + 1] - u[k]) / SUBSTEPS
        for s in range(SUBSTEPS):
            i, w = advance(i, w, u[k] + s * slope, u[k] + (s + 1) * slope, h)
        currents.append(i)
        speeds.append(w)
    return currents, speeds


def profile(points, times):
    """Piecewise linear through (time, value)."""
    values, piece = [], 0
    for t in times:
        while piece + 2 < len(points) and t >= points[piece + 1][0]:
            piece += 1
        (t0, v0), (t1, v1) = points[piece], points[piece + 1]
        values.append(v0 + (v1 - v0) * min(max((t - t0) / (t1 - t0), 0.0), 1.0))
    return values


def bench_run():
    """The fitting run: a slow ramp through breakaway, steps up and down, a run-down, a short reversal."""
    times = [k * STEP for k in range(3601)]
    return times, profile(
        [(0, 0), (0.3, 0), (2.8, 5.0), (3.2, 5.0), (3.205, 9.0), (4.2, 9.0), (4.205, 6.0), (5.0, 6.0), (5.005, 11.5),
         (6.0, 11.5), (6.005, 3.0), (7.0, 3.0), (7.005, 0), (8.0, 0), (8.005, 1.5), (8.8, 1.5), (8.805, 4.0),
         (9.5, 4.0), (11.0, 12.0), (11.6, 12.0), (12.6, 2.0), (13.0, 2.0), (13.005, 0), (13.7, 0), (13.705, -4.0),
         (14.4, -4.0), (14.405, 0), (14.9, 0), (14.905, 7.0), (15.7, 7.0), (15.705, 2.5), (16.4, 2.5), (17.4, 0),
         (1e9, 0)], times)


def cooling_cycle():
    """The validation run: what the thermal management of a car asks for."""
    times = [k * STEP for k in range(3201)]
    return times, profile(
        [(0, 0), (0.2, 0), (0.205, 3.5), (1.4, 3.5), (2.2, 7.5), (3.0, 7.5), (3.005, 2.0), (4.2, 2.0), (4.205, 10.5),
         (5.2, 10.5), (6.4, 1.5), (6.8, 1.5), (6.805, 0), (7.6, 0), (9.4, 3.0), (9.9, 3.0), (9.905, 12.5),
         (10.7, 12.5), (10.705, 5.0), (11.5, 5.0), (11.505, 0), (12.2, 0), (12.205, -3.0), (12.9, -3.0), (12.905, 0),
         (13.4, 0), (13.405, 8.5), (14.3, 8.5), (15.6, 0), (1e9, 0)], times)


def noisy(values, rng):
    """Values with noise, and the error_percent of that noise."""
    sigma = NOISE * (max(values) - min(values))
    noise = [rng.gauss(0.0, sigma) for _ in values]
    measured = [v + n for v, n in zip(values, noise)]
    rms = math.sqrt(sum(n * n for n in noise) / len(noise))
    return measured, 100.0 * rms / (max(measured) - min(measured))


def record(name, run, rng):
    """Writes one recording; returns the error_percent of its noise."""
    times, voltage = run()
    currents, speeds = simulate(voltage)
    i_measured, i_floor = noisy(currents, rng)
    w_measured, w_floor = noisy(speeds, rng)
    with open(os.path.join(HERE, name), "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["t [s]", "u_motor [V]", "i_motor [A]", "n_pump [rpm]", "U_bat [V]", "T_water [degC]"])
        for t, u, i, w in zip(times, voltage, i_measured, w_measured):
            battery = 13.6 - 0.01 * abs(i) + rng.gauss(0.0, 0.03)
            water = 62.0 + 0.05 * t + rng.gauss(0.0, 0.05)
            out.writerow(["%.3f" % t, "%.6g" % u, "%.4f" % i, "%.3f" % (w * 30.0 / math.pi), "%.3f" % battery,
                          "%.2f" % water])
    return math.sqrt(0.5 * (i_floor ** 2 + w_floor ** 2))


def main():
    rng = random.Random(20141027)
    floor = {"bench run": record("train.csv", bench_run, rng),
             "cooling cycle": record("validation.csv", cooling_cycle, rng)}
    expected = {
        "finding": "effect",
        "effects": [{"kind": "friction.coulomb",
                     "at": ["motor.flange", "rotor.flange_a", "rotor.flange_b", "impeller.flange_a",
                            "impeller.flange_b", "load.flange", "speed.flange"],
                     "parameters": {"tau_c": TAU_C}}],
        "parameters": TRUTH,
        "noise_floor_percent": {name: round(value, 4) for name, value in floor.items()},
        "before_over_floor_min": 2.0,
        "after_over_floor_max": 1.1,
    }
    with open(os.path.join(HERE, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=2)
        file.write("\n")
    for name, value in floor.items():
        print("%-14s noise floor %.3f %%" % (name, value))


if __name__ == "__main__":
    main()

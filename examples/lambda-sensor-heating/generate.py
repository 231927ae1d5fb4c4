#!/usr/bin/env python3
"""Makes train.csv, validation.csv and expected.json of this study.

A planar exhaust-gas sensor with an electric heater, on a test bench. This script has its own equations and its own
integrator (classical Runge-Kutta with fixed steps) and shares nothing with the program that analyses the recordings:

    R_T  = R*(1 + alpha*(T - 293.15 K))                     heater
    i    = u/R_T
    C*T' = R_T*i^2 - c_o*A*(T_g/3.6)^0.78*(T - T_g)         convection to the exhaust gas
           - k_r*(T^4 - T_a^4)                              radiation to the pipe: what the model lacks

Inputs run linearly between samples. White noise of 0.5 % of the range is added to the measured current.
Needs only the standard library; the seed is fixed, so the files come out the same every time.
"""
import csv
import json
import math
import os
import random

HERE = os.path.dirname(os.path.abspath(__file__))
STEP = 0.05        # [s] between samples
SUBSTEPS = 10      # integration steps per sample
NOISE = 0.005      # of the range of the current

TRUTH = {"heater.R": 2.45, "heater.alpha": 0.0036, "element.C": 0.82, "element.c_o": 1.35}
A = 2.2e-4         # [m2]
T_REF = 293.15     # [K]
K_R = 1.6e-11      # [W/K4]
T_PIPE = 293.15    # [K]


def profile(points, times):
    """Piecewise linear through (time, value)."""
    values, piece = [], 0
    for t in times:
        while piece + 2 < len(points) and t >= points[piece + 1][0]:
            piece += 1
        (t0, v0), (t1, v1) = points[piece], points[piece + 1]
        values.append(v0 + (v1 - v0) * min(max((t - t0) / (t1 - t0), 0.0), 1.0))
    return values


def smoothed(values, time_constant):
    """First-order lag on the samples: gas temperatures do not jump."""
    result, share = [values[0]], 1.0 - math.exp(-STEP / time_constant)
    for v in values[1:]:
        result.append(result[-1] + share * (v - result[-1]))
    return result


def resistance(T):
    return TRUTH["heater.R"] * (1.0 + TRUTH["heater.alpha"] * (T - T_REF))


def rate(T, u, T_gas):
    heating = u * u / resistance(T)
    convection = TRUTH["element.c_o"] * A * (T_gas / 3.6) ** 0.78 * (T - T_gas)
    radiation = K_R * (T ** 4 - T_PIPE ** 4)
    return (heating - convection - radiation) / TRUTH["element.C"]


def simulate(u, T_gas):
    """Temperature of the element at the samples; it starts as warm as the gas."""
    T, h = T_gas[0], STEP / SUBSTEPS
    result = [T]
    for k in range(len(u) - 1):
        def at(values, share):
            return values[k] + share * (values[k + 1] - values[k])
        for s in range(SUBSTEPS):
            a, m, b = s / SUBSTEPS, (s + 0.5) / SUBSTEPS, (s + 1) / SUBSTEPS
            k1 = rate(T, at(u, a), at(T_gas, a))
            k2 = rate(T + 0.5 * h * k1, at(u, m), at(T_gas, m))
            k3 = rate(T + 0.5 * h * k2, at(u, m), at(T_gas, m))
            k4 = rate(T + h * k3, at(u, b), at(T_gas, b))
            T += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
        result.append(T)
    return result


def steps(levels, ramp=0.05):
    """A programme of (start, level): holds each level, changes in `ramp` seconds."""
    points = [(0.0, levels[0][1])]
    for (_, before), (start, level) in zip(levels, levels[1:]):
        points += [(start, before), (start + ramp, level)]
    points.append((1e9, levels[-1][1]))
    return points


def warm_up():
    """The fitting run: the engine warms the sensor while a low voltage measures it; then the maker's heating ramp,
    steps of voltage at several gas temperatures, and the low voltage once more."""
    times = [k * STEP for k in range(3601)]
    voltage = profile(
        [(0, 0), (2, 0), (2.05, 3.0), (50, 3.0), (50.05, 5.0), (65, 11.0), (73, 11.0), (73.05, 8.0), (82, 8.0),
         (82.05, 10.0), (92, 10.0), (92.05, 6.5), (100, 6.5), (100.05, 3.0), (124, 3.0), (124.05, 12.0), (131, 12.0),
         (131.05, 7.5), (141, 7.5), (141.05, 4.0), (150, 4.0), (160, 10.5), (168, 10.5), (168.05, 3.0), (174, 3.0),
         (174.05, 8.5), (1e9, 8.5)], times)
    gas = smoothed(profile(steps([(0, 294.0), (5, 420.0), (18, 790.0), (36, 470.0), (66, 640.0), (88, 450.0),
                                  (102, 860.0), (114, 410.0), (134, 700.0), (154, 480.0)], 1.0), times), 2.5)
    return times, voltage, gas


def drive_cycle():
    """The validation run: the control of the heater works against a varying load of the engine."""
    times = [k * STEP for k in range(3201)]
    voltage = profile(
        [(0, 0), (2, 0), (2.05, 4.0), (5, 4.0), (16, 12.0), (26, 12.0), (26.05, 9.5), (44, 9.5), (48, 11.5),
         (58, 11.5), (58.05, 3.0), (66, 3.0), (66.05, 12.5), (80, 12.5), (86, 8.0), (100, 8.0), (100.05, 12.0),
         (112, 12.0), (112.05, 5.0), (122, 5.0), (132, 12.0), (146, 12.0), (146.05, 7.0), (1e9, 7.0)], times)
    gas = smoothed(profile(steps([(0, 296.0), (4, 450.0), (20, 520.0), (32, 430.0), (50, 720.0), (62, 500.0),
                                  (78, 440.0), (96, 660.0), (108, 480.0), (128, 410.0), (144, 580.0)], 1.0), times), 2.0)
    return times, voltage, gas


def spare_channels(times, rng):
    """What a bench records besides: the pressure of the day and the speed of the exhaust gas."""
    pressure = rng.uniform(990.0, 1025.0)
    speed, target = [], 15.0
    value = target
    for k in range(len(times)):
        if k % 160 == 0:
            target = rng.uniform(8.0, 45.0)
        value += 0.03 * (target - value)
        speed.append(value + rng.gauss(0.0, 0.2))
    return [pressure + rng.gauss(0.0, 0.05) for _ in times], speed


def record(name, run, rng):
    """Writes one recording; returns the error_percent of its noise."""
    times, voltage, gas = run()
    current = [u / resistance(T) for u, T in zip(voltage, simulate(voltage, gas))]
    sigma = NOISE * (max(current) - min(current))
    noise = [rng.gauss(0.0, sigma) for _ in times]
    measured = [i + n for i, n in zip(current, noise)]
    pressure, speed = spare_channels(times, rng)
    with open(os.path.join(HERE, name), "w", newline="", encoding="utf-8") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["t [s]", "u_heater [V]", "T_exhaust [degC]", "i_heater [mA]", "p_ambient [hPa]", "v_exhaust [m/s]"])
        for row in zip(times, voltage, gas, measured, pressure, speed):
            t, u, T, i, p, v = row
            out.writerow(["%.2f" % t, "%.6g" % u, "%.4f" % (T - 273.15), "%.3f" % (1000.0 * i), "%.2f" % p, "%.2f" % v])
    rms = math.sqrt(sum(n * n for n in noise) / len(noise))
    return 100.0 * rms / (max(measured) - min(measured))


def main():
    rng = random.Random(20140818)
    floor = {"warm-up": record("train.csv", warm_up, rng), "drive cycle": record("validation.csv", drive_cycle, rng)}
    expected = {
        "finding": "effect",
        "effects": [{"kind": "thermal.radiation", "at": ["element.solid", "heater.heatPort"],
                     "parameters": {"k_r": K_R}}],
        "parameters": TRUTH,
        "noise_floor_percent": {name: round(value, 4) for name, value in floor.items()},
        "before_over_floor_min": 2.5,
        "after_over_floor_max": 1.1,
    }
    with open(os.path.join(HERE, "expected.json"), "w", encoding="utf-8") as file:
        json.dump(expected, file, indent=2)
        file.write("\n")
    for name, value in floor.items():
        print("%-12s noise floor %.3f %%" % (name, value))


if __name__ == "__main__":
    main()

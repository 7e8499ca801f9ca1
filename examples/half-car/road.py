"""Writes road.csv: a road of class B of ISO 8608, as a measuring vehicle would give it.

The profile is a sum of waves of random phase whose power spectral density of heights is
64e-6 m^3 (n / 0.1)^-2 at n waves per metre, from 0.02 to 1.9 per metre. The first metres are level.
"""
import numpy as np

STEP, LENGTH, SEED = 0.25, 100.0, 8608

s = np.arange(0, LENGTH + STEP / 2, STEP)
n = np.arange(0.02, 1.9, 0.01)
amplitude = np.sqrt(2 * 64e-6 * (n / 0.1) ** -2 * 0.01)
phase = np.random.default_rng(SEED).uniform(0, 2 * np.pi, n.size)
height = (amplitude * np.cos(2 * np.pi * np.outer(s, n) + phase)).sum(axis=1)
level = np.clip((s - 4) / 4, 0, 1)
height *= level**2 * (3 - 2 * level)
with open("road.csv", "w") as out:
    print("# A road of class B of ISO 8608, made by road.py with the seed 8608", file=out)
    print("distance,height", file=out)
    for where, z in zip(s, height):
        print(f"{where:.2f},{z:.6f}", file=out)

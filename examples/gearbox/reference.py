"""The gearbox by the equations of its five angles, derived by hand from its kinetic energy."""
import math
import sys

import numpy as np
from scipy.integrate import solve_ivp

RS, RP, RR, A = 0.03, 0.03, 0.09, 0.06
SUN, CARRIER, MASS = 2e-3, 0.04, 0.4
PLANET = 0.5 * MASS * RP**2
K, C, EPS = 1e6, 60.0, 5e-6
HALF = [0.5 * b * 1e-3 for b in (0.20, 0.15, 0.25)]


def pos(x):
    root = math.sqrt(x * x + EPS * EPS)
    return 0.5 * (x + root), 0.5 * (1 + x / root)


def push(x, rate):
    """A flank pushes and never pulls: E + D, rounded where the damper takes over half of E."""
    above, slope = pos(x)
    elastic = K * above
    total = elastic + C * rate * slope
    r = 2 * total / elastic
    if abs(r) >= 1:
        return max(0.0, total)
    even = 63 + r * (-122 + r * (102 + r * (-42 + 7 * r)))
    return 0.5 * elastic * (1 + r) ** 6 * even / 512


def tooth(x, rate, half):
    return push(x - half, rate) - push(-x - half, -rate)


M = np.zeros((5, 5))
M[0, 0] = SUN
M[1, 1] = CARRIER + 3 * MASS * A**2 + 3 * PLANET
for p in (2, 3, 4):
    M[1, p] = M[p, 1] = M[p, p] = PLANET
INVERSE = np.linalg.inv(M)


def rates(t, y):
    q, v = y[:5], y[5:]
    f = np.zeros(5)
    f[0] = 8 * math.sin(10 * math.pi * t)
    f[1] = -2 * v[1]
    for i, half in enumerate(HALF):
        sun = np.zeros(5)
        sun[[0, 1, 2 + i]] = RS, -RS, RP
        ring = np.zeros(5)
        ring[[1, 2 + i]] = RR, RP
        for arms in (sun, ring):
            f -= tooth(arms @ q, arms @ v, half) * arms
    return np.concatenate([v, INVERSE @ f])


def main(out):
    times = np.linspace(0, 0.4, 81)
    found = solve_ivp(rates, (0, 0.4), np.zeros(10), method="DOP853", t_eval=times, rtol=1e-12,
                      atol=1e-15, max_step=2e-4)
    joints = ("sun", "carrier", "planet1", "planet2", "planet3")
    print("t," + ",".join(f"{j}.{k}" for k in "qv" for j in joints), file=out)
    for t, y in zip(found.t, found.y.T):
        print(",".join(repr(float(x)) for x in [t, *y]), file=out)


main(sys.stdout)

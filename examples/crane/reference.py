"""The crane as a pendulum whose pivot moves and whose rope winds on and off a circle.

With the angle f of the rope from the vertical, u = (sin f, -cos f) along the rope, e = (cos f, sin f),
the centre C of the pulley and l = s(t) + R (f - pi/2) the free length, the load is at
C + R e + l u, and l f'' = -e . C'' - 2 s' f' - R f'^2 - g sin f.
"""
import sys

import numpy as np
import sympy as sp
from scipy.integrate import solve_ivp

R, DRUM, G, MASS = 0.25, 0.3, 9.81, 2000.0
INERTIA = 0.5 * 120 * 0.3**2

t = sp.symbols("t")
luff = sp.Rational(7, 10) + sp.Rational(15, 100) * (1 - sp.cos(sp.Rational(4, 5) * t))
winch = 4 * (1 - sp.cos(t / 2))
head = [10 * sp.cos(luff), 2 + 10 * sp.sin(luff)]
way = [head[0] + 1, head[1] - 2]
straight = sp.sqrt(way[0] ** 2 + way[1] ** 2 - sp.Rational(1, 16))
before = sp.atan2(way[1], way[0]) + sp.atan2(sp.Rational(1, 4), straight)
used = straight + sp.Rational(1, 4) * before
start = float((used + sp.Rational(1, 4) * sp.pi / 2).subs(t, 0)) + 5
free = start + sp.Rational(3, 10) * winch - used
names = [head[0], head[1], free, winch]
value = [sp.lambdify(t, [sp.diff(n, t, k) for n in names], "numpy") for k in range(3)]


def state(time, f, w):
    c0, c1, c2 = (np.array(v(time), dtype=float) for v in value)
    length = c0[2] + R * (f - np.pi / 2)
    u, e = np.array([np.sin(f), -np.cos(f)]), np.array([np.cos(f), np.sin(f)])
    return c0, c1, c2, length, u, e


def rates(time, y):
    f, w = y
    c0, c1, c2, length, u, e = state(time, f, w)
    return [w, (-e @ c2[:2] - 2 * c1[2] * w - R * w**2 - G * np.sin(f)) / length]


def main(out):
    times = np.linspace(0, 10, 101)
    found = solve_ivp(rates, (0, 10), [0.0, 0.0], method="DOP853", t_eval=times, rtol=1e-13,
                      atol=1e-14)
    print("t,load.q[0],load.q[1],hoist.lambda,winch.drive", file=out)
    for time, (f, w) in zip(times, found.y.T):
        c0, c1, c2, length, u, e = state(time, f, w)
        place = c0[:2] + R * e + length * u
        tension = -MASS * (u @ c2[:2] + c2[2] - length * w**2 - G * np.cos(f))
        torque = INERTIA * c2[3] - DRUM * tension
        print(",".join(repr(float(x)) for x in [time, *place, tension, torque]), file=out)


main(sys.stdout)

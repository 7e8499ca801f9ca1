"""The simplest walker by its own equations (Garcia, Chatterjee, Ruina, Coleman 1998).

Without arguments: the walk of walker.xml as CSV. With "gait": the fixed points of its step and the
eigenvalues of the step's derivative, which decide whether the walk is stable.
"""
import math
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

SLOPE, L, G = 0.009, 0.25, 9.81
UNIT = math.sqrt(G / L)


def rates(t, y):
    """Equations 1 and 2 of the paper, with a massless swing foot; t in units of sqrt(l/g)."""
    theta, phi, dtheta, dphi = y
    a = math.sin(theta - SLOPE)
    return [dtheta, dphi, a, a + (dtheta**2 - math.cos(theta - SLOPE)) * math.sin(phi)]


def strike(t, y):
    """The swing foot meets the slope in front of the stance foot."""
    return min(y[1] - 2 * y[0], -y[0])


strike.terminal, strike.direction = True, 1


def exchange(y):
    """Equation 4: the hip's velocity loses its part along the new stance leg."""
    theta, _, dtheta, _ = y
    c = math.cos(2 * theta)
    return [-theta, -2 * theta, c * dtheta, c * (1 - c) * dtheta]


def swing(y, end=20.0):
    return solve_ivp(rates, (0, end), y, method="DOP853", events=strike, rtol=1e-13, atol=1e-15,
                     dense_output=True)


def step(state):
    """Returns angle and rate of the stance leg one step later."""
    theta, dtheta = state
    c = math.cos(2 * theta)
    y = swing([theta, 2 * theta, dtheta, (1 - c) * dtheta]).y[:, -1]
    after = exchange(y)
    return np.array([after[0], after[2]])


def gait(guess):
    found = fsolve(lambda s: step(s) - s, guess, xtol=1e-13)
    h = 1e-6
    slopes = np.column_stack([(step(found + h * e) - step(found - h * e)) / (2 * h)
                              for e in np.eye(2)])
    print(f"angle {found[0]:.12f}, rate {found[1]:.12f}, eigenvalues {np.linalg.eigvals(slopes)}")


def walk(out):
    times = np.linspace(0, 7, 141) * UNIT
    print("t,foot.q,stance.q,swing.q,stance.v,swing.v", file=out)
    start, place, y = 0.0, 0.0, [0.205, 0.41, -0.203, -0.0165]
    while start <= times[-1]:
        run = swing(y)
        end = start + run.t[-1]
        for t in times[(times >= start) & (times < end)]:
            theta, phi, dtheta, dphi = run.sol(t - start)
            row = [t / UNIT, place, theta, phi, dtheta * UNIT, dphi * UNIT]
            print(",".join(repr(float(x)) for x in row), file=out)
        place -= 2 * L * math.sin(run.y[0, -1])
        start, y = end, exchange(run.y[:, -1])


if sys.argv[1:] == ["gait"]:
    gait([0.2003, -0.1998])
else:
    walk(sys.stdout)

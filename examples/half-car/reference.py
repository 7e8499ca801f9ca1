"""The half car by equations of its seven coordinates, derived by hand, with the tyre of the book.

Body: x forwards, z downwards (as the second displacement of the joint), pitch about y; the hubs move
along the body's z axis; the spins are relative to the hubs. Tyre: Rill, Road Vehicle Dynamics, 2012,
chapter 3, in the vertical plane.
"""
import math
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline

G, MASS, INERTIA = 9.81, 600.0, 950.0
HUB, SPIN = 38.0, 1.1
ARMS = ((1.2, -0.25), (-1.4, -0.25))
K, C, FREE = 25e3, 1.8e3, (-0.127, -0.109)
BRAKE = (700.0, 0.4 * 700.0)
R0, KZ, DZ, EPS, LOAD, REST, ROLLING = 0.3, 2e5, 200.0, 1e-5, 3200.0, 0.01, 0.01
ONCE, TWICE = (120e3, 0.11, 3400, 0.5, 3000), (200e3, 0.12, 6000, 0.8, 5200)
SIDE, SIDE2 = (55e3, 0.18, 3100, 0.6, 2900), (80e3, 0.2, 5400, 0.8, 5100)
CX, DX = 2e5, 200.0

road = np.loadtxt("road.csv", delimiter=",", skiprows=2)
curve = CubicSpline(road[:, 0], road[:, 1])


def height(s):
    return float(curve(min(max(s, road[0, 0]), road[-1, 0])))


def numbers(once, twice, share):
    """Slope, slip, force, slip and force of a curve at a load; forces per share of the load."""
    def of_load(a, b):
        return 2 * a - b / 2 - (a - b / 2) * share

    def between(a, b):
        return a + (b - a) * (share - 1)
    return [(of_load if i % 2 == 0 else between)(a, b) for i, (a, b) in enumerate(zip(once, twice))]


def tyre(x, z, vx, vz, spin, deflection):
    """Force (x, z), moment about the axle and rate of the deflection."""
    ahead, behind = height(x + 0.1 * R0), height(x - 0.1 * R0)
    slope, ground = (ahead - behind) / (0.2 * R0), (ahead + behind) / 2
    size = math.hypot(slope, 1)
    nx, nz = -slope / size, 1 / size
    ex, ez = nz, -nx
    rs = nz * (z - ground)
    d, rate = R0 - rs, -(nx * vx + nz * vz)
    root = math.sqrt(d * d + EPS * EPS)
    pos = max(d, 0) + EPS * EPS / (2 * (abs(d) + root))
    fz = max(0, KZ * pos + DZ * rate * pos / root)
    rd = 2 * R0 / 3 + rs / 3
    transport = abs(rd * spin) + REST
    sliding = ex * vx + ez * vz - rd * spin
    slip = -sliding / transport
    share = fz / LOAD
    slope0, s_max, f_max, s_end, f_end = numbers(ONCE, TWICE, share)
    slope_y, s_y, f_y, _, _ = numbers(SIDE, SIDE2, share)
    a, b = f_max / slope0, f_y / slope_y
    norm = s_max / (s_max + s_y) + a / (a + b)
    s = max(abs(slip), 1e-9)
    if s <= s_max:
        sigma = s / s_max
        force = slope0 * s / (1 + sigma * (slope0 * s_max / f_max - 2 + sigma))
    elif s < s_end:
        sigma = (s - s_max) / (s_end - s_max)
        force = f_max - (f_max - f_end) * sigma**2 * (3 - 2 * sigma)
    else:
        force = f_end
    per_slip = share * force / s * norm
    speed = transport * norm
    bend = -(speed * CX * deflection + per_slip * sliding) / (speed * DX + per_slip)
    fx = CX * deflection + DX * bend
    circ = rd * spin
    moment = -rs * fx - ROLLING * fz * R0 * circ / math.hypot(circ, REST)
    return nx * fz + ex * fx, nz * fz + ez * fx, moment, bend


def rates(t, y):
    q, v, bends = y[:7], y[7:14], y[14:]
    cos, sin = math.cos(q[2]), math.sin(q[2])
    m, f, rate = np.zeros((7, 7)), np.zeros(7), np.zeros(2)
    m[0, 0] = m[1, 1] = MASS
    m[2, 2] = INERTIA
    f[1] = MASS * G
    brake = min(max((t - 0.5) / 0.3, 0), 1)
    brake = brake * brake * (3 - 2 * brake)
    for i, (a, b0) in enumerate(ARMS):
        b = b0 + q[3 + i]
        jx, jz = np.zeros(7), np.zeros(7)
        jx[0], jz[1] = 1, -1
        jx[2], jz[2] = -a * sin + b * cos, -a * cos - b * sin
        jx[3 + i], jz[3 + i] = sin, cos
        w, r = v[2], v[3 + i]
        ax = w * w * (-a * cos - b * sin) + 2 * w * r * cos
        az = w * w * (a * sin - b * cos) - 2 * w * r * sin
        turn = np.zeros(7)
        turn[2] = turn[5 + i] = 1
        m += HUB * (np.outer(jx, jx) + np.outer(jz, jz)) + SPIN * np.outer(turn, turn)
        x = 3 + q[0] + a * cos + b * sin
        z = 0.532 - q[1] - a * sin + b * cos
        fx, fz, moment, rate[i] = tyre(x, z, jx @ v, jz @ v, turn @ v, bends[i])
        f += jx * (fx - HUB * ax) + jz * (fz - HUB * (G + az)) + turn * moment
        f[3 + i] += -K * (q[3 + i] - FREE[i]) - C * v[3 + i]
        f[5 + i] -= BRAKE[i] * brake
    return np.concatenate([v, np.linalg.solve(m, f), rate])


def main(out):
    start = np.zeros(16)
    start[7], start[12:14] = 20, 20 / 0.2941
    times = np.linspace(0, 3, 61)
    run = solve_ivp(rates, (0, 3), start, method="LSODA", t_eval=times, rtol=1e-10, atol=1e-12)
    print("t,body.q[0],body.q[1],body.q[2],front.q,rear.q,frontSpin.v,rearSpin.v", file=out)
    for t, y in zip(run.t, run.y.T):
        row = [t, *y[:5], y[12], y[13]]
        print(",".join(repr(float(x)) for x in row), file=out)


if __name__ == "__main__":
    main(sys.stdout)

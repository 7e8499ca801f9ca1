"""The arm by the closed equations of a planar two-link arm and the recursion of its controllers."""
import math
import sys

import numpy as np
from scipy.integrate import solve_ivp

L1, C1, C2 = 0.5, 0.22, 0.18
M1, M2, I1, I2, G = 6.0, 3.5, 0.14, 0.06, 9.81
T, END, EVERY = 0.005, 2.4, 4


def rates(t, y, torque):
    q1, q2, v1, v2 = y
    a = I1 + I2 + M1 * C1**2 + M2 * (L1**2 + C2**2)
    b = M2 * L1 * C2
    d = I2 + M2 * C2**2
    h = b * math.sin(q2)
    mass = np.array([[a + 2 * b * math.cos(q2), d + b * math.cos(q2)], [d + b * math.cos(q2), d]])
    weight2 = M2 * G * C2 * math.cos(q1 + q2)
    weight1 = (M1 * C1 + M2 * L1) * G * math.cos(q1) + weight2
    right = np.array(
        [torque[0] + h * (2 * v1 * v2 + v2**2) - weight1, torque[1] - h * v1**2 - weight2])
    return [v1, v2, *np.linalg.solve(mass, right)]


class Controller:
    def __init__(self, kp, ki, kd, limit, start):
        self.kp, self.ki, self.kd, self.limit = kp, ki, kd, limit
        self.integral = self.slope = 0.0
        self.previous = -start
        self.tracking = math.sqrt(kd / ki)

    def sample(self, setpoint, measured, filter=0.01):
        error = setpoint - measured
        self.slope = (filter * self.slope + self.kd * (-measured - self.previous)) / (filter + T)
        self.previous = -measured
        free = self.kp * error + self.integral + self.slope
        output = min(self.limit, max(-self.limit, free))
        self.integral += T * (self.ki * error + (output - free) / self.tracking)
        return output


def main(out):
    one, two = Controller(420, 900, 45, 75, -math.pi / 2), Controller(160, 350, 14, 25, 0.0)
    y = [-math.pi / 2, 0.0, 0.0, 0.0]
    torque = [0.0, 0.0]
    print("t,shoulder.q,elbow.q,shoulder.v,elbow.v,torque1,torque2", file=out)
    steps = round(END / T)
    for k in range(steps + 1):
        late = 1 if k * T >= 1.2 else 0
        new = [
            one.sample(math.pi / 3 - 2 * math.pi / 9 * late, y[0]),
            two.sample(-4 * math.pi / 9 + 2 * math.pi / 3 * late, y[1])]
        if k == 0:
            torque = new
        if k % EVERY == 0:
            print(",".join(repr(float(x)) for x in [k / 200, *y, *torque]), file=out)
        torque = new
        if k < steps:
            y = solve_ivp(rates, (0, T), y, "DOP853", args=(torque,), rtol=1e-13, atol=1e-14).y[:, -1]


if __name__ == "__main__":
    main(sys.stdout)

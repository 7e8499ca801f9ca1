#!/usr/bin/env python3
"""Gradients beside CVODES and published values, and what they cost; writes docs/reports/gradients.md.

    benchmarks/peers/gradients.py [pairs]

Needs mechcli/target built, JPype, numpy and casadi (whose integrator with sensitivities is CVODES).
Costs are processor time of one thread, medians of pairs: a run and a gradient in turn, in one warm
process.
"""
import glob
import pathlib
import platform
import re
import statistics
import sys
import time
from datetime import date

import casadi
import jpype
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/reports/gradients.md"
WARM = 60

# The driver's end, s: a run that keeps two rows costs little beside its integration.
END = 0.25

FRAME = """<?xml version="1.0"?>
<!DOCTYPE MechML SYSTEM "MechML.dtd">
<MechML>
  <MBSsimulation><dynamic><timeSet tini="0" tend="{end}" tstep="{step}"/>
    <integrator name="{integrator}" relTol="{rtol}" absTol="{atol}"/></dynamic></MBSsimulation>
  <MBSmodel name="{name}" massUnits="kg" lengthUnits="m">
    <Parameters>{parameters}</Parameters>
    <Bodies>
      <body name="ground"/>
      <body name="bar"><sphere radius="0.1" point="0.5;0;0" mass="2"/></body>
    </Bodies>
    <Joints><joint name="hinge" type="R" body1="ground" body2="bar" at="0;0;0" axis="0;1;0"/></Joints>
    {states}<Forces><gravity gx="0" gy="0" gz="{g}"/>{forces}</Forces>
    <topology><root name="ground"/></topology>
  </MBSmodel>
</MechML>
"""

# The example of CVODES (cvsRoberts_FSA_dns; Hindmarsh et al., ACM TOMS 31, 2005), as printed in its
# documentation: the derivatives of y1, y2, y3 by p1, p2, p3 at t = 0.4, 4 and 40.
ROBERTSON = {
    0.4: [[-3.5595e-01, 9.5431e-08, -1.5833e-11], [3.9025e-04, -2.1309e-10, -5.2900e-13], [3.5556e-01, -9.5218e-08, 1.6362e-11]],
    4.0: [[-1.8761e+00, 2.9614e-06, -4.9334e-10], [1.7922e-04, -5.8305e-10, -2.7626e-13], [1.8759e+00, -2.9608e-06, 4.9362e-10]],
    40.0: [[-4.2475e+00, 1.3731e-05, -2.2883e-09], [4.5913e-05, -2.3573e-10, -1.1380e-13], [4.2475e+00, -1.3730e-05, 2.2884e-09]],
}


class Gradients:
    """The library in this process."""

    def __init__(self):
        lib = ROOT / "mechcli/target"
        jpype.startJVM("-Xmx2g", "-XX:+UseSerialGC", classpath=[str(lib / "mechcli.jar")] + glob.glob(str(lib / "lib/*.jar")))
        self.model = jpype.JClass("org.mechservice.library.MechModel")
        self.gradients = jpype.JClass("org.mechservice.study.gradient.Gradients")
        self.method = jpype.JClass("org.mechservice.study.gradient.GradientMethod")
        self.reduction = jpype.JClass("org.mechservice.study.Reduction")
        self.list = jpype.JClass("java.util.Arrays").asList

    def read(self, text):
        return self.model.of("gradients", text)

    def of(self, model, by, outputs):
        return self.gradients.of(model, self.list(jpype.JString[:](list(by))), self.list(self.reduction[:]([self.reduction.parse(o) for o in outputs])))

    def compute(self, gradients, method):
        found = gradients.compute(self.method.valueOf(method.upper()))
        return np.array([list(row) for row in found.derivatives()])


def parameters(values):
    return "".join(f'<parameter name="{name}" value="{value!r}" tunable="true"/>' for name, value in values.items())


def robertson(java, rtol):
    """Our derivatives, forward and adjoint, at the printed times, and those of CVODES."""
    by = {"p1": 0.04, "p2": 1e4, "p3": 3e7}
    states = ('<States><state name="y1" x0="1" derivative="-p1*y1 + p2*y2*y3"/>'
              '<state name="y2" x0="0" derivative="p1*y1 - p2*y2*y3 - p3*y2*y2" atol="1e-14"/>'
              '<state name="y3" x0="0" derivative="p3*y2*y2"/></States>')
    model = java.read(FRAME.format(end=40, step=0.4, integrator="ode15s", rtol=rtol, atol=1e-12, name="Robertson",
                                   parameters=parameters(by), forces="", states=states, g=0))
    ours = {}
    for method in ["forward", "adjoint"]:
        gradients = java.of(model, by, [f"at({y},{t})" for t in ROBERTSON for y in ["y1", "y2", "y3"]])
        ours[method] = java.compute(gradients, method).reshape(3, 3, 3)
    y, p = casadi.SX.sym("y", 3), casadi.SX.sym("p", 3)
    f = casadi.vertcat(-p[0] * y[0] + p[1] * y[1] * y[2], p[0] * y[0] - p[1] * y[1] * y[2] - p[2] * y[1] ** 2, p[2] * y[1] ** 2)
    grid = list(ROBERTSON)
    integrator = casadi.integrator("r", "cvodes", {"x": y, "p": p, "ode": f}, 0, grid,
                                   {"reltol": 1e-11, "abstol": 1e-15, "max_num_steps": 100000, "fsens_err_con": True})
    start, value = [1, 0, 0], list(by.values())
    p0 = casadi.MX.sym("p", 3)
    whole = casadi.Function("d", [p0], [casadi.jacobian(integrator(x0=start, p=p0)["xf"], p0)])
    peer = np.array(whole(value))
    peer = np.array([[peer[3 * k + i] for i in range(3)] for k in range(len(grid))])
    printed = np.array([ROBERTSON[t] for t in grid])
    return ours, peer, printed


def swing(java, rtol):
    """A damped and driven pendulum by five parameters and two start values beside CVODES."""
    by = {"c": 0.3, "k": 1.7, "a": 2.5, "w": 3.1, "s": 0.4}
    force = '<jointForce name="all" joint="hinge" expression="-c*hinge.v - k*hinge.q^3 + a*sin(w*t)*exp(-s*t)"/>'
    model = java.read(FRAME.format(end=5, step=0.05, integrator="ode113", rtol=rtol, atol=1e-13, name="Swing",
                                   parameters=parameters(by), forces=force, states="", g=-9.81))
    names = list(by) + ["hinge.q", "hinge.v"]
    outputs = ["last(hinge.q)", "last(hinge.v)", "integral(hinge.v)"]
    ours = {m: java.compute(java.of(model, names, outputs), m) for m in ["forward", "adjoint"]}
    x, p = casadi.SX.sym("x", 3), casadi.SX.sym("p", 7)
    t = casadi.SX.sym("t")
    inertia = 2 * 0.25 + 0.4 * 2 * 0.01
    torque = (-p[0] * x[1] - p[1] * x[0] ** 3 + p[2] * casadi.sin(p[3] * t) * casadi.exp(-p[4] * t) + 2 * 9.81 * 0.5 * casadi.cos(x[0]))
    ode = casadi.vertcat(x[1], torque / inertia, x[1])
    integrator = casadi.integrator("s", "cvodes", {"x": x, "p": p, "t": t, "ode": ode}, 0, 5,
                                   {"reltol": 1e-12, "abstol": 1e-14, "max_num_steps": 100000, "fsens_err_con": True})
    q = casadi.MX.sym("p", 7)
    out = integrator(x0=casadi.vertcat(q[5], q[6], 0), p=q)["xf"]
    peer = np.array(casadi.Function("d", [q], [casadi.jacobian(out, q)])(list(by.values()) + [0, 0]))
    return ours, peer


def driver(rtol):
    text = (ROOT / "examples/driver/driver-free-ck100.xml").read_text()
    stiffness = {}

    def named(found):
        stiffness[f"k_{found[1]}"] = float(found[4])
        return f'<joint name="{found[1]}" type="{found[2]}" {found[3]}stiffness="k_{found[1]}" damping="dampingRatio*{found[4]}"'

    text = re.sub(r'<joint name="(\w+)" type="(\w+)" ([^>]*?)stiffness="(\d+)" damping="[^"]*"', named, text)
    text = text.replace("</Parameters>", parameters(stiffness) + "</Parameters>")
    return re.sub(r'relTol="[^"]*" absTol="[^"]*"', f'relTol="{rtol}" absTol="{rtol}"', text), list(stiffness)


def thread_time():
    return time.clock_gettime(time.CLOCK_THREAD_CPUTIME_ID)


def cost(java, model, gradients, method, pairs):
    """Median of the processor time of a gradient over that of a run."""
    ratios = []
    for k in range(WARM + pairs):
        begin = thread_time()
        model.simulate()
        middle = thread_time()
        java.compute(gradients, method)
        end = thread_time()
        if k >= WARM:
            ratios.append((end - middle) / (middle - begin))
    return statistics.median(ratios)


def relative(a, b):
    """Largest difference over the largest derivative of the same output."""
    return float(np.max(np.abs(a - b) / np.max(np.abs(b), axis=-1, keepdims=True)))


def each(a, b):
    """Largest relative difference of a single derivative."""
    return float(np.max(np.abs(a - b) / np.abs(b)))


def main():
    pairs = int(sys.argv[1]) if len(sys.argv) > 1 else 30
    java = Gradients()
    rows = []
    for rtol in ["1e-6", "1e-9"]:
        ours, peer, printed = robertson(java, rtol)
        for method, found in ours.items():
            rows.append((f"Robertson's kinetics, 27 derivatives", method, rtol, each(found, peer), each(found, printed)))
        ours, peer = swing(java, rtol)
        for method, found in ours.items():
            rows.append(("driven pendulum, 3 outputs by 7", method, rtol, relative(found, peer), None))
    _, peer, printed = robertson(java, "1e-6")
    text, stiffness = driver("1e-5")
    model = java.read(text).every(END)
    last = ["last(j_handR.q)"]
    costs = []
    for method, by, asked in [("adjoint", stiffness, "5"), ("forward", stiffness[:1], "2.5"), ("forward", stiffness[:4], "7"),
                              ("forward", stiffness, f"{1 + 1.5 * len(stiffness):g}")]:
        few = max(5, pairs // 4) if len(by) > 4 and method == "forward" else pairs
        costs.append((method, len(by), cost(java, model, java.of(model, by, last), method, few), asked))
    tight = java.read(driver("1e-9")[0])
    forward = java.compute(java.of(tight, stiffness, last), "forward")
    adjoint = java.compute(java.of(tight, stiffness, last), "adjoint")
    agreement = relative(adjoint, forward)

    lines = ["# Gradients beside others", "",
             f"Measured on {date.today()} by `benchmarks/peers/gradients.py {pairs}`, {platform.machine()}, CasADi {casadi.__version__} with its CVODES.", "",
             "Robertson's kinetics are three [states](../mechml.md#states) of a model, whose derivatives by the three rate constants at 0.4, 4 and 40 s are printed in the documentation of CVODES "
             "(example cvsRoberts_FSA_dns) with five digits; each derivative counts relative to itself, though they lie between 1e-13 and 4. "
             "The pendulum is damped, has a cubic spring and is driven by a fading torque; the derivatives of its last angle and speed, and of an integral, by five parameters and both start values count relative to the largest of the same output. "
             f"CVODES works at 1e-11 and 1e-12; its own difference from the printed values is {each(peer, printed):.1e}.", "",
             "| problem | method | tolerance | from CVODES | from the printed values |", "|---|---|---|---|---|"]
    for name, method, rtol, a, b in rows:
        lines.append(f"| {name} | {method} | {rtol} | {a:.1e} | {'' if b is None else f'{b:.1e}'} |")
    lines += ["", "## Cost", "",
              "The driver of 41 joints (`driver-free-ck100.xml`, `ode15sR`, 1e-5), the last angle of a hand by the stiffnesses of its joints: processor time of a gradient over that of a run that keeps two rows, medians of pairs in one warm process. "
              "Asked: at most 5 runs by the adjoint, 1 + 1.5 p forward.", "",
              "| method | parameters | runs | asked |", "|---|---:|---:|---:|"]
    for method, count, ratio, asked in costs:
        lines.append(f"| {method} | {count} | {ratio:.1f} | {asked} |")
    lines += ["", f"At 1e-9 the 41 derivatives of both methods differ by {agreement:.1e} of the largest.", "",
              "[Gradients of 200 random models](random-gradients.md) compares both methods with differences."]
    PAGE.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


main()

#!/usr/bin/env python3
"""Identification of a robot arm's 24 parameters in four ways; writes docs/reports/identification.md.

    benchmarks/peers/identification.py [repetitions] [seeds]

Needs mechcli/target built, JPype, numpy and scipy; MuJoCo with its toolbox (mujoco[sysid]) is left
out with a word where it is missing. Every way fits the same measurements from the same start within
the same bounds, in one warm process, in turn: our fit with exact derivatives, our fit with
differences of runs, SciPy's least_squares (trust region reflective) on differences of our runs, and
MuJoCo's toolbox on its own model of the arm. Then the coverage of the intervals over seeds of noise.
"""
import glob
import pathlib
import re
import resource
import statistics
import sys
import tempfile
import time
from datetime import date

import jpype
import numpy as np
import scipy
from scipy.optimize import least_squares

try:
    import mujoco
    from mujoco import sysid

    sysid.optimize
except (ImportError, AttributeError):
    sysid = None

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/reports/identification.md"
FOLDER = ROOT / "examples/optimise"
STEP = 1e-4
SIGMA = 0.002
JOINTS = range(1, 7)
FREQUENCIES = [2.1, 3.3, 2.7, 4.1, 3.7, 5.3]
LONG = 10.0


def bounds():
    """The bounds of the command in docs/optimise.md."""
    text = (ROOT / "docs/optimise.md").read_text()
    command = next(line for line in text.splitlines() if line.startswith("./mech identify examples/optimise/arm.xml"))
    return {name: (float(low), float(high)) for name, low, high in re.findall(r" ([a-z]\d)=([\d.]+):([\d.]+)", command)}


def used():
    mine = resource.getrusage(resource.RUSAGE_SELF)
    return mine.ru_utime + mine.ru_stime


def measured(work):
    begin, clock = used(), time.perf_counter()
    result = work()
    return result, used() - begin, time.perf_counter() - clock


class Fit:
    """One set of measurements, and the ways to fit it."""

    def __init__(self, model, file):
        java = jpype.JClass
        by = bounds()
        self.names = list(by)
        values = {str(p.name()): float(p.value()) for p in model.parameters()}
        start = np.array([values[name] for name in by])
        self.low, self.high = np.array(list(by.values())).T
        self.start = np.where((start >= self.low) & (start <= self.high), start, (self.low + self.high) / 2)
        self.variables = java("java.util.ArrayList")()
        for name, a, b, s in zip(by, self.low, self.high, self.start):
            self.variables.add(java("org.mechservice.study.optimise.DesignVariable")(name, float(a), float(b), float(s)))
        sigmas = java("java.util.HashMap")()
        for joint in JOINTS:
            sigmas.put(f"j{joint}.q", jpype.JDouble(SIGMA))
        table = java("org.mechservice.result.SignalTable").read(java("java.nio.file.Path").of(str(file)))
        self.data = java("org.mechservice.study.identify.Measurements").of(table, java("java.util.HashMap")(), sigmas)
        rows = np.loadtxt(file, delimiter=",", skiprows=1)
        self.times, self.angles = rows[:, 0], rows[:, 1:7]
        self.model = model
        self.residuals = self.data.residuals(model, self.variables)
        self.slopes = self.data.slopes(model, self.variables)
        self.evaluations = 0

    def at(self, x):
        self.evaluations += 1
        return np.array(self.residuals.at(jpype.JArray(jpype.JDouble)(np.asarray(x, float))))

    def ours(self, exact):
        optional = jpype.JClass("java.util.Optional")
        slopes = optional.of(self.slopes) if exact else optional.empty()
        found = jpype.JClass("org.mechservice.study.identify.Identification").of(self.variables, self.residuals, STEP, slopes)
        return np.array(list(found.values())), f"{found.runs()}{' and the Jacobians' if exact else ''}", found

    def scipy(self):
        self.evaluations = 0
        x = least_squares(self.at, self.start, bounds=(self.low, self.high), jac="2-point", x_scale=self.high - self.low,
                          xtol=1e-10, ftol=1e-12, gtol=None, diff_step=1e-5).x
        return x, str(self.evaluations), None

    def mujoco(self):
        """MuJoCo's toolbox on its arm: implicitfast, 1 ms, frictionloss instead of tanh(v / 0.1)."""
        body = "<mujoco><option integrator='implicitfast' timestep='0.001' gravity='0 0 0'><flag contact='disable'/></option><worldbody>"
        for joint in JOINTS:
            body += (f"<body pos='{0 if joint == 1 else 0.3} 0 0'><inertial pos='0.15 0 0' mass='1' diaginertia='0.002 0.01 0.01'/>"
                     f"<joint name='j{joint}' axis='{'0 1 0' if joint % 2 else '0 0 1'}' stiffness='1' damping='1' frictionloss='0.1'/>")
        body += "</body>" * 6 + "</worldbody><actuator>"
        body += "".join(f"<motor joint='j{joint}'/>" for joint in JOINTS) + "</actuator></mujoco>"
        arm = mujoco.MjModel.from_xml_string(body)
        data = mujoco.MjData(arm)
        steps = int(round(self.times[-1] / 0.001))
        waves = np.sin(np.outer(np.arange(steps) * 0.001, FREQUENCIES))
        begin = np.zeros(mujoco.mj_stateSize(arm, mujoco.mjtState.mjSTATE_FULLPHYSICS))
        at = np.rint(self.times / 0.001).astype(int) - 1
        place = {name: i for i, name in enumerate(self.names)}
        runs = [0]

        def motion(x):
            runs[0] += 1
            of = lambda kind: np.array([x[place[f"{kind}{joint}"]] for joint in JOINTS])
            arm.jnt_stiffness[:] = of("k")[:].reshape(arm.jnt_stiffness[:].shape) if arm.jnt_stiffness.ndim == 1 else np.pad(of("k")[:, None], ((0, 0), (0, arm.jnt_stiffness.shape[1] - 1)))
            arm.dof_damping[:] = of("d") if arm.dof_damping.ndim == 1 else np.pad(of("d")[:, None], ((0, 0), (0, arm.dof_damping.shape[1] - 1)))
            arm.dof_frictionloss[:] = of("f")
            state, _ = mujoco.rollout.rollout(arm, data, begin, waves * of("g"))
            angles = state[0, at, 1:7]
            return ((angles - self.angles) / SIGMA).T.ravel()

        def residual(x, params, **_):
            columns = x if x.ndim > 1 else x[:, None]
            values = np.stack([motion(column) for column in columns.T], axis=1)
            return [values if x.ndim > 1 else values[:, 0]], None, None

        parameters = sysid.ParameterDict()
        for name, low, high, start in zip(self.names, self.low, self.high, self.start):
            parameters.add(sysid.Parameter(name, start, low, high))
        found, _ = sysid.optimize(parameters, residual, optimizer="mujoco", verbose=False)
        x = np.array(found.as_vector())
        self.mujoco_noise = float(np.sqrt(np.sum(motion(x) ** 2) / (self.angles.size - len(x))))
        return x, str(runs[0]), None

    def ways(self, toolbox):
        ways = {"exact derivatives": lambda: self.ours(True), "differences of runs": lambda: self.ours(False),
                "SciPy, differences of runs": self.scipy}
        if toolbox and sysid:
            ways["MuJoCo's toolbox, its own model"] = self.mujoco
        return ways


def table(fit, repetitions, toolbox):
    ways = fit.ways(toolbox)
    times = {name: [] for name in ways}
    answers = {}
    for k in range(repetitions + 1):
        for name, way in ways.items():
            if k != 1 and name.startswith("MuJoCo"):  # minutes
                continue
            answers[name], processor, clock = measured(way)
            if k:
                times[name].append((processor, clock))
    exact, _, found = answers["exact derivatives"]
    fit.noise = float(found.noise())
    deviations = np.array(list(found.deviations()))
    best = np.sum(fit.at(exact) ** 2)
    lines = ["| way | runs | processor s | clock s | processor, ratio to the first | sum of squares above the first | largest difference, standard deviations |",
             "|---|---|---:|---:|---:|---:|---:|"]
    first = None
    for name in ways:
        processor, clock = (statistics.median(each[i] for each in times[name]) for i in (0, 1))
        first = first or processor
        x, runs, _ = answers[name]
        above = "" if name.startswith("MuJoCo") else f"{np.sum(fit.at(x) ** 2) / best - 1:.1e}"
        apart = float(np.max(np.abs(x - exact) / deviations))
        lines.append(f"| {name} | {runs} | {processor:.2f} | {clock:.2f} | {processor / first:.1f} | {above} | {apart:.1e} |")
    return lines


def simulated(model, fit, truth, path, seed):
    """Writes angles of the model at the truth with noise, one row for each of its rows."""
    java = jpype.JClass
    values = java("java.util.HashMap")()
    for name, value in zip(fit.names, truth):
        values.put(name, java("java.lang.Double").valueOf(float(value)))
    run = model.set(values).simulate()
    rows = np.column_stack([np.array(run.time())] + [np.array(run.column(f"j{joint}.q")) for joint in JOINTS])[1:]
    rows[:, 1:] += SIGMA * np.random.default_rng(seed).standard_normal(rows[:, 1:].shape)
    np.savetxt(path, rows, delimiter=",", header="time," + ",".join(f"j{joint}.q" for joint in JOINTS), comments="")
    return path


def main():
    repetitions = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    seeds = int(sys.argv[2]) if len(sys.argv) > 2 else 50
    lib = ROOT / "mechcli/target"
    jpype.startJVM("-Xmx2g", "-XX:+UseSerialGC", classpath=[str(lib / "mechcli.jar")] + glob.glob(str(lib / "lib/*.jar")))
    model = jpype.JClass("org.mechservice.library.MechModel").read(jpype.JClass("java.nio.file.Path").of(str(FOLDER / "arm.xml")))
    fit = Fit(model, FOLDER / "arm-measured.csv")
    small = table(fit, repetitions, True)
    truth = fit.low + (fit.high - fit.low) * (0.35 + 0.3 * np.random.default_rng(24).random(len(fit.low)))
    with tempfile.TemporaryDirectory() as folder:
        long = model.until(LONG).every(0.01)
        longer = Fit(long, simulated(long, fit, truth, pathlib.Path(folder) / "long.csv", 1))
        large = table(longer, max(1, repetitions // 2), False)
    lines = ["# Identification of 24 parameters", "",
             f"Measured on {date.today()} by `benchmarks/peers/identification.py {repetitions} {seeds}`, SciPy {scipy.__version__}"
             + (f", MuJoCo {mujoco.__version__}. " if sysid else "; MuJoCo's toolbox was not installed. ")
             + "[The robot arm](../optimise.md#identify) of six joints: springs, dampers, dry friction and motors. "
             "All ways fit the same measurements from the same start within the same bounds, in turn, in one warm process with the code of runs and of derivatives prepared. "
             "SciPy works on runs of our generated code. Medians; processor time counts all threads.", "",
             "## 450 measured angles, 3 s", ""] + small + [
             "", f"## {longer.angles.size} measured angles, {LONG:.0f} s at 100 Hz", "",
             "Simulated with known parameters and the same noise.", ""] + large + [""]
    if sysid:
        lines += ["MuJoCo's arm has `frictionloss`, a constraint, where ours has `tanh(v / 0.1)`, and steps of 1 ms (`implicitfast`); its optimiser takes one-sided differences. "
                  f"It fits its own model, so its parameters are not ours: the size of its weighted residuals is {fit.mujoco_noise:.2f}, where ours is {fit.noise:.2f}. It was measured once, and not with the longer measurement, which would take it minutes.", ""]
    PAGE.write_text("\n".join(lines).rstrip() + "\n")
    print("\n".join(lines), flush=True)
    lines += coverage(model, fit, truth, seeds)
    PAGE.write_text("\n".join(lines) + "\n")
    print("\n".join(lines[-3:]))


def coverage(model, fit, truth, seeds):
    """How many intervals hold the truth, as lines of the page."""
    held = 0
    coarse = model.every(0.04)
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(seeds):
            one = Fit(coarse, simulated(coarse, fit, truth, pathlib.Path(folder) / "seed.csv", 100 + seed))
            _, _, found = one.ours(True)
            held += sum(abs(float(found.values()[k]) - truth[k]) <= float(found.halfWidth(k, 0.95)) for k in range(len(truth)))
    count = seeds * len(truth)
    return ["## Coverage", "", f"Of {count} intervals of 95 % ({seeds} seeds of noise, 24 parameters, 450 angles) {held} hold the known truth: {100 * held / count:.1f} %."]


main()

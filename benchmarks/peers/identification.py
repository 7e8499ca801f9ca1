#!/usr/bin/env python3
"""Identification of a robot arm's 24 parameters, three ways; writes docs/reports/identification.md.

    benchmarks/peers/identification.py [repetitions]

Needs mechcli/target built, JPype, numpy and scipy. Every way fits the same measurements from the same
start with the same bounds, in one warm process, in turn: our fit with exact derivatives, our fit with
differences of runs, and SciPy's least_squares (trust region reflective) on differences of the same runs.
"""
import glob
import pathlib
import re
import resource
import statistics
import sys
import time
from datetime import date

import jpype
import numpy as np
import scipy
from scipy.optimize import least_squares

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs/reports/identification.md"
FOLDER = ROOT / "examples/optimise"
STEP = 1e-4
SIGMA = 0.002


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


def main():
    repetitions = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    lib = ROOT / "mechcli/target"
    jpype.startJVM("-Xmx2g", "-XX:+UseSerialGC", classpath=[str(lib / "mechcli.jar")] + glob.glob(str(lib / "lib/*.jar")))
    Model = jpype.JClass("org.mechservice.library.MechModel")
    Path = jpype.JClass("java.nio.file.Path")
    Table = jpype.JClass("org.mechservice.result.SignalTable")
    Measurements = jpype.JClass("org.mechservice.study.identify.Measurements")
    Identification = jpype.JClass("org.mechservice.study.identify.Identification")
    Variable = jpype.JClass("org.mechservice.study.optimise.DesignVariable")
    Optional = jpype.JClass("java.util.Optional")
    by = bounds()
    model = Model.read(Path.of(str(FOLDER / "arm.xml")))
    file = {str(p.name()): float(p.value()) for p in model.parameters()}
    start = np.array([file[name] for name in by])
    low, high = np.array(list(by.values())).T
    start = np.where((start >= low) & (start <= high), start, (low + high) / 2)
    variables = jpype.JClass("java.util.ArrayList")()
    for name, a, b, s in zip(by, low, high, start):
        variables.add(Variable(name, float(a), float(b), float(s)))
    sigmas = jpype.JClass("java.util.HashMap")()
    for joint in range(1, 7):
        sigmas.put(f"j{joint}.q", jpype.JDouble(SIGMA))
    data = Measurements.of(Table.read(Path.of(str(FOLDER / "arm-measured.csv"))), jpype.JClass("java.util.HashMap")(), sigmas)
    residuals = data.residuals(model, variables)
    evaluations = [0]

    def at(x):
        evaluations[0] += 1
        return np.array(residuals.at(jpype.JArray(jpype.JDouble)(x)))

    def exact():
        return Identification.of(variables, residuals, STEP, Optional.of(data.slopes(model, variables)))

    def differences():
        return Identification.of(variables, residuals, STEP, Optional.empty())

    def peer():
        evaluations[0] = 0
        return least_squares(at, start, bounds=(low, high), jac="2-point", x_scale=high - low, xtol=1e-10, ftol=1e-12, gtol=None, diff_step=1e-5)

    ways = {"exact derivatives": exact, "differences of runs": differences, "SciPy, differences of runs": peer}
    times = {name: [] for name in ways}
    answers = {}
    for k in range(repetitions + 1):
        for name, way in ways.items():
            answers[name], processor, clock = measured(way)
            if k:
                times[name].append((processor, clock))
    values = {name: np.array(answer.x if hasattr(answer, "x") else list(answer.values())) for name, answer in answers.items()}
    deviations = np.array(list(answers["exact derivatives"].deviations()))
    runs = {"exact derivatives": f"{answers['exact derivatives'].runs()} beside the Jacobians",
            "differences of runs": str(answers["differences of runs"].runs()), "SciPy, differences of runs": str(evaluations[0])}
    best = np.sum(at(values["exact derivatives"]) ** 2)
    rows = []
    for name in ways:
        p, c = (statistics.median(each[i] for each in times[name]) for i in (0, 1))
        rows.append((name, runs[name], p, c, np.sum(at(values[name]) ** 2) / best - 1,
                     float(np.max(np.abs(values[name] - values["exact derivatives"]) / deviations))))
    lines = ["# Identification of 24 parameters", "",
             f"Measured on {date.today()} by `benchmarks/peers/identification.py {repetitions}`, SciPy {scipy.__version__}. "
             "[The robot arm](../optimise.md#identify) of six joints: springs, dampers, dry friction and motors, 450 measured angles. "
             "All three fit the same measurements from the same start within the same bounds, in turn, in one warm process; the runs of all are those of our generated code. "
             "Medians; processor time counts all threads, those that compile included.", "",
             "| way | runs | processor s | clock s | processor, ratio to the first | sum of squares above the first | largest difference, standard deviations |",
             "|---|---|---:|---:|---:|---:|---:|"]
    for name, count, p, c, above, apart in rows:
        lines.append(f"| {name} | {count} | {p:.2f} | {c:.2f} | {p / rows[0][2]:.1f} | {above:.1e} | {apart:.1e} |")
    PAGE.write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


main()

#!/usr/bin/env python3
"""Measures scenes as FMU with FMPy and writes the page docs/reports/export.md.

python benchmarks/export.py [--lib mechcli/target] [--out docs/reports/export.md] [SCENE.xml ...]

Needs fmpy, pandas and JPype. Each scene is built by the command line, in one Java process, for FMI 2.0
and 3.0, validated, and run in Model Exchange (CVode at 1e-10) and in Co-Simulation at the tolerance of
the scene; the reference is `mech simulate` at 1e-12. A scene whose export is refused is listed with its
reason. Without scenes: all of examples/ whose simulation is a motion.
"""
import argparse
import glob
import os
import sys
import tempfile
import time
from datetime import date

import jpype
import numpy as np
import pandas as pd
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

# Inputs, which the file takes from a table: the unit is validated, not compared.
INPUTS = ["examples/elements/input.xml"]

# Forces written as Java classes, as inputs of their units: likewise.
CLASSES = {
    "examples/five-point-suspension/five-point-suspension.xml": ["fBody", "fFpsSpringDamper"],
    "examples/driver/driver-ck100.xml": ["fJointSprings", "fSteeringWheel", "fFloor", "fSeat", "fBelts"],
}


class Mech:
    """The command line in this process."""

    def __init__(self, lib):
        jpype.startJVM("-Xmx1500m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", classpath=[f"{lib}/mechcli.jar"] + glob.glob(f"{lib}/lib/*.jar"))
        self.text = jpype.JClass("java.io.StringWriter")
        self.writer = jpype.JClass("java.io.PrintWriter")
        self.mech = jpype.JClass("org.mechservice.cli.Mech")

    def run(self, *words):
        """Returns the last line of the errors; empty if there are none."""
        out, err = self.text(), self.text()
        status = self.mech.run(self.writer(out), self.writer(err), jpype.JString[:](list(words)))
        lines = str(err.toString()).strip().splitlines()
        return "" if int(status) == 0 else lines[-1] if lines else f"status {status}"


def instants(run, names):
    """Times of a run in Model Exchange at which a column jumps, by name."""
    at = np.flatnonzero(np.diff(run["time"]) < 1e-9)
    return {name: run["time"][at][np.abs(np.diff(run[name])[at]) > 1e-6] for name in names}


def largest_error(run, reference, names, left_out):
    """Largest error over the size of the column, but for some times; of several rows the best counts."""
    worst = 0.0
    times = reference.iloc[:, 0].to_numpy()
    for name in names:
        right = reference[name].to_numpy()
        size = max(1, np.abs(right).max())
        for t, value in zip(times, right):
            low, high = np.searchsorted(run["time"], [t - 1e-9, t + 1e-9])
            if high > low and not any(abs(t - o) < 1e-9 for o in left_out.get(name, ())):
                worst = max(worst, np.abs(run[name][low:high] - value).min() / size)
    return worst


def description_of(scene):
    return os.path.relpath(scene, "examples")[:-4]


def measure(scene, mech, folder):
    unit, rows = f"{folder}/scene.fmu", f"{folder}/scene.csv"
    more = [word for name in CLASSES.get(scene, []) for word in ("--class-as-input", name)]
    began = time.time()
    refused = mech.run("build", scene, "-o", unit, "--columns", "joints", *more)
    seconds = time.time() - began
    if refused:
        return [description_of(scene), refused]
    three = unit.replace(".fmu", "-3.fmu")
    mech.run("build", scene, "-o", three, "--columns", "joints", "--fmi", "3", *more)
    findings = len(validate_fmu(unit)) + len(validate_fmu(three))
    description = read_model_description(unit)
    tolerance = float(description.defaultExperiment.tolerance)
    line = [description_of(scene), f"{tolerance:.0e}".replace("e-0", "e-")]
    size = [str(findings), str(os.path.getsize(unit) // 1024), f"{seconds:.1f}"]
    if more or scene in INPUTS:
        return line + ["–", "–", "–", "–"] + size
    refused = mech.run("simulate", scene, "--rtol", "1e-12", "--atol", "1e-12", "--columns",
                       "joints", "--out", rows, "--quiet")
    if refused:
        return [description_of(scene), "no reference: " + refused]
    reference = pd.read_csv(rows)
    variables = {v.name for v in description.modelVariables if v.causality in ("local", "output")}
    names = [c for c in reference.columns[1:] if c in variables]
    if not names:
        return [description_of(scene), "nothing of it moves freely"]
    span = dict(start_time=reference.iloc[0, 0], stop_time=reference.iloc[-1, 0],
                output_interval=float(description.defaultExperiment.stepSize), output=names)
    errors, events = [], {}
    for of, kind, rtol in ((unit, "ModelExchange", 1e-10), (unit, "CoSimulation", tolerance),
                           (three, "ModelExchange", 1e-10), (three, "CoSimulation", tolerance)):
        try:
            run = simulate_fmu(of, fmi_type=kind, relative_tolerance=rtol, **span)
            left_out = {} if kind == "ModelExchange" else events
            errors.append(largest_error(run, reference, names, left_out))
            events = instants(run, names) if kind == "ModelExchange" else events
        except Exception as failure:
            print(scene, of, kind, failure, flush=True)
            errors.append(float("nan"))
    def text(x):
        return "failed" if x != x else f"{x:.1e}"
    me = text(errors[0]) if text(errors[0]) == text(errors[2]) else f"{text(errors[0])}, {text(errors[2])}"
    over = f"{errors[1] / tolerance:.2g}"
    return line + [me, text(errors[1]), over, "yes" if errors[1] == errors[3] else "no"] + size


def is_motion(scene):
    with open(scene, encoding="utf-8") as file:
        text = file.read()
    first = text.find("<dynamic")
    others = [text.find(f"<{kind}") for kind in ("static", "kinematic", "inverseDynamic", "linearize")]
    return "<MechML" in text and first > 0 and all(o < 0 or o > first for o in others)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--lib", default="mechcli/target")
    options.add_argument("--out", default="docs/reports/export.md")
    options.add_argument("scenes", nargs="*")
    given = options.parse_args()
    scenes = given.scenes or sorted(filter(is_motion, glob.glob("examples/**/*.xml", recursive=True)))
    mech = Mech(given.lib)
    good, refused = [], []
    for scene in scenes:
        with tempfile.TemporaryDirectory() as folder:
            line = measure(scene, mech, folder)
        print(*line, flush=True)
        (good if len(line) > 2 else refused).append(line)
        write(given.out, good, refused)


def write(out, good, refused):
    with open(os.path.join(os.path.dirname(__file__), "export.md.in"), encoding="utf-8") as template:
        page = template.read()
    table = "\n".join("| " + " | ".join(line) + " |" for line in good)
    left = "\n".join(f"- {scene}: {why}" for scene, why in refused)
    page = page.replace("{date}", date.today().isoformat()).replace("{table}", table)
    page = page.replace("{count}", str(len(good)))
    with open(out, "w", encoding="utf-8") as file:
        file.write(page.replace("{refused}", left))


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Measures scenes as FMU with FMPy and writes the page docs/reports/export.md.

python benchmarks/export.py [--mech ./mech] [--out docs/reports/export.md] [SCENE.xml ...]

Each scene is built for FMI 2.0 and 3.0, validated, and run in Model Exchange (CVode at 1e-10) and in
Co-Simulation at the tolerance of the scene; the reference is `mech simulate` at 1e-12. A scene whose
export is refused is listed with its reason.
"""
import argparse
import os
import subprocess
import sys
import tempfile
import time
from datetime import date

import numpy as np
import pandas as pd
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu

SCENES = [
    "examples/benchmarks/A01_simple_pendulum.xml",
    "examples/benchmarks/A05_flyball.xml",
    "examples/benchmarks/double_pendulum.xml",
    "examples/benchmarks/bouncing_ball.xml",
    "examples/benchmarks/A03_andrews.xml",
    "examples/benchmarks/slider_crank_planar.xml",
    "examples/extremes/fourbar_redundant.xml",
    "examples/extremes/bennett.xml",
    "examples/pendulum/pendulum.xml",
    "examples/five-point-suspension/variants/elements.xml",
    "examples/five-point-suspension/five-point-suspension.xml",
    "examples/driver/driver-free-c0.xml",
    "examples/driver/driver-free-ck100.xml",
    "examples/driver/variants/driver-c0-elements.xml",
    "examples/driver/variants/driver-ck100-elements.xml",
    "examples/driver/driver-ck100.xml",
    "examples/robot/robot.xml",
    "examples/elements/event.xml",
    "examples/elements/States.xml",
    "examples/elements/table.xml",
    "examples/elements/pid.xml",
    "examples/elements/transferFunction.xml",
    "examples/elements/CoordConstraint.xml",
    "examples/elements/PointOnLine.xml",
    "examples/elements/contact.xml",
    "examples/elements/jointVal.xml",
]


def largest_error(run, reference):
    times = reference.iloc[:, 0].to_numpy()
    rows = np.minimum(np.searchsorted(run["time"], times - 1e-9), len(run["time"]) - 1)
    same = np.abs(run["time"][rows] - times) < 1e-7
    worst = 0.0
    for name in reference.columns[1:]:
        if name in run.dtype.names:
            right = reference[name].to_numpy()
            wrong = np.abs(run[name][rows] - right)[same].max()
            worst = max(worst, wrong / max(1, np.abs(right).max()))
    return worst


def measure(scene, mech, folder):
    name = os.path.basename(scene)[:-4] + "-" + str(abs(hash(scene)) % 10000)
    unit, rows = f"{folder}/{name}.fmu", f"{folder}/{name}.csv"
    began = time.time()
    built = subprocess.run([mech, "build", scene, "-o", unit, "--columns", "joints"],
                           capture_output=True, text=True)
    seconds = time.time() - began
    if built.returncode != 0:
        return [scene, "refused: " + built.stderr.strip().splitlines()[-1]]
    three = unit.replace(".fmu", "-3.fmu")
    subprocess.run([mech, "build", scene, "-o", three, "--columns", "joints", "--fmi", "3"],
                   check=True, capture_output=True)
    findings = validate_fmu(unit) + validate_fmu(three)
    subprocess.run([mech, "simulate", scene, "--rtol", "1e-12", "--atol", "1e-12", "--columns",
                    "joints", "--out", rows, "--quiet"], check=True, capture_output=True)
    reference = pd.read_csv(rows)
    description = read_model_description(unit)
    tolerance = float(description.defaultExperiment.tolerance)
    known = {v.name for v in description.modelVariables}
    span = dict(start_time=reference.iloc[0, 0], stop_time=reference.iloc[-1, 0],
                output_interval=float(description.defaultExperiment.stepSize),
                output=[c for c in reference.columns if c in known], record_events=False)
    line = [scene, f"{tolerance:.0e}".replace("e-0", "e-")]
    for kind, rtol in (("ModelExchange", 1e-10), ("CoSimulation", tolerance)):
        try:
            error = largest_error(simulate_fmu(unit, fmi_type=kind, relative_tolerance=rtol, **span),
                                  reference)
            line.append(f"{error:.1e}")
        except Exception as failure:
            error = float("nan")
            line.append(type(failure).__name__)
    line += [f"{error / tolerance:.2g}", str(len(findings)),
             str(os.path.getsize(unit) // 1024), f"{seconds:.1f}"]
    return line


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--mech", default="./mech")
    options.add_argument("--out", default="docs/reports/export.md")
    options.add_argument("scenes", nargs="*", default=SCENES)
    given = options.parse_args()
    good, refused = [], []
    with tempfile.TemporaryDirectory() as folder:
        for scene in given.scenes:
            line = measure(scene, given.mech, folder)
            print(*line, flush=True)
            (good if len(line) > 2 else refused).append(line)
    with open(os.path.join(os.path.dirname(__file__), "export.md.in"), encoding="utf-8") as template:
        page = template.read()
    table = "\n".join("| " + " | ".join(line) + " |" for line in good)
    left = "\n".join(f"- {scene}: {why}" for scene, why in refused)
    page = page.replace("{date}", date.today().isoformat()).replace("{table}", table)
    with open(given.out, "w", encoding="utf-8") as out:
        out.write(page.replace("{refused}", left))


if __name__ == "__main__":
    sys.exit(main())

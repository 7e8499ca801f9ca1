#!/usr/bin/env python3
"""Turns a run of the step benchmarks into the page docs/reports/step-overhead.md.

    java -jar benchmarks/target/benchmarks.jar "StepOverhead|RightHandSide|StepMemory" \\
         -rf json -rff benchmarks/target/steps.json
    benchmarks/overhead.py benchmarks/target/steps.json

Own work per step: the time of a step less that of its evaluations, each at the time of f alone.
"""
import datetime
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "reports" / "step-overhead.md"
ALLOWED = {"ODE113": 0.30, "ODE15S": 0.45}
SIZE = {"VanDerPol": 2, "EulerRigidBody": 3, "Kepler": 4, "Hires": 8}
TO_MICROSECONDS = {"ns": 1e-3, "us": 1.0, "ms": 1e3, "s": 1e6}


def microseconds(metric):
    """Time of one operation; JMH tells it as such or as operations in a time."""
    unit = metric["scoreUnit"]
    if unit.startswith("ops/"):
        return TO_MICROSECONDS[unit[4:]] / metric["score"]
    return TO_MICROSECONDS[unit.split("/")[0]] * metric["score"]


def secondary(result, name):
    for key, metric in result["secondaryMetrics"].items():
        if key.split(":")[-1].strip("\u00b7") == name:
            return metric
    sys.exit(f"{result['benchmark']} has no {name}: run it with the options of the benchmarks")


def main():
    results = json.loads(pathlib.Path(sys.argv[1]).read_text())
    by_name = {}
    for result in results:
        by_name.setdefault(result["benchmark"].split(".")[-2], []).append(result)
    missing = {"StepOverhead", "RightHandSide", "StepMemory"} - by_name.keys()
    if missing:
        sys.exit(f"no results of {', '.join(sorted(missing))}")
    f = {r["params"]["problem"]: microseconds(r["primaryMetric"]) for r in by_name["RightHandSide"]}
    rows = []
    for result in by_name["StepOverhead"]:
        method, problem = result["params"]["method"], result["params"]["problem"]
        step = microseconds(secondary(result, "step"))
        evaluations = step / microseconds(secondary(result, "evaluation"))
        own = step - evaluations * f[problem]
        limit = ALLOWED.get(method)
        verdict = "" if limit is None else f"{limit:.2f}: {'kept' if own <= limit else 'missed'}"
        rows.append((SIZE.get(problem, 0), problem, method, step, evaluations, own, verdict))
    rows.sort()
    lines = [
        "# What a step costs",
        "",
        f"Measured on {datetime.date.today()} with JMH {results[0]['jmhVersion']}, "
        f"Java {results[0]['jdkVersion']}, all in one run, relative and absolute tolerance 1e-6.",
        "Microseconds; own work is a step less its evaluations of f.",
        "",
        "| problem | n | method | step | evaluations in it | own work | allowed |",
        "|---|---|---|---|---|---|---|",
    ]
    for n, problem, method, step, evaluations, own, verdict in rows:
        lines.append(f"| {problem} | {n} | {method} | {step:.3f} | {evaluations:.2f} "
                     f"| {own:.3f} | {verdict} |")
    lines += ["", "| method | bytes allocated per step |", "|---|---|"]
    for result in by_name["StepMemory"]:
        size = secondary(result, "gc.alloc.rate.norm")["score"]
        lines.append(f"| {result['params']['method']} | {size:.1f} |")
    PAGE.write_text("\n".join(lines) + "\n")
    print(PAGE)


if __name__ == "__main__":
    main()

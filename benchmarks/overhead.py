#!/usr/bin/env python3
"""Turns a run of the step benchmarks into the page docs/reports/step-overhead.md.

    java -jar benchmarks/target/benchmarks.jar "StepOverhead|RightHandSideCost|StepMemory" \\
         -rf json -rff benchmarks/target/steps.json
    benchmarks/overhead.py benchmarks/target/steps.json [PAGE]

Own work per step: the time of a step less that of its evaluations, each at the time of f alone.
"""
import datetime
import json
import os
import pathlib
import platform
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "reports" / "step-overhead.md"
ALLOWED = {"ODE113": 0.30, "ODE15S": 0.45}
PEER = "HIPPARCHUS"
SIZE = {"VanDerPol": 2, "EulerRigidBody": 3, "Kepler": 4, "Hires": 8}
TITLE = {
    "ODE113": "ode113",
    "DE": "DE",
    "ODE15S": "ode15s",
    "SWITCHING": "switching",
    "HIPPARCHUS_ADAMS": "Hipparchus AdamsMoulton(6)",
    "HIPPARCHUS_DOP853": "Hipparchus DOP853",
}
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


class Step:
    """What one step of a method on a problem takes, in microseconds."""

    def __init__(self, result, f):
        self.time = microseconds(secondary(result, "step"))
        self.evaluations = self.time / microseconds(secondary(result, "evaluation"))
        self.own = self.time - self.evaluations * f


def by_class(results):
    found = {}
    for result in results:
        found.setdefault(result["benchmark"].split(".")[-2], []).append(result)
    missing = {"StepOverhead", "RightHandSideCost", "StepMemory"} - found.keys()
    if missing:
        sys.exit(f"no results of {', '.join(sorted(missing))}")
    return found


def table(head, rows):
    yield "| " + " | ".join(head) + " |"
    yield "|" + "---|" * len(head)
    for row in rows:
        yield "| " + " | ".join(row) + " |"


def verdicts(steps, methods, problems):
    peers = [m for m in methods if m.startswith(PEER)]
    for method, allowed in ALLOWED.items():
        worst = max(problems, key=lambda p: steps[p, method].own)
        own = steps[worst, method].own
        ratio = max(steps[p, method].own / steps[p, q].own for p in problems for q in peers)
        yield [TITLE[method], f"{allowed:.2f}", f"{own:.3f} ({worst})",
               "kept" if own <= allowed else "missed", f"{ratio:.2f}"]


def main():
    results = json.loads(pathlib.Path(sys.argv[1]).read_text())
    page = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else PAGE
    found = by_class(results)
    f = {r["params"]["problem"]: microseconds(r["primaryMetric"]) for r in found["RightHandSideCost"]}
    problems = sorted(f, key=SIZE.get)
    steps = {}
    for result in found["StepOverhead"]:
        problem, method = result["params"]["problem"], result["params"]["method"]
        steps[problem, method] = Step(result, f[problem])
    methods = [m for m in TITLE if any(m == method for _, method in steps)]
    titles = [TITLE[m] for m in methods]
    lines = [
        "# What a step costs",
        "",
        f"Measured on {datetime.date.today()} with JMH {results[0]['jmhVersion']}, "
        f"Java {results[0]['jdkVersion']}, {platform.system()} {platform.machine()}, "
        f"{os.cpu_count()} processors, all in one run, relative and absolute tolerance 1e-6. "
        "Own work is a step less its evaluations of f, each at the time of f alone; starts, "
        "rejected steps, Jacobians and factorisations are shared among the accepted steps.",
        "",
        "## Own work per step, us",
        "",
        *table(["problem", "n"] + titles,
               [[p, str(SIZE[p])] + [f"{steps[p, m].own:.3f}" for m in methods] for p in problems]),
        "",
        *table(["method", "allowed", "most", "", "most over what Hipparchus takes"],
               verdicts(steps, methods, problems)),
        "",
        "## Steps with their evaluations, us",
        "",
        *table(["problem", "f alone"] + titles,
               [[p, f"{f[p]:.4f}"] + [f"{steps[p, m].time:.3f}" for m in methods] for p in problems]),
        "",
        "## Evaluations in a step",
        "",
        *table(["problem"] + titles,
               [[p] + [f"{steps[p, m].evaluations:.2f}" for m in methods] for p in problems]),
        "",
        "## Memory",
        "",
        *table(["method", "bytes allocated per step"],
               [[TITLE[r["params"]["method"]], f"{secondary(r, 'gc.alloc.rate.norm')['score']:.2f}"]
                for r in found["StepMemory"]]),
    ]
    page.write_text("\n".join(lines) + "\n")
    print(page)


if __name__ == "__main__":
    main()

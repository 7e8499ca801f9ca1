"""Runs SciPy's integrators on the problems given on standard input; one CSV line per run."""
import json
import math
import sys
import time

import numpy
import scipy
from scipy.integrate import solve_ivp

NAMES = {name: getattr(math, name) for name in ("sin", "cos", "exp", "sqrt", "log", "asin", "pi")}
TOLERANCES = [float(text) for text in sys.argv[1].split(",")]
LIMIT = float(sys.argv[2])


class TooLong(Exception):
    pass


def right_hand_side(problem):
    given = dict(NAMES)
    for name, text in problem["params"].items():
        given[name] = eval(text, given)
    lines = ["def f(t, y, count, stop):", "    count[0] += 1", "    if clock() > stop: raise TooLong()"]
    lines += [f"    y{i} = y[{i}]" for i in range(problem["n"])]
    lines += [f"    {aux['name']} = {aux['expr']}" for aux in problem["aux"]]
    lines += ["    r = [" + ", ".join(problem["rhs"]) + "]"]
    if problem["form"] == "mass":
        lines += ["    M = zeros((%d, %d))" % (problem["n"], problem["n"])]
        lines += [f"    M[{m['i']}, {m['j']}] = {m['expr']}" for m in problem["mass"]]
        lines += ["    r = solve(M, r)"]
    lines += ["    return r"]
    given.update(zeros=numpy.zeros, solve=numpy.linalg.solve, clock=time.perf_counter, TooLong=TooLong)
    exec("\n".join(lines), given)
    return given["f"]


def run(problem, method, rtol):
    f = right_hand_side(problem)
    scale = numpy.array([float(text) for text in problem["scale"]])
    expected = numpy.array([float(text) for text in problem["reference"]])
    start = [float(text) for text in problem["y0"]]
    count = [0]
    began = time.perf_counter()
    try:
        solution = solve_ivp(
            lambda t, y: f(t, y, count, began + LIMIT),
            (float(eval(problem["t0"], dict(NAMES))), problem["end"]),
            start,
            method=method,
            rtol=rtol,
            atol=rtol * scale,
        )
    except (TooLong, OverflowError, ValueError, ZeroDivisionError, numpy.linalg.LinAlgError):
        return None
    if not solution.success:
        return None
    scored = problem["scored"]
    error = max(
        abs(solution.y[i, -1] - expected[i]) / (abs(expected[i]) + scale[i]) for i in scored
    )
    return error, count[0], len(solution.t) - 1, time.perf_counter() - began


def main():
    print("SciPy " + scipy.__version__)
    for problem in json.load(sys.stdin):
        for method in ("DOP853", "LSODA", "BDF", "Radau"):
            if method == "DOP853" and problem["klass"] not in ("nonstiff", "mechanical"):
                continue
            for rtol in TOLERANCES:
                result = run(problem, method, rtol)
                if result is not None:
                    fields = [problem["id"], "SciPy " + method, rtol, *result]
                    print(",".join(str(field) for field in fields), flush=True)


main()

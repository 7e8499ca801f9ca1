"""Runs integrators of SciPy and SUNDIALS on the problems of standard input; one CSV line per run."""
import json
import math
import sys
import time

import numpy
import scipy
from scipy.integrate import solve_ivp

try:
    import sksundae
    from sksundae.cvode import CVODE
except ImportError:
    sksundae = None

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


def scipy_end(method, f, span, start, rtol, atol):
    solution = solve_ivp(f, span, start, method=method, rtol=rtol, atol=atol)
    return (solution.y[:, -1], len(solution.t) - 1) if solution.success else None


def cvode_end(method, f, span, start, rtol, atol):
    def rhs(t, y, yp):
        yp[:] = f(t, y)

    solver = CVODE(rhs, method=method, rtol=rtol, atol=atol, max_num_steps=1_000_000)
    # Two times: output at every internal step; the last is the end.
    solution = solver.solve(numpy.array(span), numpy.array(start))
    return (solution.y[-1, :], len(solution.t) - 1) if solution.success else None


def run(problem, solve, method, rtol):
    f = right_hand_side(problem)
    scale = numpy.array([float(text) for text in problem["scale"]])
    expected = numpy.array([float(text) for text in problem["reference"]])
    start = [float(text) for text in problem["y0"]]
    count = [0]
    began = time.perf_counter()
    try:
        end = solve(
            method,
            lambda t, y: f(t, y, count, began + LIMIT),
            (float(eval(problem["t0"], dict(NAMES))), problem["end"]),
            start,
            rtol,
            rtol * scale,
        )
    except (TooLong, OverflowError, ValueError, ZeroDivisionError, numpy.linalg.LinAlgError):
        return None
    if end is None:
        return None
    y, steps = end
    error = max(abs(y[i] - expected[i]) / (abs(expected[i]) + scale[i]) for i in problem["scored"])
    return error, count[0], steps


def peers(klass):
    nonstiff = klass in ("nonstiff", "mechanical")
    names = ["DOP853"] if nonstiff else []
    for method in names + ["LSODA", "BDF", "Radau"]:
        yield "SciPy " + method, scipy_end, method
    if sksundae is not None:
        for method in ["Adams", "BDF"] if nonstiff else ["BDF"]:
            yield "SUNDIALS CVODE " + method, cvode_end, method


def main():
    sundials = "" if sksundae is None else ", SUNDIALS " + sksundae.SUNDIALS_VERSION
    print("SciPy " + scipy.__version__ + sundials, flush=True)
    for problem in json.load(sys.stdin):
        for name, solve, method in peers(problem["klass"]):
            for rtol in TOLERANCES:
                result = run(problem, solve, method, rtol)
                if result is not None:
                    fields = [problem["id"], name, rtol, *result]
                    print(",".join(str(field) for field in fields), flush=True)


main()

"""Runs integrators of SciPy and SUNDIALS on the problems of standard input; one CSV line per run."""
import functools
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
    from sksundae.ida import IDA
except ImportError:
    sksundae = None

NAMES = {name: getattr(math, name) for name in ("sin", "cos", "exp", "sqrt", "log", "asin", "pi")}
TOLERANCES = [float(text) for text in sys.argv[1].split(",")]
LIMIT = float(sys.argv[2])
STIFF_SUNDIALS = sys.argv[3] == "STIFF_SUNDIALS"
TOO_LONG = "not finished within %g s" % LIMIT
NOT_RUN = "not run: it did not finish at a looser tolerance"


class TooLong(Exception):
    pass


class Failed(Exception):
    pass


def right_hand_side(problem, residual=False):
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
        lines += ["    return M, r" if residual else "    r = solve(M, r)"]
    lines += ["    return r"]
    given.update(zeros=numpy.zeros, solve=numpy.linalg.solve, clock=time.process_time, TooLong=TooLong)
    exec("\n".join(lines), given)
    return given["f"]


def scipy_end(method, f, span, start, rtol, atol):
    solution = solve_ivp(f, span, start, method=method, rtol=rtol, atol=atol)
    if not solution.success:
        raise Failed(solution.message)
    return solution.y[:, -1], len(solution.t) - 1


def cvode_end(method, f, span, start, rtol, atol):
    def rhs(t, y, yp):
        yp[:] = f(t, y)

    solver = CVODE(rhs, method=method, rtol=rtol, atol=atol, max_num_steps=1_000_000)
    # Two times: output at every internal step; the last is the end.
    solution = solver.solve(numpy.array(span), numpy.array(start))
    if not solution.success:
        raise Failed(solution.message)
    return solution.y[-1, :], len(solution.t) - 1


def ida_end(problem, left_out, f, span, start, rtol, atol):
    def residual(t, y, yp, r):
        mass, right = f(t, y)
        r[:] = mass @ yp - right

    algebraic = problem["algebraic"]
    if left_out:
        # No error test and no test of the iteration then sees them.
        atol = numpy.where(numpy.isin(numpy.arange(problem["n"]), algebraic), 1e30, atol)
    solver = IDA(residual, rtol=rtol, atol=atol, algebraic_idx=algebraic, max_num_steps=1_000_000)
    slope = numpy.array([float(text) for text in problem["yp0"]])
    solution = solver.solve(numpy.array(span), numpy.array(start), slope)
    if not solution.success:
        raise Failed(solution.message)
    return solution.y[-1, :], len(solution.t) - 1


def run(problem, solve, method, rtol):
    f = right_hand_side(problem, bool(problem["algebraic"]))
    scale = numpy.array([float(text) for text in problem["scale"]])
    expected = numpy.array([float(text) for text in problem["reference"]])
    start = [float(text) for text in problem["y0"]]
    count = [0]
    began = time.process_time()
    error, steps, cause = math.nan, 0, ""
    try:
        y, steps = solve(
            method,
            lambda t, y: f(t, y, count, began + LIMIT),
            (float(eval(problem["t0"], dict(NAMES))), problem["end"]),
            start,
            rtol,
            rtol * scale,
        )
        error = max(abs(y[i] - expected[i]) / (abs(expected[i]) + scale[i]) for i in problem["scored"])
    except TooLong:
        cause = TOO_LONG
    except (Failed, RuntimeError, ArithmeticError, ValueError, numpy.linalg.LinAlgError) as reason:
        cause = str(reason).replace("\n", " ") or type(reason).__name__
    return error, count[0], steps, cause


def peers(problem):
    if STIFF_SUNDIALS:
        if sksundae is not None and problem["algebraic"]:
            for name, left_out in (("IDA", False), ("IDA, algebraic left out", True)):
                yield name, functools.partial(ida_end, problem), left_out
        elif sksundae is not None:
            yield "CVODE", cvode_end, "BDF"
        return
    klass = problem["klass"]
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
        for name, solve, method in peers(problem):
            hopeless = False
            for rtol in TOLERANCES:
                result = (math.nan, 0, 0, NOT_RUN) if hopeless else run(problem, solve, method, rtol)
                hopeless = hopeless or result[3] == TOO_LONG
                fields = [problem["id"], name.replace(",", ";"), rtol, *result]
                print(",".join("NaN" if field != field else str(field) for field in fields), flush=True)


main()

#!/usr/bin/env python3
"""Diffusion with reaction on a plate of 316 x 316 points: ode15s beside CVODE with sparse factors.

    benchmarks/peers/diffusion.py [points along an edge] [tolerance]

Needs benchmarks/target/benchmarks.jar built and numpy; for CVODE with KLU a C compiler and SUNDIALS with KLU (on Debian libsundials-dev and
libsuitesparse-dev), for CVODE with SuperLU_MT scipy and scikit-sundae. What is not there is named and left out. All take turns, three times each, every
run in a process of its own, all with differences for the Jacobian from the same pattern and one thread for the factors. Prints medians and writes
nothing. Seconds are those of the integration, sparse ordering included, imports and start of the virtual machine not; processor seconds are those of
the whole process.
"""
import importlib.util
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
RUNS = 3
HERE = pathlib.Path(__file__).resolve().parent
LIBRARIES = ["-lsundials_cvode", "-lsundials_sunlinsolklu", "-lsundials_nvecserial", "-lsundials_sunmatrixsparse", "-lm"]
TIGHT = 1e-8


def cvode(m, tolerance, out):
    import numpy as np
    import scipy.sparse as sp
    from sksundae.cvode import CVODE
    rate = 0.1 * (m + 1) ** 2
    evaluations = [0]

    def f(t, y, yp):
        evaluations[0] += 1
        u = y.reshape(m, m)
        flow = -4 * u
        flow[1:] += u[:-1]
        flow[:-1] += u[1:]
        flow[:, 1:] += u[:, :-1]
        flow[:, :-1] += u[:, 1:]
        yp[:] = (rate * flow + u * (1 - u)).ravel()

    x = np.arange(1, m + 1) / (m + 1)
    hump = x * (1 - x)
    line = sp.diags([np.ones(m - 1), np.ones(m), np.ones(m - 1)], [-1, 0, 1])
    one = sp.identity(m)
    pattern = (sp.kron(line, one) + sp.kron(one, line)).tocsc()
    begin = time.perf_counter()
    solver = CVODE(f, rtol=tolerance, atol=tolerance, linsolver="sparse", sparsity=pattern, max_num_steps=100000)
    end = solver.solve(np.array([0, 0.5]), 16 * np.outer(hump, hump).ravel())
    seconds = time.perf_counter() - begin
    used = resource.getrusage(resource.RUSAGE_SELF)
    print(f"{seconds:.3f} {used.ru_utime + used.ru_stime:.3f} {evaluations[0]} 0 0")
    end.y[-1].astype(">f8").tofile(out)


def run(command):
    return [float(value) for value in subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()[-5:]]


def compiled(program):
    command = ["cc", "-O3", "-I/usr/include/suitesparse", str(HERE / "diffusion.c"), *LIBRARIES, "-o", program]
    try:
        return subprocess.run(command, capture_output=True).returncode == 0
    except FileNotFoundError:
        return False


def main(m, tolerance):
    import numpy as np
    with tempfile.TemporaryDirectory() as folder:
        def state(name):
            return np.fromfile(pathlib.Path(folder, name), ">f8")

        def ours(tol, name):
            jar = ROOT / "benchmarks" / "target" / "benchmarks.jar"
            return ["java", "-cp", str(jar), "org.mechservice.benchmarks.LargeDiffusion", str(m), str(tol), f"{folder}/{name}"]

        def theirs(tol, name):
            return [sys.executable, __file__, "cvode", str(m), str(tol), f"{folder}/{name}"]

        run(ours(TIGHT, "tight"))
        commands = {"ode15s": ours(tolerance, "ode15s")}
        program = f"{folder}/diffusion"
        if compiled(program):
            commands["CVODE, KLU"] = [program, str(m), str(tolerance), f"{folder}/CVODE, KLU"]
        else:
            print("CVODE with KLU left out: cc finds no SUNDIALS with KLU")
        if importlib.util.find_spec("sksundae"):
            commands["CVODE, SuperLU_MT"] = theirs(tolerance, "CVODE, SuperLU_MT")
        else:
            print("CVODE with SuperLU_MT left out: no scikit-sundae")
        results = {name: [] for name in commands}
        for _ in range(RUNS):
            for name, command in commands.items():
                results[name].append(run(command))
        print(f"{m * m} unknowns, tolerances {tolerance}, medians of {RUNS}; errors against ode15s at {TIGHT}")
        for name, rows in results.items():
            clock, processor, evaluations = (statistics.median(row[i] for row in rows) for i in range(3))
            error = np.abs(state(name) - state("tight")).max()
            print(f"{name:17} {clock:7.2f} s, processor {processor:7.2f} s, {evaluations:.0f} evaluations, largest error {error:.1e}")
        for peer in list(commands)[1:]:
            for i, kind in enumerate(("clock", "processor")):
                ratio = statistics.median(a[i] / b[i] for a, b in zip(results["ode15s"], results[peer]))
                print(f"ode15s over {peer}, {kind}: {ratio:.2f}")


if __name__ == "__main__":
    if sys.argv[1:2] == ["cvode"]:
        cvode(int(sys.argv[2]), float(sys.argv[3]), sys.argv[4])
    else:
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 316, float(sys.argv[2]) if len(sys.argv) > 2 else 1e-4)

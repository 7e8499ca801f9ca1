"""Checks an FMU with FMPy: python fmpy_checks.py FMU WHAT,WHAT; prints numbers for the test to judge."""
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor

import fmpy
import numpy as np
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.validation import validate_fmu


def bounce(t, e=0.7, g=9.81):
    landing = np.sqrt(2 / g)
    v = g * landing
    if t < landing:
        return 1 - g * t * t / 2
    while True:
        v *= e
        if t < landing + 2 * v / g:
            return v * (t - landing) - g * (t - landing) ** 2 / 2
        landing += 2 * v / g


def run(fmu, kind, rtol=1e-9, **more):
    return simulate_fmu(fmu, fmi_type=kind, relative_tolerance=rtol, **more)


def ball(fmu):
    for kind in ("ModelExchange", "CoSimulation"):
        r = run(fmu, kind, stop_time=2, output_interval=0.01)
        print(kind, max(abs(r["z.x"][i] - bounce(r["time"][i])) for i in range(len(r))))


def accumulating(fmu):
    """The bounces of a ball have no end: the run has."""
    seen = []
    try:
        run(fmu, "CoSimulation", stop_time=4, output_interval=0.01,
            step_finished=lambda t, rows: seen.append(t) or True)
        print("ended", 4)
    except Exception:
        print("ended", seen[-1])


CIRCLE = ["x", "y", "E", "drift"]


def circle(fmu):
    fine = run(fmu, "CoSimulation", 1e-13, stop_time=10, output_interval=0.1, output=CIRCLE)
    for kind in ("ModelExchange", "CoSimulation"):
        r = run(fmu, kind, 1e-8, stop_time=10, output_interval=0.1, output=CIRCLE)
        at = np.searchsorted(r["time"], fine["time"] - 1e-9)
        print(kind, np.abs(r["E"]).max(), np.abs(r["drift"]).max(),
              np.abs(r["x"][at] - fine["x"]).max())


def tuned(fmu):
    r = run(fmu, "CoSimulation", stop_time=1, output_interval=0.5, output=CIRCLE,
            start_values={"gravity": 0, "vy": 2})
    print("angle", np.arctan2(r["y"][-1], r["x"][-1]))


def top(fmu):
    for kind in ("ModelExchange", "CoSimulation"):
        r = run(fmu, kind, stop_time=10, output_interval=0.1)
        print(kind, r["time"][-1], r["fall.q"][-1])


def many(fmu):
    """100 instances on 8 threads give the bits of one."""
    folder = extract(fmu)
    one = run(folder, "CoSimulation", stop_time=2, output_interval=0.01)
    with ThreadPoolExecutor(8) as pool:
        rest = list(pool.map(lambda _: run(folder, "CoSimulation", stop_time=2, output_interval=0.01),
                             range(100)))
    print("same", all(np.array_equal(one, r) for r in rest))
    shutil.rmtree(folder, ignore_errors=True)


def resumed(fmu):
    """A state serialised, restored in another instance, and an instance reset, give the same bits."""
    folder = extract(fmu)
    md = read_model_description(folder)
    references = [v.valueReference for v in md.modelVariables if v.causality in ("local", "output")]

    def instance(name):
        args = dict(guid=md.guid, unzipDirectory=folder, instanceName=name,
                    modelIdentifier=md.coSimulation.modelIdentifier)
        if md.fmiVersion == "2.0":
            f = fmpy.fmi2.FMU2Slave(**args)
        else:
            f = fmpy.fmi3.FMU3Slave(**args)
        f.instantiate()
        return f

    def begin(f):
        if md.fmiVersion == "2.0":
            f.setupExperiment(startTime=0, tolerance=1e-9)
            f.enterInitializationMode()
        else:
            f.enterInitializationMode(tolerance=1e-9, startTime=0)
        f.exitInitializationMode()

    def values(f):
        get = f.getReal if md.fmiVersion == "2.0" else f.getFloat64
        return np.array(get(references))

    def go(f, first, last):
        rows = []
        for i in range(first, last):
            f.doStep(currentCommunicationPoint=i * 0.01, communicationStepSize=0.01)
            rows.append(values(f))
        return np.array(rows)

    a, b = instance("a"), instance("b")
    begin(a)
    go(a, 0, 55)
    save = a.getFMUstate if md.fmiVersion == "2.0" else a.getFMUState
    state = save()
    bytes_ = (a.serializeFMUstate if md.fmiVersion == "2.0" else a.serializeFMUState)(state)
    rest = go(a, 55, 150)
    begin(b)
    go(b, 0, 3)
    other = (b.deSerializeFMUstate if md.fmiVersion == "2.0" else b.deserializeFMUState)(bytes_)
    (b.setFMUstate if md.fmiVersion == "2.0" else b.setFMUState)(other)
    print("serialised", np.array_equal(rest, go(b, 55, 150)))
    (a.setFMUstate if md.fmiVersion == "2.0" else a.setFMUState)(state)
    print("restored", np.array_equal(rest, go(a, 55, 150)))
    a.reset()
    begin(a)
    go(a, 0, 55)
    print("reset", np.array_equal(rest, go(a, 55, 150)))


def stiff(fmu):
    said = []
    try:
        run(fmu, "CoSimulation", stop_time=20, output_interval=20,
            start_values={"pull": 1e9}, logger=lambda *a: said.append(str(a)))
        print("ended well")
    except Exception as e:
        print("ended", e.__class__.__name__)
    print(" ".join(said))


def independent(fmu):
    """States, and the largest change of the energy of a mechanism that keeps it."""
    states = [v.derivative.name for v in read_model_description(fmu).modelVariables if v.derivative]
    print("states", *states)
    for kind in ("ModelExchange", "CoSimulation"):
        r = run(fmu, kind, stop_time=2, output_interval=0.02, output=["energy.kinetic", "energy.potential"])
        energy = r["energy.kinetic"] + r["energy.potential"]
        print(kind, np.abs(energy - energy[0]).max())


def singular(fmu):
    said = []
    try:
        run(fmu, "CoSimulation", stop_time=2, output_interval=0.02, logger=lambda *a: said.append(str(a)))
        print("ended well")
    except Exception as e:
        print("ended", e.__class__.__name__)
    print("said", " ".join(said))


def compiled(fmu):
    from fmpy.build import build_platform_binary
    folder = extract(fmu)
    build_platform_binary(folder)
    ball(folder)


fmu, what = sys.argv[1], sys.argv[2]
print("findings", validate_fmu(fmu))
for one in what.split(","):
    globals()[one](fmu)

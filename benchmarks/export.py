#!/usr/bin/env python3
"""Measures scenes as FMU with FMPy and writes the page docs/reports/export.md.

python benchmarks/export.py [--lib mechcli/target] [--out docs/reports/export.md] [SCENE.xml ...]

Needs fmpy, pandas, JPype, a C compiler, and cmake. Each scene is written by the command line as FMU of
sources for FMI 2.0 and 3.0; both are validated, compiled, and run in Model Exchange (CVode at 1e-10)
and in Co-Simulation at the tolerance of the scene. The reference is `mech simulate` at 1e-12. Most are
compiled by --cc, a compiler that is quick rather than good (apt-get install tcc); those of WHOLE are
built as users build them, for FMI 2.0 by `mech build` with its binary, for FMI 3.0 by FMPy from the
sources. Two processes work at once. What is known of a scene is kept in benchmarks/target/export-rows,
and used again as long as the scene and its FMU of sources have the same bytes. A scene whose export is
refused, or whose run ends early, is listed with the reason. Without scenes: all of examples/ whose
simulation is a motion.
"""
import argparse
import glob
import hashlib
import json
import multiprocessing
import os
import pickle
import re
import shutil
import subprocess
import sys
import tempfile
import time
from datetime import date
from multiprocessing.connection import wait

import numpy as np
import pandas as pd

# Forces written as Java classes, which become inputs of the units.
CLASSES = {
    "examples/elements/force.xml": ["rocket"],
    "examples/five-point-suspension/five-point-suspension.xml": ["fBody", "fFpsSpringDamper"],
    "examples/driver/driver-c0.xml": ["fJointSprings", "fSteeringWheel", "fFloor", "fSeat", "fBelts"],
    "examples/driver/driver-ck100.xml": ["fJointSprings", "fSteeringWheel", "fFloor", "fSeat", "fBelts"],
}

# Those whose motion under loads that are given over time goes away from itself, however small the
# difference at first: their units are validated and built alone.
UNSTABLE = {"driver/driver-c0", "driver/driver-ck100"}

# Scenes with inputs that follow a table in a plain run: times and values.
TABLES = {"examples/elements/input.xml": {"gust": ([0, 1], [2, 0])}}

# Distance of the numbers of a signal for inputs, s; an importer of Co-Simulation holds inputs between
# its communication points, which are nearer to each other by this factor.
SIGNAL, FINER = 1e-4, 4

# Longest time for what is done with one scene, s, and for one run of a unit.
PATIENCE, RUN_PATIENCE = 600, 150

# Scenes whose units are built as users build them.
WHOLE = [
    "pendulum/pendulum",
    "benchmarks/bouncing_ball",
    "benchmarks/double_pendulum",
    "driver/driver-ck100",
    "driver/driver-free-ck100",
    "extremes/fourbar_redundant",
    "five-point-suspension/five-point-suspension",
    "five-point-suspension/variants/elements",
    "walker/walker",
]

CACHE = os.path.join(os.path.dirname(__file__), "target", "export-rows")


class Mech:
    """The command line in this process."""

    def __init__(self, lib):
        import jpype

        jars = [f"{lib}/mechcli.jar"] + glob.glob(f"{lib}/lib/*.jar")
        jpype.startJVM("-Xmx1200m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", classpath=jars)
        self.strings = jpype.JString[:]
        self.text = jpype.JClass("java.io.StringWriter")
        self.writer = jpype.JClass("java.io.PrintWriter")
        self.mech = jpype.JClass("org.mechservice.cli.Mech")

    def run(self, *words):
        """Returns the last line of the errors; empty if there are none."""
        out, err = self.text(), self.text()
        status = self.mech.run(self.writer(out), self.writer(err), self.strings(list(words)))
        lines = [line for line in str(err.toString()).splitlines() if re.match(r"[A-Z]-\d+ ", line)]
        lines = lines or str(err.toString()).strip().splitlines()
        return "" if int(status) == 0 else lines[-1] if lines else f"status {status}"


def short(scene):
    """The name of a scene on the page."""
    return os.path.relpath(scene, "examples")[:-4]


def kept_of(scene):
    return os.path.join(CACHE, short(scene).replace("/", "_") + ".json")


def instants(run, names):
    """Times of a run in Model Exchange at which a column jumps, by name."""
    at = np.flatnonzero(np.diff(run["time"]) < 1e-9)
    return {name: run["time"][at][np.abs(np.diff(run[name])[at]) > 1e-6] for name in names}


def largest_error(run, reference, names, left_out):
    """Largest error over the size of the column, and its column; of several rows the best counts."""
    worst, where = 0.0, ""
    times = reference.iloc[:, 0].to_numpy()
    low, high = np.searchsorted(run["time"], times - 1e-9), np.searchsorted(run["time"], times + 1e-9)
    for name in names:
        right = reference[name].to_numpy()
        size = max(1, np.abs(right).max())
        for t, value, a, b in zip(times, right, low, high):
            if b > a and not any(abs(t - o) < 1e-9 for o in left_out.get(name, ())):
                error = np.abs(run[name][a:b] - value).min() / size
                worst, where = (error, name) if not error <= worst else (worst, where)
    return worst, where


def said(text):
    """The last sentence that a unit wrote to the log of FMPy."""
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    told = [line for line in lines if line.startswith(("[ERROR]", "[FATAL]", "[DISCARD]"))]
    return re.sub(r"^\[\w+\]\s*(\S+:)?\s*", "", (told or lines or [""])[-1])


def run_unit(unit, kind, options, signal, out):
    """Runs a unit in a process of its own, and writes its rows and what it said.

    signal: times, names of inputs and their values at the times; None if there are no inputs. In Model
    Exchange the inputs follow a cubic spline through them also within a step, where FMPy leaves them
    alone; in Co-Simulation they are held at the spline's mean over each communication step.
    """
    import fmpy
    import fmpy.simulation
    from fmpy.sundials import CVodeSolver
    from scipy.interpolate import CubicSpline

    if signal is not None:
        times, names, values = signal
        spline = CubicSpline(times, values)
        description = fmpy.read_model_description(unit)
        of_name = {v.name: v.valueReference for v in description.modelVariables}
        if kind == "CoSimulation":
            fine = np.linspace(times[0], times[-1], 1 + FINER * (times.size - 1))
            means = np.diff(spline.antiderivative()(fine), axis=0) / (fine[1] - fine[0])
            times, values = fine, np.vstack((means, means[-1:]))
            options = dict(options, output_interval=fine[1] - fine[0])
        else:
            instances = []
            instantiate, derivative = fmpy.simulation.instantiate_fmu, CVodeSolver.f

            def instantiated(*given, **named):
                instances.append(instantiate(*given, **named))
                return instances[-1]

            def with_inputs(solver, t, *rest):
                two = description.fmiVersion == "2.0"
                put = instances[-1].setReal if two else instances[-1].setFloat64
                put([of_name[name] for name in names], spline(t).tolist())
                return derivative(solver, t, *rest)

            fmpy.simulation.instantiate_fmu, CVodeSolver.f = instantiated, with_inputs
        rows = np.zeros(times.size, dtype=[("time", float)] + [(name, float) for name in names])
        rows["time"] = times
        for name, column in zip(names, values.T):
            rows[name] = column
        options = dict(options, input=rows)
    recorder, failure = [], ""
    with open(out + ".txt", "w") as log:
        os.dup2(log.fileno(), 1)
        os.dup2(log.fileno(), 2)
        try:
            rows = fmpy.simulate_fmu(
                unit, fmi_type=kind, step_finished=lambda t, r: recorder.append(r) or True, **options
            )
        except Exception as e:
            failure = str(e) or type(e).__name__
            rows = recorder[-1].result() if recorder else None
    with open(out, "wb") as file:
        pickle.dump((None if rows is None else np.array(rows), failure), file)


def in_process(units, unit, kind, options, signal):
    """Returns the rows of a run, or None, and why it ended early; empty if it did not."""
    with tempfile.TemporaryDirectory() as folder:
        out = f"{folder}/run"
        process = units.Process(target=run_unit, args=(unit, kind, options, signal, out))
        process.start()
        process.join(RUN_PATIENCE)
        if process.is_alive():
            process.kill()
            process.join()
            return None, f"no end within {RUN_PATIENCE} s"
        if not os.path.exists(out):
            return None, f"the process ended with status {process.exitcode}"
        with open(out, "rb") as file, open(out + ".txt") as log:
            rows, failure = pickle.load(file)
            return rows, (said(log.read()) or failure) if failure else ""


def digest(*files):
    sum_of = hashlib.sha256()
    for name in files:
        with open(name, "rb") as file:
            sum_of.update(file.read())
    return sum_of.hexdigest()


def compiled(source, cc):
    """Returns the folder of a unit of sources with its binary."""
    import fmpy

    folder = str(fmpy.extract(source))
    description = fmpy.read_model_description(folder)
    of_two = description.fmiVersion == "2.0"
    place = f"{folder}/binaries/{fmpy.platform if of_two else fmpy.platform_tuple}"
    os.makedirs(place, exist_ok=True)
    files = sorted(name for name in os.listdir(f"{folder}/sources") if name.endswith(".c"))
    library = f"{place}/{description.coSimulation.modelIdentifier}{fmpy.sharedLibraryExtension}"
    subprocess.run([*cc, "-shared", "-fPIC", "-o", library, *files, "-lm"], cwd=f"{folder}/sources", check=True)
    return folder


def compiled_by_fmpy(source):
    """Returns the folder of a unit of sources with the binary that `fmpy compile` makes."""
    import fmpy
    from fmpy.build import build_platform_binary

    folder = str(fmpy.extract(source))
    with open(os.devnull, "w") as silent:
        kept = os.dup(1)
        os.dup2(silent.fileno(), 1)
        try:
            build_platform_binary(folder)
        finally:
            os.dup2(kept, 1)
            os.close(kept)
    return folder


def inputs_of(scene, mech, folder, description, start, end):
    """Signals of the inputs: times, names, values; None if the unit has no inputs."""
    names = [v.name for v in description.modelVariables if v.causality == "input"]
    if not names:
        return None
    times = np.linspace(start, end, 1 + round((end - start) / SIGNAL))
    if scene in CLASSES:
        from export_inputs import loads_of

        signals = loads_of(scene, CLASSES[scene], mech, folder, times, names, description)
    else:
        starts = {v.name: float(v.start or 0) for v in description.modelVariables if v.name in names}
        tables = TABLES.get(scene, {})
        signals = {n: np.interp(times, *tables[n]) if n in tables else np.full(times.size, starts[n])
                   for n in names}
    return times, names, np.array([signals[name] for name in names]).T


def measure(scene, mech, units, cc, folder, tell):
    from fmpy.validation import validate_fmu

    sources = {v: f"{folder}/{v}.fmu" for v in ("2", "3")}
    row = {"scene": short(scene)}
    more = [word for name in CLASSES.get(scene, []) for word in ("--class-as-input", name)]
    more += ["--columns", "joints"]
    for version, source in sources.items():
        row["refused"] = mech.run("build", scene, "-o", source, "--fmi", version, "--platforms", "source", *more)
        if row["refused"]:
            tell(row)
            return
    row["key"] = digest(scene, *sources.values())
    kept = kept_of(scene)
    if os.path.exists(kept):
        with open(kept) as file:
            before = json.load(file)
        if before.get("key") == row["key"] and before.get("whole"):
            tell(before)
            return
    row["findings"] = [finding for source in sources.values() for finding in validate_fmu(source)]
    tell(row)
    if short(scene) in WHOLE:
        two = f"{folder}/whole.fmu"
        began = time.time()
        assert mech.run("build", scene, "-o", two, *more) == ""
        row["build"] = time.time() - began
        row["size"] = os.path.getsize(two) // 1024
        row["findings"] += validate_fmu(two)
        compiled_units = {"2": two, "3": compiled_by_fmpy(sources["3"])}
    else:
        compiled_units = {v: compiled(source, cc) for v, source in sources.items()}
    try:
        compare(scene, mech, units, folder, compiled_units, row, tell)
    finally:
        for unit in compiled_units.values():
            if os.path.isdir(unit):
                shutil.rmtree(unit)


def compare(scene, mech, units, folder, compiled_units, row, tell):
    from fmpy import read_model_description

    rows = f"{folder}/scene.csv"
    description = read_model_description(compiled_units["2"])
    experiment = description.defaultExperiment
    row["tolerance"] = float(experiment.tolerance)
    tell(row)
    if row["scene"] in UNSTABLE:
        row["whole"] = True
        tell(row)
        return
    row["reference"] = 1e-12
    row["ends"] = simulated(mech, scene, rows, "--rtol", "1e-12", "--atol", "1e-12")
    if row["ends"].startswith("N-004"):
        # more digits than numbers have
        row["reference"] = 1e-10
        row["ends"] = simulated(mech, scene, rows, "--rtol", "1e-10", "--atol", "1e-10")
    reference = pd.read_csv(rows) if os.path.exists(rows) else pd.DataFrame({"t": []})
    start, end = float(experiment.startTime), float(experiment.stopTime)
    row["until"] = float(reference.iloc[-1, 0]) if len(reference) else start
    variables = {v.name for v in description.modelVariables if v.causality in ("local", "output")}
    names = [c for c in reference.columns[1:] if c in variables]
    row["columns"] = len(names)
    signal = inputs_of(scene, mech, folder, description, start, row["until"])
    span = dict(start_time=start, stop_time=end if row["ends"] else row["until"],
                output_interval=float(experiment.stepSize))
    if names:
        span["output"] = names
    events = {}
    for version, of in compiled_units.items():
        for kind, rtol in (("ModelExchange", 1e-10), ("CoSimulation", row["tolerance"])):
            began = time.time()
            run, ended = in_process(units, of, kind, dict(span, relative_tolerance=rtol), signal)
            entry = {"seconds": time.time() - began, "ended": ended}
            if run is not None and names:
                left_out = {} if kind == "ModelExchange" else events
                entry["error"], entry["column"] = largest_error(run, reference, names, left_out)
                entry["until"] = float(run["time"][-1])
                events = instants(run, names) if kind == "ModelExchange" else events
            row[kind + version] = entry
            tell(row)
    if row["CoSimulation2"].get("error", 0) > 10 * row["tolerance"]:
        # as a run of Java at the tolerance of the scene, and with another method at 1e-12
        second = ["--rtol", "1e-12", "--atol", "1e-12", "--integrator", "DE"]
        for name, words in (("java", ["--integrator", "ode113"]), ("second", second)):
            if not simulated(mech, scene, rows, *words):
                other = pd.read_csv(rows).rename(columns={"t": "time"}).to_records(index=False)
                row[name] = largest_error(other, reference, names, events)[0]
    row["whole"] = True
    tell(row)


def simulated(mech, scene, rows, *words):
    """Runs a scene in Java and writes its rows; returns why it ended early, empty if it did not."""
    folder = os.path.dirname(scene)
    trust = ["--user-code", folder, "--unconfined"] if scene in CLASSES else []
    return mech.run("simulate", scene, *trust, *words, "--columns", "joints", "--out", rows, "--quiet")


def work(pipe, lib, cc):
    """Measures the scenes that come through the pipe; what is known goes back at every stage."""
    units = multiprocessing.get_context("forkserver")
    units.set_forkserver_preload(["fmpy", "fmpy.simulation", "fmpy.sundials", "lxml.etree"])
    mech = Mech(lib)
    while True:
        scene = pipe.recv()
        with tempfile.TemporaryDirectory() as folder:
            try:
                measure(scene, mech, units, cc, folder, pipe.send)
            except Exception as e:
                pipe.send({"scene": short(scene), "trouble": repr(e)})
        pipe.send(None)


class Worker:
    """A process that measures one scene after the other."""

    def __init__(self, *arguments):
        self.arguments = arguments
        self.begin()

    def begin(self):
        spawned = multiprocessing.get_context("spawn")
        self.pipe, theirs = spawned.Pipe()
        self.process = spawned.Process(target=work, args=(theirs, *self.arguments))
        self.process.start()
        theirs.close()

    def give(self, scene):
        self.row = {"scene": short(scene)}
        self.until = time.time() + PATIENCE
        self.pipe.send(scene)

    def ended(self):
        """Returns whether the scene is done; one that takes too long or kills its process is."""
        try:
            while self.pipe.poll():
                told = self.pipe.recv()
                if told is None:
                    return True
                self.row.update(told)
        except EOFError:
            self.row["trouble"] = "the process of this scene ended"
            self.begin()
            return True
        if time.time() < self.until:
            return False
        self.row["trouble"] = f"no end within {PATIENCE} s"
        self.process.kill()
        self.begin()
        return True


def all_rows(scenes, processes, *arguments):
    os.makedirs(CACHE, exist_ok=True)
    waiting, rows = list(scenes), {}
    workers = [Worker(*arguments) for _ in range(min(processes, len(scenes)))]
    busy = []
    idle = workers[:]
    while waiting or busy:
        while idle and waiting:
            worker = idle.pop()
            worker.give(waiting.pop(0))
            busy.append(worker)
        wait([w.pipe for w in busy], timeout=1)
        for worker in [w for w in busy if w.ended()]:
            busy.remove(worker)
            idle.append(worker)
            row = worker.row
            rows[row["scene"]] = row
            with open(os.path.join(CACHE, row["scene"].replace("/", "_") + ".json"), "w") as file:
                json.dump(row, file, indent=1)
            print(len(rows), json.dumps({k: v for k, v in row.items() if k != "key"}), flush=True)
    for worker in workers:
        worker.process.kill()


def is_motion(scene):
    with open(scene, encoding="utf-8") as file:
        text = file.read()
    first = text.find("<dynamic")
    others = [text.find(f"<{kind}") for kind in ("static", "kinematic", "inverseDynamic", "linearize")]
    return "<MechML" in text and first > 0 and all(o < 0 or o > first for o in others)


GROUPS = {"benchmarks": "benchmarks", "elements": "elements", "extremes": "extremes"}


def over(row):
    """Error of Co-Simulation over the tolerance; None if it was not measured."""
    error = row.get("CoSimulation2", {}).get("error")
    return None if error is None or row.get("ends") else error / row["tolerance"]


def power(x):
    return f"{x:.0e}".replace("e-0", "e-")


def error_of(row, kind):
    run = row.get(kind + "2", {})
    return f"{run['error']:.1e}" if "error" in run and not run["ended"] else "no end"


def table(heads, lines):
    rows = [heads, ["---"] * len(heads), *lines]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in rows)


def summary(rows):
    groups = {}
    for row in rows:
        groups.setdefault(GROUPS.get(row["scene"].split("/")[0], "other examples"), []).append(row)
    lines = []
    for name, some in sorted(groups.items(), key=lambda one: (one[0] == "other examples", one[0])):
        ratios = sorted(over(row) for row in some if over(row) is not None)
        units = [row for row in some if not row["refused"]]
        lines.append([name, len(some), len(units), sum(len(row["findings"]) for row in units), len(ratios),
                      f"{np.median(ratios):.2g}",
                      sum(ratio <= 1 for ratio in ratios), sum(ratio <= 10 for ratio in ratios)])
    total = [sum(line[i] for line in lines) for i in (1, 2, 3, 4, 6, 7)]
    lines.append(["all", *total[:4], "", *total[4:]])
    return table(["examples", "scenes", "units", "findings", "compared", "median over the tolerance",
                  "within the tolerance", "within ten"], lines)


def worst(rows):
    lines = []
    for row in sorted((r for r in rows if (over(r) or 0) > 1), key=over, reverse=True):
        doubt = [f"{row[key] / row['tolerance']:.2g}" if key in row else "" for key in ("java", "second")]
        lines.append([row["scene"], power(row["tolerance"]), error_of(row, "ModelExchange"),
                      error_of(row, "CoSimulation"), f"{over(row):.2g}", *doubt])
    return table(["scene", "tolerance", "error in Model Exchange", "error in Co-Simulation",
                  "over its tolerance", "Java's ode113", "reference by DE"], lines)


def whole(rows):
    lines = [[row["scene"], row["size"], f"{row['build']:.1f}",
              "–" if over(row) is None else f"{over(row):.2g}"] for row in rows if "size" in row]
    return table(["scene", "size, KB", "build, s", "error over the tolerance"], lines)


def endings(rows):
    lines = []
    for row in rows:
        if row.get("ends"):
            unit = row["CoSimulation2"]
            before = f"{unit['error']:.0e}" if "error" in unit and row["until"] > 0 else ""
            lines.append([row["scene"], cut(row["ends"]), cut(unit["ended"]) or "goes on to the end", before])
    return table(["scene", "`mech simulate`", "the unit in Co-Simulation", "error until there"], lines)


def cut(text):
    """The first sentence of a message, with short numbers and without the numbers of the step."""
    plain = re.sub(r"^([NS]-\d+)( t=\S+ s)?(, h=\S+ s)?(, order \d+)?:?", r"\1", text)
    plain = re.sub(r"\d+\.\d{4,}(?:E-?\d+|e-?\d+)?", lambda n: f"{float(n[0]):.6g}", plain)
    return re.split(r"(?<=\D)\.\s", plain)[0].replace("|", "\\|").rstrip(".")


def write(out, rows):
    with open(os.path.join(os.path.dirname(__file__), "export.md.in"), encoding="utf-8") as template:
        page = template.read()
    refused = [row for row in rows if row["refused"]]
    same = [row for row in rows if over(row) is not None]
    equal = sum(row["CoSimulation2"]["error"] == row["CoSimulation3"].get("error") for row in same)
    short_of = [row["scene"] for row in rows if row.get("ModelExchange2", {}).get("ended") and not row["ends"]]
    parts = {
        "date": date.today().isoformat(), "count": str(len(rows)), "summary": summary(rows), "worst": worst(rows),
        "whole": whole(rows), "endings": endings(rows), "equal": f"{equal} of {len(same)}",
        "refused": "\n".join(f"- {row['scene']}: {cut(row['refused'])}" for row in refused),
        "cvode": ", ".join(short_of),
    }
    for name, text in parts.items():
        page = page.replace("{" + name + "}", text)
    with open(out, "w", encoding="utf-8") as file:
        file.write(page)
    lines = [{"scene": row["scene"], "tolerance": row.get("tolerance"), "findings": len(row.get("findings", [])),
              "reference ends": row.get("ends"), "refused": row["refused"],
              **{f"{kind} FMI {version} {what}": row.get(kind + version, {}).get(key)
                 for version in "23" for kind in ("ModelExchange", "CoSimulation")
                 for what, key in (("error", "error"), ("column", "column"))},
              **{f"{kind} FMI {version} ended": re.sub(r"^(\[[^]]*\])+ ", "", row.get(kind + version, {}).get("ended", ""))
                 for version in "23" for kind in ("ModelExchange", "CoSimulation")}}
             for row in rows]
    folder = os.path.join(os.path.dirname(out) or ".", "pages")
    pd.DataFrame(lines).to_csv(os.path.join(folder, "export.csv"), index=False)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--lib", default="mechcli/target")
    options.add_argument("--out", default="docs/reports/export.md")
    options.add_argument("--cc", default="tcc" if shutil.which("tcc") else "cc -O0 -ffp-contract=off")
    options.add_argument("--processes", type=int, default=2)
    options.add_argument("--page", action="store_true", help="write the page from the rows kept")
    options.add_argument("scenes", nargs="*")
    given = options.parse_args()
    scenes = given.scenes or sorted(filter(is_motion, glob.glob("examples/**/*.xml", recursive=True)))
    if not given.page:
        all_rows(scenes, given.processes, given.lib, given.cc.split())
    if given.page or not given.scenes:
        rows = []
        for scene in scenes:
            with open(kept_of(scene)) as file:
                rows.append(json.load(file))
        troubled = [row["scene"] for row in rows if not row.get("whole") and not row["refused"]]
        if troubled:
            return "no page: not measured to the end are " + ", ".join(troubled)
        write(given.out, rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())

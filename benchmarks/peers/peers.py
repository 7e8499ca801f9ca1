#!/usr/bin/env python3
"""Measures generated code beside Pinocchio, MuJoCo and the same statements in C, in one run.

    benchmarks/peers/peers.py            # everything; writes docs/reports/peers.md
    benchmarks/peers/peers.py --short    # a trial: nothing is written

Needs gcc and a network for the first run: Pinocchio, MuJoCo, Eigen and a clang (ziglang) are taken
from PyPI into benchmarks/target/peers. A clang++ on the path is preferred.
"""
import argparse
import json
import os
import pathlib
import platform
import shutil
import subprocess
import sys
import venv
from datetime import date

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / "benchmarks" / "target" / "peers"
JAR = ROOT / "benchmarks" / "target" / "benchmarks.jar"
TABLES = ROOT / "solver-core/solver-mechanics/src/test/resources/org/mechservice/solver/dynamics"
MODELS = {"pend5": "pend5", "pend5s": "pend5s", "driver41": "driver41", "spatial200": "chain200",
          "driver": None}
# with closed loops, in tables of their own, where angles count the other way round
LOOPS = {"fourbar": HERE / "fourbar.csv"}
PACKAGES = ["pin", "mujoco", "cmeel-eigen", "ziglang"]


def run(*command, **more):
    return subprocess.run([str(c) for c in command], check=True, text=True,
                          stdout=subprocess.PIPE, **more).stdout


def figures(text):
    return {name: float(value) for name, value in (line.split() for line in text.splitlines())}


def environment(given):
    home = pathlib.Path(given) if given else WORK / "venv"
    python = home / "bin" / "python3"
    if not python.exists():
        venv.create(home, with_pip=True)
        run(python, "-m", "pip", "install", "--quiet", *PACKAGES)
    site = run(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").strip()
    return python, pathlib.Path(site)


def java(short, classpath):
    path = classpath or JAR
    if not pathlib.Path(str(path).split(os.pathsep)[0]).exists():
        run("mvn", "-q", "-pl", "benchmarks", "-am", "package", "-DskipTests", cwd=ROOT)
    run("java", "-cp", path, "org.mechservice.benchmarks.peer.PeerModels", WORK, *MODELS, *LOOPS)
    if classpath:
        return {}
    result = WORK / "jmh.json"
    times = ["-wi", "1", "-i", "1", "-w", "1", "-r", "1"] if short else []
    run("java", "-jar", JAR, "Peer", "-rf", "json", "-rff", result, *times)
    found = {}
    for entry in json.loads(result.read_text()):
        name = entry["params"]["scene"]
        kind = entry["benchmark"].rsplit(".", 1)[1]
        # the least of the iterations, as for the others
        least = min(min(fork) for fork in entry["primaryMetric"]["rawData"])
        found.setdefault(name, {})["jacobian" if kind == "derivatives" else kind] = least
    return found


def same_in_c(name, flags, label):
    program = WORK / f"{name}-{label}"
    run("gcc", *flags, f'-DMODEL="{WORK / (name + ".c")}"', HERE / "same.c", "-lm", "-o", program)
    return figures(run(program, WORK / f"{name}.state"))


def mujoco(site, name):
    library = next((site / "mujoco").glob("libmujoco.so.*"))
    program = WORK / "mujoco"
    run("gcc", "-O3", "-I", site / "mujoco" / "include", HERE / "mujoco.c", library,
        f"-Wl,-rpath,{library.parent}", "-lm", "-o", program)
    return figures(run(program, WORK / f"{name}.xml", WORK / f"{name}.order"))


def compiler(python):
    if shutil.which("clang++"):
        return ["clang++"]
    return [str(python), "-m", "ziglang", "c++"]


def pinocchio(python, site):
    include = site / "cmeel.prefix" / "include"
    program = WORK / "pinocchio"
    if not program.exists():
        # header-only: clang gives it the better figures, gcc loses a factor of nearly two
        subprocess.run(
            [*compiler(python), "-O3", "-march=native", "-DNDEBUG", "-std=c++17", "-w",
             "-fno-sanitize=all", "-I", include, "-I", include / "eigen3", HERE / "pinocchio.cpp",
             "-o", program], check=True)
    tables = {name: TABLES / f"{table}.csv" for name, table in MODELS.items() if table}
    return {name: figures(run(program, table)) for name, table in {**tables, **LOOPS}.items()}


def page(found, versions):
    lines = ["# Generated code beside its peers", "",
             f"Written by `benchmarks/peers/peers.py` on {date.today()}; nanoseconds per evaluation, the least of all"
             " rounds, every figure from the same run on one machine.", ""]
    lines += [f"- {text}" for text in versions]
    lines += ["", "## Forward dynamics", "",
              "| model | generated | same in C, gcc -O3 | with -march=native | Pinocchio | MuJoCo,"
              " least | mj_forward | best peer / generated | generated / C |",
              "|---|---:|---:|---:|---:|---:|---:|---:|---:|"]
    for name in MODELS:
        cells = {key: found.get(key, {}).get(name, {}) for key in
                 ("java", "c", "native", "pinocchio", "mujoco")}
        ours = cells["java"].get("derivative")
        peers = [cells[k]["derivative"] for k in ("pinocchio", "mujoco") if "derivative" in cells[k]]
        c = cells["c"].get("derivative")
        row = [name, text(ours), text(c), text(cells["native"].get("derivative")),
               text(cells["pinocchio"].get("derivative")), text(cells["mujoco"].get("derivative")),
               text(cells["mujoco"].get("forward")),
               ratio(min(peers), ours) if peers else "", ratio(ours, c)]
        lines.append("| " + " | ".join(row) + " |")
    lines += ["", "## Derivatives of inverse dynamics", "",
              "| model | generated | Pinocchio | Pinocchio / generated |", "|---|---:|---:|---:|"]
    for name in MODELS:
        ours = found.get("java", {}).get(name, {}).get("jacobian")
        theirs = found["pinocchio"].get(name, {}).get("jacobian")
        if ours or theirs:
            lines.append(f"| {name} | {text(ours)} | {text(theirs)} | {ratio(theirs, ours)} |")
    lines += ["", "`driver` has its joint springs, which the peers' formats do not take; the others"
              " have no forces but gravity. MuJoCo's least is kinematics, composite inertia,"
              " factors, bias and one solution. All agree on the last acceleration:", "",
              "| model | generated | C | Pinocchio | MuJoCo |", "|---|---:|---:|---:|---:|"]
    for name in MODELS:
        values = [float((WORK / f"{name}.value").read_text())] + [
            found[k].get(name, {}).get("value") for k in ("c", "pinocchio", "mujoco")]
        lines.append(f"| {name} | " + " | ".join("" if v is None else f"{v:.12g}" for v in values)
                     + " |")
    return "\n".join(lines + loops(found)) + "\n"


def loops(found):
    lines = ["", "## Closed loops", "",
             "Accelerations of a four-bar linkage. Generated: DSR with the terms of the loop as code,"
             " closed by projection, from five equations of which two are independent. Pinocchio:"
             " constraintDynamics with the loop as a point, three equations of which two are"
             " independent, and the proximal iteration that takes. The suspension's rods, one"
             " equation and no mass each, are none of its constraints: alone in"
             " [generated-loops](generated-loops.md).", "",
             "| model | generated | Pinocchio | Pinocchio / generated | last acceleration, generated"
             " | Pinocchio |", "|---|---:|---:|---:|---:|---:|"]
    for name in LOOPS:
        ours = found.get("java", {}).get(name, {}).get("derivative")
        theirs = found["pinocchio"].get(name, {})
        value = float((WORK / f"{name}.value").read_text())
        other = f"{-theirs['value']:.12g}" if theirs else ""
        lines.append(f"| {name} | {text(ours)} | {text(theirs.get('derivative'))} |"
                     f" {ratio(theirs.get('derivative'), ours)} | {value:.12g} | {other} |")
    return lines


def text(value):
    return "" if value is None else f"{value:,.0f}".replace(",", " ")


def ratio(a, b):
    return "" if not a or not b else f"{a / b:.2f}"


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--short", action="store_true", help="a trial that writes no page")
    options.add_argument("--classpath", help="classes in place of the built JAR: no JMH figures")
    options.add_argument("--venv", help="a folder with the Python packages")
    options.add_argument("--without", default="", help="pinocchio, mujoco or both")
    asked = options.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    found = {"java": java(asked.short, asked.classpath), "mujoco": {}, "pinocchio": {}}
    found["c"] = {name: same_in_c(name, ["-O3"], "c") for name in MODELS}
    found["native"] = {name: same_in_c(name, ["-O3", "-march=native"], "native")
                       for name in MODELS}
    python, site = environment(asked.venv)
    versions = [platform.processor() or platform.machine(),
                run("java", "-version", stderr=subprocess.STDOUT).splitlines()[0],
                run("gcc", "--version").splitlines()[0]]
    if "mujoco" not in asked.without:
        found["mujoco"] = {name: mujoco(site, name) for name, table in MODELS.items() if table}
    if "pinocchio" not in asked.without:
        found["pinocchio"] = pinocchio(python, site)
        versions.append(run(*compiler(python), "--version").splitlines()[0])
    versions += [line for line in run(python, "-m", "pip", "list", "--format", "freeze").split()
                 if line.split("==")[0] in PACKAGES]
    written = page(found, versions)
    if asked.short:
        sys.stdout.write(written)
    else:
        (ROOT / "docs" / "reports" / "peers.md").write_text(written)


if __name__ == "__main__":
    main()

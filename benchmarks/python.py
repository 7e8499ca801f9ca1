#!/usr/bin/env python3
"""Measures what Python adds to a run and writes the page docs/reports/python.md.

    python/take-jars && PYTHONPATH=python/src benchmarks/python.py [PAGE]

The machine's other work disturbs runs of a third of a millisecond, so that runs from Python and runs
in Java alone take turns, and the least of each kind are compared: what one run takes that nothing has
disturbed. First results are told in time of the processor as well.
"""
import datetime
import os
import pathlib
import platform
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "reports" / "python.md"
PENDULUM = ROOT / "examples" / "pendulum" / "pendulum.xml"
INPUT = ROOT / "examples" / "elements" / "input.xml"
ROUNDS = 3000

FIRST = f"""
import time
begun = time.perf_counter()
import mechservice
model = mechservice.read({str(PENDULUM)!r})
model.simulate().values
print(time.perf_counter() - begun, time.process_time())
"""


def first_results(times=7):
    """Clock and processor seconds of fresh processes, from the import to the values."""
    found = []
    for _ in range(times):
        done = subprocess.run([sys.executable, "-c", FIRST], stdout=subprocess.PIPE, check=True)
        found.append([float(word) for word in done.stdout.split()])
    return [sorted(one) for one in zip(*found)]


def warm_runs():
    """Seconds of runs in Java, and from Python without and with the numbers as an array."""
    import mechservice
    from mechservice._java import java_class

    model = mechservice.read(PENDULUM)
    control = java_class("org.mechservice.solver.api.run.RunControl")
    java = model._java
    kinds = {
        "java": lambda: java.simulate(control()),
        "simulate": lambda: model.simulate(),
        "values": lambda: model.simulate().values,
    }
    for kind in kinds.values():
        for _ in range(500):
            kind()
    times = {name: [] for name in kinds}
    for _ in range(ROUNDS):
        for name, kind in kinds.items():
            begun = time.perf_counter()
            kind()
            times[name].append(time.perf_counter() - begun)
    return {name: sorted(one) for name, one in times.items()}


def control_loop():
    """How many times faster than real time a controller at 1 kHz is, the best of twelve runs.

    By the clock, and by the time its thread has a processor.
    """
    import mechservice

    model = mechservice.read(INPUT)
    best = [0.0, 0.0]
    for _ in range(12):
        run = model.stepped(0.001, t_end=5)
        clock, processor = time.perf_counter(), time.thread_time()
        while run.running:
            run["force"] = 40 * (0.5 - run["slide.q"]) - 12 * run["slide.v"]
            run.step()
        clock, processor = time.perf_counter() - clock, time.thread_time() - processor
        best = [max(best[0], 5 / clock), max(best[1], 5 / processor)]
    return best


def main():
    page = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else PAGE
    clock, processor = first_results()
    times = warm_runs()
    loop = control_loop()
    java = times["java"]
    lines = [
        "# Runs from Python",
        "",
        "`benchmarks/python.py` measures what the Python package adds to the library in Java. Warm runs"
        f" of the pendulum (301 rows of 11 columns) take turns in one process, {ROUNDS} of each kind:"
        " in Java alone, from Python, and from Python with the numbers as an array. The least are"
        " compared, and the least tenths; medians are those of a machine with other work.",
        "",
        f"Measured on {datetime.date.today()}: Python {platform.python_version()}, {platform.system()}"
        f" {platform.release()}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.0f}.",
        "",
        "| run | least, ms | to Java | end of the first tenth, ms | to Java | median, ms | to Java |",
        "|---|---|---|---|---|---|---|",
    ]
    titles = {"java": "in Java", "simulate": "`model.simulate()`", "values": "`model.simulate().values`"}
    for name, one in times.items():
        cells = [titles[name]]
        for at in (0, len(one) // 10, len(one) // 2):
            cells += [f"{1e3 * one[at]:.3f}", f"{one[at] / java[at]:.2f}"]
        lines.append("| " + " | ".join(cells) + " |")
    lines += [
        "",
        "| | asked | measured |",
        "|---|---|---|",
        f"| warm run to one in Java | 1.2 | {times['values'][0] / java[0]:.2f} |",
        f"| import and first result, s of the processor, least and median | 3 | {processor[0]:.2f},"
        f" {processor[len(processor) // 2]:.2f} |",
        f"| import and first result, s by the clock, least and median | 3 | {clock[0]:.2f},"
        f" {clock[len(clock) // 2]:.2f} |",
        f"| a controller at 1 kHz, times real time in the time its thread had a processor | 50 | {loop[1]:.0f} |",
        f"| a controller at 1 kHz, times real time by the clock | 50 | {loop[0]:.0f} |",
        "",
        "The main thread runs the model itself, and a thread beside it hears of Ctrl-C by the socket to"
        " which Python writes the numbers of signals. With a thread for the run, two switches between"
        " threads took a fifth of such a short run; that way is left for programs that handle signals"
        " of their own.",
    ]
    page.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Measures mechanisms with many closed loops, beside Exudyn and MuJoCo, in one run.

    benchmarks/peers/loops.py            # everything; writes docs/reports/loops-at-scale.md
    benchmarks/peers/loops.py --short    # a trial: nothing is written

Needs ./mech and benchmarks/target/benchmarks.jar built, and a network for the first run: Exudyn and MuJoCo are taken from PyPI into
benchmarks/target/peers.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import time
import venv

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / "benchmarks" / "target" / "peers" / "loops"
PAGE = ROOT / "docs" / "reports" / "loops-at-scale.md"
GRAVITY = 9.81
START = 1.0
REPETITIONS = 3


# -- scenes ---------------------------------------------------------------------------------------

def document(name, bodies, joints, constraints, starts, end):
    return f"""<?xml version="1.0"?>
<!DOCTYPE MechML SYSTEM "MechML.dtd">
<MechML>
  <MBSsimulation><dynamic>
    <timeSet tini="0" tend="{end}" tstep="{end / 10}"/>
    <integrator name="auto" relTol="1e-6" absTol="1e-8"/>
  </dynamic></MBSsimulation>
  <MBSmodel name="{name}" massUnits="kg" lengthUnits="m">
    <Bodies>{"".join(bodies)}</Bodies>
    <Joints>{"".join(joints)}</Joints>
    <Constraints>{"".join(constraints)}</Constraints>
    <Forces><gravity gx="0" gy="0" gz="{-GRAVITY}"/></Forces>
    <topology><root name="Ground"/><relCoorVals>{"".join(starts)}</relCoorVals></topology>
  </MBSmodel>
</MechML>
"""


def ground(points):
    listed = "".join(f'<point name="{n}" x="{x}" y="0" z="{z}"/>' for n, x, z in points)
    return f'<body name="Ground">{listed}<vector name="y" vx="0" vy="1" vz="0"/></body>'


def rod(name):
    return (f'<body name="{name}"><point name="p1" x="0" y="0" z="0"/>'
            '<point name="p2" x="1" y="0" z="0"/><vector name="y" vx="0" vy="1" vz="0"/>'
            '<cog x="0.5" y="0" z="0"/><mass value="1"/>'
            '<inertiaTensor Ixx="1/1200" Iyy="1/12" Izz="1/12"/></body>')


def hinge(name, first, point, second, at="p1"):
    return (f'<joint name="{name}" type="R"><body1 name="{first}" point="{point}" vector="y"/>'
            f'<body2 name="{second}" point="{at}" vector="y"/></joint>')


def on_line(name, first, point, second, at):
    return (f'<PointOnLine name="{name}"><body1 name="{first}" point="{point}" vector="y"/>'
            f'<body2 name="{second}" point="{at}"/></PointOnLine>')


def start(name, angle):
    return f'<jointVal name="{name}" posVals="{angle}" velVals="0"/>'


def fourbars(n):
    """n parallelograms in a row: n + 1 cranks on the ground, couplers between neighbours."""
    bodies = [ground([(f"p{i}", i, 0) for i in range(n + 1)])]
    bodies += [rod(f"k{i}") for i in range(n + 1)] + [rod(f"c{i}") for i in range(n)]
    joints = [hinge(f"a{i}", "Ground", f"p{i}", f"k{i}") for i in range(n + 1)]
    joints += [hinge(f"b{i}", f"k{i}", "p2", f"c{i}") for i in range(n)]
    closed = [on_line(f"l{i}", f"k{i + 1}", "p2", f"c{i}", "p2") for i in range(n)]
    starts = [start(f"a{i}", START) for i in range(n + 1)]
    starts += [start(f"b{i}", -START) for i in range(n)]
    return document(f"fourbars{n}", bodies, joints, closed, starts, 1.0)


def chain(n, closed):
    """A zigzag of n rods, its end on a fixed line if closed."""
    bodies = [ground([("p2", 0, 0), ("end", n * math.cos(0.3), 0)])]
    bodies += [rod(f"k{i}") for i in range(n)]
    joints = [hinge(f"a{i}", "Ground" if i == 0 else f"k{i - 1}", "p2", f"k{i}") for i in range(n)]
    line = [on_line("l", "Ground", "end", f"k{n - 1}", "p2")] if closed else []
    angle = lambda i: 0.3 if i == 0 else 0.6 if i % 2 == 0 else -0.6
    starts = [start(f"a{i}", angle(i)) for i in range(n)]
    return document("chain", bodies, joints, line, starts, 0.2)


def track(n):
    """A ring of n shoes that hangs on one of them."""
    half = math.pi / n
    radius = 0.5 / math.sin(half)
    bodies = [ground([("p2", 0, 0)])] + [rod(f"k{i}") for i in range(n)]
    joints = [hinge(f"a{i}", "Ground" if i == 0 else f"k{i - 1}", "p2", f"k{i}") for i in range(n)]
    line = [on_line("l", "Ground", "p2", f"k{n - 1}", "p2")]
    starts = [start(f"a{i}", half if i == 0 else 2 * half) for i in range(n)]
    return document("track", bodies, joints, line, starts, 0.5) if radius > 0 else ""


def net(n):
    """n x n plates, each pinned to its neighbours at the middles of its edges."""
    plate = ('<point name="l" x="-0.5" y="0" z="0"/><point name="r" x="0.5" y="0" z="0"/>'
             '<point name="u" x="0" y="0" z="0.5"/><point name="d" x="0" y="0" z="-0.5"/>'
             '<vector name="y" vx="0" vy="1" vz="0"/><cog x="0" y="0" z="0"/><mass value="1"/>'
             '<inertiaTensor Ixx="0.1" Iyy="0.1" Izz="0.1"/>')
    bodies = [ground([("d", 0, 0)])]
    bodies += [f'<body name="b{i}_{j}">{plate}</body>' for i in range(n) for j in range(n)]
    joints, closed = [], []
    for i in range(n):
        for j in range(n):
            if j == 0:
                above = "Ground" if i == 0 else f"b{i - 1}_0"
                joints.append(hinge(f"j{i}_0", above, "d", f"b{i}_0", "u"))
            else:
                joints.append(hinge(f"j{i}_{j}", f"b{i}_{j - 1}", "r", f"b{i}_{j}", "l"))
            if i > 0 and j > 0:
                closed.append(on_line(f"c{i}_{j}", f"b{i - 1}_{j}", "d", f"b{i}_{j}", "u"))
    return document("net", bodies, joints, closed, [], 0.2)


def exact(n):
    """Angle of the cranks of n four-bars after 1 s: they move as one pendulum."""
    rate = GRAVITY * ((n + 1) / 2 + n) / ((n + 1) / 3 + n)
    angle, speed, h = START, 0.0, 1e-4
    for _ in range(10_000):
        k1 = rate * math.cos(angle)
        k2 = rate * math.cos(angle + h / 2 * speed)
        k3 = rate * math.cos(angle + h / 2 * speed + h * h / 4 * k1)
        k4 = rate * math.cos(angle + h * speed + h * h / 2 * k2)
        angle += h * speed + h * h / 6 * (k1 + k2 + k3)
        speed += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return angle


# -- measuring ------------------------------------------------------------------------------------

def process(*command):
    """Output of a command, its processor time in s and its largest memory in MB."""
    begun = subprocess.Popen([str(c) for c in command], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE)
    out, err = begun.stdout.read(), begun.stderr.read()
    _, status, use = os.wait4(begun.pid, 0)
    begun.returncode = os.waitstatus_to_exitcode(status)
    if begun.returncode:
        raise RuntimeError(f"{command}: {err or out}")
    return out, use.ru_utime + use.ru_stime, use.ru_maxrss / 1024


def median(run, repetitions):
    """The figures of the repetition with the median of the first."""
    return sorted((run() for _ in range(repetitions)), key=lambda f: f["total"])[repetitions // 2]


def ours(name, text, *options):
    file = WORK / f"{name}.xml"
    rows = WORK / f"{name}.csv"
    file.write_text(text)
    begun = time.monotonic()
    out, cpu, memory = process(ROOT / "mech", "simulate", file, "--json", "--out", rows, *options)
    report = json.loads(out)
    with open(rows) as table:
        last = list(csv.reader(table))[-1]
    return {"total": time.monotonic() - begun, "cpu": cpu, "memory": memory,
            "run": report["wallTime"], "evaluations": report["evaluations"],
            "angle": float(last[1])}


def peer(python, name, n, steps):
    begun = time.monotonic()
    out, cpu, memory = process(python, __file__, "--peer", name, n, steps)
    found = json.loads(out.splitlines()[-1])
    return {**found, "total": time.monotonic() - begun, "cpu": cpu, "memory": memory}


def exudyn(n, steps):
    import exudyn as exu
    from exudyn.itemInterface import (MarkerBodyPosition, NodeRigidBody2D, ObjectGround,
                                      ObjectJointRevolute2D, ObjectRigidBody2D, LoadForceVector)
    begun = time.perf_counter()
    container = exu.SystemContainer()
    system = container.AddSystem()
    fixed = system.AddObject(ObjectGround())

    def body(x, z, angle):
        centre = [x + 0.5 * math.cos(angle), z + 0.5 * math.sin(angle), angle]
        node = system.AddNode(NodeRigidBody2D(referenceCoordinates=centre))
        added = system.AddObject(
            ObjectRigidBody2D(mass=1, inertia=1 / 12, nodeNumber=node))
        centre = system.AddMarker(MarkerBodyPosition(bodyNumber=added))
        system.AddLoad(LoadForceVector(markerNumber=centre, loadVector=[0, -GRAVITY, 0]))
        return added

    def joint(first, at, second, point):
        ends = [system.AddMarker(MarkerBodyPosition(bodyNumber=b, localPosition=[p, 0, 0]))
                for b, p in ((first, at), (second, point))]
        system.AddObject(ObjectJointRevolute2D(markerNumbers=ends))

    down = -START
    cranks = [body(i, 0, down) for i in range(n + 1)]
    couplers = [body(i + math.cos(down), math.sin(down), 0) for i in range(n)]
    for i, crank in enumerate(cranks):
        joint(fixed, i, crank, -0.5)
    for i, coupler in enumerate(couplers):
        joint(cranks[i], 0.5, coupler, -0.5)
        joint(cranks[i + 1], 0.5, coupler, 0.5)
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = 1
    settings.timeIntegration.generalizedAlpha.useIndex2Constraints = True
    settings.timeIntegration.generalizedAlpha.useNewmark = True
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.verboseMode = 0
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    set_up = time.perf_counter()
    system.SolveDynamic(settings)
    done = time.perf_counter()
    angle = system.GetNodeOutput(system.GetObject(cranks[0])["nodeNumber"],
                                 exu.OutputVariableType.Coordinates)[2]
    return {"setUp": set_up - begun, "run": done - set_up, "angle": -(angle + down)}


def mujoco(n, steps):
    import mujoco as mj
    crank = ('<body pos="{x} 0 0" euler="0 {a} 0"><joint type="hinge" axis="0 1 0" name="a{i}"/>'
             '<inertial pos="0.5 0 0" mass="1" diaginertia="0.0008333 0.0833333 0.0833333"/>'
             '{coupler}</body>')
    coupler = ('<body name="c{i}" pos="1 0 0" euler="0 {b} 0"><joint type="hinge" axis="0 1 0"/>'
               '<inertial pos="0.5 0 0" mass="1" diaginertia="0.0008333 0.0833333 0.0833333"/>'
               '<site name="e{i}" pos="1 0 0"/></body>')
    angle = math.degrees(START)
    bodies, equal = [], []
    for i in range(n + 1):
        inner = coupler.format(i=i, b=-angle) if i < n else ""
        bodies.append(crank.format(x=i, a=angle, i=i, coupler=inner + f'<site name="t{i}" pos="1 0 0"/>'))
        if i < n:
            equal.append(f'<connect site1="e{i}" site2="t{i + 1}"/>')
    begun = time.perf_counter()
    model = mj.MjModel.from_xml_string(
        f'<mujoco><option timestep="{1 / steps}" gravity="0 0 {-GRAVITY}" integrator="RK4"/>'
        f'<default><equality solref="{2.5 / steps} 1"/></default><worldbody>{"".join(bodies)}'
        f'</worldbody><equality>{"".join(equal)}</equality></mujoco>')
    data = mj.MjData(model)
    set_up = time.perf_counter()
    mj.mj_step(model, data, steps)
    done = time.perf_counter()
    return {"setUp": set_up - begun, "run": done - set_up, "angle": START + float(data.qpos[0])}


# -- the page -------------------------------------------------------------------------------------

def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def short(x):
    return f"{x:.2g}" if x < 10 else f"{x:.0f}"


def four_bars(python, sizes, peer_steps, repetitions):
    rows, before = [], None
    for n in sizes:
        figures = median(lambda: ours(f"fourbars{n}", fourbars(n)), repetitions)
        error = abs(figures["angle"] - exact(n))
        growth = "" if before is None else (
            f'{figures["total"] / before["total"]:.1f} / {figures["run"] / before["run"]:.1f}')
        row = [str(n), f'{figures["total"]:.2f}', f'{figures["run"]:.3f}', growth, f"{error:.1e}",
               f'{figures["memory"]:.0f}']
        for name, steps, most in peer_steps:
            if n <= most:
                other = median(lambda: peer(python, name, n, steps), min(repetitions, 2))
                wrong = abs(other["angle"] - exact(n))
                row.append(f'{other["setUp"]:.3f} + {other["run"]:.2f}, {wrong:.0e}')
            else:
                row.append("not run")
        rows.append(row)
        before = figures
        print(row, file=sys.stderr, flush=True)
    head = ["N", "whole command, s", "run, s", "growth", "error", "memory, MB"]
    return table(head + [f"{name}, {steps} steps" for name, steps, _ in peer_steps], rows)


def chains(lengths, repetitions):
    rows = []
    for n in lengths:
        cost = []
        for closed in (False, True):
            figures = median(
                lambda: ours(f"chain{n}{closed}", chain(n, closed), "--integrator", "ode113"),
                repetitions)
            cost.append(1e6 * figures["run"] / figures["evaluations"])
        rows.append([str(n), f"{cost[0]:.0f}", f"{cost[1]:.0f}", f"{cost[1] / cost[0]:.1f}"])
        print(rows[-1], file=sys.stderr, flush=True)
    return table(["links", "open, µs", "one loop, µs", "ratio"], rows)


def evaluations(lengths):
    """Processor time of warm evaluations, of chains open and with a loop, by code and from data."""
    files = []
    for n in lengths:
        for closed in (False, True):
            file = WORK / f"warm{n}{closed}.xml"
            file.write_text(chain(n, closed))
            files.append(file)
    out, _, _ = process("java", "-XX:+UseSerialGC", "-cp", ROOT / "benchmarks/target/benchmarks.jar",
                        "org.mechservice.benchmarks.study.ChainWithLoop", *files)
    rows = []
    for n, line in zip(lengths, out.splitlines()):
        open_code, open_data, code, data = (float(cost) for cost in line.split())
        rows.append([str(n), short(open_code), short(code), f"{code / open_code:.1f}",
                     short(open_data), short(data), f"{data / open_data:.1f}"])
    return table(["links", "open, code, µs", "one loop, code, µs", "ratio",
                  "open, data, µs", "one loop, data, µs", "ratio"], rows)


def others(repetitions):
    rows = []
    for name, text in (("track of 100 shoes", track(100)), ("net of 10 x 10 plates", net(10)),
                       ("net of 20 x 20 plates", net(20))):
        figures = median(lambda: ours(name.replace(" ", "_"), text), repetitions)
        rows.append([name, f'{figures["total"]:.2f}', f'{figures["run"]:.2f}',
                     str(figures["evaluations"]), f'{figures["memory"]:.0f}'])
        print(rows[-1], file=sys.stderr, flush=True)
    return table(["scene", "whole command, s", "run, s", "evaluations", "memory, MB"], rows)


def environment():
    home = WORK.parent / "venv"
    python = home / "bin" / "python3"
    if not python.exists():
        venv.create(home, with_pip=True)
    process(python, "-m", "pip", "install", "--quiet", "exudyn", "mujoco", "numpy")
    return python


def machine():
    cpu = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if "model name" in line),
               platform.processor())
    return f"{cpu}, {os.cpu_count()} processors, {platform.system()} {platform.machine()}"


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--short", action="store_true")
    options.add_argument("--peer", nargs=3, metavar=("NAME", "N", "STEPS"))
    given = options.parse_args()
    if given.peer:
        name, n, steps = given.peer
        print(json.dumps({"exudyn": exudyn, "mujoco": mujoco}[name](int(n), int(steps))))
        return
    WORK.mkdir(parents=True, exist_ok=True)
    python = environment()
    repetitions = 1 if given.short else REPETITIONS
    sizes = [20, 80] if given.short else [20, 40, 80, 160, 320, 640, 1280, 2560]
    peers = [("exudyn", 250, 640), ("exudyn", 1000, 320), ("mujoco", 1000, 160)]
    text = (HERE / "loops-at-scale.md.in").read_text().format(
        date=time.strftime("%Y-%m-%d"), machine=machine(),
        fourbars=four_bars(python, sizes, peers, repetitions),
        chains=chains([50] if given.short else [50, 100, 200, 400, 1000], repetitions),
        evaluations=evaluations([200] if given.short else [200, 400, 1000]),
        others=others(repetitions))
    if given.short:
        print(text)
    else:
        PAGE.write_text(text)


if __name__ == "__main__":
    main()

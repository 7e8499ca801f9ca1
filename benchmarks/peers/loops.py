#!/usr/bin/env python3
"""Measures mechanisms with many closed loops, beside Exudyn, MuJoCo and Pinocchio, in one run.

    benchmarks/peers/loops.py            # everything; writes docs/reports/loops-at-scale.md
    benchmarks/peers/loops.py --short    # a trial: nothing is written
    benchmarks/peers/loops.py --before FOLDER    # small scenes beside an older checkout, built

Needs ./mech and benchmarks/target/benchmarks.jar built, and a network for the first run: Exudyn,
MuJoCo and Pinocchio are taken from PyPI into benchmarks/target/peers. The peers' part is in
loop_peers.py.
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

from loop_peers import (BOOM, CHASSIS, CORNER_BODIES, CORNERS, GRAVITY, HINGE, SPRING, START, TYRE,
                        points)

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / "benchmarks" / "target" / "peers" / "loops"
PAGE = ROOT / "docs" / "reports" / "loops-at-scale.md"
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


def vehicle():
    chassis, bodies, joints, closed, springs = ["pivot"], [], [], [], []
    places = {"chassis": {"pivot": (0, 0, 1.5)}, "Ground": {}}

    def body(name, mass, centre, inertia):
        listed = "".join(f'<point name="{n}" x="{x}" y="{y}" z="{z}"/>'
                         for n, (x, y, z) in places[name].items())
        return (f'<body name="{name}">{listed}<cog x="{centre[0]}" y="{centre[1]}" z="{centre[2]}"/>'
                f'<mass value="{mass}"/><inertiaTensor Ixx="{inertia[0]}" Iyy="{inertia[1]}" '
                f'Izz="{inertia[2]}"/></body>')

    def joint(name, kind, first, second, at, axes=""):
        return (f'<joint name="{name}" type="{kind}" body1="{first}" body2="{second}" '
                f'at="{at[0]};{at[1]};{at[2]}"{axes}/>')

    def link(name, law, first, p, second, q):
        length = math.dist(places[first][p], places[second][q]) + law["more"]
        return (f'<springDamper name="{name}" k="{law["k"]}" c="{law["c"]}" length0="{length}">'
                f'<body1 name="{first}" point="{p}"/><body2 name="{second}" point="{q}"/>'
                '</springDamper>')

    along_x, along_y = ' axis="1;0;0"', ' axis="0;1;0"'
    joints.append(joint("chassis", "F", "Ground", "chassis", (0, 0, 0)))
    for c, corner in enumerate(CORNERS):
        at, side = points(corner), corner[1]
        names = {part: f"{part}{c}" for part in CORNER_BODIES}
        places["chassis"] |= {f"rack{c}": at["rack"], f"tower{c}": at["tower"]}
        places["Ground"][f"post{c}"] = at["post"]
        places[names["arm"]] = {"seat": at["seat"]}
        places[names["upright"]] = {"top": at["top"], "wheel": at["wheel"]}
        places[names["rim"]] = {}
        places[names["wishbone"]] = {"top": at["top"]}
        places[names["rod"]] = {"rack": at["rack"]}
        joints += [
            joint(f"a{c}", "R", "chassis", names["arm"], at["lower"], along_x),
            joint(f"b{c}", "S", names["arm"], names["upright"], at["ball"]),
            joint(f"w{c}", "R", names["upright"], names["rim"], at["wheel"], along_y),
            joint(f"u{c}", "R", "chassis", names["wishbone"], at["upper"], along_x),
            joint(f"t{c}", "U", names["upright"], names["rod"], at["tie"],
                  along_x + ' axis2="0;0;1"')]
        closed += [
            f'<JointConstraint name="{name}{c}" type="S"><body1 name="{one}" point="{p}"/>'
            f'<body2 name="{two}" point="{p2}"/></JointConstraint>'
            for name, one, p, two, p2 in (
                ("top", names["wishbone"], "top", names["upright"], "top"),
                ("rack", "chassis", f"rack{c}", names["rod"], "rack"))]
        springs += [link(f"s{c}", SPRING, "chassis", f"tower{c}", names["arm"], "seat"),
                    link(f"y{c}", TYRE, "Ground", f"post{c}", names["upright"], "wheel")]
        for part, (mass, (x, y, z), inertia) in CORNER_BODIES.items():
            bodies.append((names[part], mass, (corner[0] + x, side * y, z), inertia))
    places["boom"] = {}
    joints.append(joint("boom", "R", "chassis", "boom", (0, 0, 1.5), along_y).replace(
        "/>", f' stiffness="{HINGE["k"]}" damping="{HINGE["c"]}"/>'))
    ground_points = "".join(f'<point name="{n}" x="{x}" y="{y}" z="{z}"/>'
                            for n, (x, y, z) in places["Ground"].items())
    texts = [f'<body name="Ground">{ground_points}</body>', body("chassis", *CHASSIS),
             body("boom", *BOOM)] + [body(*b) for b in bodies]
    text = document("vehicle", texts, joints, closed, [], 1.0)
    return text.replace("<Forces>", f'<Forces>{"".join(springs)}')


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
            "run": report["wallTime"], "setUp": report["tR"], "evaluations": report["evaluations"],
            "angle": float(last[1]), "height": float(last[7]) if len(last) > 7 else 0.0}


# -- the page -------------------------------------------------------------------------------------

def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def short(x):
    return f"{x:.2g}" if x < 10 else f"{x:.0f}"


def four_bars(sizes, repetitions):
    rows, before = [], None
    for n in sizes:
        figures = median(lambda: ours(f"fourbars{n}", fourbars(n)), repetitions)
        error = abs(figures["angle"] - exact(n))
        growth = "" if before is None else " / ".join(
            f"{figures[what] / before[what]:.1f}" for what in ("total", "setUp", "run"))
        rows.append([str(n), f'{figures["total"]:.2f}', f'{figures["setUp"]:.2f}',
                     f'{figures["run"]:.3f}', growth, f"{error:.1e}", f'{figures["memory"]:.0f}'])
        before = figures
        print(rows[-1], file=sys.stderr, flush=True)
    return table(["N", "whole command, s", "set-up, s", "run, s", "growth", "error", "memory, MB"],
                 rows)


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


def steps(lengths):
    """Processor time of the equations of an implicit step of a chain."""
    out, _, _ = process("java", "-XX:+UseSerialGC", "-cp", ROOT / "benchmarks/target/benchmarks.jar",
                        "org.mechservice.benchmarks.study.StepsOfChains", *lengths)
    rows = []
    for n, line in zip(lengths, out.splitlines()):
        cost = [float(part) for part in line.split()]
        formed = [short(c) for c in cost[3:]] if cost[3] else ["not measured"] * 3
        rows.append([str(n), *(short(c) for c in cost[:3]), *formed])
    return table(["links", "derivatives, µs", "factors, µs", "a solution, µs",
                  "with the matrix: derivatives, µs", "factors, µs", "a solution, µs"], rows)


def others(repetitions):
    rows = []
    for name, text in (("track of 100 shoes", track(100)), ("net of 10 x 10 plates", net(10)),
                       ("net of 20 x 20 plates", net(20))):
        figures = median(lambda: ours(name.replace(" ", "_"), text), repetitions)
        rows.append([name, f'{figures["total"]:.2f}', f'{figures["run"]:.2f}',
                     str(figures["evaluations"]), f'{figures["memory"]:.0f}'])
        print(rows[-1], file=sys.stderr, flush=True)
    return table(["scene", "whole command, s", "run, s", "evaluations", "memory, MB"], rows)


def drift(name, text, *options):
    """Largest residual of the loops' equations at a row, m."""
    file, rows = WORK / f"{name}.xml", WORK / f"{name}-drift.csv"
    file.write_text(text)
    process(ROOT / "mech", "simulate", file, "--quiet", "--columns", "joints,constraints",
            "--out", rows, *options)
    with open(rows) as table:
        head, *values = csv.reader(table)
    at = head.index("constraint.position")
    return max(abs(float(row[at])) for row in values)


class Point:
    """A measured run: its label, s of set-up and run, error and drift; s of the calls of a library
    alone, where a run is a loop in Python around them."""

    def __init__(self, label, set_up, run, error, drift=None, calls=None):
        self.label, self.set_up, self.run, self.error = label, set_up, run, max(error, 1e-16)
        self.drift, self.calls = drift, calls


OURS, NEW = "MechService, warm", "MechService, new process"
NAMES = {"exudyn": "Exudyn", "exudyn-dense": "Exudyn, dense", "mujoco": "MuJoCo",
         "pinocchio": "Pinocchio"}


def at_error(points, level, seconds):
    """Time to an error, between the points measured in logarithms, and whether all points are better
    than three times that; no time if none is as good."""
    front = []
    for point in sorted(points, key=seconds):
        if not front or point.error < front[-1].error:
            front.append(point)
    place = next((i for i, point in enumerate(front) if point.error <= level), None)
    if place is None:
        return None, False
    first = front[place]
    if place == 0:
        return seconds(first), first.error < level / 3
    worse = front[place - 1]
    part = math.log(worse.error / level) / math.log(worse.error / first.error)
    return seconds(worse) ** (1 - part) * seconds(first) ** part, False


def peer(python, name, scene, n, steps, expected):
    """The points of a peer; none where it does not get through."""
    alone = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    found = subprocess.run([str(python), str(HERE / "loop_peers.py"), name, scene, str(n),
                            *map(str, steps)], text=True, capture_output=True,
                           env={**os.environ, **alone})
    points = []
    for line in found.stdout.splitlines():
        if line.startswith("{"):
            one = json.loads(line)
            points.append(Point(f'{one["steps"]} steps', one["setUp"], one["run"],
                                abs(one["angle"] - expected), one["drift"], one.get("calls")))
    print(name, scene, n, [(p.label, p.run, p.error) for p in points], file=sys.stderr, flush=True)
    return [point for point in points if math.isfinite(point.error)]


def warm(column, tolerances, files, expected):
    """Points of ours in a process that has run the model before, by file."""
    out, _, _ = process("java", "-XX:+UseSerialGC", "-cp", ROOT / "benchmarks/target/benchmarks.jar",
                        "org.mechservice.benchmarks.study.WarmLoops", column, ",".join(tolerances),
                        *files)
    lines, found = iter(out.splitlines()), []
    for value in expected:
        points = []
        for tolerance in tolerances:
            set_up, run, end = map(float, next(lines).split())
            points.append(Point(tolerance, set_up, run, abs(end - value)))
        print("warm", [(p.label, p.set_up, p.run, p.error) for p in points], file=sys.stderr,
              flush=True)
        found.append(points)
    return found


def in_new_processes(name, text, tolerances, what, expected, repetitions):
    points = []
    for tolerance in tolerances:
        options = ("--rtol", tolerance, "--atol", f"{float(tolerance) / 100:g}")
        found = median(lambda: ours(name, text, *options), repetitions)
        points.append(Point(tolerance, found["setUp"], found["run"], abs(found[what] - expected),
                            drift(name, text, *options)))
    return points


def exactly(name, text, what):
    return ours(name, text, "--rtol", "1e-11", "--atol", "1e-13")[what]


def written(name, text):
    file = WORK / f"{name}.xml"
    file.write_text(text)
    return file


def rows_of_points(python, scene, texts, values, tolerances, peers):
    """Points by size and program; peers are (name, numbers of steps, largest size)."""
    files = [written(f"warm-{scene}{n}", text) for n, text in texts.items()]
    rows = {}
    for n, points, value in zip(texts, warm("a0.q", tolerances, files, values), values):
        rows[n] = {OURS: points}
        for name, counts, most in peers:
            if n <= most:
                rows[n][name] = peer(python, name, scene, n, counts, value)
    return rows


def scenes_of_points(python, repetitions):
    scenes, tolerances = {}, ["1e-3", "1e-4", "1e-6", "1e-8"]
    for title, text, scene, n, column, what in (
            ("40 four-bars in a row", fourbars(40), "fourbars", 40, "a0.q", "angle"),
            ("track of 100 shoes", track(100), "track", 100, "a0.q", "angle"),
            ("net of 10 x 10 plates", net(10), "net", 10, "j0_0.q", "angle"),
            ("vehicle of 119 coordinates", vehicle(), "vehicle", 0, "chassis.q[6]", "height")):
        name = title.replace(" ", "_")
        expected = exactly(name, text, what)
        points = scenes[title] = {
            NEW: in_new_processes(name, text, tolerances, what, expected, repetitions),
            OURS: warm(column, tolerances, [written(f"warm-{scene}", text)], [expected])[0]}
        for other, counts in (("exudyn", (20, 100, 1000, 4000)), ("exudyn-dense", (100, 1000)),
                              ("mujoco", (20, 100, 1000, 10000)),
                              ("pinocchio", (10, 20, 50, 200))):
            if other != "exudyn-dense" or scene == "net":
                points[other] = peer(python, other, scene, n, counts, expected)
    return scenes


def points_table(scenes):
    rows = []
    for title, programs in scenes.items():
        for program, points in programs.items():
            name = NAMES.get(program, program)
            for p in points:
                rows.append([title, f"{name}, {p.label}", f"{p.set_up:.3f}", f"{p.run:.3f}",
                             "" if p.calls is None else f"{p.calls:.3f}", f"{p.error:.0e}",
                             "" if p.drift is None else f"{p.drift:.0e}"])
            if not points:
                rows.append([title, name, "no result", "", "", "", ""])
    return table(["scene", "program", "set-up, s", "run, s", "of it calls, s", "error", "drift, m"],
                 rows)


def equal_cells(programs, level, names):
    """Run / set-up and run at an error, and the run's ratio to that of ours."""
    mine, _ = at_error(programs[OURS], level, lambda p: p.run)

    def ratio(seconds):
        return "" if mine is None else f" ({short(seconds / mine)})"

    cells = []
    for name in names:
        run, limit = at_error(programs.get(name, ()), level, lambda p: p.run)
        if run is None:
            cells.append("not reached" if programs.get(name) else "not run")
            continue
        whole, _ = at_error(programs[name], level, lambda p: p.set_up + p.run)
        cells.append(f'{"≤ " if limit else ""}{run:.2g} / {whole:.2g}'
                     + ("" if name == OURS else ratio(run)))
    calls, _ = at_error([p for p in programs.get("pinocchio", ()) if p.calls is not None], level,
                        lambda p: p.calls)
    return [*cells, "" if calls is None else f"{calls:.2g}{ratio(calls)}"]


def equal_table(head, rows, levels, new):
    """Times at equal errors; new, whether runs in new processes were measured too."""
    names = [OURS, *([NEW] if new else []), "exudyn", "mujoco", "pinocchio"]
    several = len(levels) > 1
    lines = [[str(title), *([f"{level:.0e}"] if several else []),
              *equal_cells(programs, level, names)]
             for title, programs in rows.items() for level in levels]
    return table([head, *(["error"] if several else []), *(NAMES.get(name, name) for name in names),
                  "Pinocchio, calls alone"], lines)


SMALL_SCENES = ("benchmarks/slider_crank_planar.xml",
                "five-point-suspension/five-point-suspension.xml")


def small_scenes(before, repetitions):
    """Whole commands of small scenes in an older checkout and in this one, in turns."""
    files = {"one four-bar": written("small-1", fourbars(1)),
             "20 four-bars in a row": written("small-20", fourbars(20))}
    files |= {scene.split("/")[-1]: before / "examples" / scene for scene in SMALL_SCENES}
    rows = []
    for name, file in files.items():
        taken = {before: [], ROOT: []}
        for _ in range(repetitions):
            for home, times in taken.items():
                begun = time.monotonic()
                _, cpu, _ = process(home / "mech", "simulate", file, "--quiet", "--out",
                                    WORK / "small.csv")
                times.append((time.monotonic() - begun, cpu))
        cells = []
        for k in (0, 1):
            old, new = (statistics.median(one[k] for one in taken[home]) for home in (before, ROOT))
            cells += [f"{old:.2f}", f"{new:.2f}", f"{new / old:.2f}"]
        rows.append([name, *cells])
        print(rows[-1], file=sys.stderr, flush=True)
    return table(["scene", "before, s", "now, s", "ratio", "before, s of processor time",
                  "now, s of processor time", "ratio"], rows)


def environment():
    home = WORK.parent / "venv"
    python = home / "bin" / "python3"
    if not python.exists():
        venv.create(home, with_pip=True)
    process(python, "-m", "pip", "install", "--quiet", "exudyn", "mujoco", "pin", "numpy")
    return python


def machine():
    cpu = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if "model name" in line),
               platform.processor())
    return f"{cpu}, {os.cpu_count()} processors, {platform.system()} {platform.machine()}"


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--short", action="store_true")
    options.add_argument("--before", type=pathlib.Path, metavar="FOLDER")
    given = options.parse_args()
    WORK.mkdir(parents=True, exist_ok=True)
    if given.before:
        print(small_scenes(given.before, 3 if given.short else 11))
        return
    python = environment()
    repetitions = 1 if given.short else REPETITIONS
    sizes = [20, 40] if given.short else [20, 40, 80, 160, 320, 640, 1280, 2560]
    lengths = [50] if given.short else [50, 100, 200, 400, 1000]
    rows = rows_of_points(
        python, "fourbars", {n: fourbars(n) for n in sizes}, [exact(n) for n in sizes],
        ["1e-5", "1e-6"],
        [("exudyn", (100, 500, 1500), 2560), ("mujoco", (1000, 4000, 16000), 1280),
         ("pinocchio", (10, 20, 40), 320)])
    chain_rows = rows_of_points(
        python, "chain", {n: chain(n, True) for n in lengths},
        [exactly(f"exact-chain{n}", chain(n, True), "angle") for n in lengths], ["1e-4", "1e-6"],
        [("exudyn", (20, 100, 500), 1000), ("mujoco", (20, 100, 400), 1000),
         ("pinocchio", (10, 20, 40), 1000)])
    scenes = scenes_of_points(python, repetitions)
    text = (HERE / "loops-at-scale.md.in").read_text().format(
        date=time.strftime("%Y-%m-%d"), machine=machine(),
        fourbars=four_bars(sizes, repetitions),
        fourbarsequal=equal_table("N", rows, (1e-6,), False),
        chainsequal=equal_table("links", chain_rows, (1e-6,), False),
        scenesequal=equal_table("scene", scenes, (1e-4, 1e-6, 1e-8), True),
        points=points_table(scenes),
        chains=chains(lengths, repetitions),
        evaluations=evaluations([200] if given.short else [200, 400, 1000]),
        steps=steps([100, 200] if given.short else [100, 200, 400, 800, 1600, 3200]),
        others=others(repetitions))
    if given.short:
        print(text)
    else:
        PAGE.write_text(text)


if __name__ == "__main__":
    main()

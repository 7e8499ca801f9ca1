#!/usr/bin/env python3
"""Measures mechanisms with many closed loops, beside Exudyn, MuJoCo and Pinocchio, in one run.

    benchmarks/peers/loops.py            # everything; writes docs/reports/loops-at-scale.md
    benchmarks/peers/loops.py --short    # a trial: nothing is written

Needs ./mech and benchmarks/target/benchmarks.jar built, and a network for the first run: Exudyn, MuJoCo and Pinocchio are taken from PyPI into
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


def points(corner):
    """Places of a corner's parts in the world, by (x, side)."""
    x, side = corner
    return {name: (x + a, side * b, c) for name, (a, b, c) in {
        "lower": (0, 0.4, 0.3), "upper": (0, 0.45, 0.55), "ball": (0, 0.75, 0.28),
        "top": (0.02, 0.72, 0.58), "wheel": (0, 0.85, 0.4), "rack": (0.15, 0.4, 0.35),
        "tie": (0.15, 0.74, 0.35), "seat": (0, 0.6, 0.29), "tower": (0, 0.55, 0.75),
        "post": (0, 0.85, -0.6)}.items()}


# A transporter of seven axles on a rig of posts: a free chassis (6 coordinates), 14 corners of
# double wishbones (8 each: lower arm, upright on a ball, wheel, upper arm, tie rod on a universal
# joint) and a boom (1): 119 coordinates. Two balls close each corner: 84 equations.
CORNERS = [(1.2 * axle, side) for axle in range(-3, 4) for side in (1, -1)]
CORNER_BODIES = {"arm": (15, (0, 0.58, 0.29), (0.4, 0.1, 0.4)),
                 "upright": (25, (0, 0.74, 0.4), (0.5, 0.4, 0.3)),
                 "rim": (40, (0, 0.85, 0.4), (1.0, 1.8, 1.0)),
                 "wishbone": (10, (0.01, 0.58, 0.56), (0.3, 0.1, 0.3)),
                 "rod": (3, (0.15, 0.57, 0.35), (0.03, 0.01, 0.03))}
CHASSIS = (7000, (0, 0, 1.0), (4000, 30000, 32000))
BOOM = (500, (1.2, 0, 1.8), (20, 400, 400))
SPRING = {"k": 1.2e5, "c": 4e3, "more": 0.09}
TYRE = {"k": 2e5, "c": 600, "more": 0.03}
HINGE = {"k": 2e5, "c": 4e3}


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


def mujoco_vehicle():
    def element(name, joint, mass, centre, inertia, inner):
        at = " ".join(map(str, centre))
        return (f'<body name="{name}">{joint}<inertial pos="{at}" mass="{mass}" diaginertia="'
                f'{" ".join(map(str, inertia))}"/>{inner}</body>')

    def joint(kind, at, axis="1 0 0", more=""):
        axis = f' axis="{axis}"' if kind == "hinge" else ""
        return f'<joint type="{kind}" pos="{" ".join(map(str, at))}"{axis}{more}/>'

    def site(name, at):
        return f'<site name="{name}" pos="{" ".join(map(str, at))}"/>'

    posts, inner, equal, tendons = [], [], [], []
    for c, corner in enumerate(CORNERS):
        at, side = points(corner), corner[1]

        def part(name, joints, inside="", c=c, corner=corner, side=side):
            mass, (x, y, z), inertia = CORNER_BODIES[name]
            return element(f"{name}{c}", joints, mass, (corner[0] + x, side * y, z), inertia, inside)

        rim = part("rim", joint("hinge", at["wheel"], "0 1 0"))
        rod = part("rod", joint("hinge", at["tie"]) + joint("hinge", at["tie"], "0 0 1"),
                   site(f"rackrod{c}", at["rack"]))
        upright = part("upright", joint("ball", at["ball"]), site(f"topup{c}", at["top"])
                       + site(f"wheel{c}", at["wheel"]) + rim + rod)
        inner += [part("arm", joint("hinge", at["lower"]), site(f"seat{c}", at["seat"]) + upright),
                  part("wishbone", joint("hinge", at["upper"]), site(f"topwish{c}", at["top"])),
                  site(f"rack{c}", at["rack"]), site(f"tower{c}", at["tower"])]
        posts.append(site(f"post{c}", at["post"]))
        equal += [f'<connect site1="topwish{c}" site2="topup{c}"/>',
                  f'<connect site1="rack{c}" site2="rackrod{c}"/>']
        for law, one, two in ((SPRING, "tower", "seat"), (TYRE, "post", "wheel")):
            length = math.dist(at[one], at[two]) + law["more"]
            tendons.append(f'<spatial stiffness="{law["k"]}" damping="{law["c"]}" springlength='
                           f'"{length}"><site site="{one}{c}"/><site site="{two}{c}"/></spatial>')
    inner.append(element("boom", joint("hinge", (0, 0, 1.5), "0 1 0", f' stiffness="{HINGE["k"]}" '
                                       f'damping="{HINGE["c"]}"'), *BOOM, ""))
    chassis = element("chassis", "<freejoint/>", *CHASSIS, "".join(inner))
    return (f'<worldbody>{"".join(posts)}{chassis}</worldbody><equality>{"".join(equal)}</equality>'
            f'<tendon>{"".join(tendons)}</tendon>')


def mujoco_drives(steps):
    """The vehicle in MuJoCo: height of its chassis after 1 s."""
    import mujoco as mj
    h = 1 / steps
    begun = time.perf_counter()
    model = mj.MjModel.from_xml_string(
        f'<mujoco><option timestep="{h}" gravity="0 0 {-GRAVITY}" integrator="RK4"/>'
        f'<default><equality solref="{2.5 * h} 1"/><geom contype="0"/></default>'
        f'{mujoco_vehicle()}</mujoco>')
    data = mj.MjData(model)
    set_up = time.perf_counter()
    mj.mj_step(model, data, steps)
    done = time.perf_counter()
    mj.mj_kinematics(model, data)
    drift = max(math.dist(data.site(a).xpos, data.site(b).xpos) for c in range(len(CORNERS))
                for a, b in ((f"topwish{c}", f"topup{c}"), (f"rack{c}", f"rackrod{c}")))
    return {"setUp": set_up - begun, "run": done - set_up, "angle": float(data.qpos[2]),
            "drift": drift}


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


def peer(python, name, scene, n, steps):
    begun = time.monotonic()
    out, cpu, memory = process(python, __file__, "--peer", name, scene, n, steps)
    found = json.loads(out.splitlines()[-1])
    return {**found, "total": time.monotonic() - begun, "cpu": cpu, "memory": memory}


# -- the peers ------------------------------------------------------------------------------------

class Planar:
    """A mechanism in the x-z plane: bodies by centre, angle from x to z, mass and inertia about y;
    pins by two bodies (-1 is the ground) and a point in each one's axes, from its centre. The first
    pin of a body leads to it in a tree; the others close loops. The angle of body 0 is compared."""

    def __init__(self, end):
        self.end, self.bodies, self.pins = end, [], []

    def body(self, x, z, angle, mass=1, inertia=1 / 12):
        self.bodies.append((x, z, angle, mass, inertia))
        return len(self.bodies) - 1

    def pin(self, first, p, second, q):
        self.pins.append((first, p, second, q))

    def split(self):
        """Pins of the tree by body, and the pins that close loops."""
        tree, closing = {}, []
        for pin in self.pins:
            if pin[2] >= 0 and pin[2] not in tree and (pin[0] < 0 or pin[0] in tree):
                tree[pin[2]] = pin
            else:
                closing.append(pin)
        return tree, closing

    def depth_first(self):
        """Bodies in an order in which each is followed by all beyond it."""
        tree, _ = self.split()
        children = {body: [] for body in range(-1, len(self.bodies))}
        for body, pin in tree.items():
            children[pin[0]].append(body)
        order, stack = [], children[-1][::-1]
        while stack:
            order.append(stack.pop())
            stack += children[order[-1]][::-1]
        return order


def planar_fourbars(n):
    scene, down = Planar(1.0), -START
    tip = (math.cos(down), math.sin(down))
    cranks = [scene.body(i + 0.5 * tip[0], 0.5 * tip[1], down) for i in range(n + 1)]
    couplers = [scene.body(i + tip[0] + 0.5, tip[1], 0) for i in range(n)]
    for i, crank in enumerate(cranks):
        scene.pin(-1, (i, 0), crank, (-0.5, 0))
    for i, coupler in enumerate(couplers):
        scene.pin(cranks[i], (0.5, 0), coupler, (-0.5, 0))
    for i, coupler in enumerate(couplers):
        scene.pin(cranks[i + 1], (0.5, 0), coupler, (0.5, 0))
    return scene


def planar_track(n):
    scene, half = Planar(0.5), math.pi / n
    x, z, last = 0.0, 0.0, (-1, (0, 0))
    for i in range(n):
        angle = -(half + 2 * half * i)
        shoe = scene.body(x + 0.5 * math.cos(angle), z + 0.5 * math.sin(angle), angle)
        scene.pin(*last, shoe, (-0.5, 0))
        x, z, last = x + math.cos(angle), z + math.sin(angle), (shoe, (0.5, 0))
    scene.pin(-1, (0, 0), *last)
    return scene


def planar_net(n):
    scene = Planar(0.2)
    plates = [[scene.body(j, -0.5 - i, 0, 1, 0.1) for j in range(n)] for i in range(n)]
    up, down, left, right = (0, 0.5), (0, -0.5), (-0.5, 0), (0.5, 0)
    for i in range(n):
        scene.pin(*((-1, (0, 0)) if i == 0 else (plates[i - 1][0], down)), plates[i][0], up)
        for j in range(1, n):
            scene.pin(plates[i][j - 1], right, plates[i][j], left)
    for i in range(1, n):
        for j in range(1, n):
            scene.pin(plates[i - 1][j], down, plates[i][j], up)
    return scene


PLANAR = {"fourbars": planar_fourbars, "track": planar_track, "net": planar_net}


def gap(scene, poses):
    """Largest distance between the two points of a pin that closes a loop, for poses (x, z, angle)."""
    def place(body, p):
        if body < 0:
            return p
        x, z, angle = poses[body]
        return (x + p[0] * math.cos(angle) - p[1] * math.sin(angle),
                z + p[0] * math.sin(angle) + p[1] * math.cos(angle))
    return max(math.dist(place(f, p), place(s, q)) for f, p, s, q in scene.split()[1])


def exudyn(scene, steps):
    import exudyn as exu
    from exudyn.itemInterface import (MarkerBodyPosition, NodeRigidBody2D, ObjectGround,
                                      ObjectJointRevolute2D, ObjectRigidBody2D, LoadForceVector)
    begun = time.perf_counter()
    container = exu.SystemContainer()
    system = container.AddSystem()
    fixed = system.AddObject(ObjectGround())
    nodes, objects = [], []
    for x, z, angle, mass, inertia in scene.bodies:
        nodes.append(system.AddNode(NodeRigidBody2D(referenceCoordinates=[x, z, angle])))
        objects.append(system.AddObject(
            ObjectRigidBody2D(mass=mass, inertia=inertia, nodeNumber=nodes[-1])))
        centre = system.AddMarker(MarkerBodyPosition(bodyNumber=objects[-1]))
        system.AddLoad(LoadForceVector(markerNumber=centre, loadVector=[0, -GRAVITY * mass, 0]))
    for first, p, second, q in scene.pins:
        ends = [system.AddMarker(MarkerBodyPosition(
            bodyNumber=fixed if body < 0 else objects[body], localPosition=[*point, 0]))
            for body, point in ((first, p), (second, q))]
        system.AddObject(ObjectJointRevolute2D(markerNumbers=ends))
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = scene.end
    settings.timeIntegration.generalizedAlpha.useIndex2Constraints = True
    settings.timeIntegration.generalizedAlpha.useNewmark = True
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.verboseMode = 0
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse
    set_up = time.perf_counter()
    system.SolveDynamic(settings)
    done = time.perf_counter()
    poses = []
    for node, (x, z, angle, _, _) in zip(nodes, scene.bodies):
        moved = system.GetNodeOutput(node, exu.OutputVariableType.Coordinates)
        poses.append((x + moved[0], z + moved[1], angle + moved[2]))
    return {"setUp": set_up - begun, "run": done - set_up, "angle": -poses[0][2],
            "drift": gap(scene, poses)}


def mujoco(scene, steps):
    import mujoco as mj
    tree, closing = scene.split()
    children = {body: [] for body in range(-1, len(scene.bodies))}
    for body, pin in tree.items():
        children[pin[0]].append(body)

    def opened(body):
        """The body's element without its end; its frame is at its pin, in its own axes."""
        first, p, _, q = tree[body]
        angle = math.degrees(scene.bodies[body][2] - (0 if first < 0 else scene.bodies[first][2]))
        if first >= 0:
            own = tree[first][3]
            p = (p[0] - own[0], p[1] - own[1])
        mass, inertia = scene.bodies[body][3:]
        return (f'<body name="b{body}" pos="{p[0]} 0 {p[1]}" euler="0 {-angle} 0">'
                f'<joint type="hinge" axis="0 1 0" name="j{body}"/>'
                f'<inertial pos="{-q[0]} 0 {-q[1]}" mass="{mass}" '
                f'diaginertia="{inertia} {inertia} {inertia}"/>')

    text, stack = [], [(child, False) for child in reversed(children[-1])]
    while stack:
        body, visited = stack.pop()
        if visited:
            text.append("</body>")
            continue
        text.append(opened(body))
        for number, (first, p, second, q) in enumerate(closing):
            for name, owner, point in (("f", first, p), ("s", second, q)):
                if owner == body:
                    own = tree[body][3]
                    text.append(f'<site name="{name}{number}" '
                                f'pos="{point[0] - own[0]} 0 {point[1] - own[1]}"/>')
        stack.append((body, True))
        stack += [(child, False) for child in reversed(children[body])]
    fixed = [f'<site name="{name}{number}" pos="{point[0]} 0 {point[1]}"/>'
             for number, (first, p, second, q) in enumerate(closing)
             for name, owner, point in (("f", first, p), ("s", second, q)) if owner < 0]
    equal = "".join(f'<connect site1="f{i}" site2="s{i}"/>' for i in range(len(closing)))
    h = scene.end / steps
    begun = time.perf_counter()
    model = mj.MjModel.from_xml_string(
        f'<mujoco><option timestep="{h}" gravity="0 0 {-GRAVITY}" integrator="RK4"/>'
        f'<default><equality solref="{2.5 * h} 1"/></default>'
        f'<worldbody>{"".join(fixed)}{"".join(text)}</worldbody><equality>{equal}</equality></mujoco>')
    data = mj.MjData(model)
    set_up = time.perf_counter()
    mj.mj_step(model, data, steps)
    done = time.perf_counter()
    mj.mj_kinematics(model, data)
    sites = [[data.site(f"{name}{i}").xpos for name in "fs"] for i in range(len(closing))]
    first = data.joint("j0").qpos[0]
    return {"setUp": set_up - begun, "run": done - set_up,
            "angle": float(first) - scene.bodies[0][2],
            "drift": max(math.dist(f, s) for f, s in sites)}


def pinocchio(scene, steps):
    import numpy as np
    import pinocchio as pin
    tree, closing = scene.split()
    begun = time.perf_counter()
    model = pin.Model()
    model.gravity.linear = np.array([0, 0, -GRAVITY])
    joints, down = {}, np.eye(3)

    def turned(angle):
        return pin.utils.rotate("y", -angle)

    for body in scene.depth_first():
        first, p, _, q = tree[body]
        angle = scene.bodies[body][2] - (0 if first < 0 else scene.bodies[first][2])
        own = (0, 0) if first < 0 else tree[first][3]
        place = pin.SE3(turned(angle), np.array([p[0] - own[0], 0, p[1] - own[1]]))
        joints[body] = model.addJoint(0 if first < 0 else joints[first], pin.JointModelRY(), place,
                                      f"j{body}")
        mass, inertia = scene.bodies[body][3:]
        model.appendBodyToJoint(
            joints[body], pin.Inertia(mass, np.array([-q[0], 0, -q[1]]), inertia * np.eye(3)),
            pin.SE3.Identity())
    constraints, datas = pin.StdVec_RigidConstraintModel(), pin.StdVec_RigidConstraintData()
    for first, p, second, q in closing:
        ends = []
        for body, point in ((first, p), (second, q)):
            own = (0, 0) if body < 0 else tree[body][3]
            at = np.array([point[0] - own[0], 0, point[1] - own[1]])
            ends += [0 if body < 0 else joints[body], pin.SE3(down, at)]
        constraint = pin.RigidConstraintModel(pin.ContactType.CONTACT_3D, model, *ends,
                                              pin.ReferenceFrame.LOCAL)
        constraint.setBaumgarteCorrectorParameters(pin.BaumgarteCorrectorParameters(100.0, 20.0))
        constraints.append(constraint)
        datas.append(constraint.createData())
    data = model.createData()
    pin.initConstraintDynamics(model, data, constraints, datas)
    proximal = pin.ProximalSettings(1e-12, 1e-10, 10)
    set_up = time.perf_counter()
    q, v, h = pin.neutral(model), np.zeros(model.nv), scene.end / steps
    force = np.zeros(model.nv)

    def slope(q, v):
        return pin.constraintDynamics(model, data, q, v, force, constraints, datas, proximal).copy()

    for _ in range(steps):
        a1 = slope(q, v)
        a2 = slope(q + h / 2 * v, v + h / 2 * a1)
        a3 = slope(q + h / 2 * v + h * h / 4 * a1, v + h / 2 * a2)
        a4 = slope(q + h * v + h * h / 2 * a2, v + h * a3)
        q = q + h * v + h * h / 6 * (a1 + a2 + a3)
        v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    done = time.perf_counter()
    pin.forwardKinematics(model, data, q)
    drift = 0
    for constraint in constraints:
        one, two = (data.oMi[j].act(place.translation) for j, place in
                    ((constraint.joint1_id, constraint.joint1_placement),
                     (constraint.joint2_id, constraint.joint2_placement)))
        drift = max(drift, float(np.linalg.norm(one - two)))
    return {"setUp": set_up - begun, "run": done - set_up,
            "angle": float(q[joints[0] - 1]) - scene.bodies[0][2], "drift": drift}


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
        growth = "" if before is None else " / ".join(
            f"{figures[what] / before[what]:.1f}" for what in ("total", "setUp", "run"))
        row = [str(n), f'{figures["total"]:.2f}', f'{figures["setUp"]:.2f}',
               f'{figures["run"]:.3f}', growth, f"{error:.1e}",
               f'{figures["memory"]:.0f}']
        for name, steps, most in peer_steps:
            if n <= most:
                other = median(lambda: peer(python, name, "fourbars", n, steps), min(repetitions, 2))
                wrong = abs(other["angle"] - exact(n))
                row.append(f'{other["setUp"]:.3f} + {other["run"]:.2f}, {wrong:.0e}')
            else:
                row.append("not run")
        rows.append(row)
        before = figures
        print(row, file=sys.stderr, flush=True)
    head = ["N", "whole command, s", "set-up, s", "run, s", "growth", "error", "memory, MB"]
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


def equal_error(python, repetitions):
    """Ours and the peers on four scenes, at several tolerances and steps."""
    scenes = {
        "40 four-bars in a row": (fourbars(40), "fourbars", 40, "angle"),
        "track of 100 shoes": (track(100), "track", 100, "angle"),
        "net of 10 x 10 plates": (net(10), "net", 10, "angle"),
        "vehicle of 119 coordinates": (vehicle(), "vehicle", 0, "height")}
    runs = [("exudyn", 100), ("exudyn", 1000), ("mujoco", 100), ("mujoco", 1000),
            ("pinocchio", 50), ("pinocchio", 200)]
    rows = []
    for title, (text, scene, n, what) in scenes.items():
        name = title.replace(" ", "_")
        reference = ours(name, text, "--rtol", "1e-11", "--atol", "1e-13")[what]
        for tolerance in ("1e-4", "1e-6", "1e-8"):
            options = ("--rtol", tolerance, "--atol", f"{float(tolerance) / 100:g}")
            found = median(lambda: ours(name, text, *options), repetitions)
            rows.append([title, f"MechService, {tolerance}", f'{found["setUp"]:.2f}',
                         f'{found["run"]:.3f}', f'{abs(found[what] - reference):.0e}',
                         f"{drift(name, text, *options):.0e}"])
            print(rows[-1], file=sys.stderr, flush=True)
        for other, steps in runs:
            try:
                found = median(lambda: peer(python, other, scene, n, steps), min(repetitions, 2))
                wrong = abs(found["angle"] - reference)
                if not math.isfinite(wrong):
                    raise RuntimeError("no finite result")
                rows.append([title, f"{other}, {steps} steps", f'{found["setUp"]:.3f}',
                             f'{found["run"]:.3f}', f"{wrong:.0e}", f'{found["drift"]:.0e}'])
            except RuntimeError as e:
                why = ("not written" if "is not written" in str(e) else "no result")
                rows.append([title, f"{other}, {steps} steps", why, "", "", ""])
            print(rows[-1], file=sys.stderr, flush=True)
    return table(["scene", "program", "set-up, s", "run, s", "error", "drift, m"], rows)


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


def peer_run(name, scene, n, steps):
    if scene == "vehicle":
        if name != "mujoco":
            raise SystemExit(f"the vehicle is not written for {name}")
        return mujoco_drives(steps)
    programs = {"exudyn": exudyn, "mujoco": mujoco, "pinocchio": pinocchio}
    return programs[name](PLANAR[scene](n), steps)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--short", action="store_true")
    options.add_argument("--peer", nargs=4, metavar=("NAME", "SCENE", "N", "STEPS"))
    given = options.parse_args()
    if given.peer:
        name, scene, n, steps = given.peer
        print(json.dumps(peer_run(name, scene, int(n), int(steps))))
        return
    WORK.mkdir(parents=True, exist_ok=True)
    python = environment()
    repetitions = 1 if given.short else REPETITIONS
    sizes = [20, 80] if given.short else [20, 40, 80, 160, 320, 640, 1280, 2560]
    peers = [("exudyn", 250, 640), ("exudyn", 1000, 320), ("mujoco", 1000, 160),
             ("pinocchio", 100, 160)]
    text = (HERE / "loops-at-scale.md.in").read_text().format(
        date=time.strftime("%Y-%m-%d"), machine=machine(),
        fourbars=four_bars(python, sizes, peers, repetitions),
        chains=chains([50] if given.short else [50, 100, 200, 400, 1000], repetitions),
        equal=equal_error(python, repetitions),
        evaluations=evaluations([200] if given.short else [200, 400, 1000]),
        steps=steps([100, 200] if given.short else [100, 200, 400, 800, 1600, 3200]),
        others=others(repetitions))
    if given.short:
        print(text)
    else:
        PAGE.write_text(text)


if __name__ == "__main__":
    main()

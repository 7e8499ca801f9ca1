#!/usr/bin/env python3
"""The mechanisms with closed loops of loops.py in Exudyn, MuJoCo and Pinocchio.

    loop_peers.py NAME SCENE N STEPS STEPS ...

prints a line of JSON for each number of steps: seconds of processor time of set-up and run, the
angle or height that is compared, and the largest gap of a loop at the end. A run is repeated three
times if it is short, and the median taken. It stops before a run that would take more than a minute,
judged by the runs before. loops.py starts this in the Python of the peers.
"""
import json
import math
import statistics
import sys
import time

GRAVITY = 9.81
START = 1.0
LONGEST = 60
REPEATED_BELOW = 3


# -- scenes ---------------------------------------------------------------------------------------

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


def vehicle_parts():
    """The vehicle: bodies by name (mass, centre, inertia about it); joints (kind, first body, second
    body, place, axes) in depth-first order; balls that close loops (first, second, place); springs
    (law, length at rest, first body, its point, second body, its point). All as at the start, in the
    axes of the world, which are those of every body."""
    x, y, z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
    bodies, balls, springs = {"chassis": CHASSIS, "boom": BOOM}, [], []
    joints = [("free", "Ground", "chassis", (0, 0, 0), ())]
    for c, corner in enumerate(CORNERS):
        at, side = points(corner), corner[1]
        for part, (mass, (a, b, height), inertia) in CORNER_BODIES.items():
            bodies[f"{part}{c}"] = (mass, (corner[0] + a, side * b, height), inertia)
        joints += [("hinge", "chassis", f"arm{c}", at["lower"], (x,)),
                   ("ball", f"arm{c}", f"upright{c}", at["ball"], ()),
                   ("hinge", f"upright{c}", f"rim{c}", at["wheel"], (y,)),
                   ("cross", f"upright{c}", f"rod{c}", at["tie"], (x, z)),
                   ("hinge", "chassis", f"wishbone{c}", at["upper"], (x,))]
        balls += [(f"wishbone{c}", f"upright{c}", at["top"]), ("chassis", f"rod{c}", at["rack"])]
        for law, first, one, second, two in ((SPRING, "chassis", "tower", f"arm{c}", "seat"),
                                             (TYRE, "Ground", "post", f"upright{c}", "wheel")):
            length = math.dist(at[one], at[two]) + law["more"]
            springs.append((law, length, first, at[one], second, at[two]))
    joints.append(("hinge", "chassis", "boom", (0, 0, 1.5), (y,)))
    return bodies, joints, balls, springs


class Planar:
    """A mechanism in the x-z plane: bodies by centre, angle from x to z, mass and inertia about y;
    pins by two bodies (-1 is the ground) and a point in each one's axes, from its centre. The first
    pin of a body leads to it in a tree; the others close loops. The angle of body 0 is compared."""

    def __init__(self, end):
        self.end, self.bodies, self.pins, self.redundant = end, [], [], False

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
    scene.redundant = True
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


def planar_chain(n):
    scene, x, z, last = Planar(0.2), 0.0, 0.0, (-1, (0, 0))
    for i in range(n):
        angle = -0.3 if i % 2 == 0 else 0.3
        link = scene.body(x + 0.5 * math.cos(angle), z + 0.5 * math.sin(angle), angle)
        scene.pin(*last, link, (-0.5, 0))
        x, z, last = x + math.cos(angle), z + math.sin(angle), (link, (0.5, 0))
    scene.pin(-1, (x, z), *last)
    return scene


PLANAR = {"fourbars": planar_fourbars, "track": planar_track, "net": planar_net,
          "chain": planar_chain}


def gap(scene, poses):
    """Largest distance between the two points of a pin that closes a loop, for poses (x, z, angle)."""
    def place(body, p):
        if body < 0:
            return p
        x, z, angle = poses[body]
        return (x + p[0] * math.cos(angle) - p[1] * math.sin(angle),
                z + p[0] * math.sin(angle) + p[1] * math.cos(angle))
    return max(math.dist(place(f, p), place(s, q)) for f, p, s, q in scene.split()[1])


# -- programs -------------------------------------------------------------------------------------

def exudyn_system():
    # the module without checks of ranges
    sys.exudynFast = True
    import exudyn as exu
    system = exu.SystemContainer().AddSystem()
    return exu, system


def exudyn_solve(exu, system, steps, end, dense=False):
    """Runs the trapezoidal rule on velocities' equations (index 2) and returns its processor time."""
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = end
    settings.timeIntegration.generalizedAlpha.useIndex2Constraints = True
    settings.timeIntegration.generalizedAlpha.useNewmark = True
    settings.timeIntegration.verboseMode = 0
    settings.solution.file.write = False
    kinds = exu.LinearSolverType
    settings.linearSolver.solverType = kinds.EigenDense if dense else kinds.EigenSparse
    settings.linearSolver.reuseAnalyzedPattern = not dense
    settings.linearSolver.ignoreSingularJacobian = dense
    begun = time.process_time()
    system.SolveDynamic(settings)
    return time.process_time() - begun


def independent(scene):
    """Which of the two equations of each pin do not follow from those before it, at the start."""
    import numpy as np
    basis, kept = np.zeros((0, 3 * len(scene.bodies))), []
    tree, closing = scene.split()
    for first, p, second, q in [*tree.values(), *closing]:
        rows = np.zeros((2, 3 * len(scene.bodies)))
        for sign, body, r in ((-1, first, p), (1, second, q)):
            if body >= 0:
                angle = scene.bodies[body][2]
                c, s = math.cos(angle), math.sin(angle)
                rows[0, 3 * body] = rows[1, 3 * body + 1] = sign
                rows[0, 3 * body + 2] = -sign * (r[0] * s + r[1] * c)
                rows[1, 3 * body + 2] = sign * (r[0] * c - r[1] * s)
        flags = []
        for row in rows:
            for _ in range(2):
                row = row - basis.T @ (basis @ row)
            length = float(np.linalg.norm(row))
            flags.append(int(length > 1e-9))
            if flags[-1]:
                basis = np.vstack([basis, row / length])
        kept.append(((first, p, second, q), flags))
    return kept


def exudyn(scene, steps, dense=False):
    """Without dense, equations that follow from others are left out, and factors are sparse; with
    it, all equations are kept, and dense factors with full pivoting pass over those that follow."""
    exu, system = exudyn_system()
    from exudyn.itemInterface import (LoadForceVector, MarkerBodyPosition, NodeRigidBody2D, ObjectGround,
                                      ObjectJointRevolute2D, ObjectJointSpherical, ObjectRigidBody2D)
    begun = time.process_time()
    fixed = system.AddObject(ObjectGround())
    nodes, objects = [], []
    for x, z, angle, mass, inertia in scene.bodies:
        nodes.append(system.AddNode(NodeRigidBody2D(referenceCoordinates=[x, z, angle])))
        objects.append(system.AddObject(
            ObjectRigidBody2D(mass=mass, inertia=inertia, nodeNumber=nodes[-1])))
        centre = system.AddMarker(MarkerBodyPosition(bodyNumber=objects[-1]))
        system.AddLoad(LoadForceVector(markerNumber=centre, loadVector=[0, -GRAVITY * mass, 0]))
    pins = [(pin, (1, 1)) for pin in scene.pins]
    if scene.redundant and not dense:
        pins = independent(scene)
    for (first, p, second, q), flags in pins:
        ends = [system.AddMarker(MarkerBodyPosition(
            bodyNumber=fixed if body < 0 else objects[body], localPosition=[*point, 0]))
            for body, point in ((first, p), (second, q))]
        if all(flags):
            system.AddObject(ObjectJointRevolute2D(markerNumbers=ends))
        elif any(flags):
            system.AddObject(ObjectJointSpherical(markerNumbers=ends, constrainedAxes=[*flags, 0]))
    system.Assemble()
    set_up = time.process_time() - begun
    run = exudyn_solve(exu, system, steps, scene.end, dense)
    poses = []
    for node, (x, z, angle, _, _) in zip(nodes, scene.bodies):
        moved = system.GetNodeOutput(node, exu.OutputVariableType.Coordinates)
        poses.append((x + moved[0], z + moved[1], angle + moved[2]))
    return {"setUp": set_up, "run": run, "angle": -float(poses[0][2]), "drift": gap(scene, poses)}


def exudyn_drives(steps):
    """The vehicle in Exudyn, bodies with Tait-Bryan angles and all its joints as equations."""
    exu, system = exudyn_system()
    import numpy as np
    from exudyn import itemInterface as item
    bodies, joints, balls, springs = vehicle_parts()
    begun = time.process_time()
    numbers, centres = {"Ground": system.AddObject(item.ObjectGround())}, {"Ground": (0, 0, 0)}
    for name, (mass, centre, inertia) in bodies.items():
        centres[name] = centre
        node = system.AddNode(item.NodeRigidBodyRxyz(referenceCoordinates=[*centre, 0, 0, 0]))
        numbers[name] = system.AddObject(
            item.ObjectRigidBody(mass=mass, inertia=[*inertia, 0, 0, 0], nodeNumber=node))
        whole = system.AddMarker(item.MarkerBodyMass(bodyNumber=numbers[name]))
        system.AddLoad(item.LoadMassProportional(markerNumber=whole, loadVector=[0, 0, -GRAVITY]))

    def local(name, place):
        return [a - b for a, b in zip(place, centres[name])]

    def spots(*ends):
        return [system.AddMarker(item.MarkerBodyPosition(
            bodyNumber=numbers[name], localPosition=local(name, place))) for name, place in ends]

    def frames(axes, place, *names):
        """Markers with the axes given as columns."""
        markers = []
        for name in names:
            frame = np.eye(4)
            frame[:3, :3], frame[:3, 3] = np.array(axes).T, local(name, place)
            markers.append(system.AddMarker(
                item.MarkerBodyRigid(bodyNumber=numbers[name], localHT=frame)))
        return markers

    x, y, z = np.eye(3)
    about = {(1, 0, 0): (y, z, x), (0, 1, 0): (z, x, y)}
    for kind, first, second, place, axes in joints:
        if kind == "hinge":
            ends = frames(about[axes[0]], place, first, second)
            system.AddObject(item.ObjectJointRevoluteZ(markerNumbers=ends))
            if second == "boom":
                system.AddObject(item.ObjectConnectorTorsionalSpringDamper(
                    markerNumbers=ends, stiffness=HINGE["k"], damping=HINGE["c"]))
        elif kind == "cross":
            # the second axis of the first marker stays square to the third of the second
            system.AddObject(item.ObjectJointGeneric(
                markerNumbers=frames((-y, x, z), place, first, second),
                constrainedAxes=[1, 1, 1, 1, 0, 0]))
        elif kind == "ball":
            balls = [*balls, (first, second, place)]
    closing = [spots((first, place), (second, place)) for first, second, place in balls]
    for ends in closing:
        system.AddObject(item.ObjectJointSpherical(markerNumbers=ends))
    for law, length, first, p, second, q in springs:
        system.AddObject(item.ObjectConnectorSpringDamper(
            markerNumbers=spots((first, p), (second, q)), referenceLength=length,
            stiffness=law["k"], damping=law["c"]))
    system.Assemble()
    set_up = time.process_time() - begun
    run = exudyn_solve(exu, system, steps, 1.0)
    place = exu.OutputVariableType.Position
    drift = max(math.dist(*(system.GetMarkerOutput(marker, place) for marker in ends))
                for ends in closing)
    height = system.GetObjectOutputBody(numbers["chassis"], place,
                                        localPosition=local("chassis", (0, 0, 0)))[2]
    return {"setUp": set_up, "run": run, "angle": float(height), "drift": drift}


def mujoco_solve(mechanism, end, steps, closing):
    """Runs the classical Runge-Kutta method on the elements of a mechanism. Returns the data at the
    end, and figures: processor times, and the largest gap of the pairs of sites that close loops."""
    import mujoco as mj
    h = end / steps
    begun = time.process_time()
    model = mj.MjModel.from_xml_string(
        f'<mujoco><option timestep="{h}" gravity="0 0 {-GRAVITY}" integrator="RK4"/>'
        f'<default><equality solref="{2.5 * h} 1"/></default>{mechanism}</mujoco>')
    data = mj.MjData(model)
    set_up = time.process_time()
    mj.mj_step(model, data, steps)
    done = time.process_time()
    mj.mj_kinematics(model, data)
    drift = max(math.dist(data.site(a).xpos, data.site(b).xpos) for a, b in closing)
    return data, {"setUp": set_up - begun, "run": done - set_up, "drift": drift}


def mujoco(scene, steps):
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
    data, figures = mujoco_solve(
        f'<worldbody>{"".join(fixed)}{"".join(text)}</worldbody><equality>{equal}</equality>',
        scene.end, steps, [(f"f{i}", f"s{i}") for i in range(len(closing))])
    first = data.joint("j0").qpos[0]
    return {**figures, "angle": float(first) - scene.bodies[0][2]}


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
    data, figures = mujoco_solve(
        mujoco_vehicle(), 1.0, steps, [ends for c in range(len(CORNERS)) for ends in (
            (f"topwish{c}", f"topup{c}"), (f"rack{c}", f"rackrod{c}"))])
    return {**figures, "angle": float(data.qpos[2])}


class Clock:
    """Adds up the processor time of calls."""

    def __init__(self):
        self.taken = 0.0

    def __call__(self, call, *given):
        begun = time.process_time()
        found = call(*given)
        self.taken += time.process_time() - begun
        return found


def runge_kutta(slope, states, end, steps):
    """Four evaluations a step; positions and velocities after the last."""
    import numpy as np
    q, v, h = np.zeros(states), np.zeros(states), end / steps
    for _ in range(steps):
        a1 = slope(q, v)
        a2 = slope(q + h / 2 * v, v + h / 2 * a1)
        a3 = slope(q + h / 2 * v + h * h / 4 * a1, v + h / 2 * a2)
        a4 = slope(q + h * v + h * h / 2 * a2, v + h * a3)
        q = q + h * v + h * h / 6 * (a1 + a2 + a3)
        v = v + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
    return q


class Closings:
    """Equations that close the loops of a model in Pinocchio, stabilised after Baumgarte."""

    def __init__(self, pin, model, ends):
        self.pin, self.model = pin, model
        self.constraints = pin.StdVec_RigidConstraintModel()
        self.datas = pin.StdVec_RigidConstraintData()
        for first, p, second, q in ends:
            places = [pin.SE3(pin.utils.eye(3), at) for at in (p, q)]
            constraint = pin.RigidConstraintModel(
                pin.ContactType.CONTACT_3D, model, first, places[0], second, places[1],
                pin.ReferenceFrame.LOCAL)
            constraint.setBaumgarteCorrectorParameters(
                pin.BaumgarteCorrectorParameters(100.0, 20.0))
            self.constraints.append(constraint)
            self.datas.append(constraint.createData())
        self.data = model.createData()
        pin.initConstraintDynamics(model, self.data, self.constraints, self.datas)
        self.proximal = pin.ProximalSettings(1e-12, 1e-10, 10)

    def accelerations(self, clock, q, v, force):
        return clock(self.pin.constraintDynamics, self.model, self.data, q, v, force,
                     self.constraints, self.datas, self.proximal).copy()

    def gap(self, q):
        self.pin.forwardKinematics(self.model, self.data, q)
        return max(math.dist(self.data.oMi[c.joint1_id].act(c.joint1_placement.translation),
                             self.data.oMi[c.joint2_id].act(c.joint2_placement.translation))
                   for c in self.constraints)


def pinocchio(scene, steps):
    import numpy as np
    import pinocchio as pin
    tree, closing = scene.split()
    begun = time.process_time()
    model = pin.Model()
    model.gravity.linear = np.array([0, 0, -GRAVITY])
    joints = {}
    for body in scene.depth_first():
        first, p, _, q = tree[body]
        angle = scene.bodies[body][2] - (0 if first < 0 else scene.bodies[first][2])
        own = (0, 0) if first < 0 else tree[first][3]
        place = pin.SE3(pin.utils.rotate("y", -angle), np.array([p[0] - own[0], 0, p[1] - own[1]]))
        joints[body] = model.addJoint(0 if first < 0 else joints[first], pin.JointModelRY(), place,
                                      f"j{body}")
        mass, inertia = scene.bodies[body][3:]
        model.appendBodyToJoint(
            joints[body], pin.Inertia(mass, np.array([-q[0], 0, -q[1]]), inertia * np.eye(3)),
            pin.SE3.Identity())
    ends = []
    for first, p, second, q in closing:
        pair = []
        for body, point in ((first, p), (second, q)):
            own = (0, 0) if body < 0 else tree[body][3]
            pair += [0 if body < 0 else joints[body],
                     np.array([point[0] - own[0], 0, point[1] - own[1]])]
        ends.append(pair)
    loops = Closings(pin, model, ends)
    set_up = time.process_time()
    force, clock = np.zeros(model.nv), Clock()
    q = runge_kutta(lambda q, v: loops.accelerations(clock, q, v, force), model.nv, scene.end, steps)
    done = time.process_time()
    return {"setUp": set_up - begun, "run": done - set_up, "calls": clock.taken,
            "angle": float(q[joints[0] - 1]) - scene.bodies[0][2], "drift": loops.gap(q)}


def pinocchio_drives(steps):
    """The vehicle in Pinocchio. Balls and the chassis have angles, so that q' = v. NumPy finds the
    forces of the 28 springs at once; Pinocchio, which takes joint forces alone, brings them there."""
    import numpy as np
    import pinocchio as pin
    bodies, joints, balls, springs = vehicle_parts()
    begun = time.process_time()
    model = pin.Model()
    model.gravity.linear = np.array([0, 0, -GRAVITY])
    numbers, places = {"Ground": 0}, {"Ground": np.zeros(3)}
    turning = {(1, 0, 0): pin.JointModelRX, (0, 1, 0): pin.JointModelRY, (0, 0, 1): pin.JointModelRZ}
    ball = pin.JointModelSphericalZYX()
    for kind, first, second, place, axes in joints:
        place = np.array(place, float)
        chain = {"free": [pin.JointModelTranslation(), ball], "ball": [ball]}.get(
            kind, [turning[axis]() for axis in axes])
        number, at = numbers[first], place - places[first]
        for i, own in enumerate(chain):
            number = model.addJoint(number, own, pin.SE3(np.eye(3), at), f"{second}.{i}")
            at = np.zeros(3)
        numbers[second], places[second] = number, place
        mass, centre, inertia = bodies[second]
        model.appendBodyToJoint(
            number, pin.Inertia(mass, np.array(centre) - place, np.diag(np.array(inertia, float))),
            pin.SE3.Identity())
    loops = Closings(pin, model, [
        [numbers[first], np.array(place) - places[first],
         numbers[second], np.array(place) - places[second]] for first, second, place in balls])
    weightless, other = model.copy(), model.createData()
    weightless.gravity.linear = np.zeros(3)
    stiffness = np.array([law["k"] for law, *_ in springs])
    damping = np.array([law["c"] for law, *_ in springs])
    rest = np.array([length for _, length, *_ in springs])
    used = sorted({numbers[name] for spring in springs for name in (spring[2], spring[4])})
    ends = []
    for name, point in ((2, 3), (4, 5)):
        ends.append((np.array([used.index(numbers[spring[name]]) for spring in springs]),
                     np.array([np.array(spring[point]) - places[spring[name]] for spring in springs])))
    wrenches = pin.StdVec_Force()
    for _ in range(model.njoints):
        wrenches.append(pin.Force.Zero())
    boom, still = model.joints[numbers["boom"]].idx_v, np.zeros(model.nv)
    set_up = time.process_time()
    clock = Clock()

    def slope(q, v):
        clock(pin.forwardKinematics, model, other, q, v)
        turned = np.array([other.oMi[joint].rotation for joint in used])
        origin = np.array([other.oMi[joint].translation for joint in used])
        moving = np.array([other.v[joint].vector for joint in used])
        spots, rates = [], []
        for body, arm in ends:
            spots.append(origin[body] + np.einsum("nij,nj->ni", turned[body], arm))
            speed = moving[body, :3] + np.cross(moving[body, 3:], arm)
            rates.append(np.einsum("nij,nj->ni", turned[body], speed))
        apart = spots[1] - spots[0]
        length = np.sqrt((apart * apart).sum(1))
        along = apart / length[:, None]
        rate = ((rates[1] - rates[0]) * along).sum(1)
        pull = (stiffness * (length - rest) + damping * rate)[:, None] * along
        total = np.zeros((len(used), 6))
        for sign, (body, arm) in zip((1, -1), ends):
            own = sign * np.einsum("nji,nj->ni", turned[body], pull)
            np.add.at(total, body, np.hstack([own, np.cross(arm, own)]))
        for joint, wrench in zip(used, total):
            wrenches[joint] = pin.Force(wrench)
        force = -clock(pin.rnea, weightless, other, q, still, still, wrenches)
        force[boom] -= HINGE["k"] * q[boom] + HINGE["c"] * v[boom]
        return loops.accelerations(clock, q, v, force)

    q = runge_kutta(slope, model.nv, 1.0, steps)
    done = time.process_time()
    return {"setUp": set_up - begun, "run": done - set_up, "calls": clock.taken,
            "angle": float(q[2]), "drift": loops.gap(q)}


# -- runs -----------------------------------------------------------------------------------------

def once(name, scene, n, steps):
    if scene == "vehicle":
        return {"exudyn": exudyn_drives, "mujoco": mujoco_drives,
                "pinocchio": pinocchio_drives}[name](steps)
    programs = {"exudyn": exudyn, "mujoco": mujoco, "pinocchio": pinocchio,
                "exudyn-dense": lambda built, count: exudyn(built, count, dense=True)}
    return programs[name](PLANAR[scene](n), steps)


def main():
    name, scene, n, *all_steps = sys.argv[1:]
    a_step = 0.0
    for steps in map(int, all_steps):
        if a_step * steps > LONGEST:
            break
        found = [once(name, scene, int(n), steps)]
        while len(found) < 3 and found[0]["run"] + found[0]["setUp"] < REPEATED_BELOW:
            found.append(once(name, scene, int(n), steps))
        figures = {what: statistics.median(one[what] for one in found) for what in found[0]}
        a_step = figures["run"] / steps
        print(json.dumps({"steps": steps, **figures}), flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""How many of the drops and hits of docs/reports/nothing-passed-over.md do MuJoCo and Exudyn feel?

    benchmarks/peers/hits.py             # all; writes its part of the page
    benchmarks/peers/hits.py --short     # the first hundred; nothing is written

The scenes are those of the set "drops and hits", which a test writes. Those are taken that the other
program has a shape or a stop for. MuJoCo runs at its default step of 2 ms with its default solver and
contact, Exudyn with its implicit solver at 10 ms, the default of its settings, and at 1 ms, with the
contact law of the scene. A hit is missed if the place or the velocity that it changes most ends
less than a tenth of that change away from what it is without the hit, which the same program computes
without the contact, or on the other side of it: how elastic a contact is does not matter. The first run fetches the peers from PyPI.
"""
import argparse
import csv
import json
import math
import pathlib
import platform
import subprocess
import sys
import venv
import xml.etree.ElementTree as xml
from datetime import date

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
VENV = ROOT / "benchmarks" / "target" / "peers" / "hits-venv"
SCENES = ROOT / "mechservice" / "target" / "nothing-passed-over" / "hits"
PAGE = ROOT / "docs" / "reports" / "nothing-passed-over.md"
BEGIN, END = "<!-- peers -->\n", "<!-- end of peers -->\n"
PACKAGES = ["mujoco", "exudyn", "numpy"]
MISSED = 0.1
AXES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


# -- scenes ---------------------------------------------------------------------------------------

class Scene:
    """What a model file of the set holds: bodies on a joint each, and one contact or stop."""

    def __init__(self, path):
        root = xml.parse(path).getroot()
        with open(path.with_suffix(".csv"), encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.kind = rows[0][1]
        self.right = {name: float(value) for name, value in rows[1:]}
        self.end = float(root.find(".//timeSet").get("tend"))
        gravity = root.find(".//gravity")
        self.gravity = [float(gravity.get(g)) for g in ("gx", "gy", "gz")] if gravity is not None \
            else [0, 0, 0]
        self.points, self.mass, self.moment, self.cog = {}, {}, {}, {}
        for body in root.iter("body"):
            name = body.get("name")
            for p in body.findall("point"):
                self.points[name, p.get("name")] = [float(p.get(c)) for c in "xyz"]
            if body.find("mass") is not None:
                self.mass[name] = float(body.find("mass").get("value"))
                tensor = body.find("inertiaTensor")
                self.moment[name] = float(tensor.get("Ixx"))
                cog = body.find("cog")
                self.cog[name] = [float(cog.get(c)) for c in "xyz"] if cog is not None else [0] * 3
        starts = {s.get("name"): s for s in root.iter("jointVal")}
        self.joints = []
        for joint in root.iter("joint"):
            start = starts.get(joint.get("name"))
            one, other = joint.find("body1"), joint.find("body2")
            self.joints.append({
                "name": joint.get("name"), "type": joint.get("type"), "body": other.get("name"),
                "at": self.points["Ground", one.get("point")], "axis": AXES[one.get("vector")],
                "q": float(start.get("posVals")) if start is not None else 0,
                "v": float(start.get("velVals")) if start is not None else 0,
                "stiffness": float(joint.get("stiffness", 0)),
                "damping": float(joint.get("damping", 0)), "lower": joint.get("lower"),
                "stop": float(joint.get("stopStiffness", 0))})
        self.contact = next((c for kind in ("sphereContact", "contact", "boxContact", "discContact")
                             for c in root.iter(kind)), None)

    def number(self, name, default=0):
        return float(self.contact.get(name, default))

    def ends(self):
        """Body, its point and the axis of both sides of the contact."""
        return [(e.get("name"), self.points[e.get("name"), e.get("point")], e.get("vector"))
                for e in (self.contact.find("body1"), self.contact.find("body2"))]


def scenes(count):
    if not (SCENES / "1.xml").exists():
        subprocess.run(["mvn", "-q", "-pl", "mechservice", "-am", "-Psoak", "test",
                        "-Dtest=NothingPassedOverTest#writesTheHitsForOtherPrograms",
                        "-Dsurefire.failIfNoSpecifiedTests=false"], check=True, cwd=ROOT)
    paths = sorted(SCENES.glob("*.xml"), key=lambda p: int(p.stem))
    return [p for p in paths if int(p.stem) <= count]


# -- MuJoCo ---------------------------------------------------------------------------------------

def text(values):
    return " ".join(repr(float(v)) for v in values)


def geoms(scene):
    """The geoms of the contact's sides, as MJCF by body; None if there are none."""
    if scene.contact is None:
        return {} if any(j["lower"] for j in scene.joints) else None
    kind = scene.contact.tag
    (one, at1, axis1), (other, at2, axis2) = scene.ends()
    turn = {"x": 'euler="0 90 0"', "y": 'euler="90 0 0"'}
    sides = {}

    def add(body, geom, at, more=""):
        sides.setdefault(body, []).append(f'<geom {geom} pos="{text(at)}" {more}/>')

    if kind == "sphereContact":
        if scene.contact.get("box1"):
            half = [0.5 * float(e) for e in scene.contact.get("box1").split(";")]
            add(one, f'type="box" size="{text(half)}"', at1)
        elif scene.number("length1"):
            size = text([scene.number("radius1"), 0.5 * scene.number("length1")])
            add(one, f'type="capsule" size="{size}"', at1, turn.get(axis1, ""))
        else:
            add(one, f'type="sphere" size="{scene.number("radius1")}"', at1)
        add(other, f'type="sphere" size="{scene.number("radius2")}"', at2)
        return sides
    add(one, 'type="plane" size="10 10 1"', at1)
    if kind == "contact":
        add(other, f'type="sphere" size="{scene.number("radius")}"', at2)
    elif kind == "boxContact":
        half = [0.5 * float(e) for e in scene.contact.get("box").split(";")]
        add(other, f'type="box" size="{text(half)}"', at2)
    else:
        size = text([scene.number("radius") + scene.number("edge"), 0.01])
        add(other, f'type="cylinder" size="{size}"', at2, turn.get(axis2, ""))
    return sides


def mjcf(scene, on):
    sides = geoms(scene)
    if sides is None:
        return None
    if not on:
        sides = {}
    bodies = ""
    for joint in scene.joints:
        body = joint["body"]
        kind = "slide" if joint["type"] == "P" else "hinge"
        stop = f'limited="true" range="{joint["lower"]} 1000"' if joint["lower"] and on else ""
        moment = [scene.moment[body]] * 3
        bodies += (f'<body pos="{text(joint["at"])}"><joint name="{joint["name"]}" type="{kind}" '
                   f'axis="{text(joint["axis"])}" stiffness="{joint["stiffness"]}" '
                   f'damping="{joint["damping"]}" {stop}/>'
                   f'<inertial pos="{text(scene.cog[body])}" mass="{scene.mass[body]}" '
                   f'diaginertia="{text(moment)}"/>{"".join(sides.get(body, []))}</body>')
    return (f'<mujoco><compiler angle="{"radian"}" eulerseq="xyz" autolimits="false"/>'
            f'<option gravity="{text(scene.gravity)}"/>'
            f'<worldbody>{"".join(sides.get("Ground", []))}{bodies}</worldbody></mujoco>'
            ).replace('euler="90 0 0"', f'euler="{math.pi / 2} 0 0"'
                      ).replace('euler="0 90 0"', f'euler="0 {math.pi / 2} 0"')


def run_mujoco(scene, on, step):
    import mujoco
    content = mjcf(scene, on)
    if content is None:
        return None
    model = mujoco.MjModel.from_xml_string(content)
    if step:
        model.opt.timestep = step
    data = mujoco.MjData(model)
    for joint in scene.joints:
        data.joint(joint["name"]).qpos[0] = joint["q"]
        data.joint(joint["name"]).qvel[0] = joint["v"]
    while data.time < scene.end - 0.5 * model.opt.timestep:
        mujoco.mj_step(model, data)
    found = {}
    for joint in scene.joints:
        found[joint["name"] + ".q"] = float(data.joint(joint["name"]).qpos[0])
        found[joint["name"] + ".v"] = float(data.joint(joint["name"]).qvel[0])
    return found


# -- Exudyn ---------------------------------------------------------------------------------------

def run_exudyn(scene, on, step):
    import exudyn as exu
    from exudyn.utilities import MarkerBodyRigid, InertiaCuboid, RigidBodyInertia
    from exudyn.itemInterface import ObjectContactSphereSphere, ObjectContactSphereTriangle
    import numpy as np
    if scene.contact is None or scene.contact.tag not in ("sphereContact", "contact"):
        return None
    if scene.number("length1"):
        return None
    container = exu.SystemContainer()
    system = container.AddSystem()
    ground = system.CreateGround(referencePosition=[0, 0, 0])
    bodies = {"Ground": ground}
    for joint in scene.joints:
        name, axis = joint["body"], np.array(joint["axis"], float)
        slides = joint["type"] == "P"
        cog = np.array(scene.cog[name])
        inertia = RigidBodyInertia(scene.mass[name], np.eye(3) * scene.moment[name])
        if slides:
            place = np.array(joint["at"]) + axis * joint["q"]
            turn, spin, speed = np.eye(3), [0, 0, 0], axis * joint["v"]
            reference = place + cog
        else:
            turn = rotation(axis, joint["q"])
            spin = axis * joint["v"]
            reference = np.array(joint["at"]) + turn @ cog
            speed = np.cross(spin, turn @ cog)
        body = system.CreateRigidBody(
            inertia=inertia, referencePosition=list(reference), initialVelocity=list(speed),
            initialAngularVelocity=list(spin), referenceRotationMatrix=turn,
            gravity=scene.gravity)
        bodies[name] = body
        create = system.CreatePrismaticJoint if slides else system.CreateRevoluteJoint
        create(bodyNumbers=[ground, body],
               position=list(np.array(joint["at"]) + (axis * joint["q"] if slides else 0)),
               axis=list(axis), useGlobalFrame=True)
        if joint["stiffness"] or joint["damping"]:
            system.CreateCartesianSpringDamper(
                bodyNumbers=[ground, body], localPosition0=list(joint["at"]),
                localPosition1=[0, 0, 0], stiffness=list(axis * joint["stiffness"]),
                damping=list(axis * joint["damping"]))
    if on:
        (one, at1, _), (other, at2, _) = scene.ends()

        def marker(body, at):
            shift = np.zeros(3) if body == "Ground" else np.array(scene.cog[body])
            return system.AddMarker(MarkerBodyRigid(bodyNumber=bodies[body],
                                                    localPosition=list(np.array(at) - shift)))
        law = {"contactStiffness": scene.number("stiffness"),
               "contactDamping": scene.number("damping"),
               "contactStiffnessExponent": scene.number("exponent", 1)}
        if scene.contact.tag == "sphereContact" and not scene.contact.get("box1"):
            system.AddObject(ObjectContactSphereSphere(
                markerNumbers=[marker(one, at1), marker(other, at2)],
                nodeNumber=node(system, 1),
                spheresRadii=[scene.number("radius1"), scene.number("radius2")], **law))
        else:
            top = 0.0
            radius = scene.number("radius")
            if scene.contact.get("box1"):
                top = 0.5 * float(scene.contact.get("box1").split(";")[2])
                radius = scene.number("radius2")
            system.AddObject(ObjectContactSphereTriangle(
                markerNumbers=[marker(other, at2), marker(one, [at1[0], at1[1], at1[2] + top])],
                nodeNumber=node(system, 0), radiusSphere=radius,
                trianglePoints=exu.Vector3DList([[-1, -1, 0], [1, -1, 0], [0, 1, 0]]),
                **law))
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = max(1, math.ceil(scene.end / step))
    settings.timeIntegration.endTime = scene.end
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.displayStatistics = False
    system.SolveDynamic(settings, showHints=False, showCausingItems=False)
    found = {}
    for joint in scene.joints:
        axis = np.array(joint["axis"])
        kind = exu.OutputVariableType.Velocity if joint["type"] == "P" \
            else exu.OutputVariableType.AngularVelocity
        value = system.GetObjectOutputBody(bodies[joint["body"]], kind, localPosition=[0, 0, 0])
        found[joint["name"] + ".v"] = float(axis @ np.array(value))
        if joint["type"] == "P":
            place = system.GetObjectOutputBody(
                bodies[joint["body"]], exu.OutputVariableType.Position, localPosition=[0, 0, 0])
            found[joint["name"] + ".q"] = float(axis @ (np.array(place) - np.array(joint["at"])))
    return found


def node(system, spheres):
    from exudyn.itemInterface import NodeGenericData
    count = 4
    return system.AddNode(NodeGenericData(numberOfDataCoordinates=count,
                                          initialCoordinates=[0.1] + [0] * (count - 1)))


def rotation(axis, angle):
    import numpy as np
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


# -- comparison -----------------------------------------------------------------------------------

PEERS = {"MuJoCo, 2 ms": (run_mujoco, None), "Exudyn, 10 ms": (run_exudyn, 0.01),
         "Exudyn, 1 ms": (run_exudyn, 0.001)}


def verdict(scene, run, step):
    """felt, missed, failed, or None if the program has nothing for the scene."""
    try:
        without = run(scene, False, step)
        if without is None:
            return None
        found = run(scene, True, step)
    except Exception:  # noqa: BLE001  what a peer cannot run is counted, whatever it throws
        return "failed"
    # of places and of velocities, the one that the hit changes most
    for kind in (".q", ".v"):
        changes = {c: scene.right[c] - without[c] for c in without
                   if c.endswith(kind) and c in scene.right}
        most = max(changes, key=lambda c: abs(changes[c]))
        if (found[most] - without[most]) / changes[most] < MISSED:
            return "missed"
    return "felt"


def measure(count):
    table = {}
    for path in scenes(count):
        scene = Scene(path)
        for name, (run, step) in PEERS.items():
            found = verdict(scene, run, step)
            if found:
                counts = table.setdefault(scene.kind, {}).setdefault(
                    name, {"felt": 0, "missed": 0, "failed": 0})
                counts[found] += 1
    print(json.dumps(table))


def page(table, versions):
    lines = [f"Written on {date.today()} by `benchmarks/peers/hits.py`, {platform.system()} "
             f"{platform.machine()}, {versions}. The hits of the first set for which the program has "
             "a shape or a stop, at its usual steps. Missed: the place or the velocity that the hit "
             "changes most ends less than a tenth of that change away from what it is without the "
             "hit. MuJoCo's contact is "
             "softer and less elastic than that of the scene, which does not count; failed: the "
             "program ended the run with an error, so it was told.\n\n",
             "| kind | " + " | ".join(f"{p}: missed of all" for p in PEERS) + " |\n",
             "|---" * (1 + len(PEERS)) + "|\n"]

    def cell(counts):
        if not counts:
            return ""
        failed = f", {counts['failed']} failed" if counts["failed"] else ""
        return f"{counts['missed']} of {sum(counts.values())}{failed}"
    total = {}
    for kind, row in table.items():
        lines.append(f"| {kind} | " + " | ".join(cell(row.get(p)) for p in PEERS) + " |\n")
        for peer, counts in row.items():
            into = total.setdefault(peer, {"felt": 0, "missed": 0, "failed": 0})
            for key, value in counts.items():
                into[key] += value
    lines.append("| all | " + " | ".join(cell(total.get(p)) for p in PEERS) + " |\n")
    return "".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--short", action="store_true", help="the first hundred; nothing is written")
    parser.add_argument("--python", help="a Python that has mujoco, exudyn and numpy")
    parser.add_argument("--measure", type=int, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.measure:
        measure(options.measure)
        return
    python = pathlib.Path(options.python) if options.python else VENV / "bin" / "python3"
    if not python.exists():
        venv.create(VENV, with_pip=True)
        subprocess.run([python, "-m", "pip", "install", "--quiet", *PACKAGES], check=True)
    output = subprocess.run([python, __file__, "--measure", "100" if options.short else "1000"],
                            check=True, text=True, stdout=subprocess.PIPE).stdout
    versions = subprocess.run(
        [python, "-c", "from importlib.metadata import version as v\n"
         "print(f'MuJoCo {v(\"mujoco\")}, Exudyn {v(\"exudyn\")}')"],
        check=True, text=True, stdout=subprocess.PIPE).stdout.strip()
    content = page(json.loads(output.strip().splitlines()[-1]), versions)
    if options.short:
        sys.stdout.write(content)
        return
    whole = PAGE.read_text(encoding="utf-8")
    before, rest = whole.split(BEGIN)
    PAGE.write_text(before + BEGIN + content + END + rest.split(END)[1], encoding="utf-8")


if __name__ == "__main__":
    main()

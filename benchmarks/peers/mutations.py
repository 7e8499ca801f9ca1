"""Changes every attribute of small models, one at a time, and compares accelerations with MuJoCo.

A change of an attribute is right if MuJoCo and the import refuse it, if both accelerate alike
before and after, or if the import reports a loss that changes the motion. `robots.py --mutations`
runs it.
"""
import re
import xml.etree.ElementTree as ElementTree

# Values that an attribute of this kind is changed to; numbers are changed as numbers.
WORDS = {
    "true": ["false"], "false": ["true"], "auto": ["true", "false"],
    "enable": ["disable"], "disable": ["enable"],
    "hinge": ["slide"], "slide": ["hinge"], "ball": ["hinge"], "free": ["ball"],
    "sphere": ["box"], "box": ["ellipsoid"], "ellipsoid": ["box"], "capsule": ["cylinder"],
    "cylinder": ["capsule"], "degree": ["radian"], "radian": ["degree"],
}
# Attributes that a model lacks, with a value that is not the default.
ADDED = {
    "compiler": {"angle": "radian", "autolimits": "false", "boundmass": "3", "boundinertia": "0.5",
                 "balanceinertia": "true", "settotalmass": "9", "eulerseq": "zyx",
                 "inertiafromgeom": "true", "inertiagrouprange": "0 2", "fitaabb": "true",
                 "fusestatic": "true", "discardvisual": "true"},
    "option": {"gravity": "1 2 -3", "wind": "3 0 0", "density": "1000", "viscosity": "1",
               "timestep": "0.01", "integrator": "implicit", "cone": "elliptic",
               "impratio": "3", "o_margin": "1", "magnetic": "1 1 1", "solver": "PGS",
               "tolerance": "1e-3", "iterations": "3", "jacobian": "dense"},
    "flag": {name: "disable" for name in (
        "gravity", "spring", "damper", "actuation", "limit", "frictionloss", "equality",
        "clampctrl", "warmstart", "filterparent", "refsafe", "sensor", "midphase",
        "eulerdamp", "autoreset", "constraint", "contact")},
    "body": {"pos": "0.1 0.2 0.3", "quat": "0.8 0.6 0 0", "axisangle": "1 2 3 40", "gravcomp": "0.5",
             "xyaxes": "0 1 0 -1 0 0.1", "zaxis": "1 1 1", "euler": "10 20 30", "mocap": "true",
             "childclass": "nowhere", "user": "1 2"},
    "joint": {"pos": "0.1 0 0.2", "axis": "1 2 3", "type": "slide", "range": "-1 1", "ref": "0.3",
              "springref": "0.4", "springdamper": "0.2 1.1", "stiffness": "7", "damping": "0.8",
              "frictionloss": "0.5", "armature": "0.3", "limited": "true", "margin": "0.1",
              "actuatorfrcrange": "-1 1", "actuatorfrclimited": "false",
              "actuatorgravcomp": "true", "group": "3", "springyield": "0.2",
              "solreflimit": "0.1 1", "solimplimit": "0.5 0.6 0.1", "solreffriction": "0.1 1"},
    "freejoint": {"group": "2"},
    "geom": {"pos": "0.1 0.2 0", "euler": "10 20 30", "mass": "3", "density": "333", "size": "0.11 0.12 0.13",
             "fromto": "0 0 0 0.1 0.2 0.3", "type": "box", "shellinertia": "true", "group": "3",
             "fluidshape": "ellipsoid", "contype": "0", "friction": "0.3", "rgba": "1 0 0 1",
             "margin": "0.1", "gap": "0.1", "condim": "6", "priority": "2", "solmix": "2"},
    "fixed": {"stiffness": "5", "damping": "0.3", "springlength": "0.1", "range": "-1 1",
              "frictionloss": "0.3", "limited": "true", "armature": "0.2", "group": "2"},
    "spatial": {"stiffness": "5", "damping": "0.3", "springlength": "0.1", "range": "0 1",
                "frictionloss": "0.3", "armature": "0.2", "width": "0.1"},
    "motor": {"gear": "2", "ctrlrange": "1 2", "forcerange": "-0.1 0.1", "armature": "0.2",
              "damping": "0.3", "delay": "0.01"},
    "position": {"gear": "2", "kp": "30", "kv": "2", "dampratio": "0.7", "timeconst": "0.1",
                 "inheritrange": "0.8",
                 "ctrlrange": "1 2", "forcerange": "-0.1 0.1", "armature": "0.2", "damping": "0.3"},
    "velocity": {"gear": "2", "kv": "3", "ctrlrange": "1 2", "forcerange": "-0.1 0.1",
                 "armature": "0.2", "damping": "0.3"},
    "general": {"gear": "2", "biastype": "affine", "biasprm": "1 2 3", "gainprm": "3",
                "dyntype": "integrator", "gaintype": "affine", "armature": "0.2", "damping": "0.3",
                "actrange": "0.1 0.2", "actearly": "true", "ctrllimited": "true",
                "forcelimited": "false", "inheritrange": "0.8"},
    "replicate": {"count": "3", "offset": "0.1 0.2 0.3", "euler": "0 0 20"},
    "frame": {"pos": "0.1 0.2 0.3", "euler": "10 20 30"},
    "mesh": {"scale": "1 2 1", "inertia": "shell", "refpos": "0.1 0 0", "refquat": "0.8 0.6 0 0"},
    "weld": {"active": "false"}, "connect": {"active": "false"},
    "intvelocity": {"gear": "2", "kp": "30", "kv": "2", "dampratio": "0.7", "ctrlrange": "1 2",
                    "actrange": "0.1 0.2", "forcerange": "-0.1 0.1", "armature": "0.2",
                    "inheritrange": "0.8"},
    "damper": {"gear": "2", "kv": "3", "ctrlrange": "0.5 2", "forcerange": "-0.1 0.1"},
    "cylinder": {"gear": "2", "area": "2", "diameter": "0.3", "bias": "1 2 3", "timeconst": "0.2",
                 "ctrlrange": "1 2", "forcerange": "-0.1 0.1"},
    "inertial": {"euler": "10 20 30", "diaginertia": "0.3 0.4 0.5"},
    "site": {"pos": "0.1 0.2 0.3", "euler": "10 20 30", "zaxis": "1 1 1"},
    "pulley": {"divisor": "3"},
}
NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?$")


def numbers(text):
    """Returns texts in which one number after the other is changed."""
    words = text.split()
    if not words or not all(NUMBER.match(word) for word in words):
        return []
    changed = []
    for i, word in enumerate(words):
        value = float(word)
        other = value * 1.3 + (0.07 if value == 0 else 0)
        copy = list(words)
        copy[i] = repr(other) if "." in word or "e" in word.lower() or value == 0 else str(
            int(value) + 1)
        changed.append(" ".join(copy))
    return changed


def changes(root):
    """Yields (what is changed, the changed tree's text), and leaves the tree as it was."""
    for index, element in enumerate(root.iter()):
        place = f"{element.tag}[{index}]"
        for name, value in list(element.attrib.items()):
            if name in ("name", "class", "file", "model"):
                continue
            others = numbers(value) or WORDS.get(value, [])
            for other in others:
                element.set(name, other)
                yield f"{place} {name}={other!r} for {value!r}", ElementTree.tostring(root, "unicode")
            del element.attrib[name]
            yield f"{place} without {name}={value!r}", ElementTree.tostring(root, "unicode")
            element.set(name, value)
        for name, value in ADDED.get(element.tag, {}).items():
            if name not in element.attrib:
                element.set(name, value)
                yield f"{place} with {name}={value!r}", ElementTree.tostring(root, "unicode")
                del element.attrib[name]


def with_settings(text):
    """Returns a model in which every element that holds settings is there to be changed."""
    root = ElementTree.fromstring(text)
    for name in ("compiler", "option"):
        if root.find(name) is None:
            root.insert(0, ElementTree.Element(name))
    option = root.find("option")
    if option.find("flag") is None:
        ElementTree.SubElement(option, "flag")
    return root

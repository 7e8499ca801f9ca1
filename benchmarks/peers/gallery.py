#!/usr/bin/env python3
"""Draws the scenes of docs/gallery.md in the viewers of MuJoCo and Exudyn, as these draw by default.

    MUJOCO_GL=egl python gallery.py mujoco OUT [ROBOT.urdf]
    xvfb-run python gallery.py exudyn OUT

It needs the packages mujoco and pillow, or exudyn and an X server (xvfb does). Shapes that a viewer
does not find in the model (both draw what the model gives them, and nothing for a mass or a joint)
are given as the boxes, capsules and cylinders that our examples have as looks. Times are those of
one picture of 640 x 400 by this processor.
"""

import math
import sys
import time
from pathlib import Path

BLUE, ORANGE, GREEN, RED, DARK = "0.18 0.45 0.78 1", "0.89 0.6 0.2 1", "0.35 0.66 0.42 1", ".83 .27 .17 1", ".24 .27 .3 1"


def capsule(a, b, r, colour, kind="capsule"):
    return f'<geom type="{kind}" fromto="{" ".join(map(str, (*a, *b)))}" size="{r}" rgba="{colour}"/>'


def box(at, half, colour):
    return f'<geom type="box" pos="{" ".join(map(str, at))}" size="{" ".join(map(str, half))}" rgba="{colour}"/>'


def ball(at, r, colour):
    return f'<geom type="sphere" pos="{" ".join(map(str, at))}" size="{r}" rgba="{colour}"/>'


def pendulum():
    bodies, ends = "", ""
    for i, colour in enumerate((BLUE, ORANGE, GREEN, RED, DARK)):
        bodies += (f'<body pos="0 0 {-1 if i else 5}"><joint axis="{1 if i % 2 else 0} 1 0" ref="0"/>'
                   + capsule((0, 0, 0), (0, 0, -1), 0.04, colour))
        ends += "</body>"
    return bodies + ends, 6


def crane():
    lattice = "".join(capsule((2, y * .35, z * .35), (8.5, y * .15, 9 + z * .15), .06, RED)
                      for y in (1, -1) for z in (1, -1))
    # the rope is a tendon around a cylinder
    world = (box((-.5, 0, 1.2), (1.3, .75, .65), ORANGE) + box((-.4, .95, .3), (1.8, .25, .3), DARK)
             + box((-.4, -.95, .3), (1.8, .25, .3), DARK) + lattice
             + '<site name="drum" pos="-1 0 2.3" size=".05"/><site name="side" pos="8.6 0 9.8" size=".01"/>'
             + '<geom name="pulley" type="cylinder" fromto="8.5 -.1 9 8.5 .1 9" size=".3" rgba=".7 .7 .7 1"/>'
             + '<body pos="8.8 0 4"><freejoint/>' + ball((0, 0, 0), .55, DARK)
             + '<site name="load" pos="0 0 .5" size=".05"/></body>')
    tendon = ('<tendon><spatial width=".03" rgba=".55 .45 .31 1"><site site="drum"/>'
              '<geom geom="pulley" sidesite="side"/><site site="load"/></spatial></tendon>')
    return world, 18, tendon


def gearbox():
    world = capsule((0, 0, .03), (0, 0, .07), .03, BLUE, "cylinder")
    for i, colour in enumerate((GREEN, RED, ORANGE)):
        x, y = .06 * math.cos(2 * math.pi * i / 3), .06 * math.sin(2 * math.pi * i / 3)
        world += capsule((x, y, .03), (x, y, .07), .03, colour, "cylinder")
        world += capsule((0, 0, .02), (x, y, .02), .008, DARK)
    return world, .3


def half_car():
    world = box((0, 0, .62), (1.85, .04, .17), BLUE) + box((-.2, 0, .98), (.85, .03, .21), ".6 .77 .93 .55")
    for x in (1.3, -1.3):
        world += capsule((x, -.08, .3), (x, .08, .3), .3, DARK, "cylinder")
    return world, 5


def walker():
    world = box((0, 0, .25), (.035, .03, .035), RED)
    for y, lean, colour in ((.035, .05, BLUE), (-.035, -.05, ORANGE)):
        world += capsule((0, y, .25), (lean, y, .012), .011, colour)
        world += capsule((lean - .03, y, .012), (lean + .045, y, .012), .012, DARK)
    return world, .7


def whitworth():
    return (capsule((0, .03, .3), (0, -.03, .3), .1, BLUE, "cylinder") + box((-.03, 0, .3), (.02, .02, .3), RED)
            + capsule((0, 0, .6), (.25, 0, .6), .015, DARK) + box((.4, 0, .6), (.15, .04, .04), GREEN)), 1.2


def suspension():
    world = capsule((0, -.095, .3), (0, .095, .3), .3, DARK, "cylinder")
    for a, b in (((0, -.1, .5), (-.3, -.5, .55)), ((0, -.1, .5), (.2, -.5, .55)), ((0, -.1, .15), (-.25, -.5, .1)),
                 ((.1, -.1, .15), (.2, -.5, .1)), ((-.1, -.1, .3), (-.2, -.5, .3))):
        world += capsule(a, b, .012, ".7 .72 .75 1")
    return world, 1.6


def driver():
    world = box((.1, 0, .25), (.26, .25, .06), DARK) + box((-.22, 0, .65), (.06, .24, .4), DARK)
    world += capsule((0, .08, .4), (0, -.08, .4), .1, DARK) + capsule((-.02, .08, .62), (-.02, -.08, .62), .12, BLUE)
    world += capsule((-.02, .09, .78), (-.02, -.09, .78), .115, BLUE) + ball((.02, 0, 1.05), .1, ".88 .7 .55 1")
    for y in (.1, -.1):
        world += capsule((.05, y, .4), (.45, y, .5), .07, DARK) + capsule((.45, y, .5), (.7, y, .12), .05, DARK)
        world += capsule((0, 1.8 * y, .85), (.15, 1.8 * y, .6), .046, BLUE)
        world += capsule((.15, 1.8 * y, .6), (.4, 1.8 * y, .68), .036, ".88 .7 .55 1")
    return world, 2


def hit():
    return '<body pos="0 0 .0495"><freejoint/>' + ball((0, 0, 0), .05, BLUE) + "</body>", .5


SCENES = [pendulum, driver, suspension, whitworth, gearbox, crane, half_car, walker, hit]


def mujoco_pictures(out, robot):
    import mujoco
    from PIL import Image

    def draw(name, model, distance, height):
        data = mujoco.MjData(model)
        mujoco.mj_forward(model, data)
        camera = mujoco.MjvCamera()
        camera.lookat[:] = (0, 0, height)
        camera.distance, camera.azimuth, camera.elevation = distance, 125, -20
        options = mujoco.MjvOption()
        options.flags[mujoco.mjtVisFlag.mjVIS_CONTACTFORCE] = name == "hit"
        with mujoco.Renderer(model, 400, 640) as renderer:
            renderer.update_scene(data, camera, options)
            renderer.render()
            began = time.process_time()
            picture = renderer.render()
            Image.fromarray(picture).save(out / f"mujoco-{name}.png")
            print(f"{name}: {1000 * (time.process_time() - began):.0f} ms")

    for scene in SCENES:
        world, size, *more = scene()
        text = ('<mujoco><visual><global offwidth="640" offheight="400"/></visual><asset>'
                '<texture type="skybox" builtin="gradient" rgb1=".3 .5 .7" rgb2="0 0 0" width="512" height="512"/>'
                '<texture name="floor" type="2d" builtin="checker" rgb1=".2 .3 .4" rgb2=".1 .2 .3" width="300" height="300"/>'
                '<material name="floor" texture="floor" texrepeat="5 5" reflectance=".2"/></asset><worldbody>'
                f'<light pos="0 0 {2 * size}" dir="0 0 -1" directional="true"/>'
                f'<geom type="plane" size="{size} {size} .1" material="floor"/>{world}</worldbody>{"".join(more)}</mujoco>')
        draw(scene.__name__, mujoco.MjModel.from_xml_string(text), size, .25 * size)
    if robot:
        try:
            draw("robot", mujoco.MjModel.from_xml_path(robot), 2, .5)
        except ValueError as error:
            print("robot:", error)


def exudyn_pictures(out):
    import exudyn as exu
    from exudyn import graphics, itemInterface, utilities

    def rgba(colour):
        return [float(x) for x in colour.split()]

    import xml.etree.ElementTree as tree

    for scene in SCENES:
        world, size, *_ = scene()
        shapes = []

        def gather(element, origin):
            here = [a + float(b) for a, b in zip(origin, element.get("pos", "0 0 0").split())] \
                if element.tag == "body" else origin
            for one in element:
                if one.tag == "body":
                    gather(one, here)
                elif one.tag == "geom":
                    colour = rgba(one.get("rgba", ".5 .5 .5 1"))
                    sizes = [float(x) for x in one.get("size").split()]
                    if one.get("fromto"):
                        v = [float(x) for x in one.get("fromto").split()]
                        a = [x + y for x, y in zip(v[:3], here)]
                        way = [y - x for x, y in zip(v[:3], v[3:])]
                        shapes.append(graphics.Cylinder(pAxis=a, vAxis=way, radius=sizes[0], color=colour, nTiles=32))
                        continue
                    at = [x + float(y) for x, y in zip(here, one.get("pos").split())]
                    shapes.append(
                        graphics.Sphere(point=at, radius=sizes[0], color=colour, nTiles=32)
                        if one.get("type") == "sphere"
                        else graphics.Brick(centerPoint=at, size=[2 * s for s in sizes], color=colour))

        gather(tree.fromstring(f"<worldbody>{world}</worldbody>"), [0, 0, 0])
        shapes.append(graphics.CheckerBoard(size=2 * size))
        system = exu.SystemContainer()
        mbs = system.AddSystem()
        mbs.AddObject(itemInterface.ObjectGround(
            visualization=itemInterface.VObjectGround(graphicsData=shapes)))
        mbs.Assemble()
        settings = system.visualizationSettings
        settings.view0.window.renderWindowSize = [640, 400]
        settings.openGL.advanced.initialModelRotation = [[.57, -.28, .77], [.82, .2, -.53], [0, .94, .34]]
        system.renderer.Start()
        system.renderer.DoIdleTasks(.2)
        settings.exportImages.saveImageFileName = str(out / f"exudyn-{scene.__name__}")
        began = time.process_time()
        system.renderer.ZoomAll()
        system.renderer.DoIdleTasks(.3)
        system.renderer.RedrawAndSaveImage()
        print(f"{scene.__name__}: {1000 * (time.process_time() - began):.0f} ms")
        system.renderer.Stop()


if __name__ == "__main__":
    where = Path(sys.argv[2])
    where.mkdir(parents=True, exist_ok=True)
    if sys.argv[1] == "mujoco":
        mujoco_pictures(where, sys.argv[3] if len(sys.argv) > 3 else None)
    else:
        exudyn_pictures(where)

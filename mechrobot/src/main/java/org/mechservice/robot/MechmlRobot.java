package org.mechservice.robot;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.document.Comment;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.robot.Robot.Joint;
import org.mechservice.robot.Robot.Link;
import org.mechservice.robot.Robot.Mimic;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A robot as a MechML document. Each body has the frame of its link. A joint's point and vectors
 * have the joint's name on both bodies.
 */
final class MechmlRobot {
  /** Acceleration of free fall where a format leaves it to the simulator, m/s²; z points up. */
  private static final Vector3 GRAVITY = new Vector3(0, 0, -9.81);

  private final Robot robot;
  private final RobotTree tree;
  private final String fileName;
  private final RobotJoints joints;
  private final RobotActions actions;
  private final RobotLooks looks;

  MechmlRobot(String fileName, Robot robot, RobotTree tree, RobotLooks looks) {
    this.looks = looks;
    this.fileName = fileName;
    this.robot = robot;
    this.tree = tree;
    joints = new RobotJoints(robot, tree);
    actions = new RobotActions(robot);
  }

  Document document() {
    TagBuilder mechml = new TagBuilder("MechML").add(simulation()).add(model());
    List<Comment> prolog =
        List.of(
            new Comment(
                " Made from "
                    + fileName.replaceAll("-{2,}|\\p{Cntrl}", "_")
                    + ". "
                    + robot.format().title()
                    + " does not define "
                    + (robot.gravity().isEmpty() ? "gravity, " : "")
                    + "the simulation, the stiffness of stops and"
                    + " the transition speed of friction: the import has chosen these values. "));
    return new Document(Optional.of("mechml.dtd"), prolog, mechml.element(), List.of());
  }

  private static TagBuilder simulation() {
    TagBuilder dynamic =
        new TagBuilder("dynamic")
            .add(new TagBuilder("timeSet").set("tini", "0").set("tend", "1").set("tstep", "0.01"))
            .add(
                new TagBuilder("integrator")
                    .set("name", MethodNames.AUTO)
                    .set("relTol", "1e-6")
                    .set("absTol", "1e-8"));
    return new TagBuilder("MBSsimulation").add(dynamic);
  }

  private Element model() {
    Vector3 gravity = robot.gravity().orElse(GRAVITY);
    TagBuilder bodies = new TagBuilder("Bodies");
    TagBuilder all = new TagBuilder("Joints");
    TagBuilder couplings = new TagBuilder("Constraints");
    TagBuilder start = new TagBuilder("relCoorVals");
    TagBuilder forces = new TagBuilder("Forces");
    TagBuilder states = new TagBuilder("States");
    actions.addConstraints(couplings);
    actions.addForces(forces, states);
    robot.links().forEach(link -> bodies.add(body(link)));
    for (Joint joint : robot.joints()) {
      all.add(joints.joint(joint));
      joint.coordinate().mimic().ifPresent(mimic -> couplings.add(coupling(joint, mimic)));
      joints.start(joint).ifPresent(start::add);
    }
    TagBuilder model =
        new TagBuilder("MBSmodel")
            .set("name", robot.name())
            .set("massUnits", "kg")
            .set("lengthUnits", "m");
    model.addUnlessEmpty(joints.parameters()).add(bodies).add(all);
    return model
        .addUnlessEmpty(couplings)
        .addUnlessEmpty(states)
        .add(
            forces.add(
                new TagBuilder("gravity")
                    .set("gx", gravity.x())
                    .set("gy", gravity.y())
                    .set("gz", gravity.z())))
        .add(
            new TagBuilder("topology")
                .add(new TagBuilder("root").set("name", tree.root()))
                .addUnlessEmpty(start))
        .element();
  }

  private Element body(Link link) {
    TagBuilder body = TagBuilder.of("body", link.element()).set("name", link.name());
    looks.source(link).ifPresent(file -> body.set("graphSrc", file));
    joints.frames(link.name()).forEach(body::add);
    actions.frames(link.name()).forEach(body::add);
    link.inertial().ifPresent(inertial -> inertia(body, inertial));
    return body.element();
  }

  private static void inertia(TagBuilder body, Inertial inertial) {
    Vector3 cog = inertial.frame().at();
    Element from = inertial.element();
    if (!cog.equals(Vector3.ZERO)) {
      body.add(
          TagBuilder.of("cog", from, body).set("x", cog.x()).set("y", cog.y()).set("z", cog.z()));
    }
    body.add(TagBuilder.of("mass", from, body).set("value", inertial.mass()));
    double[] m = turned(inertial.frame().turn(), inertial.moments());
    TagBuilder tensor = TagBuilder.of("inertiaTensor", from, body);
    List<String> names = List.of("Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz");
    for (int i = 0; i < m.length; i++) {
      tensor.set(names.get(i), m[i]);
    }
    body.add(tensor);
  }

  /** Returns R I Rᵀ: the tensor in the axes of the link. */
  static double[] turned(Rotation turn, List<Double> moments) {
    double[] i = moments.stream().mapToDouble(Double::doubleValue).toArray();
    if (turn.equals(Rotation.IDENTITY)) {
      return i;
    }
    Vector3[] rows = {
      turn.apply(new Vector3(i[0], i[3], i[4])),
      turn.apply(new Vector3(i[3], i[1], i[5])),
      turn.apply(new Vector3(i[4], i[5], i[2]))
    };
    // rows[k] is R times column k of I; its components are those of the rows of R I.
    Vector3 x = turn.apply(new Vector3(rows[0].x(), rows[1].x(), rows[2].x()));
    Vector3 y = turn.apply(new Vector3(rows[0].y(), rows[1].y(), rows[2].y()));
    Vector3 z = turn.apply(new Vector3(rows[0].z(), rows[1].z(), rows[2].z()));
    return new double[] {x.x(), y.y(), z.z(), x.y(), x.z(), y.z()};
  }

  private static Element coupling(Joint joint, Mimic mimic) {
    TagBuilder coupling =
        TagBuilder.of("CoordConstraint", mimic.element())
            .set("name", joint.name() + " follows " + mimic.joint())
            .set("constant", mimic.offset());
    return coupling
        .add(
            TagBuilder.of("term", mimic.element(), coupling)
                .set("joint", joint.name())
                .set("factor", "1"))
        .add(
            TagBuilder.of("term", mimic.element(), coupling)
                .set("joint", mimic.joint())
                .set("factor", -mimic.multiplier()))
        .element();
  }
}

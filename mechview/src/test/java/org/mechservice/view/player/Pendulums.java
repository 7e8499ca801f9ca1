package org.mechservice.view.player;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneVerdict;

/** A pendulum that turns about y once in two seconds, for pictures. */
final class Pendulums {
  private Pendulums() {}

  static SceneDescription scene(String bodyName, String geometry) {
    Anchor pivot = new Anchor(Anchor.ROOT, Point3.ZERO);
    Anchor top = new Anchor(0, Point3.ZERO);
    Anchor tip = new Anchor(0, new Point3(1, 0, 0));
    return new SceneDescription(
        "pendulum of " + bodyName,
        "Ground",
        BodyPose.WORLD,
        "",
        List.of(),
        new Point3(0, 0, -9.81),
        List.of(
            new SceneBody(
                bodyName,
                BodyPose.WORLD,
                1,
                new Point3(0.5, 0, 0),
                List.of(0.0, 1 / 12.0, 1 / 12.0, 0.0, 0.0, 0.0),
                geometry)),
        List.of(
            new SceneJoint(
                "j", JointType.R, false, false, pivot, top, new Point3(0, 1, 0), Point3.ZERO)),
        List.of(),
        List.of(
            new SceneForce(
                "s",
                SceneForce.Kind.SPRING,
                List.of(new Anchor(Anchor.ROOT, new Point3(0, 0, 2)), tip),
                Point3.ZERO,
                false,
                0,
                "")),
        new SceneVerdict(1, 0, 0, true, List.of()));
  }

  static List<Variable> columns(String bodyName) {
    List<Variable> columns = new ArrayList<>(List.of(new Variable("t", "s")));
    for (String end : List.of("x", "y", "z", "e0", "e1", "e2", "e3")) {
      columns.add(new Variable(bodyName + "." + end, end.startsWith("e") ? "1" : "m"));
    }
    return columns;
  }

  /** Returns rows from 0 s on. */
  static Recording recording(String bodyName, int rows, double step) {
    Recording recording = new Recording();
    recording.begin(columns(bodyName));
    for (int i = 0; i < rows; i++) {
      double half = Math.PI * i * step / 2;
      recording.row(new double[] {i * step, 0, 0, 0, Math.cos(half), 0, Math.sin(half), 0});
    }
    return recording;
  }
}

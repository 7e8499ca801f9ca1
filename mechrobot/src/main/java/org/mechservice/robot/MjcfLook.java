package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.Solid;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * A solid of a body as a shape of MuJoCo.
 *
 * @param kind what it is in MechML
 * @param shape its type in MJCF; empty if MJCF has none
 * @param size half the edges, or the radius and half the length, m
 * @param frame in the body
 */
record MjcfLook(String kind, Optional<String> shape, List<Double> size, Frame frame) {
  MjcfLook {
    size = List.copyOf(size);
  }

  /** Returns the solids of a body. */
  static List<MjcfLook> of(MechmlModel model, String body) {
    List<MjcfLook> all = new ArrayList<>();
    for (Solid solid : model.solids(body)) {
      all.add(of(solid));
    }
    return all;
  }

  private static MjcfLook of(Solid solid) {
    if (solid instanceof Solid.Block block) {
      Vector3 half = block.edges().times(0.5);
      return new MjcfLook(
          "box",
          Optional.of("box"),
          List.of(half.x(), half.y(), half.z()),
          new Frame(block.center(), Rotation.IDENTITY));
    } else if (solid instanceof Solid.Ball ball) {
      return new MjcfLook(
          "sphere",
          Optional.of("sphere"),
          List.of(ball.radius()),
          new Frame(ball.center(), Rotation.IDENTITY));
    } else if (solid instanceof Solid.Round round && round.radius() == round.top()) {
      Vector3 along = round.to().minus(round.from());
      return new MjcfLook(
          "cylinder",
          Optional.of("cylinder"),
          List.of(round.radius(), along.norm() / 2),
          new Frame(round.from().plus(along.times(0.5)), MjcfCompiler.least(along.normalized())));
    }
    boolean cone = solid instanceof Solid.Round;
    return new MjcfLook(cone ? "cone" : "mesh", Optional.empty(), List.of(), Frame.SAME);
  }
}

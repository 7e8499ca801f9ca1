package org.mechservice.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.robot.Robot.Inertial;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/** The shapes of one body with their masses, which together are its inertia. */
final class ShapeMasses {
  /**
   * A shape with mass.
   *
   * @param frame of the shape in the body
   * @param mass kg
   */
  private record Part(Frame frame, double mass, UniformShape shape) {
    Vector3 centre() {
      return frame.at().plus(frame.turn().apply(shape.centre()));
    }
  }

  private final List<Part> parts = new ArrayList<>();

  /**
   * Adds a shape.
   *
   * @param frame of the shape in the body
   * @param mass kg
   */
  void add(Frame frame, double mass, UniformShape shape) {
    parts.add(new Part(frame, mass, shape));
  }

  /**
   * Returns the inertia of all shapes together; empty if no shape has mass.
   *
   * @param body for messages
   */
  Optional<Inertial> inertial(Element body) {
    double mass = 0;
    Vector3 moment = Vector3.ZERO;
    for (Part part : parts) {
      mass += part.mass();
      moment = moment.plus(part.centre().times(part.mass()));
    }
    if (!(mass > 0)) {
      return Optional.empty();
    }
    Vector3 centre = moment.times(1 / mass);
    if (parts.size() == 1) {
      // In the axes of the shape, which a medium around it feels where two moments are equal.
      Part only = parts.get(0);
      double m = mass;
      return Optional.of(
          new Inertial(
              body,
              new Frame(centre, only.frame().turn()),
              m,
              only.shape().moments().stream().map(x -> m * x).toList()));
    }
    double[] sum = new double[6];
    for (Part part : parts) {
      addMoments(part, part.centre().minus(centre), sum);
    }
    return Optional.of(
        new Inertial(
            body,
            new Frame(centre, Rotation.IDENTITY),
            mass,
            List.of(sum[0], sum[1], sum[2], sum[3], sum[4], sum[5])));
  }

  /** Adds m (R J Rᵀ + (d·d) 1 − d dᵀ): xx, yy, zz, xy, xz, yz. */
  private static void addMoments(Part part, Vector3 d, double[] sum) {
    double[] j = MechmlRobot.turned(part.frame().turn(), part.shape().moments());
    double m = part.mass();
    double dd = d.dot(d);
    sum[0] += m * (j[0] + dd - d.x() * d.x());
    sum[1] += m * (j[1] + dd - d.y() * d.y());
    sum[2] += m * (j[2] + dd - d.z() * d.z());
    sum[3] += m * (j[3] - d.x() * d.y());
    sum[4] += m * (j[4] - d.x() * d.z());
    sum[5] += m * (j[5] - d.y() * d.z());
  }
}

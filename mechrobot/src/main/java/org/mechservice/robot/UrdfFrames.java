package org.mechservice.robot;

import java.util.Optional;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.ShortestDecimal;

/** Frames as URDF writes them: a point and the angles roll, pitch and yaw. */
final class UrdfFrames {
  /** About x, which takes z to its opposite. */
  private static final Rotation HALF_TURN = new Rotation(1, 0, 0, 0, -1, 0, 0, 0, -1);

  private UrdfFrames() {}

  /** Returns the element {@code origin} of a frame; empty if it is the frame around it. */
  static Optional<TagBuilder> origin(Frame frame) {
    boolean moved = !frame.at().equals(Vector3.ZERO);
    boolean turned = !frame.turn().isIdentity();
    if (!moved && !turned) {
      return Optional.empty();
    }
    TagBuilder origin = new TagBuilder("origin").set("xyz", text(frame.at()));
    if (turned) {
      origin.set("rpy", text(rollPitchYaw(frame.turn())));
    }
    return Optional.of(origin);
  }

  /**
   * Returns a rotation that takes a unit vector to another one, the least unless they nearly oppose
   * each other.
   *
   * @param to along z or against it
   */
  static Rotation toZ(Vector3 from, Vector3 to) {
    return from.dot(to) < 0
        ? HALF_TURN.times(Rotation.least(from, to.negated()))
        : Rotation.least(from, to);
  }

  /** Returns three numbers separated by blanks. */
  static String text(Vector3 v) {
    // Zero is written without a sign.
    return ShortestDecimal.format(v.x() + 0.0)
        + " "
        + ShortestDecimal.format(v.y() + 0.0)
        + " "
        + ShortestDecimal.format(v.z() + 0.0);
  }

  /**
   * Returns the angles of R = Rz(yaw) Ry(pitch) Rx(roll), rad. Yaw is taken off R first, so that
   * pitch and roll are accurate also where the pitch is ±π/2 and yaw is not determined.
   */
  private static Vector3 rollPitchYaw(Rotation r) {
    double yaw = Math.atan2(r.yx(), r.xx());
    double s = Math.sin(yaw);
    double c = Math.cos(yaw);
    double pitch = Math.atan2(-r.zx(), c * r.xx() + s * r.yx());
    double roll = Math.atan2(s * r.xz() - c * r.yz(), c * r.yy() - s * r.xy());
    return new Vector3(roll, pitch, yaw);
  }
}

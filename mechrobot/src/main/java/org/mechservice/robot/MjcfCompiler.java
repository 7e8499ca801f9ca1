package org.mechservice.robot;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;

/**
 * Conventions of the numbers in an MJCF file: the unit of angles, the order of Euler angles, and
 * the five ways to write an orientation. Source: MuJoCo documentation, XML reference, "Frame
 * orientations" and {@code compiler}.
 */
final class MjcfCompiler {
  private static final Vector3 Z = new Vector3(0, 0, 1);

  /** What settles the inertia of bodies. */
  enum InertiaSource {
    /** Shapes, where a body has no inertial. */
    AUTO,
    /** Shapes, always. */
    SHAPES,
    /** The element inertial alone. */
    INERTIAL
  }

  private final Element mujoco;
  private final RobotNumbers numbers;
  private final double angle;
  private final String eulerSequence;

  /** Reads the elements {@code compiler} of a file; a later one overrides an earlier one. */
  MjcfCompiler(Element mujoco, RobotNumbers numbers) {
    this.mujoco = mujoco;
    this.numbers = numbers;
    angle = setting("angle").filter("radian"::equals).isPresent() ? 1 : Math.PI / 180;
    String sequence = setting("eulerseq").orElse("xyz");
    boolean known = sequence.matches("[xyzXYZ]{3}");
    if (!known) {
      numbers.contradiction(
          mujoco, "eulerseq is " + sequence + "; it is three of x, y, z, X, Y, Z");
    }
    eulerSequence = known ? sequence : "xyz";
  }

  /** Returns a setting; empty if no element has it. */
  Optional<String> setting(String name) {
    return mujoco.children("compiler").stream()
        .flatMap(compiler -> compiler.attribute(name).stream())
        .reduce((earlier, later) -> later);
  }

  /** Returns a numeric setting. */
  double number(String name, double otherwise) {
    double value = otherwise;
    for (Element compiler : mujoco.children("compiler")) {
      value = numbers.optional(compiler, name, value);
    }
    return value;
  }

  /** Returns what settles the inertia of bodies. */
  InertiaSource inertiaSource() {
    return switch (setting("inertiafromgeom").orElse("auto")) {
      case "true" -> InertiaSource.SHAPES;
      case "false" -> InertiaSource.INERTIAL;
      default -> InertiaSource.AUTO;
    };
  }

  /** Returns the first and last group of shapes that have inertia. */
  int[] inertiaGroups() {
    for (int i = mujoco.children("compiler").size() - 1; i >= 0; i--) {
      Element compiler = mujoco.children("compiler").get(i);
      Optional<String> text = compiler.attribute("inertiagrouprange");
      if (text.isPresent()) {
        List<Double> ends = numbers.read(compiler, "inertiagrouprange", text.get(), 2, 2);
        return new int[] {ends.get(0).intValue(), ends.get(1).intValue()};
      }
    }
    return new int[] {0, Integer.MAX_VALUE};
  }

  /** Returns whether a joint is limited that gives a range and does not say whether it holds. */
  boolean autolimits() {
    return setting("autolimits").filter("false"::equals).isEmpty();
  }

  /** Returns the size of the file's unit of angles, rad. */
  double angle() {
    return angle;
  }

  /**
   * Returns the frame that {@code pos} and one of {@code quat}, {@code axisangle}, {@code euler},
   * {@code xyaxes}, {@code zaxis} give.
   */
  Frame frame(Element element) {
    Vector3 at =
        element
            .attribute("pos")
            .map(text -> vector(numbers.read(element, "pos", text, 3, 3), 0))
            .orElse(Vector3.ZERO);
    return new Frame(at, turn(element));
  }

  /** Returns the rotation of a replica: MuJoCo multiplies the Euler angles by its number. */
  Rotation turnOfReplica(Element replicate, int index) {
    return replicate
        .attribute("euler")
        .map(text -> numbers.read(replicate, "euler", text, 3, 3))
        .map(angles -> ofEulerAngles(angles.stream().map(a -> index * a).toList()))
        .orElse(Rotation.IDENTITY);
  }

  private static Vector3 vector(List<Double> numbers, int from) {
    return new Vector3(numbers.get(from), numbers.get(from + 1), numbers.get(from + 2));
  }

  private Rotation turn(Element element) {
    Optional<String> quaternion = element.attribute("quat");
    Optional<String> axisAngle = element.attribute("axisangle");
    Optional<String> euler = element.attribute("euler");
    Optional<String> axes = element.attribute("xyaxes");
    Optional<String> zAxis = element.attribute("zaxis");
    if (Stream.of(quaternion, axisAngle, euler, axes, zAxis).filter(Optional::isPresent).count()
        > 1) {
      numbers.contradiction(element, "it has several orientations; leave one");
    }
    if (quaternion.isPresent()) {
      return ofQuaternion(element, numbers.read(element, "quat", quaternion.get(), 4, 4));
    }
    if (axisAngle.isPresent()) {
      List<Double> a = numbers.read(element, "axisangle", axisAngle.get(), 4, 4);
      return Rotation.about(unit(element, "axisangle", vector(a, 0)), a.get(3) * angle);
    }
    if (euler.isPresent()) {
      return ofEulerAngles(numbers.read(element, "euler", euler.get(), 3, 3));
    }
    if (axes.isPresent()) {
      List<Double> a = numbers.read(element, "xyaxes", axes.get(), 6, 6);
      Vector3 x = unit(element, "xyaxes", vector(a, 0));
      Vector3 given = vector(a, 3);
      Vector3 y = unit(element, "xyaxes", given.minus(x.times(x.dot(given))));
      return Rotation.ofColumns(x, y, x.cross(y));
    }
    if (zAxis.isPresent()) {
      Vector3 z =
          unit(element, "zaxis", vector(numbers.read(element, "zaxis", zAxis.get(), 3, 3), 0));
      return least(z);
    }
    return Rotation.IDENTITY;
  }

  /** Returns the least rotation that brings z to a direction; about x where that is not defined. */
  static Rotation least(Vector3 direction) {
    Vector3 axis = Z.cross(direction);
    double sine = axis.norm();
    if (sine < 1e-12) {
      return direction.z() > 0 ? Rotation.IDENTITY : Rotation.about(new Vector3(1, 0, 0), Math.PI);
    }
    return Rotation.about(axis.times(1 / sine), StrictMath.atan2(sine, direction.z()));
  }

  /** Returns the rotation of a quaternion w x y z of any length but zero. */
  Rotation ofQuaternion(Element element, List<Double> quaternion) {
    double[] e = quaternion.stream().mapToDouble(Double::doubleValue).toArray();
    if (!(EulerParameters.norm(e, 0) > 0)) {
      numbers.contradiction(element, "its quaternion is zero");
      return Rotation.IDENTITY;
    }
    double[] r = new double[9];
    EulerParameters.rotation(e, 0, r, 0);
    return new Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
  }

  /**
   * Returns the rotation about three axes: lower case turns with the frame, upper case does not.
   */
  private Rotation ofEulerAngles(List<Double> angles) {
    Rotation turn = Rotation.IDENTITY;
    for (int i = 0; i < 3; i++) {
      char letter = eulerSequence.charAt(i);
      Vector3 axis =
          switch (Character.toLowerCase(letter)) {
            case 'x' -> new Vector3(1, 0, 0);
            case 'y' -> new Vector3(0, 1, 0);
            default -> Z;
          };
      Rotation one = Rotation.about(axis, angles.get(i) * angle);
      turn = Character.isLowerCase(letter) ? turn.times(one) : one.times(turn);
    }
    return turn;
  }

  private Vector3 unit(Element element, String what, Vector3 v) {
    if (!(v.norm() > 0)) {
      numbers.contradiction(element, what + " has no direction");
      return Z;
    }
    return v.normalized();
  }
}

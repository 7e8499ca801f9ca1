package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.JointStart;
import org.mechservice.solver.mechanism.joint.Planar;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Screw;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.mechanism.joint.Weld;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** Random joints of every type, half of them taken against the file's sense, and motions. */
public final class RandomMechmlJoints {
  private static final List<JointType> TYPES = List.of(JointType.values());

  private final Random random;

  public RandomMechmlJoints(Random random) {
    this.random = random;
  }

  /** Returns a joint of a random type with coordinates and velocities around 1. */
  public Joint any(String name, Attachment attachment, Vector3 axis) {
    return of(TYPES.get(random.nextInt(TYPES.size())), name, attachment, axis);
  }

  /** Returns a joint of a type with coordinates and velocities around 1. */
  public Joint of(JointType type, String name, Attachment attachment, Vector3 axis) {
    Joint joint =
        forward(name, type, type.hasEulerParameters() ? parallel(attachment) : attachment, axis);
    // Reversed twice it leads outwards again, but the file's sense leads inwards.
    return random.nextBoolean() ? joint : againstTheFile(name, type, joint.attachment(), axis);
  }

  private Joint againstTheFile(String name, JointType type, Attachment attachment, Vector3 axis) {
    return forward(name, type, attachment.reversed(), axis).reversed();
  }

  private static Attachment parallel(Attachment attachment) {
    return new Attachment(
        attachment.parent(),
        attachment.parentPoint(),
        attachment.child(),
        attachment.childPoint(),
        Rotation.IDENTITY);
  }

  private Joint forward(String name, JointType type, Attachment attachment, Vector3 axis) {
    Vector3 unit = axis.normalized();
    Vector3 aside = Math.abs(unit.x()) < 0.7 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
    Vector3 normal = unit.cross(aside).normalized();
    Vector3 inChild = attachment.zeroRotation().transposed().apply(normal);
    JointStart start = start(type);
    double q = number();
    double v = number();
    return switch (type) {
      case R -> new Revolute(name, attachment, unit, q, v, Origin.NONE);
      case P -> new Prismatic(name, attachment, unit, q, v, Origin.NONE);
      case H -> new Screw(name, attachment, unit, 0.4 * number(), q, v, Origin.NONE);
      case C -> new Cylindrical(name, attachment, unit, start, Origin.NONE);
      case U -> new Universal(name, attachment, unit, inChild, start, false, Origin.NONE);
      case PL -> new Planar(name, attachment, unit, normal, start, false, Origin.NONE);
      case S -> new Spherical(name, attachment, start, false, Origin.NONE);
      case F -> new Free(name, attachment, start, false, Origin.NONE);
      case W -> new Weld(name, attachment, Origin.NONE);
    };
  }

  private JointStart start(JointType type) {
    List<Double> q = new ArrayList<>(numbers(type.positionCount()));
    if (type.hasEulerParameters()) {
      double norm = Math.sqrt(q.subList(0, 4).stream().mapToDouble(e -> e * e).sum());
      q.subList(0, 4).replaceAll(e -> e / norm);
    }
    return new JointStart(q, numbers(type.velocityCount()));
  }

  private List<Double> numbers(int count) {
    List<Double> numbers = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      numbers.add(number());
    }
    return numbers;
  }

  private double number() {
    return 2 * random.nextDouble() - 1;
  }

  /** Returns motions for about one joint in three of those that can be driven. */
  public List<PrescribedMotion> motions(List<Joint> joints) {
    List<PrescribedMotion> motions = new ArrayList<>();
    for (int j = 0; j < joints.size(); j++) {
      JointType type = joints.get(j).type();
      boolean possible = type.positionCount() == type.velocityCount() && type != JointType.W;
      if (possible && random.nextInt(3) == 0) {
        List<Expression> coordinates = new ArrayList<>();
        for (int i = 0; i < type.positionCount(); i++) {
          coordinates.add(ofTime());
        }
        motions.add(new PrescribedMotion(j, coordinates));
      }
    }
    return motions;
  }

  /**
   * a sin(b t + c), exp(−a t²), or (b t + c) cos(b t + c): motions without kinks, as no code is
   * generated for others.
   */
  public Expression ofTime() {
    Expression t = new Expression.Time();
    Expression a = Expression.of(number());
    Expression linear = new Expression.Sum(new Expression.Product(Expression.of(number()), t), a);
    return switch (random.nextInt(3)) {
      case 0 -> new Expression.Product(a, new Expression.Call(MathFunction.SIN, List.of(linear)));
      case 1 ->
          new Expression.Call(
              MathFunction.EXP,
              List.of(
                  new Expression.Negation(
                      new Expression.Product(
                          Expression.of(0.5), new Expression.Power(t, Expression.of(2))))));
      default ->
          new Expression.Product(linear, new Expression.Call(MathFunction.COS, List.of(linear)));
    };
  }
}

package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.dynamics.DataDrivenModel;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/**
 * Closures of all kinds on a tree, closed by its positions at the start: cut joints of all types,
 * some of which are driven, rods with and without mass, points on planes and lines, relations of
 * coordinates. Velocities at the start are for assembly to fit.
 */
public final class RandomMechmlLoops {
  private final Random random;
  private final Mechanism tree;
  private final double[] poses;
  private final List<LoopClosure> closures = new ArrayList<>();

  private RandomMechmlLoops(long seed, Mechanism tree) {
    this.random = new Random(seed);
    this.tree = tree;
    DataDrivenModel open = new DataDrivenModel(tree, Scenes.SETTINGS);
    double[] y = new double[open.description().stateCount()];
    open.initialState(y);
    poses = new double[BodyPoses.NUMBERS_PER_BODY * tree.bodies().size()];
    open.poses(0, y, poses);
  }

  /** Returns the tree with closures. */
  public static Mechanism on(Mechanism tree, long seed, int count) {
    RandomMechmlLoops loops = new RandomMechmlLoops(seed, tree);
    for (int i = 0; i < count; i++) {
      loops.closures.add(loops.closure("c" + i));
    }
    return loops.closed(seed);
  }

  /** Returns the tree with a closure of a kind between its last body and the root. */
  public static Mechanism closedBy(Kind kind, Mechanism tree, long seed) {
    RandomMechmlLoops loops = new RandomMechmlLoops(seed, tree);
    BodyPoint onRoot = new BodyPoint(BodyPoint.ROOT, loops.vector().times(0.5));
    int last = tree.bodies().size() - 1;
    loops.closures.add(loops.closure("c", kind, onRoot, last));
    return loops.closed(seed);
  }

  private Mechanism closed(long seed) {
    return new Mechanism(
            "loops" + seed,
            tree.root(),
            tree.gravity(),
            tree.bodies(),
            tree.joints(),
            tree.motions(),
            tree.startRoles(),
            closures,
            tree.forces(),
            tree.parameters())
        .withArmatures(tree.armatures());
  }

  /** What closes a loop. */
  public enum Kind {
    CUT,
    ROD,
    PLANE,
    LINE,
    RELATION
  }

  private LoopClosure closure(String name) {
    int second = random.nextInt(tree.bodies().size());
    int first = random.nextInt(-1, second);
    BodyPoint onFirst = new BodyPoint(first, vector().times(0.5));
    // three in seven are cut joints
    Kind kind = Kind.values()[Math.max(0, random.nextInt(7) - 2)];
    return closure(name, kind, onFirst, second);
  }

  /** Returns a closure of a kind between a point and another body. */
  private LoopClosure closure(String name, Kind kind, BodyPoint onFirst, int second) {
    int first = onFirst.body();
    Vector3 place = place(first).plus(axes(first).apply(onFirst.position()));
    return switch (kind) {
      case CUT -> cut(name, onFirst, second, place);
      case ROD -> {
        BodyPoint onSecond = new BodyPoint(second, vector().times(0.5));
        Vector3 other = place(second).plus(axes(second).apply(onSecond.position()));
        double mass = random.nextBoolean() ? 0 : 0.5 + random.nextDouble();
        yield new DistanceClosure(
            name, onFirst, onSecond, other.minus(place).norm(), mass, Origin.NONE);
      }
      case PLANE ->
          new PointOnPlaneClosure(
              name, at(second, place), onFirst, vector().normalized(), Origin.NONE);
      case LINE ->
          new PointOnLineClosure(
              name, at(second, place), onFirst, vector().normalized(), Origin.NONE);
      case RELATION -> relation(name);
    };
  }

  /** A joint at zero, whatever the poses of its bodies; if driven, by a motion from zero. */
  private LoopClosure cut(String name, BodyPoint onFirst, int second, Vector3 place) {
    Attachment attachment =
        new Attachment(
            onFirst.body(),
            onFirst.position(),
            second,
            at(second, place).position(),
            axes(onFirst.body()).transposed().times(axes(second)));
    Joint joint = new RandomMechmlJoints(random).any(name, attachment, vector());
    JointType type = joint.type();
    boolean driven =
        type.positionCount() == type.velocityCount()
            && type.positionCount() > 0
            && random.nextInt(4) == 0;
    return driven
        ? new JointClosure(
            joint,
            StartRole.PREFERRED,
            IntStream.range(0, type.positionCount()).mapToObj(k -> fromZero()).toList())
        : new JointClosure(joint);
  }

  /** sin(a t) or a t². */
  private Expression fromZero() {
    Expression a = Expression.of(number());
    Expression t = new Expression.Time();
    return random.nextBoolean()
        ? new Expression.Call(MathFunction.SIN, List.of(new Expression.Product(a, t)))
        : new Expression.Product(a, new Expression.Power(t, Expression.of(2)));
  }

  /** a q1 + f(q2) + b t less what that is at the start, f linear or not. */
  private LoopClosure relation(String name) {
    Expression first = position();
    Expression second = position();
    Expression f =
        random.nextBoolean()
            ? new Expression.Product(Expression.of(number()), second)
            : new Expression.Call(MathFunction.SIN, List.of(second));
    Expression sum =
        new Expression.Sum(new Expression.Product(Expression.of(2 + number()), first), f);
    Expression moving =
        new Expression.Sum(
            sum, new Expression.Product(Expression.of(number()), new Expression.Time()));
    return new CoordinateClosure(name, moving, Origin.NONE);
  }

  /** A position of a joint that has one of its own. */
  private Expression position() {
    while (true) {
      int joint = random.nextInt(tree.joints().size());
      JointType type = tree.joints().get(joint).type();
      int euler = type.hasEulerParameters() ? 4 : 0;
      if (type.positionCount() > euler) {
        int component = euler + random.nextInt(type.positionCount() - euler);
        return new Expression.CoordinatePosition(new JointCoordinate(joint, component));
      }
    }
  }

  private BodyPoint at(int body, Vector3 place) {
    return new BodyPoint(body, axes(body).transposed().apply(place.minus(place(body))));
  }

  private Vector3 place(int body) {
    if (body < 0) {
      return tree.root().position();
    }
    int at = BodyPoses.NUMBERS_PER_BODY * body;
    return new Vector3(poses[at], poses[at + 1], poses[at + 2]);
  }

  private Rotation axes(int body) {
    if (body < 0) {
      return tree.root().orientation();
    }
    double[] r = new double[9];
    EulerParameters.rotation(poses, BodyPoses.NUMBERS_PER_BODY * body + 3, r, 0);
    return new Rotation(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);
  }

  private double number() {
    return 2 * random.nextDouble() - 1;
  }

  private Vector3 vector() {
    return new Vector3(number(), number(), number());
  }
}

package org.mechservice.solver.closure;

import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Quotient;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/**
 * Seeded linkages of one or two freedoms in gravity, with a spring in one joint and in the same
 * joint a force that jumps or is nearly as steep as a jump.
 */
final class JumpingLoops {
  /** What jumps. */
  enum Law {
    /** Dry friction on a belt that moves, by the sign of the velocity over it. */
    SIGN,
    /** The same by a steep hyperbolic tangent. */
    STEEP,
    /** A force that changes its sign with time. */
    BANG_BANG,
    /** A spring in steps. */
    STAIRS,
    /** A stop: a stiff spring that acts in one direction. */
    STOP
  }

  /** Which value of the law acts. */
  enum Side {
    BEFORE,
    BEHIND,
    /** The one that the state asks for. */
    OWN
  }

  /** Linkages, with the joint whose force jumps. */
  private enum Shape {
    /** Two blocks on crossed slides with a rod between them. */
    TRAMMEL(0),
    /** A slider-crank; friction in the slide. */
    SLIDER_CRANK(2),
    FOUR_BAR(0),
    /** A four-bar with a geared rocker instead of a coupler's second end. */
    GEARED(0),
    /** A four-bar with a pendulum on its coupler. */
    WITH_PENDULUM(0);

    private final int joint;

    Shape(int joint) {
      this.joint = joint;
    }
  }

  private static final double WIDEST = 1e-4;

  /** Way from the start to a stop, and the least of its stiffnesses over the force. */
  private static final double WAY = 0.05;

  private static final double SOFTEST = 1e3;

  /** Place of the first block of a trammel at the start. */
  private static final double ASIDE = 0.6;

  private final Law law;
  private final Shape shape;
  private final double width;
  private final double stop;
  private final double belt;
  private final double end;
  private final double force;
  private final double stiffness;
  private final double place;
  private final double speed;
  private final double rate;

  JumpingLoops(Law law, long seed) {
    this(law, seed, 0);
  }

  /**
   * @param change part by which force and spring are changed
   */
  JumpingLoops(Law law, long seed, double change) {
    Random random = new Random(seed * 0x9E3779B97F4A7C15L);
    this.law = law;
    shape = Shape.values()[random.nextInt(Shape.values().length)];
    width = law == Law.STEEP ? WIDEST * StrictMath.pow(10, -4 * random.nextDouble()) : 0;
    stop = law == Law.STOP ? SOFTEST * StrictMath.pow(10, 4 * random.nextDouble()) : 0;
    belt = random.nextInt(3) == 0 ? 0 : 0.2 + 0.6 * random.nextDouble();
    end = 1 + 3 * random.nextDouble();
    force = (1 + change) * (2 + 10 * random.nextDouble());
    stiffness = (1 + change) * (10 + 90 * random.nextDouble());
    place = 0.4 * (random.nextDouble() - 0.5);
    speed = 2 * random.nextDouble() - 1;
    rate = 2 + 8 * random.nextDouble();
  }

  Law law() {
    return law;
  }

  /** Returns the velocity within which the law is steep; 0: it jumps. */
  double width() {
    return width;
  }

  double end() {
    return end;
  }

  /** Returns the velocity of the joint with the jump, or what its derivative is. */
  double velocity(double[] state) {
    return state[state.length / 2 + shape.joint];
  }

  /** Returns how far a state is behind the jump of friction, or a time behind that of a force. */
  double behind(double t, double[] y) {
    return law == Law.BANG_BANG ? StrictMath.sin(rate * t) : velocity(y) - belt;
  }

  Mechanism mechanism(Side side) {
    return switch (shape) {
      case TRAMMEL -> trammel(side);
      case SLIDER_CRANK -> sliderCrank(side);
      default -> fourBar(side);
    };
  }

  private Mechanism trammel(Side side) {
    List<Joint> joints =
        List.of(
            new Prismatic("x", onGround(0), Linkages.X, ASIDE, speed, Origin.NONE),
            new Prismatic("z", onGround(1), Linkages.Z, 0.8, -0.75 * speed, Origin.NONE));
    LoopClosure rod =
        new DistanceClosure(
            "rod",
            new BodyPoint(0, Vector3.ZERO),
            new BodyPoint(1, Vector3.ZERO),
            1,
            0,
            Origin.NONE);
    return mechanism(List.of(block("cart", 1), block("lift", 0.5)), joints, List.of(rod), side);
  }

  private Mechanism sliderCrank(Side side) {
    Vector3 pin = new Vector3(0.15, 0, 0.2);
    Vector3 end = new Vector3(0.95, 0, 0);
    List<Body> bodies =
        List.of(
            Linkages.bar("crank", Vector3.ZERO, pin, 1),
            Linkages.bar("rod", pin, end, 0.7),
            block("slider", 1));
    Attachment slide = new Attachment(-1, end, 2, Vector3.ZERO, Rotation.IDENTITY);
    List<Joint> joints =
        List.of(
            turning("crank", -1, 0, Vector3.ZERO, speed),
            turning("pin", 0, 1, pin, 0),
            new Prismatic("slide", slide, Linkages.X, 0, 0, Origin.NONE));
    LoopClosure eye =
        new PointOnLineClosure(
            "eye", new BodyPoint(1, end), new BodyPoint(2, Vector3.ZERO), Linkages.Y, Origin.NONE);
    return mechanism(bodies, joints, List.of(eye), side);
  }

  private Mechanism fourBar(Side side) {
    Vector3 b = new Vector3(0.1, 0, 0.4);
    Vector3 c = new Vector3(1.1, 0, 0.7);
    Vector3 d = new Vector3(1.2, 0, 0);
    Vector3 middle = b.plus(c).times(0.5);
    List<Body> bodies =
        List.of(
            Linkages.bar("AB", Vector3.ZERO, b, 1),
            Linkages.bar("BC", b, c, 2),
            Linkages.bar("CD", d, c, 1.5),
            Linkages.bar("bob", middle, middle.plus(Linkages.Z.times(-0.5)), 0.6));
    List<Joint> joints =
        List.of(
            turning("A", -1, 0, Vector3.ZERO, speed),
            turning("B", 0, 1, b, 0),
            turning("D", -1, 2, d, 0),
            turning("bob", 1, 3, middle, 1));
    int count = shape == Shape.WITH_PENDULUM ? 4 : 3;
    List<LoopClosure> closures =
        shape == Shape.GEARED
            ? geared(c, d.plus(Linkages.X.times(0.3)))
            : List.of(
                new PointOnLineClosure(
                    "C", new BodyPoint(1, c), new BodyPoint(2, c), Linkages.Y, Origin.NONE));
    return mechanism(bodies.subList(0, count), joints.subList(0, count), closures, side);
  }

  private static List<LoopClosure> geared(Vector3 c, Vector3 onRocker) {
    Expression crank = new CoordinatePosition(new JointCoordinate(0, 0));
    Expression rocker = new CoordinatePosition(new JointCoordinate(2, 0));
    Expression gear = new Sum(crank, new Product(Expression.of(-0.8), rocker));
    return List.of(
        new DistanceClosure(
            "strut",
            new BodyPoint(1, c),
            new BodyPoint(2, onRocker),
            c.minus(onRocker).norm(),
            0,
            Origin.NONE),
        new CoordinateClosure("gear", gear, Origin.NONE));
  }

  private Mechanism mechanism(
      List<Body> bodies, List<Joint> joints, List<LoopClosure> closures, Side side) {
    return new Mechanism(
        toString(),
        Linkages.GROUND,
        Linkages.Z.times(-9.81),
        bodies,
        joints,
        List.of(),
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        closures,
        forces(side),
        List.of());
  }

  private List<ForceElement> forces(Side side) {
    JointCoordinate joint = new JointCoordinate(shape.joint, 0);
    double start = shape == Shape.TRAMMEL ? ASIDE : 0;
    Expression position = new CoordinatePosition(joint);
    Expression off = new Sum(position, Expression.of(-start - place));
    Expression into = new Sum(position, Expression.of(-start - WAY));
    Expression jump =
        switch (side) {
          case BEFORE -> Expression.of(-1);
          case BEHIND -> Expression.of(1);
          case OWN -> jump(new CoordinateVelocity(joint), off, into);
        };
    return List.of(
        new JointForce("spring", joint, new Product(Expression.of(-stiffness), off), Origin.NONE),
        new JointForce("jump", joint, new Product(Expression.of(-force), jump), Origin.NONE));
  }

  private Expression jump(Expression velocity, Expression off, Expression into) {
    Expression slip = new Sum(velocity, Expression.of(-belt));
    return switch (law) {
      case SIGN -> call(MathFunction.SIGNUM, slip);
      case STEEP -> call(MathFunction.TANH, new Quotient(slip, Expression.of(width)));
      case BANG_BANG ->
          call(
              MathFunction.SIGNUM,
              call(MathFunction.SIN, new Product(Expression.of(rate), new Time())));
      case STAIRS ->
          new Quotient(
              call(MathFunction.FLOOR, new Product(Expression.of(30), off)), Expression.of(10));
      case STOP -> new Product(Expression.of(stop), call(MathFunction.MAX, into, Expression.of(0)));
    };
  }

  private static Expression call(MathFunction function, Expression... arguments) {
    return new Expression.Call(function, List.of(arguments));
  }

  private static Body block(String name, double mass) {
    return new Body(name, mass, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE);
  }

  private static Attachment onGround(int child) {
    return new Attachment(-1, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }

  private static Revolute turning(String name, int parent, int child, Vector3 at, double speed) {
    Attachment attachment = new Attachment(parent, at, child, at, Rotation.IDENTITY);
    return new Revolute(name, attachment, Linkages.Y, 0, speed, Origin.NONE);
  }

  @Override
  public String toString() {
    return law + " on " + shape + ", width " + width + ", belt " + belt + ", to " + end;
  }
}

package org.mechservice.solver.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Argument;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.PathMotion;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.expression.Expression.PointVelocity;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.expression.ScalarFormulas;
import org.mechservice.solver.force.law.Condition;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.force.law.Wrap;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.LawForce;
import org.mechservice.solver.mechanism.force.NamedPoint;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.mechanism.force.PathForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;
import org.mechservice.solver.text.Origin;

/**
 * Seeded forces of every kind between the bodies and joints of a mechanism, all terms of a size of
 * 1 to 10 so that their differences keep their digits.
 */
public final class RandomForces {
  /** What can be drawn. */
  public enum Kind {
    SPRING_BOTH,
    SPRING_ABOVE,
    SPRING_BELOW,
    JOINT_SPRING,
    JOINT_STOP,
    BUSHING_ENERGY,
    BUSHING_LINEAR,
    FORCE_TORQUE_WORLD,
    FORCE_TORQUE_BODY,
    JOINT_FORCE,
    CONTACT_PLANE,
    CONTACT_PROFILE,
    FRICTION,
    USER_WITH_DIFFERENCES,
    USER_WITH_DERIVATIVES,
    COUPLING_SPRING,
    PAIR_FORCE,
    RELATIVE_WRENCH,
    LAW,
    CONTACT_TRACKS,
    PATH,
    PATH_ON_A_SIDE,
    PATH_IN_A_RING
  }

  private final Random random;
  private final Mechanism mechanism;
  private final List<JointCoordinate> positions = new ArrayList<>();
  private final List<JointCoordinate> velocities = new ArrayList<>();
  private final List<JointCoordinate> allPositions = new ArrayList<>();

  public RandomForces(long seed, Mechanism mechanism) {
    random = new Random(seed);
    this.mechanism = mechanism;
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      int surplus = joint.type().positionCount() - joint.type().velocityCount();
      for (int i = 0; i < joint.type().positionCount(); i++) {
        allPositions.add(new JointCoordinate(j, i));
        if (surplus == 0 || i >= 4) {
          positions.add(new JointCoordinate(j, i));
        }
      }
      for (int i = 0; i < joint.type().velocityCount(); i++) {
        velocities.add(new JointCoordinate(j, i));
      }
    }
  }

  /** Returns the mechanism with some forces of a kind. */
  public Mechanism with(Kind kind) {
    List<ForceElement> forces = IntStream.range(0, 3).mapToObj(i -> force(kind, "f" + i)).toList();
    return with(forces);
  }

  /** Returns the mechanism with one force of every kind. */
  public Mechanism withAll() {
    List<ForceElement> forces = new ArrayList<>();
    for (Kind kind : Kind.values()) {
      forces.add(force(kind, kind.name()));
    }
    return with(forces);
  }

  public Mechanism with(List<ForceElement> forces) {
    return new Mechanism(
            mechanism.name(),
            mechanism.root(),
            mechanism.gravity(),
            mechanism.bodies(),
            mechanism.joints(),
            mechanism.motions(),
            mechanism.startRoles(),
            mechanism.closures(),
            forces,
            mechanism.parameters())
        .withArmatures(mechanism.armatures());
  }

  ForceElement force(Kind kind, String name) {
    return switch (kind) {
      case SPRING_BOTH -> spring(name, Side.BOTH);
      case SPRING_ABOVE -> spring(name, Side.ABOVE);
      case SPRING_BELOW -> spring(name, Side.BELOW);
      case JOINT_SPRING -> jointSpring(name, pick(positions), Side.BOTH);
      case JOINT_STOP ->
          jointSpring(name, pick(positions), random.nextBoolean() ? Side.ABOVE : Side.BELOW);
      case BUSHING_ENERGY -> bushing(name, Bushing.Law.ENERGY);
      case BUSHING_LINEAR -> bushing(name, Bushing.Law.LINEAR);
      case FORCE_TORQUE_WORLD -> wrench(name, ForceTorque.Axes.WORLD);
      case FORCE_TORQUE_BODY -> wrench(name, ForceTorque.Axes.BODY);
      case JOINT_FORCE -> new JointForce(name, pick(velocities), formula(3), Origin.NONE);
      case CONTACT_PLANE -> contact(name, Expression.ZERO, List.of(), 1.5);
      case CONTACT_PROFILE -> contact(name, hills(), List.of(), 1 + random.nextInt(2));
      case CONTACT_TRACKS -> contact(name, Expression.ZERO, tracks(), 1 + random.nextInt(2));
      case FRICTION -> friction(name, pick(velocities));
      case USER_WITH_DIFFERENCES -> user(name, "differences");
      case USER_WITH_DERIVATIVES -> user(name, "derivatives");
      case COUPLING_SPRING -> couplingSpring(name, new CoordinatePosition(pick(positions)));
      case PAIR_FORCE -> pairForce(name);
      case RELATIVE_WRENCH -> relativeWrench(name);
      case LAW -> law(name);
      case PATH -> path(name, false, false);
      case PATH_ON_A_SIDE -> path(name, true, false);
      case PATH_IN_A_RING -> path(name, false, true);
    };
  }

  /** A tension along a path around a sphere or a cylinder. */
  private PathForce path(String name, boolean onSide, boolean inRing) {
    Expressions e = new Expressions();
    List<Expression> leaves = new ArrayList<>();
    BodyPoint at = point();
    ScalarVector centre = place(e, at, leaves);
    List<ScalarVector> axes =
        List.of(
            direction(e, at, new Vector3(1, 0, 0), leaves),
            direction(e, at, new Vector3(0, 1, 0), leaves),
            direction(e, at, new Vector3(0, 0, 1), leaves));
    Wrap wrap =
        new Wrap(
            e,
            place(e, point(), leaves).minus(centre),
            place(e, point(), leaves).minus(centre),
            random.nextBoolean() ? Optional.of(axes.get(2)) : Optional.empty(),
            e.constant(0.3 + 0.2 * random.nextDouble()));
    BodyPoint side =
        new BodyPoint(at.body(), at.position().plus(new Vector3(1 + random.nextDouble(), 0.7, 0)));
    Wrap.Way way =
        inRing
            ? wrap.inside(axes, 0)
            : onSide ? wrap.beside(place(e, side, leaves).minus(centre)) : wrap.shortest();
    Expression tension =
        new Sum(
            new Product(number(), PathMotion.LENGTH),
            new Product(
                new Sum(number(), new Product(new Time(), PathMotion.LENGTH)), PathMotion.RATE));
    return new PathForce(
        name,
        new ScalarFormulas(leaves).of(way.length()),
        tension,
        List.of(),
        List.of(),
        Origin.NONE);
  }

  private static ScalarVector place(Expressions e, BodyPoint point, List<Expression> leaves) {
    List<Scalar> components = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      components.add(e.input(leaves.size()));
      leaves.add(new PointPosition(point, i));
    }
    return new ScalarVector(components.get(0), components.get(1), components.get(2));
  }

  private static ScalarVector direction(
      Expressions e, BodyPoint from, Vector3 vector, List<Expression> leaves) {
    BodyPoint tip = new BodyPoint(from.body(), from.position().plus(vector));
    return place(e, tip, leaves).minus(place(e, from, leaves));
  }

  public JointSpringDamper jointSpring(String name, Coordinate coordinate, Side side) {
    return new JointSpringDamper(
        name,
        coordinate,
        coefficient(side),
        coefficient(side),
        number(),
        side == Side.BOTH ? number() : Expression.ZERO,
        side,
        Expression.of(0.4),
        dissipation(side),
        Origin.NONE);
  }

  public JointFriction friction(String name, Coordinate coordinate) {
    return new JointFriction(
        name, coordinate, positive(), positive(), Expression.of(0.5), Origin.NONE);
  }

  public JointForce jointForce(String name, ClosureCoordinate coordinate) {
    return new JointForce(
        name,
        coordinate,
        new Sum(
            formula(2),
            new Product(new CoordinatePosition(coordinate), new CoordinateVelocity(coordinate))),
        Origin.NONE);
  }

  /** A spring along a product of a position with two coordinates of points and time. */
  public CouplingSpringDamper couplingSpring(String name, Expression position) {
    Side side = List.of(Side.values()).get(random.nextInt(3));
    Expression place =
        new Call(
            MathFunction.HYPOT,
            List.of(
                new Sum(number(), new PointPosition(point(), random.nextInt(3))),
                new PointPosition(point(), random.nextInt(3))));
    Expression along =
        new Sum(
            new Product(place, new Call(MathFunction.SIN, List.of(position))),
            new Product(new PointPosition(point(), random.nextInt(3)), new Time()));
    return new CouplingSpringDamper(
        name,
        along,
        false,
        coefficient(side),
        coefficient(side),
        number(),
        side == Side.BOTH ? number() : Expression.ZERO,
        side,
        Expression.of(0.4),
        dissipation(side),
        List.of(along),
        List.of(),
        Origin.NONE);
  }

  private SpringDamper spring(String name, Side side) {
    return new SpringDamper(
        name,
        point(),
        point(),
        coefficient(side),
        coefficient(side),
        positive(),
        side == Side.BOTH ? number() : Expression.ZERO,
        side,
        Expression.of(0.3),
        dissipation(side),
        Origin.NONE);
  }

  /** A coefficient of a spring; one that acts on one side has no negative ones. */
  private Expression coefficient(Side side) {
    Expression any = number();
    return side == Side.BOTH ? any : Expression.of(Math.abs(((Expression.Constant) any).value()));
  }

  private Expression dissipation(Side side) {
    return side == Side.BOTH ? Expression.ZERO : Expression.of(random.nextDouble());
  }

  private Bushing bushing(String name, Bushing.Law law) {
    return new Bushing(
        name, frame(), frame(), numbers(36), numbers(36), numbers(6), law, Origin.NONE);
  }

  private ForceTorque wrench(String name, ForceTorque.Axes axes) {
    List<Expression> six = IntStream.range(0, 6).mapToObj(i -> formula(2)).toList();
    return new ForceTorque(name, point(), axes, six, Origin.NONE);
  }

  /** Hills that bend less than spheres of the size of the mechanism. */
  private static Expression hills() {
    Call wave = new Call(MathFunction.SIN, List.of(new Argument()));
    return new Product(Expression.of(0.1), wave);
  }

  /** Two curves that the centre of a sphere may touch at once. */
  private static List<Expression> tracks() {
    Expression incline = new Product(Expression.of(0.3), new Argument());
    return List.of(hills(), new Sum(Expression.of(0.1), incline));
  }

  private Contact contact(
      String name, Expression height, List<Expression> tracks, double exponent) {
    return new Contact(
        name,
        point(),
        Expression.of(0.3),
        frame(),
        height,
        tracks,
        positive(),
        positive(),
        Expression.of(random.nextDouble()),
        Expression.of(exponent),
        Expression.of(0.5),
        Expression.of(0.7),
        Expression.of(0.6),
        Origin.NONE);
  }

  /**
   * A force that depends on all components of a relative motion, with an energy of the distance.
   */
  private PairForce pairForce(String name) {
    List<Expression> motion = relativeMotion();
    Expression square = Expression.ZERO;
    Expression along = Expression.ZERO;
    for (int i = 0; i < 3; i++) {
      square = new Sum(square, new Product(motion.get(i), motion.get(i)));
      Expression rate = motion.get(RelativeMotion.RATE + i);
      along = new Sum(along, new Product(Expression.of(2), new Product(motion.get(i), rate)));
    }
    List<Expression> wrench =
        IntStream.range(0, 6)
            .mapToObj(i -> new Call(MathFunction.SIN, List.of(mixture(motion))))
            .map(Expression.class::cast)
            .toList();
    return new PairForce(
        name,
        "pair",
        ((RelativeMotion) motion.get(0)).frame1(),
        ((RelativeMotion) motion.get(0)).frame2(),
        wrench,
        new Call(MathFunction.SIN, List.of(square)),
        new Product(new Call(MathFunction.COS, List.of(square)), along),
        List.of(
            new PairForce.Value("square", "m²", square), new PairForce.Value("load", "N", square)),
        Expression.ZERO,
        PairForce.Shape.POINT,
        Origin.NONE);
  }

  /** A force that is a law with numbers. */
  private LawForce law(String name) {
    List<PairLaw> laws = Stream.of(PairLaw.values()).filter(law -> law.row().isPresent()).toList();
    PairLaw law = laws.get(random.nextInt(laws.size()));
    List<Expression> numbers =
        law.row().orElseThrow().attributes().stream()
            .map(number -> number.condition() == Condition.FINITE ? number() : positive())
            .toList();
    return new LawForce(name, law, frame(), frame(), numbers, Origin.NONE);
  }

  private ForceTorque relativeWrench(String name) {
    List<Expression> motion = relativeMotion();
    List<Expression> six =
        IntStream.range(0, 6).mapToObj(i -> mixture(motion)).map(Expression.class::cast).toList();
    return new ForceTorque(name, point(), ForceTorque.Axes.WORLD, six, Origin.NONE);
  }

  private List<Expression> relativeMotion() {
    BodyFrame frame1 = frame();
    BodyFrame frame2 = frame();
    return IntStream.range(0, RelativeMotion.COUNT)
        .mapToObj(i -> new RelativeMotion(frame1, frame2, i))
        .map(Expression.class::cast)
        .toList();
  }

  private Expression mixture(List<Expression> parts) {
    Expression sum = number();
    for (Expression part : parts) {
      sum = new Sum(sum, new Product(new Product(Expression.of(0.3), number()), part));
    }
    return sum;
  }

  private UserForceElement user(String name, String className) {
    List<NamedPoint> points =
        List.of(
            new NamedPoint("A", "p", point()),
            new NamedPoint("B", "p", point()),
            new NamedPoint("C", "p", point()));
    JointCoordinate coordinate = pick(velocities);
    String joint = mechanism.joints().get(coordinate.joint()).name();
    String withJoint = className + " " + joint + " " + coordinate.component();
    return new UserForceElement(name, withJoint, points, Origin.NONE);
  }

  /** A smooth function of everything an expression may contain. */
  private Expression formula(int depth) {
    if (depth == 0) {
      return leaf();
    }
    Expression a = formula(depth - 1);
    Expression b = formula(depth - 1);
    return switch (random.nextInt(3)) {
      case 0 -> new Sum(a, b);
      case 1 -> new Product(new Call(MathFunction.ATAN, List.of(a)), b);
      default -> new Call(MathFunction.SIN, List.of(new Sum(a, b)));
    };
  }

  private Expression leaf() {
    return switch (random.nextInt(6)) {
      case 0 -> new Time();
      case 1 -> new CoordinatePosition(pick(allPositions));
      case 2 -> new CoordinateVelocity(pick(velocities));
      case 3 -> new PointPosition(point(), random.nextInt(3));
      case 4 -> new PointVelocity(point(), random.nextInt(3));
      default -> number();
    };
  }

  private <T> T pick(List<T> all) {
    return all.get(random.nextInt(all.size()));
  }

  private BodyPoint point() {
    return new BodyPoint(body(), vector());
  }

  private BodyFrame frame() {
    return new BodyFrame(body(), vector(), Rotation.about(vector().normalized(), 1));
  }

  private int body() {
    return random.nextInt(-1, mechanism.bodies().size());
  }

  private Vector3 vector() {
    return new Vector3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
  }

  private List<Expression> numbers(int count) {
    return IntStream.range(0, count).mapToObj(i -> number()).toList();
  }

  private Expression number() {
    return Expression.of(4 * random.nextDouble() - 2);
  }

  private Expression positive() {
    return Expression.of(0.5 + 2 * random.nextDouble());
  }
}

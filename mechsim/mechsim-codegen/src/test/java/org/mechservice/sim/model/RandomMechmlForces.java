package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.expression.Table;
import org.mechservice.solver.force.law.Condition;
import org.mechservice.solver.force.law.ForceRow;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.Side;
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
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** Random forces of every kind on a given tree. */
public final class RandomMechmlForces {
  private static final List<Side> SIDES = List.of(Side.values());

  private final Random random;
  private final Mechanism tree;
  private final List<ForceElement> forces = new ArrayList<>();

  private RandomMechmlForces(long seed, Mechanism tree) {
    this.random = new Random(seed);
    this.tree = tree;
  }

  /** Returns the tree with some forces of each kind. */
  public static Mechanism on(Mechanism tree, long seed) {
    return of(ForceElement.class, tree, seed);
  }

  /** Returns the tree with some forces of a kind. */
  public static Mechanism of(Class<? extends ForceElement> kind, Mechanism tree, long seed) {
    RandomMechmlForces forces = new RandomMechmlForces(seed, tree);
    for (int round = 0; round < 2; round++) {
      forces.addOneOfEach();
    }
    forces.addLaws();
    return new Mechanism(
            "forced" + seed,
            tree.root(),
            tree.gravity(),
            tree.bodies(),
            tree.joints(),
            tree.motions(),
            tree.startRoles(),
            List.of(),
            forces.forces.stream().filter(kind::isInstance).toList(),
            List.of())
        .withArmatures(tree.armatures());
  }

  private void addOneOfEach() {
    Side side = SIDES.get(random.nextInt(3));
    Expression preload = side == Side.BOTH ? number(5) : Expression.ZERO;
    Expression eps = random.nextBoolean() ? Expression.ZERO : positive(0.1);
    Expression chi = side == Side.BOTH ? Expression.ZERO : Expression.of(0.5);
    forces.add(
        new SpringDamper(
            name(),
            point(),
            point(),
            positive(100),
            positive(3),
            positive(0.5),
            preload,
            side,
            eps,
            chi,
            Origin.NONE));
    forces.add(bushing());
    coordinates(true).forEach(c -> forces.add(coupled(c, preload, side, eps)));
    forces.add(contact());
    forces.add(
        new ForceTorque(
            name(),
            point(),
            random.nextBoolean() ? ForceTorque.Axes.WORLD : ForceTorque.Axes.BODY,
            List.of(formula(), number(2), formula(), number(1), formula(), Expression.ZERO),
            Origin.NONE));
    coordinates(true)
        .forEach(
            c ->
                forces.add(
                    new JointSpringDamper(
                        name(),
                        c,
                        positive(20),
                        positive(2),
                        number(0.3),
                        preload,
                        side,
                        eps,
                        chi,
                        Origin.NONE)));
    coordinates(false)
        .forEach(
            c -> {
              forces.add(
                  new JointFriction(
                      name(), c, positive(2), positive(1), positive(0.1), Origin.NONE));
              forces.add(new JointForce(name(), c, formula(), Origin.NONE));
            });
    forces.add(pairForce());
  }

  /** Adds the laws with numbers, behind the others, whose draws they leave alone. */
  private void addLaws() {
    for (PairLaw law : PairLaw.values()) {
      law.row().ifPresent(row -> forces.add(law(law, row)));
    }
  }

  /** A force that is a law with numbers. */
  private ForceElement law(PairLaw law, ForceRow row) {
    List<Expression> numbers =
        row.attributes().stream()
            .map(number -> number.condition() == Condition.FINITE ? number(5) : positive(1))
            .toList();
    return new LawForce(name(), law, frame(), frame(), numbers, Origin.NONE);
  }

  /** A spring along a coordinate, the distance of a point from an axis and time. */
  private ForceElement coupled(JointCoordinate c, Expression preload, Side side, Expression eps) {
    Expression distance =
        new Expression.Call(
            MathFunction.HYPOT,
            List.of(
                new Expression.Sum(positive(1), new Expression.PointPosition(point(), 0)),
                new Expression.PointPosition(point(), 2)));
    Expression turn = new Expression.Product(number(1), new Expression.CoordinatePosition(c));
    Expression along =
        new Expression.Sum(
            new Expression.Sum(distance, turn), new Expression.Product(number(1), new Time()));
    return new CouplingSpringDamper(
        name(),
        along,
        random.nextBoolean(),
        positive(20),
        positive(2),
        positive(1),
        preload,
        side,
        eps,
        List.of(),
        Origin.NONE);
  }

  /** Returns one coordinate of a random joint that has any: a position, or a velocity. */
  private List<JointCoordinate> coordinates(boolean position) {
    for (int tries = 0; tries < 20; tries++) {
      int joint = random.nextInt(tree.joints().size());
      JointType type = tree.joints().get(joint).type();
      int euler = position && type.hasEulerParameters() ? 4 : 0;
      int count = (position ? type.positionCount() : type.velocityCount()) - euler;
      if (count > 0) {
        return List.of(new JointCoordinate(joint, euler + random.nextInt(count)));
      }
    }
    return List.of();
  }

  private ForceElement bushing() {
    List<Expression> stiffness = new ArrayList<>();
    List<Expression> damping = new ArrayList<>();
    List<Expression> preload = new ArrayList<>();
    for (int i = 0; i < 36; i++) {
      stiffness.add(i % 7 == 0 ? positive(50) : random.nextBoolean() ? number(5) : Expression.ZERO);
      damping.add(i % 7 == 0 ? positive(2) : Expression.ZERO);
    }
    for (int i = 0; i < 6; i++) {
      preload.add(number(3));
    }
    Bushing.Law law = random.nextBoolean() ? Bushing.Law.ENERGY : Bushing.Law.LINEAR;
    return new Bushing(name(), frame(), frame(), stiffness, damping, preload, law, Origin.NONE);
  }

  private Expression surface(Expression bump) {
    Table table =
        new Table(
            "surface",
            List.of(-1.0, -0.4, -0.1, 0.3, 0.9),
            List.of(0.0, 0.15, -0.1, 0.2, 0.1),
            Table.Method.AKIMA,
            Table.Extrapolation.HOLD);
    return switch (random.nextInt(3)) {
      case 0 -> Expression.ZERO;
      case 1 -> bump;
      default -> new Expression.TableValue(table, List.of(new Expression.Argument()));
    };
  }

  private ForceElement contact() {
    Expression x = new Expression.Argument();
    Expression bump =
        new Expression.Product(
            positive(0.2),
            new Expression.Call(MathFunction.SIN, List.of(new Expression.Product(number(2), x))));
    return new Contact(
        name(),
        point(),
        positive(0.3),
        frame(),
        surface(bump),
        List.of(),
        positive(100),
        positive(3),
        Expression.of(0.5),
        Expression.of(random.nextBoolean() ? 1 : 1.5),
        positive(0.2),
        random.nextBoolean() ? Expression.ZERO : positive(0.5),
        positive(0.1),
        Origin.NONE);
  }

  /** A force that depends on all components of a relative motion, with shared parts. */
  private ForceElement pairForce() {
    BodyFrame frame1 = frame();
    BodyFrame frame2 = frame();
    Expression sum = number(1);
    for (int i = 0; i < Expression.RelativeMotion.COUNT; i++) {
      Expression part = new Expression.RelativeMotion(frame1, frame2, i);
      sum = new Expression.Sum(sum, new Expression.Product(number(0.5), part));
    }
    Expression shared = new Expression.Call(MathFunction.SIN, List.of(sum));
    List<Expression> wrench = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      shared = new Expression.Sum(shared, new Expression.Product(number(0.3), shared));
      wrench.add(shared);
    }
    return new PairForce(
        name(),
        "pair",
        frame1,
        frame2,
        wrench,
        Expression.ZERO,
        Expression.ZERO,
        List.of(new PairForce.Value("size", "N", shared), new PairForce.Value("load", "N", shared)),
        Expression.ZERO,
        PairForce.Shape.POINT,
        Origin.NONE);
  }

  /** A formula of time, a coordinate, a point's place and a point's velocity. */
  private Expression formula() {
    Expression t = new Expression.Time();
    Expression place = new Expression.PointPosition(point(), random.nextInt(3));
    Expression speed = new Expression.PointVelocity(point(), random.nextInt(3));
    Expression sum = new Expression.Sum(new Expression.Product(number(1), place), speed);
    for (JointCoordinate c : coordinates(true)) {
      sum = new Expression.Sum(sum, new Expression.CoordinatePosition(c));
    }
    return new Expression.Sum(
        new Expression.Call(MathFunction.TANH, List.of(sum)),
        new Expression.Call(MathFunction.COS, List.of(new Expression.Product(t, number(3)))));
  }

  private String name() {
    return "f" + forces.size();
  }

  private BodyPoint point() {
    return new BodyPoint(random.nextInt(-1, tree.bodies().size()), vector().times(0.4));
  }

  private BodyFrame frame() {
    Rotation axes =
        random.nextInt(3) == 0
            ? Rotation.IDENTITY
            : Rotation.about(vector().normalized(), 2 * random.nextDouble());
    return new BodyFrame(random.nextInt(-1, tree.bodies().size()), vector().times(0.4), axes);
  }

  private Vector3 vector() {
    return new Vector3(
        2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 0.1 + random.nextDouble());
  }

  private Expression number(double size) {
    return Expression.of(size * (2 * random.nextDouble() - 1));
  }

  private Expression positive(double size) {
    return Expression.of(size * (0.2 + random.nextDouble()));
  }
}

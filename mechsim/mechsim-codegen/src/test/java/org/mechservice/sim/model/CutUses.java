package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/** Springs, friction, forces and relations that depend on every coordinate of every cut joint. */
public final class CutUses {
  private final Random random;
  private final List<ForceElement> forces;

  private CutUses(List<ForceElement> forces, long seed) {
    this.random = new Random(seed);
    this.forces = new ArrayList<>(forces);
  }

  /** Returns a mechanism with such forces, and every other one with a relation. */
  public static Mechanism in(Mechanism loops, long seed) {
    CutUses uses = new CutUses(loops.forces(), seed);
    List<Expression> free = new ArrayList<>();
    for (int c = 0; c < loops.closures().size(); c++) {
      if (loops.closures().get(c) instanceof JointClosure cut) {
        uses.addForces(c, cut.joint().type());
        if (!cut.isDriven() && !cut.joint().type().hasEulerParameters()) {
          free.addAll(positions(c, cut.joint().type()));
        }
      }
    }
    List<LoopClosure> closures = new ArrayList<>(loops.closures());
    if (!free.isEmpty() && seed % 2 == 0) {
      closures.add(uses.relation(free.get(0), free.get(free.size() - 1)));
    }
    return new Mechanism(
            loops.name(),
            loops.root(),
            loops.gravity(),
            loops.bodies(),
            loops.joints(),
            loops.motions(),
            loops.startRoles(),
            closures,
            uses.forces,
            loops.parameters())
        .withArmatures(loops.armatures());
  }

  private static int euler(JointType type) {
    return type.hasEulerParameters() ? 4 : 0;
  }

  private static List<Expression> positions(int closure, JointType type) {
    return IntStream.range(euler(type), type.positionCount())
        .mapToObj(i -> new ClosureCoordinate(closure, i))
        .<Expression>map(Expression.CoordinatePosition::new)
        .toList();
  }

  private void addForces(int closure, JointType type) {
    for (int i = euler(type); i < type.positionCount(); i++) {
      ClosureCoordinate position = new ClosureCoordinate(closure, i);
      forces.add(spring(position, Side.BOTH));
      forces.add(spring(position, Side.ABOVE));
    }
    Expression sum = Expression.of(number());
    for (Expression position : positions(closure, type)) {
      sum = new Expression.Sum(sum, new Expression.Product(position, position));
    }
    for (int i = 0; i < type.velocityCount(); i++) {
      ClosureCoordinate velocity = new ClosureCoordinate(closure, i);
      forces.add(
          new JointFriction(name(), velocity, positive(), positive(), positive(), Origin.NONE));
      sum = new Expression.Sum(sum, new Expression.CoordinateVelocity(velocity));
      forces.add(new JointForce(name(), velocity, bounded(sum), Origin.NONE));
    }
    Expression zero = Expression.ZERO;
    forces.add(
        new ForceTorque(
            name(),
            new BodyPoint(0, new Vector3(0.1, 0.2, 0.3)),
            ForceTorque.Axes.WORLD,
            List.of(bounded(sum), zero, zero, zero, bounded(sum), zero),
            Origin.NONE));
  }

  private ForceElement spring(ClosureCoordinate position, Side side) {
    return new JointSpringDamper(
        name(),
        position,
        positive(),
        positive(),
        Expression.of(number()),
        Expression.ZERO,
        side,
        Expression.of(0.4),
        Origin.NONE);
  }

  /** 2 a + sin(a) b, of coordinates a and b of cut joints, which are zero at the start. */
  private LoopClosure relation(Expression a, Expression b) {
    Expression sine = new Expression.Call(MathFunction.SIN, List.of(a));
    Expression relation =
        new Expression.Sum(
            new Expression.Product(Expression.of(2 + number()), a),
            new Expression.Product(sine, b));
    return new CoordinateClosure("related", relation, Origin.NONE);
  }

  private static Expression bounded(Expression sum) {
    return new Expression.Call(MathFunction.TANH, List.of(sum));
  }

  private String name() {
    return "u" + forces.size();
  }

  private double number() {
    return 2 * random.nextDouble() - 1;
  }

  private Expression positive() {
    return Expression.of(0.5 + random.nextDouble());
  }
}

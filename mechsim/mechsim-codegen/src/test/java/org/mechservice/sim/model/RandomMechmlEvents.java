package org.mechservice.sim.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.mechservice.mechml.AbsoluteTolerances;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.mechanism.StateChange;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/**
 * Events and outputs of a mechanism that depend on time, every coordinate of every joint, places
 * and velocities of points; events set the states of every joint that has some.
 */
public final class RandomMechmlEvents {
  private final Random random;
  private final Mechanism mechanism;
  private final List<Expression> leaves = new ArrayList<>();

  private RandomMechmlEvents(Mechanism mechanism, long seed) {
    this.mechanism = mechanism;
    random = new Random(seed);
    leaves.add(new Expression.Time());
    for (int j = 0; j < mechanism.joints().size(); j++) {
      JointType type = mechanism.joints().get(j).type();
      for (int i = 0; i < type.positionCount(); i++) {
        leaves.add(new Expression.CoordinatePosition(new JointCoordinate(j, i)));
      }
      for (int i = 0; i < type.velocityCount(); i++) {
        leaves.add(new Expression.CoordinateVelocity(new JointCoordinate(j, i)));
      }
    }
    for (int body = BodyPoint.ROOT; body < mechanism.bodies().size(); body++) {
      BodyPoint point = new BodyPoint(body, new Vector3(0.1, -0.2, 0.3));
      for (int axis = 0; axis < 3; axis++) {
        leaves.add(new Expression.PointPosition(point, axis));
        leaves.add(new Expression.PointVelocity(point, axis));
      }
    }
  }

  /** Returns the model of a mechanism with events and outputs. */
  public static MechmlModel on(Mechanism mechanism, long seed) {
    RandomMechmlEvents all = new RandomMechmlEvents(mechanism, seed);
    SimulationSettings settings = all.settings();
    return new MechmlModel(
        mechanism, settings, List.of(settings), List.of(), all.outputs(), List.of(), List.of());
  }

  private SimulationSettings settings() {
    return new SimulationSettings(
        "",
        new SimulationTask.Dynamic(),
        Scenes.SETTINGS,
        AbsoluteTolerances.uniform(Scenes.SETTINGS.absoluteTolerance()),
        "auto",
        "auto",
        List.of(),
        events());
  }

  private List<Event> events() {
    List<Event> events = new ArrayList<>();
    for (int i = 0; i < leaves.size(); i++) {
      ModelEvents.Direction both = ModelEvents.Direction.BOTH;
      boolean sets = i == 0;
      events.add(
          new Event(
              "e" + i,
              formula(leaves.get(i)),
              both,
              sets ? ModelEvents.Action.SET : ModelEvents.Action.RECORD,
              sets ? changes() : List.of(),
              Origin.NONE));
    }
    return events;
  }

  private List<StateChange> changes() {
    List<StateChange> changes = new ArrayList<>();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      if (!mechanism.isDriven(j) && joint.type() != JointType.W) {
        changes.add(
            new StateChange(
                j, some(joint.type().positionCount()), some(joint.type().velocityCount())));
      }
    }
    return changes;
  }

  private List<Expression> some(int count) {
    List<Expression> some = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      some.add(formula(leaves.get(random.nextInt(leaves.size()))));
    }
    return some;
  }

  private List<Output> outputs() {
    List<Output> outputs = new ArrayList<>();
    for (int i = 0; i < leaves.size(); i++) {
      outputs.add(new Output("o" + i, formula(leaves.get(i)), "1", Origin.NONE));
    }
    return outputs;
  }

  /** a x + tanh(x y). */
  private Expression formula(Expression x) {
    Expression y = leaves.get(random.nextInt(leaves.size()));
    Expression a = Expression.of(2 * random.nextDouble() - 1);
    Expression product = new Expression.Product(x, y);
    return new Expression.Sum(
        new Expression.Product(a, x), new Expression.Call(MathFunction.TANH, List.of(product)));
  }
}

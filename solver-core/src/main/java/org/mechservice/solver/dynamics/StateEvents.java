package org.mechservice.solver.dynamics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.ModelEvents;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.ExpressionInputs;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.MotionJump;
import org.mechservice.solver.mechanism.StateChange;
import org.mechservice.solver.spatial.EulerParameters;

/** The events of a mechanism, evaluated in its motion, whatever the formulation. */
public final class StateEvents implements ModelEvents {
  private static final int EULER_PARAMETERS = 4;

  private final Mechanism mechanism;
  private final List<Kind> kinds;
  private final TreeMotion motion;
  private final ExpressionInputs triggers;
  private final List<Assignment> assignments = new ArrayList<>();
  private final ExpressionInputs values;
  private final int ownCount;
  private Optional<DrivenJumps> driven = Optional.empty();

  /**
   * Prepares the events of a mechanism.
   *
   * @throws IllegalArgumentException if an expression refers to what the mechanism does not have
   */
  public StateEvents(Mechanism mechanism) {
    this.mechanism = mechanism;
    List<Event> events = mechanism.events();
    kinds = events.stream().map(e -> new Kind(e.name(), e.direction(), e.action())).toList();
    motion = new TreeMotion(new TreeGeometry(mechanism));
    triggers = new ExpressionInputs(motion, events.stream().map(Event::trigger).toList());
    for (int i = 0; i < events.size(); i++) {
      for (StateChange change : events.get(i).changes()) {
        int q = mechanism.positionOffset(change.joint());
        int v = mechanism.positionCount() + mechanism.velocityOffset(change.joint());
        assign(i, q, change.positions());
        assign(i, v, change.velocities());
      }
    }
    ownCount = events.size();
    values = new ExpressionInputs(motion, assignments.stream().map(Assignment::value).toList());
  }

  private void assign(int event, int at, List<Expression> expressions) {
    for (int k = 0; k < expressions.size(); k++) {
      assignments.add(new Assignment(event, at + k, expressions.get(k)));
    }
  }

  /** A component of the state that takes the value of an expression. */
  private record Assignment(int event, int component, Expression value) {}

  @Override
  public List<Kind> kinds() {
    List<Kind> all = new ArrayList<>(kinds);
    driven.ifPresent(jumps -> all.addAll(jumps.kinds()));
    return all;
  }

  @Override
  public void values(double t, double[] y, double[] g) {
    motion.sweep(t, y);
    triggers.evaluate(t);
    triggers.accepted();
    for (int i = 0; i < ownCount; i++) {
      g[i] = triggers.value(i);
    }
    if (driven.isPresent()) {
      driven.get().values(t, g, ownCount);
    }
  }

  @Override
  public void change(boolean[] occurred, double t, double[] y) {
    if (driven.isPresent()) {
      driven.get().change(occurred, ownCount, t, y);
    }
    motion.sweep(t, y);
    values.evaluate(t);
    values.accepted();
    for (int i = 0; i < assignments.size(); i++) {
      if (occurred[assignments.get(i).event()]) {
        y[assignments.get(i).component()] = values.value(i);
      }
    }
    normalize(y);
  }

  /** Gives Euler parameters norm one again; expressions need not. */
  private void normalize(double[] y) {
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      if (joint.type().hasEulerParameters() && !mechanism.isDriven(j)) {
        int at = mechanism.positionOffset(j);
        double norm = EulerParameters.norm(y, at);
        for (int k = at; k < at + EULER_PARAMETERS; k++) {
          y[k] /= norm;
        }
      }
    }
  }

  @Override
  public boolean changes(int event, int component) {
    return assignments.stream().anyMatch(a -> a.event() == event && a.component() == component);
  }

  @Override
  public double beside(double t) {
    return driven.isPresent() ? driven.get().beside(t) : t;
  }

  @Override
  public void goOn(double t) {
    driven.ifPresent(jumps -> jumps.goOn(t));
  }

  @Override
  public double after(boolean[] occurred, double t) {
    return driven.isPresent() ? driven.get().after(occurred, ownCount, t) : t;
  }

  @Override
  public List<Double> begin(double from, double to) {
    List<MotionJump> jumps = mechanism.motionJumps(from, to);
    driven = jumps.isEmpty() ? Optional.empty() : Optional.of(new DrivenJumps(motion, jumps));
    List<Double> times = new ArrayList<>();
    for (double time : mechanism.timeJumps(from, to)) {
      if (beside(time) == time) {
        times.add(time);
      }
    }
    jumps.forEach(jump -> times.add(jump.time()));
    return times;
  }
}

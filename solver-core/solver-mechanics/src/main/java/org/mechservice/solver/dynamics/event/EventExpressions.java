package org.mechservice.solver.dynamics.event;

import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.formula.ExpressionInputs;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * The expressions of events, evaluated in the motion of the mechanism. Outputs are not evaluated.
 */
final class EventExpressions implements WrittenValues {
  private final TreeMotion motion;
  private final ExpressionInputs triggers;
  private final int triggerCount;
  private final ExpressionInputs assigned;
  private final int assignedCount;
  private final ExpressionInputs watched;
  private final int watchedCount;

  EventExpressions(
      TreeMotion motion,
      List<Expression> triggers,
      List<Expression> assigned,
      List<Expression> watched) {
    this.motion = motion;
    this.triggers = new ExpressionInputs(motion, triggers);
    triggerCount = triggers.size();
    this.assigned = new ExpressionInputs(motion, assigned);
    assignedCount = assigned.size();
    this.watched = new ExpressionInputs(motion, watched);
    watchedCount = watched.size();
  }

  @Override
  public void triggers(double t, double[] y, double[] values) {
    evaluate(triggers, triggerCount, t, y, values);
  }

  @Override
  public void assignments(double t, double[] y, double[] values) {
    evaluate(assigned, assignedCount, t, y, values);
  }

  @Override
  public void watched(double t, double[] y, double[] values) {
    evaluate(watched, watchedCount, t, y, values);
  }

  @Override
  public void outputs(double t, double[] y, double[] values) {}

  private void evaluate(
      ExpressionInputs expressions, int count, double t, double[] y, double[] values) {
    motion.sweep(t, y);
    expressions.evaluate(t);
    expressions.accepted();
    for (int i = 0; i < count; i++) {
      values[i] = expressions.value(i);
    }
  }
}

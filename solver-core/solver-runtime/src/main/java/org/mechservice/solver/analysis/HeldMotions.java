package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/** A mechanism whose prescribed motions are held constant, for statics. */
final class HeldMotions {
  private HeldMotions() {}

  /** Returns the mechanism with its motions held at their values of a given time. */
  static Mechanism at(Mechanism mechanism, double t) {
    List<PrescribedMotion> motions = new ArrayList<>();
    for (PrescribedMotion motion : mechanism.motions()) {
      motions.add(new PrescribedMotion(motion.joint(), held(motion.coordinates(), mechanism, t)));
    }
    List<LoopClosure> closures = new ArrayList<>();
    for (LoopClosure closure : mechanism.closures()) {
      closures.add(
          closure instanceof JointClosure cut && cut.isDriven()
              ? new JointClosure(cut.joint(), cut.startRole(), held(cut.motion(), mechanism, t))
              : closure);
    }
    Mechanism held =
        new Mechanism(
            mechanism.name(),
            mechanism.root(),
            mechanism.gravity(),
            mechanism.bodies(),
            mechanism.joints(),
            motions,
            mechanism.startRoles(),
            closures,
            mechanism.forces(),
            mechanism.parameters());
    return held.withFurtherStates(mechanism.furtherStates()).withArmatures(mechanism.armatures());
  }

  private static List<Expression> held(List<Expression> motion, Mechanism mechanism, double t) {
    FormulaEvaluation evaluation = new FormulaEvaluation(motion);
    List<Expression> leaves = evaluation.leaves();
    for (int i = 0; i < leaves.size(); i++) {
      evaluation.setLeaf(
          i,
          leaves.get(i) instanceof Expression.ParameterValue parameter
              ? mechanism.parameters().get(parameter.index()).value()
              : t);
    }
    evaluation.values();
    List<Expression> held = new ArrayList<>();
    for (int i = 0; i < motion.size(); i++) {
      held.add(Expression.of(evaluation.value(i)));
    }
    return held;
  }
}

package org.mechservice.solver.kinematics;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.expression.TapeEvaluation;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;

/** The coordinates of driven joints as functions of time. Workspace of one thread. */
final class PrescribedCoordinates {
  private final TapeEvaluation evaluation;
  private final int[] timeLeaves;
  private final int[] parameterLeaves;
  private final int[] parameterIndex;
  private final int positionStart;
  private final int velocityStart;
  private final int count;

  /**
   * @throws IllegalArgumentException if a motion depends on anything but time and parameters
   */
  PrescribedCoordinates(TreeGeometry tree) {
    Mechanism mechanism = tree.mechanism();
    evaluation = new TapeEvaluation(new Tape(inJointOrder(mechanism)));
    positionStart = tree.statePositionCount;
    velocityStart = tree.stateVelocityCount;
    count = tree.velocityCount - velocityStart;
    List<Integer> times = new ArrayList<>();
    List<Integer> parameters = new ArrayList<>();
    List<Integer> indices = new ArrayList<>();
    List<Expression> leaves = evaluation.tape().leaves();
    for (int leaf = 0; leaf < leaves.size(); leaf++) {
      if (leaves.get(leaf) instanceof Expression.Time) {
        times.add(leaf);
      } else if (leaves.get(leaf) instanceof Expression.ParameterValue parameter) {
        parameters.add(leaf);
        indices.add(parameter.index());
        evaluation.setLeaf(leaf, mechanism.parameters().get(parameter.index()).value());
      } else {
        throw new IllegalArgumentException(
            "a prescribed motion depends on " + leaves.get(leaf) + "; it may depend on time alone");
      }
    }
    timeLeaves = times.stream().mapToInt(Integer::intValue).toArray();
    parameterLeaves = parameters.stream().mapToInt(Integer::intValue).toArray();
    parameterIndex = indices.stream().mapToInt(Integer::intValue).toArray();
  }

  /** Returns the expressions in the order of the extended coordinates. */
  private static List<Expression> inJointOrder(Mechanism mechanism) {
    List<Expression> ordered = new ArrayList<>();
    mechanism.motions().stream()
        .sorted((a, b) -> Integer.compare(a.joint(), b.joint()))
        .map(PrescribedMotion::coordinates)
        .forEach(ordered::addAll);
    return ordered;
  }

  /** Sets the values of the parameters. */
  void setParameters(double[] parameters) {
    for (int i = 0; i < parameterLeaves.length; i++) {
      evaluation.setLeaf(parameterLeaves[i], parameters[parameterIndex[i]]);
    }
  }

  /** Writes the driven part of extended positions, velocities and accelerations. */
  void evaluate(double t, double[] q, double[] v, double[] a) {
    if (count == 0) {
      return;
    }
    for (int leaf : timeLeaves) {
      evaluation.setLeaf(leaf, t, 1, 0);
    }
    evaluation.derivatives();
    evaluation.rates();
    for (int i = 0; i < count; i++) {
      q[positionStart + i] = evaluation.value(i);
      v[velocityStart + i] = evaluation.rate(i);
      a[velocityStart + i] = evaluation.secondRate(i);
    }
  }
}

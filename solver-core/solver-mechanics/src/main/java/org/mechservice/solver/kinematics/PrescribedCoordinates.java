package org.mechservice.solver.kinematics;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;

/**
 * The coordinates of driven joints as functions of time. Workspace of one thread.
 *
 * <p>A ball follows a path of unit quaternions e: its angular velocity is ω = 2 E(e) e′, in the
 * axes of the file's body 1, and ω′ = 2 E(e) e″, since E(e′) e′ = 0.
 */
final class PrescribedCoordinates {
  private final FormulaEvaluation evaluation;
  private final int[] timeLeaves;
  private final int[] parameterLeaves;
  private final int[] parameterIndex;
  private final int positionStart;
  private final int velocityStart;

  /** Whether each driven joint, in file order, begins with Euler parameters. */
  private final boolean[] isBall;

  /** Number of coordinates of each driven joint that are no Euler parameters. */
  private final int[] plain;

  /**
   * @throws IllegalArgumentException if a motion depends on anything but time and parameters
   */
  PrescribedCoordinates(TreeGeometry tree) {
    Mechanism mechanism = tree.mechanism();
    evaluation =
        new FormulaEvaluation(
            inJointOrder(mechanism).flatMap(m -> m.coordinates().stream()).toList());
    positionStart = tree.statePositionCount;
    velocityStart = tree.stateVelocityCount;
    List<JointType> types =
        inJointOrder(mechanism)
            .map(motion -> mechanism.joints().get(motion.joint()).type())
            .toList();
    isBall = new boolean[types.size()];
    plain = new int[types.size()];
    for (int i = 0; i < plain.length; i++) {
      isBall[i] = types.get(i).hasEulerParameters();
      plain[i] = types.get(i).positionCount() - (isBall[i] ? 4 : 0);
    }
    List<Integer> times = new ArrayList<>();
    List<Integer> parameters = new ArrayList<>();
    List<Integer> indices = new ArrayList<>();
    List<Expression> leaves = evaluation.leaves();
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

  /** Returns the motions in the order of the extended coordinates. */
  private static Stream<PrescribedMotion> inJointOrder(Mechanism mechanism) {
    return mechanism.motions().stream().sorted((a, b) -> Integer.compare(a.joint(), b.joint()));
  }

  /** Sets the values of the parameters. */
  void setParameters(double[] parameters) {
    for (int i = 0; i < parameterLeaves.length; i++) {
      evaluation.setLeaf(parameterLeaves[i], parameters[parameterIndex[i]]);
    }
  }

  /** Writes the driven part of extended positions, velocities and accelerations. */
  void evaluate(double t, double[] q, double[] v, double[] a) {
    for (int leaf : timeLeaves) {
      evaluation.setLeaf(leaf, t, 1, 0);
    }
    evaluation.derivatives();
    evaluation.rates();
    int next = 0;
    int at = velocityStart;
    for (int joint = 0; joint < plain.length; joint++) {
      if (isBall[joint]) {
        turn(next, q, v, a, at);
        next += 4;
        at += 3;
      }
      for (int i = 0; i < plain[joint]; i++) {
        q[positionStart + next] = evaluation.value(next);
        v[at] = evaluation.rate(next);
        a[at] = evaluation.secondRate(next);
        next++;
        at++;
      }
    }
  }

  /** Writes a ball whose Euler parameters are four results from {@code first}. */
  private void turn(int first, double[] q, double[] v, double[] a, int at) {
    double e0 = evaluation.value(first);
    double e1 = evaluation.value(first + 1);
    double e2 = evaluation.value(first + 2);
    double e3 = evaluation.value(first + 3);
    q[positionStart + first] = e0;
    q[positionStart + first + 1] = e1;
    q[positionStart + first + 2] = e2;
    q[positionStart + first + 3] = e3;
    for (int order = 1; order <= 2; order++) {
      double d0 = rate(first, order);
      double d1 = rate(first + 1, order);
      double d2 = rate(first + 2, order);
      double d3 = rate(first + 3, order);
      double[] out = order == 1 ? v : a;
      out[at] = 2 * (e0 * d1 - e1 * d0 + e2 * d3 - e3 * d2);
      out[at + 1] = 2 * (e0 * d2 - e2 * d0 + e3 * d1 - e1 * d3);
      out[at + 2] = 2 * (e0 * d3 - e3 * d0 + e1 * d2 - e2 * d1);
    }
  }

  private double rate(int result, int order) {
    return order == 1 ? evaluation.rate(result) : evaluation.secondRate(result);
  }
}

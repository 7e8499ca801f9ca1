package org.mechservice.solver.expression;

import java.util.Arrays;

/**
 * Runs a tape: values, gradients by the leaves, derivatives along a trajectory. Workspace of one
 * thread; nothing allocates after construction.
 *
 * <p>Set the leaves, call {@link #values()} or {@link #derivatives()}, then read the results. A
 * result may be not finite; {@link #firstNotFinite()} finds it.
 */
public final class TapeEvaluation {
  private final Tape tape;
  private final LocalDerivatives local;

  /** Value of each slot, and its first and second derivative along the trajectory. */
  private final double[] value;

  private final double[] rate;
  private final double[] secondRate;

  /** Partial derivatives of each step by its operands. */
  private final double[] byA;

  private final double[] byB;
  private final double[] byAA;
  private final double[] byAB;
  private final double[] byBB;

  /** Derivative of a result by each slot, and its change in a direction of the leaves. */
  private final double[] adjoint;

  private final double[] tangent;
  private final double[] adjointChange;

  /** Makes a workspace for a tape. */
  public TapeEvaluation(Tape tape) {
    this.tape = tape;
    local = new LocalDerivatives(tape);
    int slots = tape.initial.length;
    int steps = tape.target.length;
    value = tape.initial.clone();
    rate = new double[slots];
    secondRate = new double[slots];
    byA = new double[steps];
    byB = new double[steps];
    byAA = new double[steps];
    byAB = new double[steps];
    byBB = new double[steps];
    adjoint = new double[slots];
    tangent = new double[slots];
    adjointChange = new double[slots];
  }

  /** Returns the tape this runs. */
  public Tape tape() {
    return tape;
  }

  /**
   * Sets a leaf, in SI units.
   *
   * @param leaf index in {@link Tape#leaves()}
   */
  public void setLeaf(int leaf, double x) {
    value[tape.leafSlot[leaf]] = x;
  }

  /**
   * Sets a leaf and its derivatives along the trajectory.
   *
   * @param leaf index in {@link Tape#leaves()}
   * @param x value
   * @param first derivative by time
   * @param second second derivative by time; with the accelerations left out of it, {@link
   *     #secondRate} gives the velocity products alone
   */
  public void setLeaf(int leaf, double x, double first, double second) {
    int slot = tape.leafSlot[leaf];
    value[slot] = x;
    rate[slot] = first;
    secondRate[slot] = second;
  }

  /** Evaluates all results. */
  public void values() {
    tape.evaluate(value);
  }

  /**
   * Evaluates all results and the partial derivatives of all steps, which the methods below use.
   */
  public void derivatives() {
    for (int i = 0; i < tape.target.length; i++) {
      double a = value[tape.first[i]];
      double b = value[tape.second[i]];
      value[tape.target[i]] = tape.operation[i].value(a, b);
      tape.operation[i].differentiate(a, b, local);
      byA[i] = local.byA;
      byB[i] = local.byB;
      byAA[i] = local.byAA;
      byAB[i] = local.byAB;
      byBB[i] = local.byBB;
    }
  }

  /**
   * Evaluates first and second derivatives of all results along the trajectory, after {@link
   * #derivatives()}: f′ = f_a a′ + f_b b′ and its derivative.
   */
  public void rates() {
    for (int i = 0; i < tape.target.length; i++) {
      int a = tape.first[i];
      int b = tape.second[i];
      double first = product(byA[i], rate[a]) + product(byB[i], rate[b]);
      double second = product(byA[i], secondRate[a]) + product(byB[i], secondRate[b]);
      second += product(byAA[i], rate[a] * rate[a]);
      second += 2 * product(byAB[i], rate[a] * rate[b]);
      second += product(byBB[i], rate[b] * rate[b]);
      rate[tape.target[i]] = first;
      secondRate[tape.target[i]] = second;
    }
  }

  /**
   * Returns slope · change, and 0 if one of them is 0, even if the other is not finite: a constant
   * operand needs no slope, and an operand without influence, such as a branch not taken, needs no
   * change.
   */
  private static double product(double slope, double change) {
    return slope == 0 || change == 0 ? 0 : slope * change;
  }

  /** Returns a result. */
  public double value(int index) {
    return value[tape.result[index]];
  }

  /** Returns a result's derivative along the trajectory after {@link #rates()}. */
  public double rate(int index) {
    return rate[tape.result[index]];
  }

  /** Returns a result's second derivative along the trajectory after {@link #rates()}. */
  public double secondRate(int index) {
    return secondRate[tape.result[index]];
  }

  /**
   * Writes the gradient of a result by the leaves after {@link #derivatives()}.
   *
   * @param index the result
   * @param gradient one number per leaf; overwritten
   */
  public void gradient(int index, double[] gradient) {
    sweepBack(index);
    for (int leaf = 0; leaf < tape.leafSlot.length; leaf++) {
      gradient[leaf] = adjoint[tape.leafSlot[leaf]];
    }
  }

  private void sweepBack(int index) {
    Arrays.fill(adjoint, 0);
    adjoint[tape.result[index]] = 1;
    for (int i = tape.target.length - 1; i >= 0; i--) {
      double w = adjoint[tape.target[i]];
      if (w != 0) {
        adjoint[tape.first[i]] += product(byA[i], w);
        adjoint[tape.second[i]] += product(byB[i], w);
      }
    }
  }

  /**
   * Writes the change of a result's gradient along a direction of the leaves, H d with the Hessian
   * H, after {@link #derivatives()}.
   *
   * @param index the result
   * @param direction d, one number per leaf; not modified
   * @param change H d, one number per leaf; overwritten
   */
  public void gradientChange(int index, double[] direction, double[] change) {
    sweepBack(index);
    Arrays.fill(adjointChange, 0);
    sweepTangent(direction);
    for (int i = tape.target.length - 1; i >= 0; i--) {
      double w = adjoint[tape.target[i]];
      double wChange = adjointChange[tape.target[i]];
      double da = tangent[tape.first[i]];
      double db = tangent[tape.second[i]];
      double byAChange = product(byAA[i], da) + product(byAB[i], db);
      double byBChange = product(byAB[i], da) + product(byBB[i], db);
      adjointChange[tape.first[i]] += product(byA[i], wChange) + product(byAChange, w);
      adjointChange[tape.second[i]] += product(byB[i], wChange) + product(byBChange, w);
    }
    for (int leaf = 0; leaf < tape.leafSlot.length; leaf++) {
      change[leaf] = adjointChange[tape.leafSlot[leaf]];
    }
  }

  private void sweepTangent(double[] direction) {
    for (int leaf = 0; leaf < tape.leafSlot.length; leaf++) {
      tangent[tape.leafSlot[leaf]] = direction[leaf];
    }
    for (int i = 0; i < tape.target.length; i++) {
      tangent[tape.target[i]] =
          product(byA[i], tangent[tape.first[i]]) + product(byB[i], tangent[tape.second[i]]);
    }
  }

  /** Returns the first result whose value is not finite, or −1. */
  public int firstNotFinite() {
    for (int i = 0; i < tape.result.length; i++) {
      if (!Double.isFinite(value[tape.result[i]])) {
        return i;
      }
    }
    return -1;
  }
}

package org.mechservice.solver.integration;

import java.util.Arrays;
import org.mechservice.solver.linear.MatrixLayout;

/**
 * ∂f/∂y where it was evaluated last. It is kept from step to step, however old, until an iteration
 * fails and the Jacobian is not that of the present point.
 */
final class KeptJacobian {
  private final MatrixLayout layout;
  private final JacobianDifferences differences;

  /** The Jacobian in use and the one being formed, elements by layout. */
  private double[] values;

  private double[] forming;

  private boolean wanted = true;
  private boolean current;
  private int notFiniteComponent;
  private long evaluations;

  /**
   * @param threshold size below which a component is negligible; not modified
   * @param derivative0 f at the start; not modified
   */
  KeptJacobian(MatrixLayout layout, double[] threshold, double[] derivative0) {
    this.layout = layout;
    differences = new JacobianDifferences(layout, threshold);
    differences.knowDerivative(derivative0);
    values = new double[layout.length()];
    forming = new double[layout.length()];
  }

  /** Returns ∂f/∂y, elements by layout; not to be modified. */
  double[] values() {
    return values;
  }

  /** Returns whether a new one was asked for and is not yet there. */
  boolean wanted() {
    return wanted;
  }

  /** Returns whether it was evaluated, or could not be, where the step being tried starts. */
  boolean current() {
    return current;
  }

  /** Asks for a new one. */
  void want() {
    wanted = true;
  }

  /** Takes note that a step was accepted. */
  void moveOn() {
    current = false;
  }

  /**
   * Evaluates it at the start of the step. One that is not finite does not replace the one in use.
   */
  Attempt evaluate(RightHandSide equations, double t, double[] y) {
    Attempt attempt =
        equations.system() instanceof JacobianSystem known
            ? evaluateKnown(equations, known, t, y)
            : evaluateByDifferences(equations, t, y);
    if (attempt == Attempt.STOPPED) {
      return attempt;
    }
    wanted = false;
    current = true;
    evaluations++;
    if (attempt == Attempt.PASSED) {
      double[] freed = values;
      values = forming;
      forming = freed;
    }
    return attempt;
  }

  private Attempt evaluateKnown(
      RightHandSide equations, JacobianSystem system, double t, double[] y) {
    if (equations.stopped()) {
      return Attempt.STOPPED;
    }
    Arrays.fill(forming, 0);
    system.jacobian(t, y, forming);
    notFiniteComponent = rowNotFinite();
    return notFiniteComponent < 0 ? Attempt.PASSED : Attempt.NOT_FINITE;
  }

  private Attempt evaluateByDifferences(RightHandSide equations, double t, double[] y) {
    Attempt attempt = differences.evaluate(equations, t, y, forming);
    notFiniteComponent = differences.notFiniteComponent();
    return attempt;
  }

  private int rowNotFinite() {
    for (int j = 0; j < layout.dimension(); j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        if (!Double.isFinite(forming[layout.index(i, j)])) {
          return i;
        }
      }
    }
    return -1;
  }

  /** Returns the component of f whose derivatives were not finite. */
  int notFiniteComponent() {
    return notFiniteComponent;
  }

  long evaluations() {
    return evaluations;
  }

  /** Adds J x to a vector. */
  void addProduct(double[] x, double[] sum) {
    for (int j = 0; j < x.length; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i++) {
        sum[i] += values[layout.index(i, j)] * x[j];
      }
    }
  }
}

package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;

/**
 * Tells what is slight of what is left of the equations F = 0 of a step: small changes of the state
 * would solve it if nothing were stiff, as nothing is in a step that is short enough.
 *
 * <p>Without relations between states the factors of ∂F/∂y' tell, which are kept as long as the
 * derivatives. Otherwise, to find out takes factors of another matrix, and then again those of the
 * step's own. But what has to change grows in proportion to what is left, so one answer holds for
 * what is left later, by rows, until step, derivatives or tolerances change.
 */
final class NegligibleResidual {
  /** Part of the step in which nothing is stiff. */
  private static final double SHORT = 0x1p-40;

  /** Likewise; longer, for the difference of two changes that are alike. */
  private static final double SHORT_BESIDE_RELATIONS = 0x1p-30;

  /**
   * Share of what is known to be slight that is so whatever the signs are: with others, parts that
   * cancelled in the change may add up.
   */
  private static final double WHATEVER_SIGNS = 0.5;

  /** Growth of a weight that is none. */
  private static final double SAME_WEIGHT = 1.1;

  private final ResidualLinearisation linearisation;
  private final Manifold manifold;

  /** Changes that solve what is left, by a short step and by half of it, length n. */
  private final double[] change;

  private final double[] changeOfHalf;

  /** Magnitudes that a change of one unit of the tolerance solves, length n. */
  private final double[] unit;

  /** hγ of the steps and weights that they hold for, length n; 0 if nothing is known. */
  private double unitHGamma;

  private final double[] weight;

  NegligibleResidual(ResidualLinearisation linearisation, Manifold manifold) {
    this.linearisation = linearisation;
    this.manifold = manifold;
    int n = manifold.dimension();
    change = new double[n];
    changeOfHalf = new double[n];
    unit = new double[n];
    weight = new double[n];
  }

  /** Forgets what is known: the derivatives are others. */
  void forget() {
    unitHGamma = 0;
  }

  /**
   * Returns whether what is left is slight; true where that cannot be said. The factors stay those
   * of the step.
   *
   * @param left −F, or parts of its rows
   * @param small norm of a change that is small
   */
  boolean is(double[] left, double hGamma, ErrorNorm norm, double small) {
    if (!manifold.anyAlgebraic() && solveUnstiff(left, SHORT * hGamma)) {
      return norm.of(change) <= SHORT * small;
    }
    boolean known = hGamma == unitHGamma && weightsAsKnown(norm);
    if (known && covered(left, small)) {
      return true;
    }
    double size =
        manifold.anyAlgebraic()
            ? sizeBesideRelations(left, hGamma, norm)
            : size(left, hGamma, norm);
    linearisation.factor(hGamma);
    if (size > 0) {
      if (!known) {
        begin(hGamma, norm);
      }
      learn(left, size);
    }
    return size <= small;
  }

  /** Solves by the factors of ∂F/∂y'; returns false if there are none. */
  private boolean solveUnstiff(double[] left, double hGamma) {
    System.arraycopy(left, 0, change, 0, change.length);
    if (!linearisation.solveUnstiff(change)) {
      return false;
    }
    for (int l = 0; l < change.length; l++) {
      change[l] *= linearisation.algebraic(l) ? 1 : hGamma;
    }
    return true;
  }

  private boolean weightsAsKnown(ErrorNorm norm) {
    for (int l = 0; l < weight.length; l++) {
      if (norm.weight(l) > SAME_WEIGHT * weight[l]) {
        return false;
      }
    }
    return true;
  }

  private boolean covered(double[] left, double small) {
    double units = WHATEVER_SIGNS * small;
    for (int l = 0; l < unit.length; l++) {
      if (Math.abs(left[l]) > units * unit[l]) {
        return false;
      }
    }
    return true;
  }

  private void begin(double hGamma, ErrorNorm norm) {
    unitHGamma = hGamma;
    Arrays.fill(unit, 0);
    for (int l = 0; l < weight.length; l++) {
      weight[l] = norm.weight(l);
    }
  }

  private void learn(double[] left, double size) {
    for (int l = 0; l < unit.length; l++) {
      unit[l] = Math.max(unit[l], Math.abs(left[l]) / size);
    }
  }

  /** Returns the norm of the change if nothing were stiff; 0 where that cannot be said. */
  private double size(double[] left, double hGamma, ErrorNorm norm) {
    return solve(left, SHORT * hGamma, change) ? norm.of(change) / SHORT : 0;
  }

  /**
   * Returns the same beside relations between states, as the rates of loops are. These are mended
   * by one change however short the step: it is told from that of the step by what half the step
   * needs. The larger counts.
   */
  private double sizeBesideRelations(double[] left, double hGamma, ErrorNorm norm) {
    double step = SHORT_BESIDE_RELATIONS * hGamma;
    if (!solve(left, step, change) || !solve(left, step / 2, changeOfHalf)) {
      return 0;
    }
    for (int l = 0; l < change.length; l++) {
      double ofStep = 2 * (change[l] - changeOfHalf[l]);
      changeOfHalf[l] = change[l] - ofStep;
      change[l] = ofStep;
    }
    return Math.max(norm.of(change) / SHORT_BESIDE_RELATIONS, norm.of(changeOfHalf));
  }

  /** Returns whether the matrix of a step is regular; if so, solves with it for what is left. */
  private boolean solve(double[] left, double hGamma, double[] change) {
    if (!linearisation.factor(hGamma)) {
      return false;
    }
    System.arraycopy(left, 0, change, 0, change.length);
    linearisation.solve(hGamma, change);
    return true;
  }

  /** Carries what is known over. */
  void transfer(SavedState state) {
    unitHGamma = state.number(unitHGamma);
    state.numbers(unit);
    state.numbers(weight);
  }
}

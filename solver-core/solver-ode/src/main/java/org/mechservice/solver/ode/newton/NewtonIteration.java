package org.mechservice.solver.ode.newton;

import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;
import org.mechservice.solver.ode.backward.BackwardDifferences;
import org.mechservice.solver.ode.step.ErrorNorm;
import org.mechservice.solver.ode.step.Manifold;
import org.mechservice.solver.ode.step.RightHandSide;

/**
 * Simplified Newton iteration for the correction d of a step: the equations say what is left of
 * them at y* + d and, with the factors of their matrix, which change δ would mend it; d ← d + δ.
 * Passive components follow the others after each iteration.
 *
 * <p>With the rate ρ at which ‖δ‖ falls, the error left after an iteration is about ‖δ‖ ρ / (1 −
 * ρ). It is accepted below half the tolerance; after the first iteration, where only a rate of
 * earlier steps is known, below a twentieth, or what {@link IterationRules} say. A rate above 0.9,
 * or one too slow for four iterations, ends it. A rate is trusted only as long as the factors it
 * was measured with: kept longer it would let steps pass that have not converged. Shampine and
 * Reichelt 1997, §2.
 *
 * <p>All this believes in the matrix. Where its derivatives are much steeper than the equations are
 * now, behind a jump or outside of the narrow zone of a steep friction law, every δ is tiny, though
 * next to nothing of the equations is solved. So a first δ is taken for granted only if it is of
 * the size that the rate was measured for and the {@link ResidualMonitor} of the equations is
 * usual, or if they would be solved as well if nothing were stiff, or up to their rounding errors;
 * else the rate is measured, and a change before the last has to mend most of the equations.
 * Programs published do not look.
 */
final class NewtonIteration {
  private static final int ITERATIONS = 4;

  /** Error left, in units of the tolerance, that is accepted. */
  private static final double ACCURACY = 0.5;

  private static final double SLOWEST_RATE = 0.9;

  /**
   * Two changes in a row this small, in units of the tolerance and of negligible changes, that do
   * not fall any more are round-off of large terms in the equations, and no sign of divergence.
   */
  private static final double STANDSTILL = 0.01;

  private static final double NEGLIGIBLE_CHANGES = 100;

  /** Sizes of a first change over that for which the rate was measured that it is good for. */
  private static final double FAMILIAR_LARGER = 100;

  private static final double FAMILIAR_SMALLER = 1e-3;

  /** Share of the rate that is remembered from iteration to iteration. */
  private static final double MEMORY = 0.9;

  /** Part of the first change that may remain after one that takes it back. */
  private static final double TAKEN_BACK = 0.1;

  /** A change this small relative to y is round-off. */
  private static final double ROUNDOFF = 100 * Math.ulp(1.0);

  private final double[] change;

  private final ResidualMonitor remainder;
  private final IterationRules rules;

  /** Size of the change after which the rate was measured last. */
  private double measuredSize;

  private double rate;
  private boolean rateKnown;

  /** Number of steps in a row accepted without measuring the rate. */
  private int stepsByOldRate;

  private boolean begun;
  private int iteration;

  /** Norms of the last change and of the one before it. */
  private double size;

  private double lastSize;

  /** Rate seen in the present iteration; 0 before there is one. */
  private double seen;

  private double negligible;

  NewtonIteration(int dimension, IterationRules rules) {
    change = new double[dimension];
    remainder = new ResidualMonitor(dimension);
    this.rules = rules;
  }

  /** Expects no faster convergence than at a rate: the factors are those of a similar matrix. */
  void expectRate(double slowest) {
    rate = Math.max(rate, slowest);
  }

  /** Expects slower convergence by a factor; if that is not known, the rate is forgotten. */
  void expectGrowth(double factor) {
    rate *= factor;
    if (!(rate <= SLOWEST_RATE)) {
      rateKnown = false;
    }
  }

  /** Returns the rate seen in the last iteration; 0 if it took one change, or all but round-off. */
  double rateSeen() {
    return seen;
  }

  /** Returns how many changes the last iteration took. */
  int changes() {
    return iteration;
  }

  /** Returns the norm of the last change. */
  double size() {
    return size;
  }

  /** Forgets the rate: the matrix was factored anew. */
  void forgetRate() {
    rateKnown = false;
  }

  /** Returns whether an iteration is under way that was stopped. */
  boolean begun() {
    return begun;
  }

  /** Forgets an iteration that was stopped. */
  void abandon() {
    begun = false;
  }

  /** Begins at the prediction. */
  void begin(BackwardDifferences differences, ErrorNorm norm) {
    begun = true;
    iteration = 0;
    seen = 0;
    negligible = ROUNDOFF * norm.of(differences.predicted);
  }

  /** Iterates to the end, or until stopped; the next call then goes on. */
  TrialOutcome iterate(
      StepEquations equations,
      double t,
      double hGamma,
      BackwardDifferences differences,
      ErrorNorm norm) {
    if (iteration == 0 && !complete(equations, t, differences)) {
      return end(TrialOutcome.NOT_COMPLETED);
    }
    while (true) {
      if (!equations.evaluate(t, hGamma, differences, change)) {
        return TrialOutcome.STOPPED;
      }
      iteration++;
      remainder.keep(change, iteration == 1);
      equations.factors().solve(hGamma, change);
      differences.correct(change);
      lastSize = size;
      size = norm.of(change);
      if (!Double.isFinite(size) || !Double.isFinite(negligible)) {
        return end(TrialOutcome.NOT_FINITE);
      }
      if (!complete(equations, t, differences)) {
        return end(TrialOutcome.NOT_COMPLETED);
      }
      if (converged(equations, hGamma, differences, norm)) {
        return end(TrialOutcome.PASSED);
      }
      if (!takenBack(equations, differences, norm) && hopeless()) {
        return end(TrialOutcome.NOT_CONVERGING);
      }
    }
  }

  /** Makes the passive components fit the others; returns false if that is not possible. */
  private static boolean complete(
      StepEquations equations, double t, BackwardDifferences differences) {
    Manifold manifold = equations.manifold();
    if (!manifold.completes()) {
      return true;
    }
    boolean fits = manifold.complete(t, differences.corrected());
    differences.takeOverCorrected();
    return fits;
  }

  private TrialOutcome end(TrialOutcome attempt) {
    begun = false;
    return attempt;
  }

  private boolean converged(
      StepEquations equations, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    boolean small = size <= negligible;
    if (small && !rules.heedsRoundOff()) {
      return true;
    }
    boolean passes = iteration == 1 ? firstPasses(small) : laterPasses(small);
    if (!passes || !rules.heedsRoundOff()) {
      return passes;
    }
    return iteration == 1
        ? believed(equations, hGamma, differences, norm)
        : reduced(equations, hGamma, differences, norm);
  }

  private boolean believed(
      StepEquations equations, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    if (!familiar()) {
      return remainder.negligible(equations, hGamma, differences, norm, ACCURACY);
    }
    boolean usual = remainder.usual(equations, hGamma, norm, rate);
    if (usual) {
      remainder.believed();
    }
    return usual;
  }

  private boolean reduced(
      StepEquations equations, double hGamma, BackwardDifferences differences, ErrorNorm norm) {
    boolean reduced = remainder.reduced(equations, hGamma, differences, norm);
    if (reduced) {
      remainder.measured();
    }
    return reduced;
  }

  private boolean firstPasses(boolean small) {
    return small || convergedByOldRate();
  }

  private boolean laterPasses(boolean small) {
    seen = size / lastSize;
    if (diverges()) {
      return rules.heedsRoundOff() && (small || Math.max(size, lastSize) <= standstill());
    }
    learnRate();
    return small || errorLeft() <= ACCURACY;
  }

  /** Returns whether a first change is of a size that the rate was measured for. */
  private boolean familiar() {
    return rateKnown
        && size <= FAMILIAR_LARGER * measuredSize
        && size >= FAMILIAR_SMALLER * measuredSize;
  }

  private double standstill() {
    return Math.min(STANDSTILL, NEGLIGIBLE_CHANGES * negligible);
  }

  private boolean convergedByOldRate() {
    boolean converged =
        rateKnown
            && stepsByOldRate < rules.stepsByOldRate()
            && errorLeft() <= rules.accuracyByOldRate();
    stepsByOldRate += converged ? 1 : 0;
    return converged;
  }

  private void learnRate() {
    rate = Math.max(rateKnown ? MEMORY * rate : 0, size / lastSize);
    rateKnown = true;
    measuredSize = lastSize;
    stepsByOldRate = 0;
  }

  /**
   * Returns whether the second change takes back the first. Multipliers that were predicted far off
   * move the state at first, where the equations multiply them with it; they are right after that,
   * so the two changes say nothing about convergence.
   */
  private boolean takenBack(
      StepEquations equations, BackwardDifferences differences, ErrorNorm norm) {
    return iteration == 2
        && rules.heedsRoundOff()
        && equations.manifold().anyAlgebraic()
        && norm.of(differences.correction) <= TAKEN_BACK * size;
  }

  private boolean hopeless() {
    if (iteration == 1) {
      return false;
    }
    if (diverges() || iteration == ITERATIONS) {
      return true;
    }
    double predicted = errorLeft();
    for (int i = iteration; i < ITERATIONS; i++) {
      predicted *= rate;
    }
    return predicted > ACCURACY;
  }

  private boolean diverges() {
    return size > SLOWEST_RATE * lastSize;
  }

  private double errorLeft() {
    return size * rate / (1 - rate);
  }

  /** Returns the change δ of the last iteration; not to be modified. */
  double[] change() {
    return change;
  }

  /** Returns the first component of the evaluation, or else of δ, that was not finite. */
  int notFiniteComponent(StepEquations equations) {
    int component = equations.notFiniteInEvaluation();
    return component < 0 ? RightHandSide.firstNotFinite(change) : component;
  }

  /** Carries the rate of convergence known over. */
  void transfer(SavedState state) {
    rate = state.number(rate);
    rateKnown = state.flag(rateKnown);
    measuredSize = state.number(measuredSize);
    stepsByOldRate = state.integer(stepsByOldRate);
    remainder.transfer(state);
  }
}

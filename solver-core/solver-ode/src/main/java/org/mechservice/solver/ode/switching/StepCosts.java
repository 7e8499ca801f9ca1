package org.mechservice.solver.ode.switching;

import java.util.Optional;
import org.mechservice.solver.ode.BandedSystem;
import org.mechservice.solver.ode.BlockSystem;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SparseSystem;

/**
 * Cost of steps of an Adams method and of a backward formula: a model of the processor time and not
 * the time itself, for methods have to change at the same steps on every machine. Only ratios
 * count; the unit is about a nanosecond of the machine it was measured on.
 *
 * <p>Measured on mechanisms of 2 to 40 unknowns, runs of 0.1 to 10 ms, warm. Beside its evaluations
 * a step of ode113 takes 0.16, 0.27 and 0.50 µs with 4, 15 and 40 unknowns, one of ode15s 0.23, 0.7
 * and 1.8 µs, its solutions included; an evaluation by the cheapest generated code takes some 12 ns
 * an unknown. Evaluations are counted as dearer than that, since most right-hand sides are: a
 * change that they pay costs at most a fifth of the time where they are as cheap as that. So a step
 * of ode15s, with 1.3 evaluations, costs 0.8 times one of ode113 with 4 unknowns, 1.1 times with 20
 * and 1.2 times with 40.
 *
 * <p>The elimination of a {@link BandedSystem} takes 2 n l (l + u + 1) operations instead of about
 * n³/12, and its differences l + u + 1 evaluations instead of n.
 */
final class StepCosts {
  private static final double EVALUATION = 200;
  private static final double EVALUATION_PER_UNKNOWN = 30;
  private static final double ADAMS_STEP = 140;
  private static final double ADAMS_STEP_PER_UNKNOWN = 9;
  private static final double BACKWARD_STEP = 100;
  private static final double BACKWARD_STEP_PER_UNKNOWN = 42;

  /** Of an elimination, per operation. */
  private static final double OPERATION = 0.5;

  /** What a step takes as a rule. */
  private static final double ADAMS_EVALUATIONS = 2;

  private static final double BACKWARD_EVALUATIONS = 1.3;
  private static final double BACKWARD_FACTORISATIONS = 0.17;

  /** Steps that are taken, as a part of those that would just pass: safety factors, late growth. */
  private static final double SHARE_OF_LONGEST = 0.75;

  /** Cost relative to the other method's from which on a change pays. */
  private static final double WORTH_A_CHANGE = 0.75;

  /** Short steps of the backward formula from order 1 on. */
  private static final double STEPS_TO_BEGIN = 15;

  private final double evaluation;
  private final double adamsStep;
  private final double backwardTry;
  private final double factorisation;
  private final double backwardStep;
  private final double start;

  private StepCosts(double dimension, double operations, double columns) {
    evaluation = EVALUATION + EVALUATION_PER_UNKNOWN * dimension;
    adamsStep = ADAMS_EVALUATIONS * evaluation + ADAMS_STEP + ADAMS_STEP_PER_UNKNOWN * dimension;
    backwardTry = BACKWARD_STEP + BACKWARD_STEP_PER_UNKNOWN * dimension;
    factorisation = OPERATION * operations;
    backwardStep = backward(1, BACKWARD_EVALUATIONS, BACKWARD_FACTORISATIONS);
    start = evaluation * columns + STEPS_TO_BEGIN * backwardStep;
  }

  /** Returns the costs for a problem of which nothing but the number of unknowns is known. */
  static StepCosts dense(int dimension) {
    // Positions are eliminated beforehand where their derivatives are velocities.
    double half = 0.5 * dimension;
    return new StepCosts(dimension, 2 * half * half * half / 3, dimension);
  }

  /** Returns the costs for a problem, by the structure that it declares. */
  static StepCosts of(OdeSystem system) {
    int n = system.dimension();
    Optional<BandedSystem> band = system.part(BandedSystem.class);
    Optional<BlockSystem> blocks = system.part(BlockSystem.class);
    if (band.isEmpty() && blocks.isPresent()) {
      double size = Math.min(n, blocks.get().blockSize());
      double half = 0.5 * size;
      return new StepCosts(n, n / size * 2 * half * half * half / 3, size);
    }
    if (band.isEmpty()) {
      return system
          .part(SparseSystem.class)
          .map(known -> sparse(known, n))
          .orElseGet(() -> dense(n));
    }
    BandedSystem banded = band.get();
    double width = Math.min(n, banded.lowerBandwidth() + banded.upperBandwidth() + 1.0);
    return new StepCosts(n, 2.0 * n * banded.lowerBandwidth() * width, width);
  }

  /** As if the unknowns lay in a plane and each were coupled with its neighbours. */
  private static StepCosts sparse(SparseSystem pattern, int n) {
    double elements = 0;
    double most = 0;
    for (int j = 0; j < n; j++) {
      int inColumn = pattern.equations(j, n).length;
      elements += inColumn;
      most = Math.max(most, inColumn);
    }
    double perColumn = elements / n;
    double operations = perColumn * perColumn * n * Math.sqrt(n);
    double half = 0.5 * n;
    return new StepCosts(n, Math.min(operations, 2 * half * half * half / 3), most);
  }

  /** Returns the cost of a step of the Adams method. */
  double adamsStep() {
    return adamsStep;
  }

  /** Returns what the backward formula has cost; a try is a step, accepted or not. */
  double backward(long tries, long evaluations, long factorisations) {
    return backward((double) tries, (double) evaluations, (double) factorisations);
  }

  private double backward(double tries, double evaluations, double factorisations) {
    return backwardTry * tries + evaluation * evaluations + factorisation * factorisations;
  }

  /** Returns the usual cost of a step of the backward formula. */
  double backwardStep() {
    return backwardStep;
  }

  /**
   * Returns how long a step of the backward formula that would just pass has to be for a change, in
   * steps of the Adams method.
   */
  double stepWorthAChange() {
    return backwardStep / (SHARE_OF_LONGEST * WORTH_A_CHANGE * adamsStep);
  }

  /**
   * Returns whether what is saved up to the end of a run pays the change.
   *
   * @param ahead steps of the Adams method up to there
   * @param longer by what the other's steps are longer than those worth a change
   */
  boolean paysStart(double ahead, double longer) {
    return (1 - WORTH_A_CHANGE / longer) * ahead * adamsStep >= start;
  }
}

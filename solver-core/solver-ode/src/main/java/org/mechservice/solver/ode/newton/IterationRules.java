package org.mechservice.solver.ode.newton;

/**
 * When a Newton iteration is taken to have converged on the strength of what earlier ones have
 * shown, and when factors of a similar matrix will do.
 *
 * @param accuracyByOldRate error left, in units of the tolerance, that is accepted after the first
 *     iteration of a step, when only the rate of earlier steps is known
 * @param stepsByOldRate number of steps in a row that may be accepted so; then the rate is measured
 * @param heedsRoundOff whether a rate is learnt from a change that was no more than round-off, as
 *     that of a linear problem always is
 * @param closeRatio how much hγ may differ from that of the factors, relative to it; the iteration
 *     then goes 2 / (1 + ratio) of its way, which errs by the same share in stiff and in slow
 *     components. Brenan, Campbell and Petzold 1996, ch. 5
 * @param keepsRate whether a rate outlives factors of the same derivatives, in proportion to hγ
 * @param looksAhead whether derivatives are formed at predictions, and renewed once they have cost
 *     as many iterations as new ones would
 */
record IterationRules(
    double accuracyByOldRate,
    int stepsByOldRate,
    boolean heedsRoundOff,
    double closeRatio,
    boolean keepsRate,
    boolean looksAhead) {
  /** The rules published for ode15s. */
  static final IterationRules PUBLISHED =
      new IterationRules(0.05, Integer.MAX_VALUE, false, 0, false, false);

  /**
   * For systems in residual form whose mass matrix moves, or that do not say what is algebraic.
   * Loops held by penalty are among them: where angles are rounded to 1e-9, trusting a rate for
   * more makes the error test fail at every step size.
   */
  static final IterationRules LEARNING =
      new IterationRules(0.05, Integer.MAX_VALUE, true, 0, false, false);

  /**
   * Trusts a rate for more, but not for long. Chosen on stiff problems of the suite and 14 others,
   * written for the comparison: on these the same digits for a fifth fewer evaluations on the mean
   * than before, 0.77 instead of 0.95 of those of CVODE.
   */
  static final IterationRules TRUSTING = new IterationRules(0.2, 20, true, 0, true, true);

  /**
   * For systems in residual form that say which components are algebraic, if any. Measured on five
   * mechanisms at 41 tolerances each: a seventh fewer evaluations than by {@link #LEARNING}, the
   * same errors on the mean of all but one, where they grow by six tenths. To trust as much as
   * {@link #TRUSTING} saves another hundredth, at larger errors on all five. Five systems with
   * algebraic components take a tenth fewer evaluations at equal errors than by LEARNING.
   */
  static final IterationRules TRUSTING_RESIDUALS =
      new IterationRules(0.25, 20, true, 0, false, false);
}

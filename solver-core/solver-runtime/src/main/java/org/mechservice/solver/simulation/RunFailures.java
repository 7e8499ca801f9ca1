package org.mechservice.solver.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.ode.IntegrationFailure;
import org.mechservice.solver.ode.IntegrationStatistics;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.simulation.equations.ModelEquations;
import org.mechservice.solver.simulation.equations.RunEvents;

/**
 * The failures that end a run early: the model or the integrator cannot continue, a row cannot be
 * written, a balance has drifted too far, or a strict run has a warning. The cause comes from the
 * defect of the equations if they have one, else from the integrator.
 */
final class RunFailures {
  /** Instead of a column: the loops cannot be closed at an output time. */
  static final int LOOPS_OPEN = -2;

  /** In place of a column: the balance of energy, or that of momentum, has drifted too far. */
  private static final int ENERGY_DRIFTED = -3;

  private static final int MOMENTUM_DRIFTED = -4;

  private final ModelEquations equations;
  private final RunEvents events;
  private final Integrator integrator;
  private final RowWriter rows;
  private final Optional<MomentumBalance> momentum;
  private final RunSettings settings;
  private final OptionalDouble maxDrift;
  private final ModelDescription description;
  private final BooleanSupplier stiff;

  /**
   * @param stiff whether the run so far is stiff
   */
  RunFailures(
      ModelEquations equations,
      RunEvents events,
      Integrator integrator,
      RowWriter rows,
      Optional<MomentumBalance> momentum,
      RunRequest request,
      BooleanSupplier stiff) {
    this.stiff = stiff;
    this.equations = equations;
    this.events = events;
    this.integrator = integrator;
    this.rows = rows;
    this.momentum = momentum;
    settings = request.settings();
    maxDrift = request.maxDrift();
    description = equations.model().description();
  }

  /**
   * Explains why there was no first step: the model itself may have refused, before the integrator
   * could begin.
   */
  Outcome atStart(double[] y, double[] yDot) {
    double t = settings.tStart();
    Optional<Defects.Defect> defect = equations.defect(t, y, yDot, List.of());
    if (defect.isPresent()) {
      return failed(FailureText.of(defect.get(), t, 0, 0));
    }
    return equations.singularJoint() == ExplicitModel.REGULAR
        ? ofIntegrator(y, yDot)
        : failed(FailureText.singularStart(t, description, equations.singularJoint()));
  }

  /**
   * Explains why the integrator cannot go on.
   *
   * @param y state at the last accepted step; not modified
   * @param yDot its derivative; not modified
   */
  Outcome ofIntegrator(double[] y, double[] yDot) {
    IntegrationFailure failure = integrator.failure();
    List<Failure.Step> tried = FailureText.steps(failure);
    Optional<Defects.Defect> defect = equations.defect(integrator.time(), y, yDot, tried);
    if (defect.isEmpty() && failure.slidesAlongJump()) {
      defect = acrossTheJump(failure, y, yDot);
    }
    if (defect.isEmpty() && FailureText.mayLieInLoops(failure.cause())) {
      defect = equations.obstacle();
    }
    Failure told =
        defect.isPresent()
            ? FailureText.of(defect.get(), failure.time(), failure.stepSize(), failure.order())
            : FailureText.of(
                failure,
                description,
                equations.singularJoint(),
                events.part(),
                FailureText.staysShort(failure.cause())
                    ? LocalMotion.of(equations, failure.worstComponent(), integrator.time(), y)
                        .sentence()
                    : "",
                FailureText.ImplicitLoops.of(equations.model()),
                settings.integrator());
    return failed(told.after(tried));
  }

  /**
   * Looks for the force that jumps beside the last state, at the states that lie a step ahead and a
   * step back: a solution that slides along a jump is thrown to and fro, so that its last slope may
   * lead either way.
   */
  private Optional<Defects.Defect> acrossTheJump(
      IntegrationFailure failure, double[] y, double[] yDot) {
    double size = Math.abs(failure.stepSize());
    return across(failure, size, y, yDot).or(() -> across(failure, -size, y, yDot));
  }

  private Optional<Defects.Defect> across(
      IntegrationFailure failure, double way, double[] y, double[] yDot) {
    double t = integrator.time();
    Failure.Step step =
        new Failure.Step(
            t, way, failure.order(), Double.POSITIVE_INFINITY, FailureText.TOO_INACCURATE);
    return equations.defect(t, y, yDot, List.of(step));
  }

  /** Returns the value instead of a column if a balance has drifted too far. */
  int drifted() {
    if (maxDrift.isEmpty()) {
      return RowWriter.ALL_FINITE;
    }
    double most = maxDrift.getAsDouble();
    if (rows.energyMonitor().exceeds(most)) {
      return ENERGY_DRIFTED;
    }
    return momentum.isPresent() && momentum.get().exceeds(most)
        ? MOMENTUM_DRIFTED
        : RowWriter.ALL_FINITE;
  }

  /**
   * Explains why there is no row.
   *
   * @param column column that is not finite, or a value instead of one
   */
  Outcome ofRow(double t, int column) {
    return failed(
        switch (column) {
          case LOOPS_OPEN -> loopsOpen(t);
          case ENERGY_DRIFTED -> energyDrifts(t);
          case MOMENTUM_DRIFTED ->
              momentum
                  .orElseThrow()
                  .failure(maxDrift.orElseThrow(), t, integrator.stepSize(), integrator.order());
          default -> FailureText.notFiniteColumn(t, rows.columnName(column), rows.largestState());
        });
  }

  private Failure loopsOpen(double t) {
    return equations
        .obstacle()
        .map(obstacle -> FailureText.of(obstacle, t, 0, 0))
        .orElseGet(() -> FailureText.loopsOpen(t));
  }

  private Failure energyDrifts(double t) {
    IntegrationStatistics done = integrator.statistics();
    return FailureText.energyDrifts(
        t,
        integrator,
        rows.energyMonitor(),
        maxDrift.orElseThrow(),
        settings,
        limits(done).stream().findFirst().map(RunReport.Limit::state),
        stiff.getAsBoolean());
  }

  /** Ends a strict run at a warning. */
  Outcome ofWarning(RunNotes.Note warning) {
    return failed(FailureText.ofStrict(warning));
  }

  /** Returns the states that caused rejected steps, most frequent first. */
  List<RunReport.Limit> limits(IntegrationStatistics done) {
    List<RunReport.Limit> limits = new ArrayList<>();
    for (IntegrationStatistics.Limit limit : done.limits()) {
      String name = equations.name(limit.component());
      limits.add(new RunReport.Limit(name, limit.inaccurate(), limit.unsolved()));
    }
    return limits;
  }

  private static Outcome failed(Failure failure) {
    return new Outcome.Failed(failure);
  }
}

package org.mechservice.sim.scene;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.simulation.RuntimeSolver;

/**
 * The beginning of the run of an open chain by one formulation and integrator, and the arithmetic
 * operations that it takes. Two methods are compared over the same stretch of the motion, so that
 * steps which grow with time, as they do where a fast motion dies away, do not count against
 * either. Nothing is measured in time: the same model gives the same numbers on every machine.
 *
 * <p>The evaluations, Jacobians, factorisations and solutions are those counted in the trial, times
 * the operations of each on this tree with n velocities: 579 n of accelerations by articulated
 * bodies and 231 n of a residual by the recursion of Newton and Euler (Featherstone 2008, table
 * 10.1); four such recursions, and three products of six numbers for each pair of a joint and one
 * before it, of a Jacobian by recursion; 2/3 n³ of dense factors and 2 n² of a solution by them;
 * and with the sparsity of the tree 2 d² and 4 d for each velocity at depth d. Where the Jacobian
 * is too large for code, data form its forces by all velocities before the bodies on which they
 * act: 2 (d₁ + d₂)² products of six numbers for a force between bodies at depths d₁ and d₂.
 *
 * @param formulation its name
 * @param integrator its name
 * @param operations up to the end of the trial; infinite if it failed, or did not come to the end
 * @param end time reached, s
 * @param steps taken
 * @param isWhole whether the trial came to the end of the run
 */
record MethodTrial(
    String formulation,
    String integrator,
    double operations,
    double end,
    long steps,
    boolean isWhole) {
  /** Steps of a trial: several times those by which methods begin at order 1, and not more than. */
  private static final long STEPS = 200;

  private static final long MOST_STEPS = 1000;

  /** Part of the run, in steps as the last one, that a trial covers if that takes more steps. */
  private static final double SHARE = 0.05;

  /** Steps within which another method has to come as far, in those of the first. */
  private static final long FACTOR = 10;

  private static final double ARTICULATED = 579;
  private static final double NEWTON_EULER = 231;

  /** Multiplications and additions of a product of six numbers. */
  private static final double PRODUCT = 11;

  private static final double RECURSIONS_OF_A_JACOBIAN = 4;

  private static final ResultSink NOWHERE =
      new ResultSink() {
        @Override
        public void begin(List<Variable> columns) {}

        @Override
        public void row(double[] values) {}
      };

  /** Ends the run after a number of steps. */
  private static final class FirstSteps extends RunControl {
    private final End ends;

    FirstSteps(End ends) {
      this.ends = ends;
    }

    @Override
    public boolean proceed(double time, double stepSize, int order, long steps) {
      if (steps > 0 && ends.test(steps, time, stepSize)) {
        stop();
      }
      return super.proceed(time, stepSize, order, steps);
    }
  }

  /** Whether a trial ends after a step. */
  private interface End {
    boolean test(long steps, double time, double stepSize);
  }

  /**
   * Tries a method over its first steps.
   *
   * @param mechanism an open chain without user forces
   */
  static MethodTrial of(
      Mechanism mechanism, Formulation formulation, IntegrationMethod method, RunSettings run) {
    End covered =
        (steps, time, stepSize) ->
            steps >= MOST_STEPS
                || (steps >= STEPS && steps * stepSize >= SHARE * (run.tEnd() - time));
    return of(mechanism, formulation, method, run, run.tEnd(), covered, true);
  }

  /** Tries a method over a whole run, however many steps it takes. */
  static MethodTrial whole(
      Mechanism mechanism, Formulation formulation, IntegrationMethod method, RunSettings run) {
    return of(mechanism, formulation, method, run, run.tEnd(), (s, time, size) -> false, true);
  }

  /** Tries another method over the same stretch. */
  MethodTrial against(
      Mechanism mechanism, Formulation other, IntegrationMethod method, RunSettings run) {
    End lost = (count, time, stepSize) -> count >= FACTOR * steps;
    return of(mechanism, other, method, run, end, lost, false);
  }

  private static MethodTrial of(
      Mechanism mechanism,
      Formulation formulation,
      IntegrationMethod method,
      RunSettings run,
      double to,
      End ends,
      boolean first) {
    RunSettings settings = run.withIntegrator(method.label()).withOutput(to, to - run.tStart());
    CompactModel data =
        new CompactModel(mechanism, formulation.label(), MethodNames.NONE, settings);
    RunReport report;
    try {
      report =
          new RuntimeSolver()
              .run(
                  DataDriven.model(data, UserForceSource.NONE),
                  new RunRequest(settings, Set.of()),
                  NOWHERE,
                  new FirstSteps(ends));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    boolean came =
        report.outcome() instanceof Outcome.Completed
            || (first && report.outcome() instanceof Outcome.Stopped);
    return new MethodTrial(
        formulation.label(),
        method.label(),
        came ? operations(mechanism, formulation, report) : Double.POSITIVE_INFINITY,
        report.timeReached(),
        report.steps(),
        first && report.outcome() instanceof Outcome.Completed);
  }

  private static double operations(Mechanism mechanism, Formulation formulation, RunReport report) {
    double n = mechanism.velocityCount();
    if (!formulation.isResidual()) {
      boolean implicit = report.factorisations() > 0;
      return report.evaluations() * (ARTICULATED * n + (implicit ? 2 * n * n : 0))
          + report.factorisations() * 2 * n * n * n / 3;
    }
    double pairs = 0;
    double factors = 0;
    TreeGeometry tree = new TreeGeometry(mechanism);
    int[] depth = new int[tree.linkCount];
    for (int link = 0; link < tree.linkCount; link++) {
      int own = tree.driven[link] ? 0 : tree.kind[link].velocityCount();
      depth[link] = own + (tree.parent[link] < 0 ? 0 : depth[tree.parent[link]]);
      for (int d = depth[link] - own + 1; d <= depth[link]; d++) {
        pairs += d;
        factors += 2.0 * d * d;
      }
    }
    double ofForces = isData(mechanism, formulation) ? ofForces(mechanism, tree, depth) : 0;
    return report.evaluations() * (NEWTON_EULER * n + 4 * pairs)
        + report.jacobians()
            * (RECURSIONS_OF_A_JACOBIAN * NEWTON_EULER * n + 3 * PRODUCT * pairs + ofForces)
        + report.factorisations() * factors;
  }

  private static boolean isData(Mechanism mechanism, Formulation formulation) {
    FormulationChoice choice = new FormulationChoice(formulation.label(), MethodNames.NONE, "");
    return !GenerationLimits.notGenerated(mechanism, choice, () -> 0).isEmpty();
  }

  private static double ofForces(Mechanism mechanism, TreeGeometry tree, int[] depth) {
    double sum = 0;
    for (ForceElement force : mechanism.forces()) {
      double velocities = 0;
      for (int body : force.bodies()) {
        velocities += body < 0 ? 0 : depth[tree.linkOfBody[body]];
      }
      sum += 2 * velocities * velocities * PRODUCT;
    }
    return sum;
  }

  /** Returns the trial in words. */
  String text() {
    return String.format(Locale.ROOT, "%s with %s %.2g", formulation, integrator, operations);
  }

  /** Returns the trial that foresees fewer operations; the first of equal ones. */
  static MethodTrial better(MethodTrial first, MethodTrial second) {
    return second.operations < first.operations ? second : first;
  }

  /** Returns the reason of a choice between two. */
  static Optional<String> reason(String why, MethodTrial first, MethodTrial second) {
    return Optional.of(
        why
            + String.format(
                Locale.ROOT, ", and operations counted in a trial to %.2g s are by ", first.end)
            + first.text()
            + ", by "
            + second.text());
  }
}

package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.mechservice.client.MechSession;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.page.SolverChart;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;

/**
 * Contraction of the simplified Newton iteration against step size and against the age of its
 * Jacobian: with the whole Jacobian, with that of the forces alone, and with differences; and what
 * the integrator makes of them.
 */
final class NewtonStudy implements MethodStudy {
  private static final int BARS = 8;
  private static final double STIFFNESS = 1e4;
  private static final double DAMPING = 1e2;
  private static final double END = 1;
  private static final double[] STEPS = {1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1};
  private static final int[] AGES = {0, 1, 2, 5, 10, 20, 50, 100};

  /** Output rows of the motion the Jacobians are taken from. */
  private static final int ROWS = 200;

  /** Relative size of a difference of first order. */
  private static final double FORWARD = 1.5e-8;

  /** Relative size of a central difference. */
  private static final double CENTRAL = 6e-6;

  private static final double VISIBLE = 1e-10;

  private final StudyContext context;

  NewtonStudy(StudyContext context) {
    this.context = context;
  }

  @Override
  public String name() {
    return "newton";
  }

  /** The source of the iteration matrix. */
  private enum Kind {
    FULL("full"),
    FORCES("forces only"),
    DIFFERENCED("differenced");

    private final String label;

    Kind(String label) {
      this.label = label;
    }
  }

  @Override
  public void measure(StudyPage page) {
    page.title("Newton's iteration: contraction and age of the Jacobian");
    page.notes(
        "A chain of %d bars with springs of %.0e N·m/rad and dampers of %.0e N·m·s/rad, let go at"
            + " 0.3 rad each. Equations of a backward Euler step h from states along its motion,"
            + " F(t + h, y + h d, d) = 0. Contraction: ratio of the second to the first correction."
            + " Full: ∂F/∂y and ∂F/∂y' by central differences, nine digits. Forces only: the same"
            + " at rest, v = v' = 0: what is left is M, springs, dampers and weight. Differenced:"
            + " one-sided differences, half the digits.",
        BARS, STIFFNESS, DAMPING);
    BarChain chain = new BarChain(BARS, 1, 1, STIFFNESS, DAMPING, 0.3, END);
    context.with(chain.text(), session -> measure(page, session));
  }

  private Boolean measure(StudyPage page, MechSession session) {
    Candidate candidate = StudyContext.compact(session, StudyContext.IMPLICIT);
    StudyContext.Ran ran = StudyContext.run(candidate, END, END / ROWS, 1e-8, 60);
    ResidualModel model = (ResidualModel) candidate.models().get();
    bySize(page, model, ran.rows());
    byAge(page, model, ran.rows());
    integrator(page, session);
    return true;
  }

  private void bySize(StudyPage page, ResidualModel model, List<double[]> rows) {
    StudyPage.Table table =
        page.table("Contraction, fresh Jacobian", "h, s", "full", "forces only", "differenced");
    SolverChart chart = new SolverChart("step h, s", "contraction");
    Map<Kind, double[]> rates = new EnumMap<>(Kind.class);
    for (Kind kind : Kind.values()) {
      List<SolverChart.Value> values = new ArrayList<>();
      double[] found = new double[STEPS.length];
      for (int i = 0; i < STEPS.length; i++) {
        context.at(kind.label + ", h = " + StudyContext.number(STEPS[i]), 0.3);
        found[i] = contraction(model, rows, kind, STEPS[i], 0);
        values.add(value(STEPS[i], found[i], kind.label));
      }
      chart.add(kind.label, values);
      page.finds("%s: %s.", kind.label, largestStep(found));
      rates.put(kind, found);
    }
    double[] full = of(rates, Kind.FULL);
    double[] forces = of(rates, Kind.FORCES);
    double[] differenced = of(rates, Kind.DIFFERENCED);
    for (int i = 0; i < STEPS.length; i++) {
      table.row(STEPS[i], full[i], forces[i], differenced[i]);
    }
    page.shows("Contraction against step size", chart);
  }

  private static double[] of(Map<Kind, double[]> rates, Kind kind) {
    return rates.getOrDefault(kind, new double[0]);
  }

  private static String largestStep(double[] rates) {
    String found = "a fresh Jacobian contracts by less than 10 at every step looked at";
    for (int i = 0; i < STEPS.length; i++) {
      if (rates[i] < 0.1) {
        found =
            "a fresh Jacobian contracts by more than 10 an iteration up to h = "
                + StudyContext.number(STEPS[i])
                + " s";
      }
    }
    return found;
  }

  private void byAge(StudyPage page, ResidualModel model, List<double[]> rows) {
    double h = 1e-2;
    StudyPage.Table table =
        page.table(
            "Contraction against age, h = 0.01 s", "age, s", "full", "forces only", "differenced");
    SolverChart chart = new SolverChart("age of the Jacobian, s", "contraction");
    Map<Kind, double[]> rates = new EnumMap<>(Kind.class);
    for (Kind kind : Kind.values()) {
      List<SolverChart.Value> values = new ArrayList<>();
      double[] found = new double[AGES.length];
      for (int i = 0; i < AGES.length; i++) {
        context.at(kind.label + ", age " + AGES[i], 0.6);
        found[i] = contraction(model, rows, kind, h, AGES[i]);
        if (AGES[i] > 0) {
          values.add(value(AGES[i] * END / ROWS, found[i], kind.label));
        }
      }
      chart.add(kind.label, values);
      rates.put(kind, found);
    }
    double[] full = of(rates, Kind.FULL);
    double[] forces = of(rates, Kind.FORCES);
    double[] differenced = of(rates, Kind.DIFFERENCED);
    for (int i = 0; i < AGES.length; i++) {
      table.row(AGES[i] * END / ROWS, full[i], forces[i], differenced[i]);
    }
    page.shows("Contraction against the age of the Jacobian", chart);
    int old = AGES.length - 2;
    page.finds(
        "At h = 0.01 s a full Jacobian contracts to %.1e fresh and %.1e when it is %.2g s old, that"
            + " of the forces alone to %.1e and %.1e: what the forces leave out matters %s.",
        full[0],
        full[old],
        AGES[old] * END / ROWS,
        forces[0],
        forces[old],
        forces[old] > 2 * full[old] ? "at every age" : "while it is fresh only");
  }

  private static SolverChart.Value value(double x, double rate, String label) {
    return new SolverChart.Value(x, Math.max(rate, VISIBLE), label + ": " + StudyPage.shown(rate));
  }

  /** Geometric mean over states along the motion. */
  private static double contraction(
      ResidualModel model, List<double[]> rows, Kind kind, double h, int age) {
    double logs = 0;
    int count = 0;
    for (int at = 5 + age; at < rows.size(); at += 20) {
      double rate = contraction(model, rows.get(at - age), rows.get(at), kind, h);
      if (rate > 0) {
        logs += Math.log(rate);
        count++;
      }
    }
    return count == 0 ? Double.NaN : Math.exp(logs / count);
  }

  private static double contraction(
      ResidualModel model, double[] old, double[] now, Kind kind, double h) {
    int n = now.length - 1;
    DenseLu lu = new DenseLu(n);
    double[] matrix = new double[n * n];
    iterationMatrix(model, old, kind, h, lu, matrix);
    if (lu.factor(matrix) != LinearSolver.NONSINGULAR) {
      return Double.NaN;
    }
    double[] y = java.util.Arrays.copyOfRange(now, 1, now.length);
    double[] d = new double[n];
    // The explicit slope as a start, as a predictor gives it.
    model.derivative(now[0], y, d);
    double[] tried = new double[n];
    double[] residual = new double[n];
    double[] sizes = new double[2];
    for (int iteration = 0; iteration < 2; iteration++) {
      for (int i = 0; i < n; i++) {
        tried[i] = y[i] + h * d[i];
      }
      model.residual(now[0] + h, tried, d, residual);
      lu.solve(residual);
      double square = 0;
      for (int i = 0; i < n; i++) {
        d[i] -= residual[i];
        square += residual[i] * residual[i];
      }
      sizes[iteration] = Math.sqrt(square);
    }
    return sizes[1] / sizes[0];
  }

  /** h ∂F/∂y + ∂F/∂y' at a row of the motion, column by column. */
  private static void iterationMatrix(
      ResidualModel model, double[] row, Kind kind, double h, DenseLu lu, double[] matrix) {
    int n = row.length - 1;
    double[] y = java.util.Arrays.copyOfRange(row, 1, row.length);
    double[] d = new double[n];
    model.derivative(row[0], y, d);
    if (kind == Kind.FORCES) {
      java.util.Arrays.fill(d, 0);
      java.util.Arrays.fill(y, n / 2, n, 0);
    }
    double[] above = new double[n];
    double[] below = new double[n];
    double part = kind == Kind.DIFFERENCED ? FORWARD : CENTRAL;
    for (int column = 0; column < n; column++) {
      // One difference for both: F(y + h e, d + e).
      double step = part * Math.max(1, Math.max(Math.abs(y[column]) / h, Math.abs(d[column])));
      double[] moved = y.clone();
      double[] slope = d.clone();
      moved[column] += h * step;
      slope[column] += step;
      model.residual(row[0] + h, moved, slope, above);
      double back = kind == Kind.DIFFERENCED ? 0 : step;
      moved[column] = y[column] - h * back;
      slope[column] = d[column] - back;
      model.residual(row[0] + h, moved, slope, below);
      for (int i = 0; i < n; i++) {
        matrix[lu.layout().index(i, column)] = (above[i] - below[i]) / (step + back);
      }
    }
  }

  private void integrator(StudyPage page, MechSession session) {
    StudyPage.Table table =
        page.table(
            "ode15sR on the same motion",
            "formulation, Jacobian",
            "tolerance",
            "steps",
            "rejected",
            "evaluations",
            "Jacobians",
            "steps per Jacobian",
            "factorisations",
            "ms");
    for (String formulation : List.of("RR-JF", "RR")) {
      Candidate candidate =
          StudyContext.candidate(
              session, new SimulationMethod(formulation, MethodNames.NONE, "ode15sR"));
      for (double tolerance : new double[] {1e-4, 1e-6, 1e-8}) {
        context.at(formulation + " at " + StudyContext.number(tolerance), 0.9);
        StudyContext.Ran ran = StudyContext.run(candidate, END, END, tolerance, 60);
        for (int i = 0; i < 10; i++) {
          ran = StudyContext.run(candidate, END, END, tolerance, 60);
        }
        var report = ran.report();
        table.row(
            formulation + (formulation.equals("RR") ? ", differenced" : ", full"),
            tolerance,
            report.steps(),
            report.rejectedSteps(),
            report.evaluations(),
            report.jacobians(),
            (double) report.steps() / Math.max(1, report.jacobians()),
            report.factorisations(),
            1e3 * ran.seconds());
        page.finds(
            "%s",
            String.format(
                Locale.ROOT,
                "ode15sR with %s at %s: %d steps, %d evaluations, a Jacobian every %.1f steps.",
                formulation,
                StudyContext.number(tolerance),
                report.steps(),
                report.evaluations(),
                (double) report.steps() / Math.max(1, report.jacobians())));
      }
    }
  }
}

package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.mechservice.client.MechSession;
import org.mechservice.client.SessionBuilds;
import org.mechservice.report.measure.LoopForces;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.page.SolverChart;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MethodNames;

/** Energy, momentum and open loops over very many periods: bounded, linear or quadratic. */
final class PeriodsStudy implements MethodStudy {
  private static final double TOLERANCE = 1e-8;
  private static final int ROWS = 2000;

  /** Slopes are fitted to what comes after this part of the run. */
  private static final double FITTED_FROM = 0.02;

  private final StudyContext context;
  private final double periods;
  private final double limit;

  /** Findings by scene and invariant, one part per method. */
  private final Map<String, List<String>> found = new LinkedHashMap<>();

  PeriodsStudy(StudyContext context) {
    this.context = context;
    periods = context.quick() ? 1e3 : 1e5;
    limit = context.quick() ? 5 : 1200;
  }

  @Override
  public String name() {
    return "periods";
  }

  /**
   * A quantity that should be constant.
   *
   * @param name for the page
   * @param of a row of time and state
   */
  private record Invariant(String name, ToDoubleFunction<double[]> of) {}

  @Override
  public void measure(StudyPage page) {
    page.title(String.format(Locale.ROOT, "Invariants over %.0e periods", periods));
    page.notes(
        "Relative tolerance %.0e. Drift: the largest change so far; energy as a part of its scale,"
            + " momentum as a part of its modulus, Φ in m, Φ' in m/s. The slope of its logarithm"
            + " over that of time is fitted by least squares to what comes after %.0f %% of the"
            + " run: below 0.3 it is called bounded, to 0.7 a random walk, to 1.4 linear, above"
            + " quadratic. Runs are stopped after %.0f s.",
        TOLERANCE, 100 * FITTED_FROM, limit);
    StudyPage.Table table =
        page.table(
            "Drift",
            "scene",
            "method",
            "of",
            "after 1 % of the run",
            "at the end",
            "slope",
            "verdict",
            "steps per period",
            "ended");
    List<SimulationMethod> open =
        List.of(
            StudyContext.EXPLICIT,
            new SimulationMethod("DTR", MethodNames.NONE, "DE"),
            StudyContext.IMPLICIT);
    // A bar that swings to 1 rad about its lowest position: 2π √(2 l / 3 g) = 1.638 s, and 6.6 %.
    scene(page, table, "pendulum", pendulum(), 1.746, open, this::energy);
    // Without forces, about its largest inertia: ω √((3 − 1)(3 − 2) / (1 · 2)) = 1 rad/s.
    String spin =
        StudyContext.replaced(
            StudyContext.scene("spin_1e3_asymmetric.xml"), "1e3*0.001;1e3*0.001;1e3", "0.1;0.1;1");
    scene(page, table, "free rotor", spin, 2 * Math.PI, open, this::momentum);
    String fourBar =
        StudyContext.replaced(StudyContext.scene("start_off_1e-6.xml"), "3.000001", "3");
    scene(page, table, "four-bar", fourBar, 1.5, StudyContext.WITH_LOOPS, this::loops);
    found.forEach((what, said) -> page.finds("%s: %s.", what, String.join("; ", said)));
  }

  private static String pendulum() {
    return new BarChain(1, 1, 1, 0, 0, Math.PI / 2 - 1, 1).text();
  }

  private List<Invariant> energy(MechSession session, Candidate candidate) {
    Model model = candidate.models().get();
    double[] energy = new double[2];
    List<Invariant> invariants = new ArrayList<>();
    if (model instanceof Energies known) {
      // Of the bar at 1 rad from its lowest position: m g l/2 (1 − cos 1).
      double scale = 9.81 / 2 * (1 - Math.cos(1));
      invariants.add(
          new Invariant(
              "energy",
              row -> {
                known.energy(row[0], stateOf(row), energy);
                return (energy[0] + energy[1]) / scale;
              }));
    }
    return invariants;
  }

  /** Modulus of the angular momentum of the rotor with inertias 1, 2, 3 kg m². */
  private List<Invariant> momentum(MechSession session, Candidate candidate) {
    double modulus = Math.sqrt(0.1 * 0.1 + 0.2 * 0.2 + 9);
    return List.of(
        new Invariant(
            "momentum",
            row -> {
              double[] spin = ownAxes(row);
              return Math.hypot(Math.hypot(spin[0], 2 * spin[1]), 3 * spin[2]) / modulus;
            }),
        new Invariant(
            "energy",
            row -> {
              double[] spin = ownAxes(row);
              return (spin[0] * spin[0] + 2 * spin[1] * spin[1] + 3 * spin[2] * spin[2]) / 3.03;
            }));
  }

  /** Angular velocity of a row of the rotor, of Euler parameters and ω, in its own axes. */
  private static double[] ownAxes(double[] row) {
    double norm = row[1] * row[1] + row[2] * row[2] + row[3] * row[3] + row[4] * row[4];
    double[] turned = new double[3];
    double[] e = {row[2], row[3], row[4]};
    double[] w = {row[5], row[6], row[7]};
    double along = e[0] * w[0] + e[1] * w[1] + e[2] * w[2];
    double scalar = row[1] * row[1] - (norm - row[1] * row[1]);
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      double cross = w[j] * e[k] - w[k] * e[j];
      turned[i] = (scalar * w[i] + 2 * along * e[i] + 2 * row[1] * cross) / norm;
    }
    return turned;
  }

  private List<Invariant> loops(MechSession session, Candidate candidate) {
    Model model =
        session
            .fetchModel(
                SessionBuilds.options(candidate.method()).columns(Set.of(ColumnGroup.CONSTRAINTS)))
            .newModel();
    Optional<LoopForces> loops = LoopForces.of(model);
    List<Invariant> invariants = new ArrayList<>();
    loops.ifPresent(
        known -> {
          invariants.add(new Invariant("Φ", row -> known.residual(row[0], stateOf(row))));
          invariants.add(new Invariant("Φ'", row -> known.residualRate(row[0], stateOf(row))));
        });
    Model plain = candidate.models().get();
    double[] energy = new double[2];
    if (plain instanceof Energies known) {
      invariants.add(
          new Invariant(
              "energy",
              row -> {
                known.energy(row[0], stateOf(row), energy);
                return (energy[0] + energy[1]) / 9.81;
              }));
    }
    return invariants;
  }

  private static double[] stateOf(double[] row) {
    return java.util.Arrays.copyOfRange(row, 1, row.length);
  }

  private interface Invariants {
    List<Invariant> of(MechSession session, Candidate candidate);
  }

  private void scene(
      StudyPage page,
      StudyPage.Table table,
      String scene,
      String text,
      double period,
      List<SimulationMethod> methods,
      Invariants invariants) {
    Function<MechSession, SolverChart> use =
        session -> {
          SolverChart chart = new SolverChart("periods", "drift");
          for (SimulationMethod method : methods) {
            context.at(scene + ", " + method, 0.5);
            Candidate candidate = StudyContext.candidate(session, method);
            double end = period * periods;
            StudyContext.Ran ran = StudyContext.run(candidate, end, end / ROWS, TOLERANCE, limit);
            for (Invariant invariant : invariants.of(session, candidate)) {
              judge(table, chart, scene, method, invariant, ran, period);
            }
          }
          return chart;
        };
    page.shows(scene, context.with(text, use));
  }

  private void judge(
      StudyPage.Table table,
      SolverChart chart,
      String scene,
      SimulationMethod method,
      Invariant invariant,
      StudyContext.Ran ran,
      double period) {
    double[] drift = new double[ran.rows().size()];
    double start = Double.NaN;
    double worst = 0;
    List<SolverChart.Value> values = new ArrayList<>();
    for (int i = 0; i < drift.length; i++) {
      double[] row = ran.rows().get(i);
      double value = invariant.of().applyAsDouble(row);
      start = i == 0 ? value : start;
      worst = Math.max(worst, Math.abs(value - start));
      drift[i] = worst;
      if (i > 0 && worst > 0 && Math.floor(30 * Math.log(i)) > Math.floor(30 * Math.log(i - 1))) {
        String hover = method + ", " + invariant.name() + ": " + StudyPage.shown(worst);
        values.add(new SolverChart.Value(row[0] / period, worst, hover));
      }
    }
    if (drift.length < 2) {
      table.row(scene, method.name(), invariant.name(), "", "", "", "", "", ran.ending());
      return;
    }
    chart.add(method + ", " + invariant.name(), values);
    double slope = slope(drift);
    String verdict = verdict(slope);
    double turns = ran.rows().get(drift.length - 1)[0] / period;
    int early = Math.max(1, drift.length / 100);
    table.row(
        scene,
        method.name(),
        invariant.name(),
        drift[early],
        worst,
        slope,
        verdict,
        ran.report().steps() / turns,
        ran.completed() ? "yes" : ran.ending());
    String often = ran.completed() ? "" : String.format(Locale.ROOT, " after %.0f periods", turns);
    found
        .computeIfAbsent(scene + ", " + invariant.name(), key -> new ArrayList<>())
        .add(String.format(Locale.ROOT, "%s %s (%.0e%s)", method, verdict, worst, often));
  }

  private static double slope(double[] drift) {
    SimpleRegression line = new SimpleRegression();
    for (int i = (int) Math.max(1, FITTED_FROM * drift.length); i < drift.length; i++) {
      if (drift[i] > 0) {
        line.addData(Math.log(i), Math.log(drift[i]));
      }
    }
    return line.getN() < 2 ? 0 : line.getSlope();
  }

  private static String verdict(double slope) {
    if (slope < 0.3) {
      return "bounded";
    } else if (slope < 0.7) {
      return "random walk";
    }
    return slope < 1.4 ? "linear" : "quadratic";
  }
}

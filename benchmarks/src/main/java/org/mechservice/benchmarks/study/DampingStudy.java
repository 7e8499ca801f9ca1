package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.client.MechSession;
import org.mechservice.report.measure.Quantiles;
import org.mechservice.report.measure.Spectrum;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.ModelProblem;
import org.mechservice.report.page.SolverChart;

/** Steps and cost of explicit and implicit methods as damping and stiffness grow. */
final class DampingStudy implements MethodStudy {
  private static final double[] STIFFNESS = {1e2, 1e4, 1e6, 1e8};
  private static final double[] RATIO = {0, 1e-4, 1e-3, 1e-2, 1e-1, 1, 10};
  private static final int BARS = 5;
  private static final double TOLERANCE = 1e-5;
  private static final int REPEATS = 5;

  /** Decay of an undamped chain, 1/s, is what rounding makes of 0. */
  private static final double ROUNDING = 1e-3;

  private final StudyContext context;
  private final double limit;

  DampingStudy(StudyContext context) {
    this.context = context;
    limit = context.quick() ? 2 : 60;
  }

  @Override
  public String name() {
    return "damping";
  }

  /** Both methods at one stiffness and damping. */
  private record Pair(
      double ratio, double decay, StudyContext.Ran explicit, StudyContext.Ran implicit) {
    double gain() {
      double slow = explicit.completed() ? explicit.seconds() : Double.POSITIVE_INFINITY;
      double fast = implicit.completed() ? implicit.seconds() : Double.POSITIVE_INFINITY;
      return slow / fast;
    }
  }

  @Override
  public void measure(StudyPage page) {
    page.title("Damping and stiffness sweeps");
    page.notes(
        "A chain of %d bars of 1 m and 1 kg on hinges with springs K and dampers C, let go at 0.05"
            + " rad each; 1 s, tolerance %.0e. %s against %s, processor time, median of %d warm"
            + " runs. Eigenvalues: of the equations linearised in the independent coordinates at"
            + " the start. Runs are stopped after %.0f s.",
        BARS,
        TOLERANCE,
        StudyContext.EXPLICIT.name(),
        StudyContext.IMPLICIT.name(),
        REPEATS,
        limit);
    StudyPage.Table table =
        page.table(
            "Sweeps",
            "K, N·m/rad",
            "C/K, s",
            "rightmost eigenvalue, 1/s",
            "fastest decay, 1/s",
            "highest frequency, rad/s",
            "explicit: steps",
            "rejected",
            "ms",
            "implicit: steps",
            "rejected",
            "ms",
            "explicit ÷ implicit, time");
    SolverChart chart = new SolverChart("fastest decay, 1/s", "steps");
    List<SolverChart.Value> explicit = new ArrayList<>();
    List<SolverChart.Value> implicit = new ArrayList<>();
    for (double stiffness : STIFFNESS) {
      List<Pair> pairs = new ArrayList<>();
      for (double ratio : RATIO) {
        context.at(
            "K = " + StudyContext.number(stiffness) + ", C/K = " + StudyContext.number(ratio), 0.5);
        Pair pair = pair(table, stiffness, ratio);
        pairs.add(pair);
        String hover =
            "K = " + StudyContext.number(stiffness) + ", C/K = " + StudyContext.number(ratio);
        if (pair.decay() > ROUNDING && pair.explicit().completed()) {
          explicit.add(value(pair.decay(), pair.explicit(), hover));
        }
        if (pair.decay() > ROUNDING && pair.implicit().completed()) {
          implicit.add(value(pair.decay(), pair.implicit(), hover));
        }
      }
      page.finds("K = %s N·m/rad: %s.", StudyContext.number(stiffness), crossover(pairs));
    }
    explicit.sort(java.util.Comparator.comparingDouble(SolverChart.Value::cost));
    implicit.sort(java.util.Comparator.comparingDouble(SolverChart.Value::cost));
    chart.add(StudyContext.EXPLICIT.name(), explicit);
    chart.add(StudyContext.IMPLICIT.name(), implicit);
    page.shows("Steps against the fastest decay, all sweeps together", chart);
  }

  private static SolverChart.Value value(double decay, StudyContext.Ran ran, String hover) {
    return new SolverChart.Value(decay, (double) ran.report().steps(), hover);
  }

  private Pair pair(StudyPage.Table table, double stiffness, double ratio) {
    BarChain chain = new BarChain(BARS, 1, 1, stiffness, ratio * stiffness, 0.05, 1);
    return context.with(chain.text(), session -> pair(session, table, stiffness, ratio));
  }

  private Pair pair(MechSession session, StudyPage.Table table, double stiffness, double ratio) {
    Candidate explicit = StudyContext.candidate(session, StudyContext.EXPLICIT);
    Candidate implicit = StudyContext.candidate(session, StudyContext.IMPLICIT);
    ModelProblem problem = new ModelProblem(explicit.equations());
    Optional<Spectrum.Sample> spectrum = Spectrum.at(problem, 0, problem.start());
    double rightmost =
        modes(spectrum).stream().mapToDouble(Spectrum.Mode::real).max().orElse(Double.NaN);
    double decay =
        modes(spectrum).stream().mapToDouble(mode -> -mode.real()).max().orElse(Double.NaN);
    double frequency =
        modes(spectrum).stream().mapToDouble(Spectrum.Mode::imaginary).max().orElse(Double.NaN);
    Pair pair = new Pair(ratio, decay, timed(explicit), timed(implicit));
    table.row(
        stiffness,
        ratio,
        rightmost,
        decay,
        frequency,
        steps(pair.explicit()),
        pair.explicit().report().rejectedSteps(),
        1e3 * pair.explicit().seconds(),
        steps(pair.implicit()),
        pair.implicit().report().rejectedSteps(),
        1e3 * pair.implicit().seconds(),
        pair.gain());
    return pair;
  }

  private static List<Spectrum.Mode> modes(Optional<Spectrum.Sample> spectrum) {
    return spectrum.map(Spectrum.Sample::modes).orElse(List.of());
  }

  private static String steps(StudyContext.Ran ran) {
    return ran.report().steps() + (ran.completed() ? "" : " (" + ran.ending() + ")");
  }

  /** A run that takes long is not repeated. */
  private StudyContext.Ran timed(Candidate candidate) {
    StudyContext.Ran ran = StudyContext.run(candidate, 1, 0.1, TOLERANCE, limit);
    if (!ran.completed() || ran.seconds() > 0.2) {
      return ran;
    }
    double[] seconds = new double[REPEATS];
    for (int i = -REPEATS; i < REPEATS; i++) {
      ran = StudyContext.run(candidate, 1, 0.1, TOLERANCE, limit);
      seconds[Math.max(i, 0)] = ran.seconds();
    }
    return new StudyContext.Ran(ran.report(), Quantiles.median(seconds), ran.rows());
  }

  private static String crossover(List<Pair> pairs) {
    for (int i = 0; i < pairs.size(); i++) {
      if (pairs.get(i).gain() > 1) {
        Pair first = pairs.get(i);
        Pair last = pairs.get(pairs.size() - 1);
        return String.format(
            java.util.Locale.ROOT,
            "the implicit method is the faster one from C/K = %s s on (%s times), at C/K = %s s %s"
                + " times",
            StudyContext.number(first.ratio()),
            StudyPage.shown(first.gain()),
            StudyContext.number(last.ratio()),
            StudyPage.shown(last.gain()));
      }
    }
    return "the explicit method is the faster one at every damping looked at";
  }
}

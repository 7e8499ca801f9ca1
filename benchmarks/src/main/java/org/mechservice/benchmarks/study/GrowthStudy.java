package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.mechservice.report.page.SolverChart;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;

/**
 * Growth per period of an undamped oscillator at a given |hλ|, for each order: the integrators
 * themselves, their step held by its bound and their order by its own, with tolerances that accept
 * everything.
 */
final class GrowthStudy implements MethodStudy {
  private static final double ACCEPTS_ALL = 1e30;
  private static final int WARM_UP_STEPS = 200;
  private static final double[] SIZES = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10};

  /** Beyond this an amplitude has said what it had to say. */
  private static final double FAR = 1e12;

  private final StudyContext context;

  GrowthStudy(StudyContext context) {
    this.context = context;
  }

  @Override
  public String name() {
    return "growth";
  }

  /**
   * The growth of the amplitude.
   *
   * @param perPeriod factor per period
   * @param order used at the end
   */
  private record Growth(double perPeriod, int order) {}

  @Override
  public void measure(StudyPage page) {
    page.title("Growth per period of an undamped oscillator");
    page.notes(
        "x'' = −ω² x with ω = 1 rad/s; step and order are held by the settings' bounds, tolerances"
            + " accept every step. The amplitude √(y₀² + y₁²) is compared after %d steps with that"
            + " at the end. Order used: an integrator lowers its order by itself where that"
            + " promises a smaller error; such points are not shown in the diagram.",
        WARM_UP_STEPS);
    measure(page, "ode113", Ode113::new, new int[] {1, 2, 3, 4, 5, 6, 8, 10, 12});
    measure(page, "ode15s", Ode15s::new, new int[] {1});
    measureFormulas(page);
  }

  /**
   * The formulas of ode15s at a step that is held. The integrator itself cannot be made to hold an
   * order above 1: it goes to a higher one only where that promises a longer step, and with
   * tolerances that accept all, every order promises the same.
   */
  private void measureFormulas(StudyPage page) {
    StudyPage.Table table =
        page.table("Formulas of ode15s", "order", "|hλ|", "growth per period − 1");
    SolverChart grows = new SolverChart("|hλ|", "growth per period − 1");
    SolverChart decays = new SolverChart("|hλ|", "1 − growth per period");
    StringBuilder limits = new StringBuilder();
    for (int order = 1; order <= BackwardRecursion.HIGHEST_ORDER; order++) {
      List<SolverChart.Value> up = new ArrayList<>();
      List<SolverChart.Value> down = new ArrayList<>();
      double worst = 0;
      double at = 0;
      for (double size : SIZES) {
        double gain = new BackwardRecursion(order).growthPerPeriod(size) - 1;
        table.row(order, size, gain);
        String hover = "order " + order + ": " + StudyPage.shown(gain);
        if (gain != 0) {
          (gain > 0 ? up : down).add(new SolverChart.Value(size, Math.abs(gain), hover));
        }
        if (gain > worst) {
          worst = gain;
          at = size;
        }
      }
      if (!up.isEmpty()) {
        grows.add("order " + order, up);
      }
      if (!down.isEmpty()) {
        decays.add("order " + order, down);
      }
      limits.append(limits.isEmpty() ? "" : ", ").append(order).append(": ");
      limits.append(worst == 0 ? "nowhere" : StudyPage.shown(worst) + " at " + StudyPage.shown(at));
    }
    page.finds(
        "Formulas of ode15s and ode15sR: where an undamped oscillation grows, and by how much per"
            + " period at most, by order: %s. Told to hold a high order with tolerances that accept"
            + " all, ode15s itself stays at order 1: it goes to a higher order only where that"
            + " promises a longer step, and here all promise the same.",
        limits);
    page.shows("Formulas of ode15s: the amplitude grows", grows);
    page.shows("Formulas of ode15s: the amplitude decays", decays);
  }

  private void measure(
      StudyPage page,
      String integrator,
      Function<IntegratorSettings, Integrator> maker,
      int[] orders) {
    StudyPage.Table table =
        page.table(integrator, "highest order", "|hλ|", "order used", "growth per period − 1");
    SolverChart grows = new SolverChart("|hλ|", "growth per period − 1");
    SolverChart decays = new SolverChart("|hλ|", "1 − growth per period");
    StringBuilder limits = new StringBuilder();
    boolean anyGrows = false;
    for (int order : orders) {
      context.at(integrator + ", order " + order, (double) order / 26);
      List<SolverChart.Value> up = new ArrayList<>();
      List<SolverChart.Value> down = new ArrayList<>();
      double neutral = 0;
      boolean stable = true;
      boolean everHeld = false;
      for (double size : SIZES) {
        Growth growth = growth(maker, order, size);
        double gain = growth.perPeriod() - 1;
        table.row(order, size, growth.order(), gain);
        if (growth.order() == order && Double.isFinite(gain) && gain != 0) {
          String hover = integrator + ", order " + order + ": " + StudyPage.shown(gain);
          (gain > 0 ? up : down).add(new SolverChart.Value(size, Math.abs(gain), hover));
        }
        stable &= gain < 1e-2;
        boolean held = growth.order() == order;
        everHeld |= held;
        neutral = stable && held ? size : neutral;
      }
      if (!up.isEmpty()) {
        anyGrows = true;
        grows.add("order " + order, up);
      }
      if (!down.isEmpty()) {
        decays.add("order " + order, down);
      }
      limits.append(limits.isEmpty() ? "" : ", ").append(order).append(": ");
      limits.append(
          !everHeld ? "not held" : neutral == 0 ? "below 0.01" : StudyPage.shown(neutral));
    }
    page.finds(
        "%s: largest |hλ| looked at up to which the amplitude grows by less than a hundredth per"
            + " period while the order is held, by order: %s."
            + " Not held: the integrator stays at a lower order, whose figures the table has.",
        integrator, limits);
    if (anyGrows) {
      page.shows(integrator + ": the amplitude grows", grows);
    }
    page.shows(integrator + ": the amplitude decays", decays);
  }

  private Growth growth(Function<IntegratorSettings, Integrator> maker, int order, double size) {
    double periods = context.quick() ? 20 : 200;
    double end = Math.max(2 * Math.PI * periods, 10 * WARM_UP_STEPS * size);
    IntegratorSettings settings =
        new IntegratorSettings(
            0.5, List.of(ACCEPTS_ALL), size, size, order, Long.MAX_VALUE, () -> false);
    Integrator integrator = maker.apply(settings);
    double[] y = {1, 0};
    double[] slope = new double[2];
    StepResult result = integrator.start(new Oscillator(1), 0, y, end);
    double from = Double.NaN;
    double fromTime = 0;
    double amplitude = 1;
    int steps = 0;
    while (result == StepResult.ADVANCED && amplitude < FAR && amplitude > 1 / FAR) {
      result = integrator.step();
      integrator.interpolate(integrator.time(), y, slope);
      amplitude = Math.hypot(y[0], y[1]);
      // A high order takes a while to be reached; an unstable one must be caught before that.
      if (++steps == WARM_UP_STEPS || (steps == 2 * order + 4 && size > 0.3)) {
        from = amplitude;
        fromTime = integrator.time();
      }
    }
    double turns = (integrator.time() - fromTime) / (2 * Math.PI);
    return new Growth(Math.pow(amplitude / from, 1 / turns), integrator.order());
  }
}

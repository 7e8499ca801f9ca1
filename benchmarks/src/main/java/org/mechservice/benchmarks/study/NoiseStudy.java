package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import org.mechservice.report.page.SolverChart;
import org.mechservice.solver.ode.Integrator;
import org.mechservice.solver.ode.IntegratorSettings;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.ResidualIntegrator;
import org.mechservice.solver.ode.ResidualSystem;
import org.mechservice.solver.ode.StepResult;
import org.mechservice.solver.ode.adams.De;
import org.mechservice.solver.ode.adams.Ode113;
import org.mechservice.solver.ode.stiff.Ode15s;
import org.mechservice.solver.ode.stiff.Ode15sR;

/** The effect of rounding noise in forces on the sequence of steps. */
final class NoiseStudy implements MethodStudy {
  private static final double[] NOISE = {0, 1e-16, 1e-14, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4};
  private static final double[] TOLERANCES = {1e-4, 1e-6, 1e-8, 1e-10};
  private static final long MOST_STEPS = 200_000;

  private final StudyContext context;

  NoiseStudy(StudyContext context) {
    this.context = context;
  }

  @Override
  public String name() {
    return "noise";
  }

  /** A pendulum whose force has a random relative error. */
  private static final class NoisyPendulum implements OdeSystem, ResidualSystem {
    private static final double GRAVITY = 9.81;
    private final double noise;

    NoisyPendulum(double noise) {
      this.noise = noise;
    }

    @Override
    public int dimension() {
      return 2;
    }

    @Override
    public void derivative(double t, double[] y, double[] yDot) {
      yDot[0] = y[1];
      yDot[1] = -GRAVITY * (Math.sin(y[0]) + noise * drawn(t, y[0], y[1]));
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      derivative(t, y, residual);
      residual[0] = yDot[0] - residual[0];
      residual[1] = yDot[1] - residual[1];
    }

    /** Depends on every bit of its arguments, and on nothing else: between −1 and 1. */
    private static double drawn(double t, double x, double v) {
      long bits = Double.doubleToRawLongBits(t);
      bits = 31 * bits + Double.doubleToRawLongBits(x);
      bits = 31 * bits + Double.doubleToRawLongBits(v);
      bits = (bits ^ (bits >>> 33)) * 0xff51afd7ed558ccdL;
      bits = (bits ^ (bits >>> 33)) * 0xc4ceb9fe1a85ec53L;
      return (double) ((bits ^ (bits >>> 33)) >> 11) / (double) (1L << 52);
    }
  }

  private record Cost(long steps, long rejected, boolean ended, double error) {}

  @Override
  public void measure(StudyPage page) {
    page.title("Rounding noise in forces");
    page.notes(
        "A pendulum of 1 m from 1 rad, 10 s. The force is wrong by noise × its largest value, drawn"
            + " anew for every argument. Error: against the same integrator without noise. Runs end"
            + " after %d steps.",
        MOST_STEPS);
    Map<String, Function<IntegratorSettings, Integrator>> makers = new TreeMap<>();
    makers.put("DE", De::new);
    makers.put("ode113", Ode113::new);
    makers.put("ode15s", Ode15s::new);
    makers.put("ode15sR", Ode15sR::new);
    StudyPage.Table table =
        page.table(
            "Steps", "integrator", "tolerance", "noise", "steps", "× without", "rejected", "error");
    SolverChart chart = new SolverChart("noise ÷ tolerance", "steps, times those without noise");
    makers.forEach((name, maker) -> measure(page, table, chart, name, maker));
    page.shows("Steps against noise, all tolerances together", chart);
  }

  private void measure(
      StudyPage page,
      StudyPage.Table table,
      SolverChart chart,
      String name,
      Function<IntegratorSettings, Integrator> maker) {
    List<SolverChart.Value> values = new ArrayList<>();
    double harmless = Double.POSITIVE_INFINITY;
    double worst = 1;
    for (double tolerance : TOLERANCES) {
      context.at(name + " at " + StudyContext.number(tolerance), 0.5);
      double[] clean = new double[2];
      Cost without = run(maker, 0, tolerance, clean, clean);
      for (double noise : NOISE) {
        Cost with = run(maker, noise, tolerance, clean, new double[2]);
        double times = with.ended() ? (double) with.steps() / without.steps() : Double.NaN;
        table.row(name, tolerance, noise, with.steps(), times, with.rejected(), with.error());
        double ratio = noise / tolerance;
        if (!(times < 1.5)) {
          harmless = Math.min(harmless, ratio);
        }
        if (noise > 0 && with.ended()) {
          worst = Math.max(worst, times);
          String hover =
              name
                  + " at "
                  + StudyContext.number(tolerance)
                  + ", noise "
                  + StudyContext.number(noise);
          values.add(new SolverChart.Value(ratio, times, hover));
        }
      }
    }
    values.sort(java.util.Comparator.comparingDouble(SolverChart.Value::cost));
    chart.add(name, values);
    page.finds(
        Double.isInfinite(harmless)
            ? "%s: no noise looked at costs half as many steps again (at most %.2f times)."
            : "%s: noise costs half as many steps again from %3$.0e of the tolerance on (at most"
                + " %2$.1f times the steps without).",
        name,
        worst,
        harmless);
  }

  private static Cost run(
      Function<IntegratorSettings, Integrator> maker,
      double noise,
      double tolerance,
      double[] clean,
      double[] end) {
    IntegratorSettings settings =
        new IntegratorSettings(
            tolerance, List.of(tolerance), Double.POSITIVE_INFINITY, 0, 0, MOST_STEPS, () -> false);
    Integrator integrator = maker.apply(settings);
    NoisyPendulum pendulum = new NoisyPendulum(noise);
    double[] start = {1, 0};
    double[] slope = new double[2];
    pendulum.derivative(0, start, slope);
    double tEnd = 10;
    StepResult result =
        integrator instanceof ResidualIntegrator residual
            ? residual.start(pendulum, 0, start, slope, tEnd)
            : integrator.start(pendulum, 0, start, tEnd);
    while (result == StepResult.ADVANCED) {
      result = integrator.step();
    }
    long steps = integrator.statistics().steps();
    long rejected = integrator.statistics().rejectedSteps();
    if (result != StepResult.REACHED_END) {
      return new Cost(steps, rejected, false, Double.NaN);
    }
    double[] y = new double[2];
    integrator.interpolate(tEnd, y, slope);
    double error = Math.max(Math.abs(y[0] - clean[0]), Math.abs(y[1] - clean[1]));
    System.arraycopy(y, 0, end, 0, 2);
    return new Cost(steps, rejected, true, error);
  }
}

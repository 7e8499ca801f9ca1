package org.mechservice.benchmarks.study;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.client.MechSession;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.page.SolverChart;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.linear.spectrum.SingularValues;

/** Digits lost in accelerations against the condition of the mass matrix. */
final class ConditionStudy implements MethodStudy {
  private static final double[] RATIOS = {1e-8, 1e-6, 1e-4, 1e-2, 1, 1e2, 1e4, 1e6, 1e8};
  private static final int[] LENGTHS = {2, 5, 10, 20, 50, 100, 200};
  private static final double EPSILON = Math.ulp(1.0) / 2;

  private final StudyContext context;

  ConditionStudy(StudyContext context) {
    this.context = context;
  }

  @Override
  public String name() {
    return "condition";
  }

  /** One chain: condition, difference of two algorithms, residual each leaves. */
  private record Loss(double condition, double apart, double backwardDtr, double backwardDsr) {
    double digits() {
      return Math.max(0, Math.log10(apart / EPSILON));
    }
  }

  @Override
  public void measure(StudyPage page) {
    page.title("Digits lost against condition");
    page.notes(
        "Chains of bars of 1 m, hinges at 0.3 rad, velocities between −1 and 1 rad/s. Condition: of"
            + " D M D with D = diag(M)^(−½). Forward: largest difference between the accelerations"
            + " of DTR and DSR over the largest acceleration; digits lost: its logarithm over half"
            + " an ulp. Backward: ‖M a + b − τ‖ / (‖M‖ ‖a‖ + ‖b − τ‖), by the residual of RR.");
    StudyPage.Table byMass =
        page.table(
            "Mass ratio, 5 bars",
            "last ÷ first",
            "condition",
            "forward",
            "digits lost",
            "backward DTR",
            "backward DSR");
    SolverChart chart = new SolverChart("condition of D M D", "difference of DTR and DSR");
    double worstBackward = 0;
    double worstDigits = 0;
    List<SolverChart.Value> values = new ArrayList<>();
    for (double ratio : RATIOS) {
      context.at("mass ratio " + StudyContext.number(ratio), 0.3);
      Loss loss = loss(new BarChain(5, 1, ratio, 0, 0, 0.3, 1));
      row(byMass, ratio, loss);
      values.add(value(loss, "mass ratio " + StudyContext.number(ratio)));
      worstBackward = Math.max(worstBackward, Math.max(loss.backwardDtr(), loss.backwardDsr()));
      worstDigits = Math.max(worstDigits, loss.digits());
    }
    values.sort(java.util.Comparator.comparingDouble(SolverChart.Value::cost));
    chart.add("mass ratio 1e-8 … 1e8", values);
    page.finds(
        "Mass ratios from 1e-8 to 1e8 along five bars cost %.1f digits at most.", worstDigits);
    StudyPage.Table byLength =
        page.table(
            "Length, equal bars",
            "bars",
            "condition",
            "forward",
            "digits lost",
            "backward DTR",
            "backward DSR");
    List<SolverChart.Value> lengths = new ArrayList<>();
    double lastDigits = 0;
    int longest = context.quick() ? 50 : 200;
    for (int bars : LENGTHS) {
      if (bars <= longest) {
        context.at(bars + " bars", 0.7);
        Loss loss = loss(new BarChain(bars, 1, 1, 0, 0, 0.3, 1));
        row(byLength, bars, loss);
        lengths.add(value(loss, bars + " bars"));
        worstBackward = Math.max(worstBackward, Math.max(loss.backwardDtr(), loss.backwardDsr()));
        lastDigits = loss.digits();
      }
    }
    chart.add("2 … " + longest + " bars", lengths);
    page.finds("A chain of %d bars costs %.1f digits.", longest, lastDigits);
    page.finds(
        "Whatever the condition, what is solved is solved to rounding: the backward error is %.1e"
            + " at most.",
        worstBackward);
    page.shows("Forward difference against condition", chart);
  }

  private static void row(StudyPage.Table table, Object what, Loss loss) {
    table.row(
        what,
        loss.condition(),
        loss.apart(),
        loss.digits(),
        loss.backwardDtr(),
        loss.backwardDsr());
  }

  private static SolverChart.Value value(Loss loss, String hover) {
    return new SolverChart.Value(loss.condition(), Math.max(loss.apart(), 1e-17), hover);
  }

  private Loss loss(BarChain chain) {
    return context.with(chain.text(), ConditionStudy::loss);
  }

  private static Loss loss(MechSession session) {
    ExplicitModel dtr = (ExplicitModel) model(session, "DTR", "ode113");
    ExplicitModel dsr = (ExplicitModel) model(session, "DSR", "ode113");
    ResidualModel rr = (ResidualModel) model(session, "RR", "ode15sR");
    int n = rr.description().velocityCount();
    double[] y = new double[2 * n];
    rr.initialState(y);
    for (int i = 0; i < n; i++) {
      y[n + i] = Math.sin(7.0 * (i + 1));
    }
    double[] first = new double[2 * n];
    double[] second = new double[2 * n];
    dtr.derivative(0, y, first);
    dsr.derivative(0, y, second);
    double[] bias = column(rr, y, -1);
    double[] mass = new double[n * n];
    double norm = 0;
    for (int j = 0; j < n; j++) {
      double[] column = column(rr, y, j);
      for (int i = 0; i < n; i++) {
        mass[i * n + j] = column[n + i] - bias[n + i];
        norm = Math.max(norm, Math.abs(mass[i * n + j]) * n);
      }
    }
    double largest = 0;
    double apart = 0;
    for (int i = n; i < 2 * n; i++) {
      largest = Math.max(largest, Math.abs(first[i]));
      apart = Math.max(apart, Math.abs(first[i] - second[i]));
    }
    return new Loss(
        condition(n, mass),
        apart / largest,
        backward(rr, y, first, norm, bias),
        backward(rr, y, second, norm, bias));
  }

  private static Model model(MechSession session, String formulation, String integrator) {
    SimulationMethod method = new SimulationMethod(formulation, MethodNames.NONE, integrator);
    return StudyContext.compact(session, method).models().get();
  }

  /** The residual with a unit acceleration, or with none for −1. */
  private static double[] column(ResidualModel model, double[] y, int unit) {
    int n = y.length / 2;
    double[] slope = new double[2 * n];
    System.arraycopy(y, n, slope, 0, n);
    if (unit >= 0) {
      slope[n + unit] = 1;
    }
    double[] residual = new double[2 * n];
    model.residual(0, y, slope, residual);
    return residual;
  }

  private static double backward(
      ResidualModel model, double[] y, double[] slope, double norm, double[] bias) {
    int n = y.length / 2;
    double[] residual = new double[2 * n];
    model.residual(0, y, slope, residual);
    double left = 0;
    double acceleration = 0;
    double force = 0;
    for (int i = n; i < 2 * n; i++) {
      left = Math.max(left, Math.abs(residual[i]));
      acceleration = Math.max(acceleration, Math.abs(slope[i]));
      force = Math.max(force, Math.abs(bias[i]));
    }
    return left / (norm * acceleration + force);
  }

  private static double condition(int n, double[] mass) {
    double[] scaled = new double[n * n];
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        scaled[i * n + j] = mass[i * n + j] / Math.sqrt(mass[i * n + i] * mass[j * n + j]);
      }
    }
    SingularValues values = new SingularValues(n, n);
    values.decompose(scaled);
    return values.value(0) / values.value(n - 1);
  }
}

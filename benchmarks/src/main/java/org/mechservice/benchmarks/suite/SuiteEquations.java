package org.mechservice.benchmarks.suite;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.ResidualSystem;

/** A problem of the suite as equations, in explicit form where it has one, and in residual form. */
final class SuiteEquations implements OdeSystem, ResidualSystem {
  private final ProblemFile problem;
  private final int n;
  private final Map<String, Integer> slots = new HashMap<>();
  private final double[] values;
  private final List<Formula.Node> aux = new ArrayList<>();
  private final List<Formula.Node> right = new ArrayList<>();
  private final List<Formula.Node> residuals = new ArrayList<>();
  private final List<Entry> mass = new ArrayList<>();
  private final DenseLu lu;
  private final double[] matrix;
  private final int firstAux;

  private record Entry(int row, int column, Formula.Node value) {}

  SuiteEquations(ProblemFile problem) {
    this.problem = problem;
    n = problem.n;
    slots.put("t", 0);
    for (int i = 0; i < n; i++) {
      slots.put("y" + i, 1 + i);
      slots.put("yp" + i, 1 + n + i);
    }
    int next = 1 + 2 * n;
    for (String name : problem.params.keySet()) {
      slots.put(name, next++);
    }
    firstAux = next;
    for (ProblemFile.Named one : problem.aux) {
      slots.put(one.name(), next++);
    }
    values = new double[next];
    problem.params.forEach((name, text) -> values[slot(name)] = formula(text).at(values));
    problem.aux.forEach(one -> aux.add(formula(one.expr())));
    problem.rhs.forEach(text -> right.add(formula(text)));
    problem.residual.forEach(text -> residuals.add(formula(text)));
    for (ProblemFile.MassElement element : problem.mass) {
      mass.add(new Entry(element.i(), element.j(), formula(element.expr())));
    }
    lu = new DenseLu(n);
    matrix = new double[n * n];
  }

  private int slot(String name) {
    return slots.getOrDefault(name, -1);
  }

  private Formula.Node formula(String text) {
    return Formula.of(text, this::slot);
  }

  /** Returns the value of an expression of the problem's parameters. */
  double number(String text) {
    return formula(text).at(values);
  }

  @Override
  public int dimension() {
    return n;
  }

  @Override
  public Component component(int index) {
    return problem.algebraic.contains(index) ? Component.ALGEBRAIC : Component.DIFFERENTIAL;
  }

  private void place(double t, double[] y) {
    values[0] = t;
    System.arraycopy(y, 0, values, 1, n);
    for (int i = 0; i < aux.size(); i++) {
      values[firstAux + i] = aux.get(i).at(values);
    }
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    place(t, y);
    for (int i = 0; i < n; i++) {
      yDot[i] = right.get(i).at(values);
    }
    if (mass.isEmpty()) {
      return;
    }
    java.util.Arrays.fill(matrix, 0);
    for (Entry entry : mass) {
      matrix[lu.layout().index(entry.row(), entry.column())] = entry.value().at(values);
    }
    if (lu.factor(matrix) == LinearSolver.NONSINGULAR) {
      lu.solve(yDot);
    } else {
      java.util.Arrays.fill(yDot, Double.NaN);
    }
  }

  @Override
  public void residual(double t, double[] y, double[] yDot, double[] residual) {
    place(t, y);
    System.arraycopy(yDot, 0, values, 1 + n, n);
    for (int i = 0; i < residuals.size(); i++) {
      residual[i] = residuals.get(i).at(values);
    }
    for (int i = 0; i < right.size(); i++) {
      residual[i] = (mass.isEmpty() ? yDot[i] : 0) - right.get(i).at(values);
    }
    for (Entry entry : mass) {
      residual[entry.row()] += entry.value().at(values) * yDot[entry.column()];
    }
  }
}

package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.force.formula.ExpressionInputs;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.system.LinearSystem;

/**
 * The linear system x' = A x + B u, y = C x + D u of a linearised mechanism. Its states are the
 * displacements and velocities of the independent coordinates and the integrated further states,
 * its inputs the inputs of the model, its outputs those of the model's author, or the displacements
 * of all coordinates if there are none.
 *
 * <p>A and B are analytic. C and D are derivatives of the outputs: by further states and inputs
 * analytic, by displacements and velocities central differences of two steps, extrapolated.
 */
final class LinearSystems {
  private static final double STEP = 0x1p-14;

  private final EquationsOfMotion equations;
  private final Linearisation linear;
  private final double t;
  private final double[] y;
  private final CoordinateNames names;
  private final List<Output> outputs;
  private final int fq;
  private final int ofMotion;
  private final int size;
  private final List<Integer> states = new ArrayList<>();
  private final List<Integer> inputs = new ArrayList<>();

  private LinearSystems(
      EquationsOfMotion equations,
      Linearisation linear,
      double t,
      double[] y,
      List<Output> outputs) {
    this.equations = equations;
    this.linear = linear;
    this.t = t;
    this.y = y;
    this.outputs = outputs;
    names = new CoordinateNames(equations.tree.mechanism());
    fq = linear.placeCount();
    ofMotion = fq + linear.freedom();
    size = linear.order();
    for (int i = 0; i < ofMotion; i++) {
      states.add(i);
    }
    List<FurtherState> further = equations.tree.mechanism().furtherStates();
    for (int k = 0; k < further.size(); k++) {
      switch (further.get(k).role()) {
        case INTEGRATED -> states.add(ofMotion + k);
        case INPUT -> inputs.add(ofMotion + k);
        case SAMPLED -> {} // constant between two samples
      }
    }
  }

  /**
   * Returns the system.
   *
   * @param matrix as {@link Linearisation#system} returned it, not empty
   * @param y state of the linearisation; not modified
   */
  static LinearSystem of(
      EquationsOfMotion equations,
      Linearisation linear,
      double[] matrix,
      double t,
      double[] y,
      List<Output> outputs) {
    return new LinearSystems(equations, linear, t, y, outputs).system(matrix);
  }

  private LinearSystem system(double[] matrix) {
    List<Variable> ofOutputs = new ArrayList<>();
    double[] slopes;
    if (outputs.isEmpty()) {
      for (int j = 0; j < names.count(); j++) {
        ofOutputs.add(new Variable(names.name(j), names.unit(j)));
      }
      slopes = displacements();
    } else {
      outputs.forEach(output -> ofOutputs.add(new Variable(output.name(), output.unit())));
      slopes = slopes();
    }
    return new LinearSystem(
        states.stream().map(this::variable).toList(),
        inputs.stream().map(this::variable).toList(),
        ofOutputs,
        part(matrix, states, states),
        part(matrix, states, inputs),
        part(slopes, rows(ofOutputs.size()), states),
        part(slopes, rows(ofOutputs.size()), inputs));
  }

  private static List<Integer> rows(int count) {
    List<Integer> rows = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      rows.add(i);
    }
    return rows;
  }

  private double[] part(double[] matrix, List<Integer> rows, List<Integer> columns) {
    double[] part = new double[rows.size() * columns.size()];
    int next = 0;
    for (int row : rows) {
      for (int column : columns) {
        part[next++] = matrix[row * size + column];
      }
    }
    return part;
  }

  private Variable variable(int component) {
    if (component >= ofMotion) {
      FurtherState state = equations.tree.mechanism().furtherStates().get(component - ofMotion);
      return new Variable(state.name(), state.unit());
    }
    int velocity =
        component < fq
            ? linear.independentPlaces()[component]
            : linear.independent()[component - fq];
    return component < fq
        ? new Variable(names.name(velocity) + ".q", names.unit(velocity))
        : new Variable(names.name(velocity) + ".v", names.unit(velocity) + "/s");
  }

  /** Returns the displacements of all coordinates as outputs, in columns of all components. */
  private double[] displacements() {
    double[] slopes = new double[names.count() * size];
    double[] z = new double[fq];
    double[] xi = new double[names.count()];
    for (int j = 0; j < fq; j++) {
      z[j] = 1;
      linear.expandPlaces(z, xi);
      z[j] = 0;
      for (int i = 0; i < xi.length; i++) {
        slopes[i * size + j] = xi[i];
      }
    }
    return slopes;
  }

  /** Returns the derivatives of the outputs by all components. */
  private double[] slopes() {
    ExpressionInputs values =
        new ExpressionInputs(equations.motion, outputs.stream().map(Output::value).toList());
    double[] slopes = new double[outputs.size() * size];
    double[] coarse = new double[outputs.size()];
    double[] fine = new double[outputs.size()];
    for (int j = 0; j < ofMotion; j++) {
      difference(values, j, STEP, coarse);
      difference(values, j, STEP / 2, fine);
      for (int i = 0; i < fine.length; i++) {
        slopes[i * size + j] = fine[i] + (fine[i] - coarse[i]) / 3;
      }
    }
    equations.motion.sweep(t, y);
    values.evaluate(t);
    values.differentiate();
    for (int i = 0; i < fine.length; i++) {
      for (int k = 0; k < linear.furtherCount(); k++) {
        slopes[i * size + ofMotion + k] = values.byState(i, k);
      }
    }
    return slopes;
  }

  private void difference(ExpressionInputs values, int component, double h, double[] slopes) {
    double[] plus = moved(values, component, h);
    double[] minus = moved(values, component, -h);
    for (int i = 0; i < slopes.length; i++) {
      slopes[i] = (plus[i] - minus[i]) / (2 * h);
    }
  }

  private double[] moved(ExpressionInputs values, int component, double h) {
    double[] other = y.clone();
    double[] z = new double[ofMotion];
    double[] xi = new double[names.count()];
    if (component < fq) {
      z[component] = 1;
      linear.expandPlaces(z, xi);
      equations.coordinates.move(other, 0, xi, 0, h);
      linear.velocityByPlace(component, xi);
    } else {
      z[component - fq] = 1;
      linear.expand(z, xi);
    }
    for (int i = 0; i < xi.length; i++) {
      other[equations.nq + i] += h * xi[i];
    }
    equations.motion.sweep(t, other);
    values.evaluate(t);
    double[] found = new double[outputs.size()];
    for (int i = 0; i < found.length; i++) {
      found[i] = values.value(i);
    }
    return found;
  }
}

package org.mechservice.study.gradient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.DoubleFunction;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.sim.gradient.ModelFunctions;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.ode.solve.IntegrationException;
import org.mechservice.solver.text.ShortestDecimal;
import org.mechservice.study.ModelInputs;
import org.mechservice.study.Reduction;

/**
 * Values of outputs of a run, and their derivatives by parameters and start values.
 *
 * <pre>{@code
 * Gradients gradients =
 *     Gradients.of(model, List.of("k", "c"), List.of(Reduction.parse("max(height.q)")));
 * Gradient found = gradients.compute(GradientMethod.AUTO);
 * double byStiffness = found.derivatives()[0][0];
 * }</pre>
 *
 * <p>Integrals and extremes are those of the motion, not of its rows. Parameters that can be inputs
 * of the code are differentiated exactly, in the program of the equations; of those that are folded
 * into it, such as masses and points, and of the assembly of loops, differences of fourth order are
 * taken at fixed states, whose error is some 1e-10 of the derivative. The tolerances of the run
 * hold for the derivatives too.
 *
 * <p>Workspace of one thread.
 */
public final class Gradients {
  /** Step of the differences, as a part of the value. */
  static final double STEP = 1e-3;

  /**
   * As {@link #STEP} where the forces have switches: near them differences are one-sided and of
   * second order.
   */
  private static final double STEP_AT_SWITCHES = 1e-5;

  /** Places of differences of fourth order, in steps. */
  private static final double[] SIDES = {-2, -1, 1, 2};

  /** Part by which differences of second and fourth order may differ of a smooth start. */
  private static final double SMOOTH = 1e-3;

  /** To what a start is known, m or rad: assembly ends some digits before rounding. */
  private static final double ROUNDING = 1e-10;

  private static final int MOST_VALUES = 20_000;
  private static final long MEMORY = 256L << 20;

  /** Cost of a tangent, and of the way back, in runs. */
  private static final double TANGENT = 1.5;

  private static final double WAY_BACK = 3;

  private final MechModel model;
  private final List<String> by;
  private final List<Reduction> reductions;
  private final Set<String> tunable;
  private final RunSettings run;
  private final ModelFunctions functions;
  private final int[] chosen;
  private final List<List<ModelFunctions>> beside;
  private final List<String> columns;
  private final List<GradientOutput> wanted;
  private final List<String> units;
  private final List<String> names;
  private long memory = MEMORY;

  private Gradients(
      MechModel model, List<String> by, List<Reduction> reductions, Set<String> tunable)
      throws MechmlException {
    this.model = model;
    this.by = by;
    this.tunable = tunable;
    this.run = model.request().settings();
    this.reductions = expanded(reductions, run);
    columns = this.reductions.stream().map(Reduction::column).distinct().toList();
    List<String> inputs =
        model.content().mechanism().parameters().stream().map(Parameter::name).toList();
    chosen = by.stream().filter(tunable::contains).mapToInt(inputs::indexOf).toArray();
    functions = new ModelFunctions(model.content(), run, columns, chosen);
    wanted =
        this.reductions.stream()
            .map(r -> new GradientOutput(columns.indexOf(r.column()), r))
            .toList();
    units = this.reductions.stream().map(r -> unit(r, functions.unit(r.column()))).toList();
    names = this.reductions.stream().map(Reduction::toString).toList();
    beside = new ArrayList<>();
    for (String name : by) {
      beside.add(isSettled(name) ? shifted(name) : List.of());
    }
  }

  private boolean isSettled(String name) {
    return isParameter(model, name) && !tunable.contains(name);
  }

  private static boolean isParameter(MechModel model, String name) {
    return model.parameters().stream().anyMatch(p -> p.name().equals(name));
  }

  private ModelParameter parameter(String name) {
    return model.parameters().stream().filter(p -> p.name().equals(name)).findFirst().orElseThrow();
  }

  private List<ModelFunctions> shifted(String name) throws MechmlException {
    List<ModelFunctions> models = new ArrayList<>();
    double value = parameter(name).value();
    for (double side : SIDES) {
      MechModel other = moved(name, value + side * step(value));
      RunSettings its = other.request().settings();
      if (its.tStart() != run.tStart() || its.tEnd() != run.tEnd()) {
        throw new IllegalArgumentException(
            "start or end of the run depends on \""
                + name
                + "\"; there is no gradient by it. Write an event that ends the run instead");
      }
      ModelFunctions moved = new ModelFunctions(other.content(), run, columns, chosen);
      if (moved.switches().count() != functions.switches().count()) {
        throw new IllegalArgumentException(
            "there is no gradient by \""
                + name
                + "\": beside its value the forces have another number of signs, steps and"
                + " contacts");
      }
      models.add(moved);
    }
    return models;
  }

  private MechModel moved(String name, double value) {
    try {
      return model.set(name, value);
    } catch (MechmlException e) {
      throw new IllegalArgumentException(
          "there is no gradient by \""
              + name
              + "\": at "
              + ShortestDecimal.format(value)
              + ", beside its value, the model cannot be used: "
              + e.getMessage(),
          e);
    }
  }

  private static double size(double value) {
    return value == 0 ? 1 : Math.abs(value);
  }

  private double step(double value) {
    boolean switching = functions.switches().count() > 0 && !functions.assembles();
    return (switching ? STEP_AT_SWITCHES : STEP) * size(value);
  }

  /**
   * Prepares derivatives of a model.
   *
   * @param by parameters of the file, and components of the start by the names of their columns,
   *     such as {@code crank.v}
   * @param outputs what is differentiated
   * @throws MechmlException if the model cannot be read with the parameters as inputs
   * @throws IllegalArgumentException if there is no such parameter or column, or the model has a
   *     part without derivative; names it
   */
  public static Gradients of(MechModel model, List<String> by, List<Reduction> outputs)
      throws MechmlException {
    if (by.isEmpty() || outputs.isEmpty()) {
      throw new IllegalArgumentException("a gradient is of at least one output by one parameter");
    }
    if (new LinkedHashSet<>(by).size() < by.size()) {
      throw new IllegalArgumentException("a parameter is given twice");
    }
    List<String> parameters = by.stream().filter(name -> isParameter(model, name)).toList();
    ModelInputs inputs = ModelInputs.of(model, parameters);
    return new Gradients(inputs.model(), List.copyOf(by), outputs, inputs.names());
  }

  /** Sets the bound of the memory in which the adjoint keeps the motion, bytes. */
  public Gradients memory(long bytes) {
    memory = bytes;
    return this;
  }

  /** Returns the outputs, a series as its single values. */
  public List<Reduction> outputs() {
    return reductions;
  }

  /** Returns the parameters that are inputs of the equations. */
  public Set<String> tunable() {
    return Set.copyOf(tunable);
  }

  /**
   * Sets the value of a parameter that is an input.
   *
   * @param value in the unit of the file
   */
  public Gradients set(String name, double value) {
    List<Parameter> inputs = model.content().mechanism().parameters();
    for (int i = 0; i < inputs.size(); i++) {
      if (inputs.get(i).name().equals(name)) {
        double si = inputs.get(i).with(value).value();
        functions.parameters()[i] = si;
        for (List<ModelFunctions> models : beside) {
          for (ModelFunctions other : models) {
            other.parameters()[i] = si;
          }
        }
        return this;
      }
    }
    throw new IllegalArgumentException("\"" + name + "\" is no input of the equations");
  }

  /**
   * Computes values and derivatives.
   *
   * @throws IllegalArgumentException if a result has no derivative; says where and why
   * @throws org.mechservice.solver.ode.solve.IntegrationException if the motion, or a derivative,
   *     cannot be integrated to its end
   */
  public Gradient compute(GradientMethod method) {
    GradientModel equations = new GradientModel(functions, directions());
    double forward = 1 + TANGENT * by.size();
    double adjoint = 1 + WAY_BACK * wanted.size();
    boolean chooseAdjoint =
        method == GradientMethod.ADJOINT || (method == GradientMethod.AUTO && adjoint < forward);
    String reason =
        method == GradientMethod.AUTO
            ? String.format(
                Locale.ROOT,
                "%s by %s: about %.1f runs forward, %.1f adjoint",
                counted(wanted.size(), "output"),
                counted(by.size(), "parameter"),
                forward,
                adjoint)
            : "as asked for";
    double[] start = functions.start();
    if (chooseAdjoint || method == GradientMethod.FORWARD || functions.switches().count() == 0) {
      return gradient(equations, start, chooseAdjoint, reason);
    }
    try {
      return gradient(equations, start, false, reason);
    } catch (IntegrationException e) {
      // The equations of tangents jump at a touch by stiffness times tangent, more than a step can
      // pass over at tight tolerances. On the way back steps end there.
      GradientModel again = new GradientModel(functions, directions());
      return gradient(again, start, true, reason + "; forward steps do not pass a contact");
    }
  }

  private Gradient gradient(
      GradientModel equations, double[] start, boolean chooseAdjoint, String reason) {
    Outcomes found =
        chooseAdjoint
            ? new AdjointRun(equations, wanted, run, memory).run(start)
            : new ForwardRun(equations, wanted, run).run(start);
    double[][] derivatives = new double[wanted.size()][by.size()];
    for (int i = 0; i < derivatives.length; i++) {
      for (int k = 0; k < by.size(); k++) {
        derivatives[i][k] = found.slopes()[i][k] * equations.directions.get(k).factor();
      }
    }
    return new Gradient(
        names,
        units,
        by,
        equations.directions.stream().map(Direction::unit).toList(),
        found.values(),
        derivatives,
        chooseAdjoint ? GradientMethod.ADJOINT : GradientMethod.FORWARD,
        reason,
        found.steps(),
        by.stream().filter(this::isSettled).toList());
  }

  private static String counted(int count, String what) {
    return count + " " + what + (count == 1 ? "" : "s");
  }

  private List<Direction> directions() {
    List<Direction> directions = new ArrayList<>();
    int input = 0;
    double[] start = functions.start();
    for (int k = 0; k < by.size(); k++) {
      String name = by.get(k);
      if (tunable.contains(name)) {
        directions.add(ofInput(name, input++));
      } else if (isSettled(name)) {
        double value = parameter(name).value();
        double h = step(value);
        List<ModelFunctions> models = beside.get(k);
        double[] byIt =
            difference(name, h, side -> models.get(Arrays.binarySearch(SIDES, side)).start());
        directions.add(
            new Direction(name, parameter(name).unit(), 1, size(value), -1, h, models, byIt));
      } else {
        directions.add(ofStart(name, start));
      }
    }
    return directions;
  }

  private Direction ofInput(String name, int input) {
    Parameter parameter = model.content().mechanism().parameters().get(chosen[input]);
    double value = functions.parameters()[chosen[input]];
    double h = step(value);
    double[] byIt =
        functions.assembles()
            ? difference(name, h, side -> functions.startWith(chosen[input], value + side * h))
            : new double[functions.equations().states()];
    return new Direction(
        name,
        parameter.unitInFile(),
        parameter.numerator() / parameter.denominator(),
        size(value),
        input,
        0,
        List.of(),
        byIt);
  }

  private Direction ofStart(String name, double[] start) {
    Optional<Integer> component = functions.state(name);
    if (component.isEmpty()) {
      List<String> known =
          new ArrayList<>(model.parameters().stream().map(ModelParameter::name).toList());
      known.addAll(functions.stateNames());
      throw new IllegalArgumentException(
          "the model has no parameter and no start value \""
              + name
              + '"'
              + NearestName.suggestion(name, known)
              + (known.isEmpty() ? "" : "; it has " + String.join(", ", known)));
    }
    int at = component.get();
    double[] byIt = new double[start.length];
    if (functions.assembles()) {
      byIt = difference(name, STEP, side -> functions.startMoved(at, side * STEP));
    } else {
      byIt[at] = 1;
    }
    String unit = functions.stateUnits().get(at);
    return new Direction(name, unit, 1, size(start[at]), -1, 0, List.of(), byIt);
  }

  /** Returns the derivative of the start by differences. */
  private static double[] difference(String name, double h, DoubleFunction<double[]> start) {
    double[][] at = new double[SIDES.length][];
    Arrays.setAll(at, i -> start.apply(SIDES[i]));
    double[] slope = new double[at[0].length];
    double largest = 0;
    double farthest = 0;
    for (int i = 0; i < slope.length; i++) {
      double near = (at[2][i] - at[1][i]) / (2 * h);
      slope[i] = (4 * near - (at[3][i] - at[0][i]) / (4 * h)) / 3;
      largest = Math.max(largest, Math.abs(slope[i]));
      farthest = Math.max(farthest, Math.abs(slope[i] - near));
    }
    if (farthest > SMOOTH * largest && farthest > ROUNDING / h) {
      throw new IllegalArgumentException(
          "the start of the run does not depend smoothly on \""
              + name
              + "\": its loops are closed in different ways close by; give the start of more joints"
              + " so that the loops are nearly closed");
    }
    return slope;
  }

  private static String unit(Reduction reduction, String unit) {
    return switch (reduction.kind()) {
      case CROSSING -> "s";
      case INTEGRAL -> unit.equals("1") ? "s" : unit + "·s";
      case LAST, AT, MIN, MAX, MEAN, RMS, SERIES -> unit;
    };
  }

  private static List<Reduction> expanded(List<Reduction> reductions, RunSettings run) {
    List<Reduction> single = new ArrayList<>();
    for (Reduction reduction : reductions) {
      if (!reduction.fits(run.tStart(), run.tEnd())) {
        throw new IllegalArgumentException(
            reduction
                + " is outside the run, which is from "
                + ShortestDecimal.format(run.tStart())
                + " s to "
                + ShortestDecimal.format(run.tEnd())
                + " s");
      } else if (reduction.kind() != Reduction.Kind.SERIES) {
        single.add(reduction);
        continue;
      }
      double distance = Double.isNaN(reduction.argument()) ? run.tStep() : reduction.argument();
      double count = Math.floor((run.tEnd() - run.tStart()) / distance * (1 + 1e-12));
      if (count > MOST_VALUES) {
        throw new IllegalArgumentException(
            reduction + " has " + (long) count + " values; at most " + MOST_VALUES + " are kept");
      }
      for (int i = 0; i <= count; i++) {
        double time = Math.min(run.tEnd(), run.tStart() + i * distance);
        single.add(new Reduction(reduction.column(), Reduction.Kind.AT, time));
      }
    }
    return List.copyOf(single);
  }
}

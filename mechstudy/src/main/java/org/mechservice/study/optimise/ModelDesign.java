package org.mechservice.study.optimise;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.DoubleBuffer;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.ModelParameter;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.study.PointModel;
import org.mechservice.study.PointOutcome;
import org.mechservice.study.Reduction;
import org.mechservice.study.gradient.RowGradients;

/**
 * A design problem about a model, put together from texts: what to minimise, what to hold. A
 * formula may name reductions of outputs and parameters of the model.
 */
public final class ModelDesign {
  /** Step of the differences of formulas, a part of a variable's range: the cube root of 1e-16. */
  private static final double FORMULA_STEP = 1e-5;

  /** Rows of extremes beyond which these are taken as smooth: a simplex of them is no program. */
  private static final int MOST_ROWS = 10_000;

  /** Points whose quantities are kept: those of the differences of twenty variables. */
  private static final int KNOWN_POINTS = 64;

  private static final Pattern RELATION = Pattern.compile("<=|>=|==|<|>|=");

  /** A formula less another, and its aim. */
  private record AimFormula(
      Aim aim, ReductionExpression left, ReductionExpression right, double sign) {
    double value(double[] reduced, Map<String, Double> parameters) {
      return sign * (left.value(reduced, parameters) - right.value(reduced, parameters));
    }
  }

  private final MechModel model;
  private final List<DesignVariable> variables;
  private final Map<String, Double> fixed;
  private final List<Reduction> reductions = new ArrayList<>();
  private final List<AimFormula> wanted = new ArrayList<>();

  /**
   * @param model the model, with the values of the parameters that are not changed
   * @param variables parameters that may be changed
   */
  public ModelDesign(MechModel model, List<DesignVariable> variables) {
    this.model = model;
    this.variables = List.copyOf(variables);
    fixed =
        model.parameters().stream()
            .collect(Collectors.toMap(ModelParameter::name, ModelParameter::value));
  }

  /**
   * Adds a formula that is to be small.
   *
   * @throws IllegalArgumentException if it cannot be read
   */
  public ModelDesign minimise(String formula) {
    return add(Aim.Kind.MINIMISE, formula, formula, "0", 1);
  }

  /**
   * Adds a formula that is to be large: its negative value is minimised.
   *
   * @throws IllegalArgumentException if it cannot be read
   */
  public ModelDesign maximise(String formula) {
    return add(Aim.Kind.MINIMISE, "-(" + formula + ")", formula, "0", -1);
  }

  /**
   * Adds a formula whose square is one term of the sum to be minimised; {@code a = b} means a - b.
   *
   * @throws IllegalArgumentException if it cannot be read
   */
  public ModelDesign residual(String formula) {
    Matcher relation = RELATION.matcher(formula);
    if (!relation.find()) {
      return add(Aim.Kind.RESIDUAL, formula, formula, "0", 1);
    } else if (!relation.group().contains("=") || relation.group().matches("[<>]=")) {
      throw new IllegalArgumentException(
          "\"" + formula + "\" is no residual; write A = B or one formula");
    }
    return add(
        Aim.Kind.RESIDUAL,
        formula,
        formula.substring(0, relation.start()),
        formula.substring(relation.end()),
        1);
  }

  /**
   * Adds a constraint: two formulas with {@code <=}, {@code >=} or {@code =} between them.
   *
   * @throws IllegalArgumentException if it cannot be read
   */
  public ModelDesign subjectTo(String constraint) {
    Matcher relation = RELATION.matcher(constraint);
    if (!relation.find()) {
      throw new IllegalArgumentException(
          "\"" + constraint + "\" is no constraint; write such as max(x) <= 0.1");
    }
    String left = constraint.substring(0, relation.start());
    String right = constraint.substring(relation.end());
    if (RELATION.matcher(right).find()) {
      throw new IllegalArgumentException(
          "\"" + constraint + "\" has more than one relation; write two constraints");
    }
    return switch (relation.group().charAt(0)) {
      case '<' -> add(Aim.Kind.AT_MOST_ZERO, constraint, left, right, 1);
      case '>' -> add(Aim.Kind.AT_MOST_ZERO, constraint, left, right, -1);
      default -> add(Aim.Kind.ZERO, constraint, left, right, 1);
    };
  }

  private ModelDesign add(Aim.Kind kind, String text, String left, String right, double sign) {
    Set<String> names = fixed.keySet();
    ReductionExpression a = ReductionExpression.parse(left, reductions, names);
    ReductionExpression b = ReductionExpression.parse(right, reductions, names);
    double scale = b.isConstant() ? Math.abs(b.value(new double[0], Map.of())) : 0;
    wanted.add(new AimFormula(new Aim(kind, text.strip(), scale), a, b, sign));
    return this;
  }

  /**
   * Returns the problem.
   *
   * @throws MechmlException if the model cannot be used
   * @throws IllegalArgumentException if it has no such parameter or output, or there is nothing to
   *     minimise
   */
  public DesignProblem problem() throws MechmlException {
    return problem(false);
  }

  /**
   * Returns the problem, with exact derivatives if this is wanted.
   *
   * @throws MechmlException if the model cannot be used
   * @throws IllegalArgumentException as {@link #problem()}, or if there are no exact derivatives;
   *     says why
   */
  public DesignProblem problem(boolean exact) throws MechmlException {
    List<String> names = variables.stream().map(DesignVariable::name).toList();
    if (reductions.isEmpty()) {
      throw new IllegalArgumentException("no formula names an output of the model");
    }
    Parts parts = parts(names);
    Optional<Derivatives> slopes = Optional.empty();
    if (exact) {
      RowGradients gradients = RowGradients.of(model, names, reductions);
      slopes = Optional.of(point -> slopes(parts, gradients, point));
    }
    return new DesignProblem(
        variables,
        wanted.stream().map(AimFormula::aim).toList(),
        point -> parts.aims(parts.quantities(point), point),
        slopes,
        Optional.of(parts));
  }

  /** Returns the reductions of a run, and the rows of those that are extremes. */
  private Parts parts(List<String> names) throws MechmlException {
    List<Reduction> all = new ArrayList<>(reductions);
    for (Reduction reduction : reductions) {
      if (isExtreme(reduction)) {
        all.add(new Reduction(reduction.column(), Reduction.Kind.SERIES, Double.NaN));
      }
    }
    RunSettings run = model.request().settings();
    double rows = (run.tEnd() - run.tStart()) / run.tStep() + 1;
    if (rows * (all.size() - reductions.size()) > MOST_ROWS) {
      return new Parts(PointModel.of(model, names, reductions), List.of());
    }
    PointModel points = PointModel.of(model, names, all);
    List<Composition.Extreme> extremes = new ArrayList<>();
    int from = reductions.size();
    int each = (points.names().size() - from) / Math.max(1, all.size() - from);
    for (int i = 0; i < reductions.size(); i++) {
      if (isExtreme(reductions.get(i))) {
        boolean largest = reductions.get(i).kind() == Reduction.Kind.MAX;
        extremes.add(new Composition.Extreme(i, largest, from, from + each));
        from += each;
      }
    }
    return new Parts(points, extremes);
  }

  private static boolean isExtreme(Reduction reduction) {
    return reduction.kind() == Reduction.Kind.MIN || reduction.kind() == Reduction.Kind.MAX;
  }

  /** What the aims are made of. */
  private final class Parts implements Composition {
    private final PointModel points;
    private final List<Extreme> extremes;

    /** Those of the points asked for last. */
    private final Map<DoubleBuffer, double[]> known =
        new LinkedHashMap<>() {
          private static final long serialVersionUID = 1L;

          @Override
          protected boolean removeEldestEntry(Map.Entry<DoubleBuffer, double[]> eldest) {
            return size() > KNOWN_POINTS;
          }
        };

    Parts(PointModel points, List<Extreme> extremes) {
      this.points = points;
      this.extremes = extremes;
    }

    @Override
    public List<Extreme> extremes() {
      return extremes;
    }

    @Override
    public int count() {
      return reductions.size();
    }

    @Override
    public double[] quantities(double[] point) throws PointFailedException {
      DoubleBuffer key = DoubleBuffer.wrap(point.clone());
      synchronized (known) {
        double[] before = known.get(key);
        if (before != null) {
          return before;
        }
      }
      double[] quantities = reduced(points, named(point));
      synchronized (known) {
        known.put(key, quantities);
      }
      return quantities;
    }

    @Override
    public double[] aims(double[] quantities, double[] point) {
      Map<String, Double> all = new HashMap<>(fixed);
      all.putAll(named(point));
      return wanted.stream().mapToDouble(each -> each.value(quantities, all)).toArray();
    }
  }

  /**
   * Returns the derivatives of the aims: exact ones of the reductions, and differences of the
   * formulas, which cost no runs.
   */
  private double[][] slopes(Parts parts, RowGradients gradients, double[] point)
      throws PointFailedException {
    double[][] byVariable;
    try {
      byVariable = gradients.at(point);
    } catch (IllegalArgumentException e) {
      throw PointFailedException.at(
          variables, point, "the gradient", String.valueOf(e.getMessage()));
    }
    double[] reduced = parts.quantities(point);
    double[][] slopes = new double[wanted.size()][point.length];
    for (int j = 0; j < point.length; j++) {
      double range = variables.get(j).upper() - variables.get(j).lower();
      for (int side = -1; side <= 1; side += 2) {
        double move = side * FORMULA_STEP * range;
        double[] moved = reduced.clone();
        for (int r = 0; r < byVariable.length; r++) {
          moved[r] += move * byVariable[r][j];
        }
        Map<String, Double> all = new HashMap<>(fixed);
        all.putAll(named(point));
        all.merge(variables.get(j).name(), move, Double::sum);
        for (int i = 0; i < slopes.length; i++) {
          slopes[i][j] += wanted.get(i).value(moved, all) / (2 * move);
        }
      }
    }
    return slopes;
  }

  private Map<String, Double> named(double[] point) {
    Map<String, Double> set = new HashMap<>();
    for (int j = 0; j < point.length; j++) {
      set.put(variables.get(j).name(), point[j]);
    }
    return set;
  }

  /**
   * Runs a model at a point.
   *
   * @param set values of parameters
   * @return the values of its reductions
   * @throws PointFailedException if it cannot be run there; says why
   */
  public static double[] reduced(PointModel points, Map<String, Double> set)
      throws PointFailedException {
    try {
      PointOutcome outcome = points.run(set);
      if (outcome instanceof PointOutcome.Failed failed) {
        String message = failed.message();
        throw new PointFailedException(
            message.startsWith(failed.code()) ? message : failed.code() + " " + message);
      }
      return ((PointOutcome.Values) outcome).values();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}

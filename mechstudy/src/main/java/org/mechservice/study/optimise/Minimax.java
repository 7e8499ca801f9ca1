package org.mechservice.study.optimise;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hipparchus.exception.MathRuntimeException;
import org.hipparchus.optim.linear.LinearConstraint;
import org.hipparchus.optim.linear.LinearConstraintSet;
import org.hipparchus.optim.linear.LinearObjectiveFunction;
import org.hipparchus.optim.linear.NonNegativeConstraint;
import org.hipparchus.optim.linear.Relationship;
import org.hipparchus.optim.linear.SimplexSolver;
import org.hipparchus.optim.nonlinear.scalar.GoalType;

/**
 * Minimises aims that are made of extremes, such as {@code max(y) - min(y)}: where two rows are
 * largest at once, the objective has a corner, at which methods for smooth functions stop.
 *
 * <p>Each extreme becomes a variable of its own that no row exceeds (its epigraph), and every row,
 * not only the extreme one, has its linear model. A linear program gives the best point of these
 * models within a trust region of the unit cube (Madsen 1975, J. Inst. Maths Applics 16, 321;
 * constraints by an exact penalty: Fletcher 1987, <i>Practical Methods of Optimization</i>, 14.3).
 * At an optimum with as many rows at the extreme as the problem has freedoms the steps converge
 * quadratically. An extreme that an aim wants to be larger is linear in its extreme row.
 *
 * <p>What the models promise within a small region is a measure of optimality: nothing at an
 * optimum, with corners or without.
 */
final class Minimax {
  /** Radius of the first region, of the last one, and that of the promise. */
  private static final double FIRST = 0.05;

  private static final double LAST = 1e-10;
  private static final double NEARBY = 1e-3;

  private static final int ITERATIONS = 200;

  /** Parts of the promised improvement with which a step is taken, and the region grows. */
  private static final double TAKEN = 1e-3;

  private static final double GOOD = 0.7;
  private static final double POOR = 0.25;

  /** Promised improvement, relative to the objective's size, for which no run is made. */
  private static final double NOTHING = 1e-9;

  /**
   * Size of an objective, relative to that at the start, to which a promise is related at least.
   */
  private static final double SMALL = 1e-3;

  /** Step of the differences of formulas, relative to the size of a quantity. */
  private static final double FORMULA_STEP = 1e-6;

  /** Weight of a violated constraint, in scaled objectives: the first, and the largest. */
  private static final double WEIGHT = 10;

  private static final double MOST_WEIGHT = 1e8;

  /** Relative difference of an extreme from its row: times of rows are rounded. */
  private static final double SAME = 1e-9;

  /** Of the simplex method, for numbers of size one. */
  private static final double ACCURACY = 1e-10;

  private static final int ULPS = 10;
  private static final double CUT_OFF = 1e-12;

  /** Rows of an extreme in a linear program at first; those that matter beside them are added. */
  private static final int FIRST_ROWS = 40;

  private static final int ROUNDS = 20;

  /** Part of the size of a row's model by which another one may exceed it. */
  private static final double EXCEEDS = 1e-9;

  private final DesignProblem problem;
  private final Composition made;
  private final Trials trials;
  private final CentralDifferences differences;
  private final int n;
  private double weight = WEIGHT;

  Minimax(DesignProblem problem, Composition made, Trials trials, double step) {
    this.problem = problem;
    this.made = made;
    this.trials = trials;
    n = problem.variables().size();
    differences = new CentralDifferences(this::quantities, step);
  }

  private double[] quantities(double[] parts) throws PointFailedException {
    Optional<String> failure = trials.at(parts).failure();
    if (failure.isPresent()) {
      throw new PointFailedException(failure.get());
    }
    return made.quantities(problem.point(parts));
  }

  /** Goes from a point of the unit cube to a corner or another place without a promise. */
  void minimise(double[] start) throws PointFailedException {
    double[] x = start.clone();
    double radius = FIRST;
    Model model = new Model(x);
    for (int i = 0; i < ITERATIONS && radius > LAST; i++) {
      Optional<Step> solved = holding(model, radius);
      if (solved.isEmpty()) {
        radius /= 10;
        continue;
      }
      Step step = solved.get();
      double here = merit(x);
      double promised = here - step.merit;
      if (!(promised > NOTHING * Math.max(SMALL, Math.abs(here)))) {
        radius /= 10;
        continue;
      }
      double gained = here - merit(step.to);
      double largest = 0;
      for (int j = 0; j < n; j++) {
        largest = Math.max(largest, Math.abs(step.to[j] - x[j]));
      }
      if (gained > TAKEN * promised) {
        x = step.to;
        model = new Model(x);
      }
      if (gained > GOOD * promised && largest > 0.9 * radius) {
        radius = Math.min(0.5, 2 * radius);
      } else if (!(gained > POOR * promised)) {
        radius = Math.min(radius, largest) / 4;
      }
    }
  }

  /**
   * Returns by how much the models promise to lower the objective within 1e-3 of the variables'
   * ranges, relative to its size, or to a thousandth of that at the start; violated constraints
   * count. Empty if rounding leaves their linear program without a solution.
   */
  OptionalDouble promise(double[] x) throws PointFailedException {
    Optional<Step> step = holding(new Model(x), NEARBY);
    return step.isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            Math.max(0, merit(x) - step.get().merit)
                / Math.max(SMALL, Math.abs(trials.objective(x))));
  }

  /** Returns where the models lead, with constraints so heavy that they hold if they can. */
  private Optional<Step> holding(Model model, double radius) {
    Optional<Step> step = model.step(radius);
    while (step.isPresent() && step.get().violation > Trial.FEASIBLE && weight < MOST_WEIGHT) {
      weight *= 10;
      step = model.step(radius);
    }
    return step;
  }

  /** The scaled objective and what constraints are violated by; infinite where the run fails. */
  private double merit(double[] x) {
    Trial trial = trials.at(x);
    if (trial.failure().isPresent()) {
      return Double.POSITIVE_INFINITY;
    }
    double merit = trials.objective(x);
    for (double g : trials.constraints(x, Aim.Kind.AT_MOST_ZERO)) {
      merit += weight * Math.max(0, g);
    }
    for (double h : trials.constraints(x, Aim.Kind.ZERO)) {
      merit += weight * Math.abs(h);
    }
    return merit;
  }

  /** Where a linear program leads, with what its models say there. */
  private static final class Step {
    final double[] to;
    final double merit;
    final double violation;

    Step(double[] to, double merit, double violation) {
      this.to = to;
      this.merit = merit;
      this.violation = violation;
    }
  }

  /** Linear models of quantities and aims about a point. */
  private final class Model {
    private final double[] x;
    private final double[] quantities;
    private final double[][] slopes;

    /** Aims, objectives and constraints scaled, residuals as the slope of their squares. */
    private final double[] aims;

    /** Derivatives of the aims by the quantities, and by the variables beside them. */
    private final double[][] byQuantity;

    private final double[][] byVariable;

    Model(double[] x) throws PointFailedException {
      this.x = x;
      quantities = Minimax.this.quantities(x);
      slopes = differences.at(x);
      aims = scaled(quantities, problem.point(x));
      byQuantity = new double[aims.length][made.count()];
      byVariable = new double[aims.length][n];
      for (int i = 0; i < made.count(); i++) {
        double move = FORMULA_STEP * (quantities[i] == 0 ? 1 : Math.abs(quantities[i]));
        double[] up = quantities.clone();
        double[] down = quantities.clone();
        up[i] += move;
        down[i] -= move;
        double[] more = scaled(up, problem.point(x));
        double[] less = scaled(down, problem.point(x));
        for (int a = 0; a < aims.length; a++) {
          byQuantity[a][i] = (more[a] - less[a]) / (2 * move);
        }
      }
      for (int j = 0; j < n; j++) {
        double[] up = x.clone();
        double[] down = x.clone();
        up[j] += FORMULA_STEP;
        down[j] -= FORMULA_STEP;
        double[] more = scaled(quantities, problem.point(up));
        double[] less = scaled(quantities, problem.point(down));
        for (int a = 0; a < aims.length; a++) {
          byVariable[a][j] = (more[a] - less[a]) / (2 * FORMULA_STEP);
        }
      }
    }

    /**
     * Returns the row at which an extreme is taken; that of the extreme itself, whose slopes mean
     * nothing at a corner, if it is taken between rows, as at an event.
     */
    private int active(Composition.Extreme extreme) {
      double value = quantities[extreme.quantity()];
      int nearest = extreme.quantity();
      double least = SAME * Math.abs(value);
      for (int row = extreme.from(); row < extreme.to(); row++) {
        double off = Math.abs(quantities[row] - value);
        if (off <= least) {
          least = off;
          nearest = row;
        }
      }
      return nearest;
    }

    /** Returns the aims in the scales of the trials; residuals squared. */
    private double[] scaled(double[] of, double[] point) {
      double[] values = made.aims(of, point);
      for (int a = 0; a < values.length; a++) {
        double value = values[a];
        boolean squared = problem.aims().get(a).kind() == Aim.Kind.RESIDUAL;
        values[a] = (squared ? value * value : value) / trials.scale(a);
      }
      return values;
    }

    /** Returns where the models lead in a region; empty if their program has no solution. */
    Optional<Step> step(double radius) {
      Program program = new Program(radius);
      for (int a = 0; a < aims.length; a++) {
        switch (problem.aims().get(a).kind()) {
          case MINIMISE, RESIDUAL -> program.add(a, 1, program.objective);
          case AT_MOST_ZERO -> program.constrain(a, false);
          case ZERO -> program.constrain(a, true);
        }
      }
      return program.solved();
    }

    /**
     * The linear program of a region. Its variables are the moves in units of the radius, the
     * extremes of each aim that wants them smaller, as differences from their values, and what
     * constraints are violated by. All are scaled to be of size one.
     */
    private final class Program {
      private final double radius;
      private final List<Bundle> bundles = new ArrayList<>();
      private final List<double[]> rows = new ArrayList<>();
      private final List<Relationship> relations = new ArrayList<>();
      private final List<Double> right = new ArrayList<>();

      /** Coefficients of the objective; grows with the variables. */
      private final List<Double> objective = new ArrayList<>();

      private int slacks;

      Program(double radius) {
        this.radius = radius;
        grow(objective, n);
      }

      private void grow(List<Double> coefficients, int length) {
        while (coefficients.size() < length) {
          coefficients.add(0.0);
        }
      }

      /** Adds the linear model of an aim, without its value, to coefficients. */
      private void add(int aim, double factor, List<Double> to) {
        for (int j = 0; j < n; j++) {
          addTo(to, j, factor * radius * byVariable[aim][j]);
        }
        for (int i = 0; i < made.count(); i++) {
          double c = factor * byQuantity[aim][i];
          if (c == 0) {
            continue;
          }
          Optional<Composition.Extreme> extreme = extreme(i);
          if (extreme.isPresent() && (extreme.get().largest() ? c > 0 : c < 0)) {
            Bundle bundle = new Bundle(extreme.get(), variables());
            bundles.add(bundle);
            addTo(to, bundle.variable, c * bundle.size);
          } else {
            double[] slope = slopes[extreme.isPresent() ? active(extreme.get()) : i];
            for (int j = 0; j < n; j++) {
              addTo(to, j, c * radius * slope[j]);
            }
          }
        }
      }

      private int variables() {
        return n + bundles.size() + slacks;
      }

      private void addTo(List<Double> coefficients, int variable, double value) {
        grow(coefficients, variable + 1);
        coefficients.set(variable, coefficients.get(variable) + value);
      }

      private Optional<Composition.Extreme> extreme(int quantity) {
        return made.extremes().stream().filter(e -> e.quantity() == quantity).findFirst();
      }

      /** Constrains an aim to be at most zero, or zero, up to a violation that costs. */
      private void constrain(int aim, boolean equal) {
        for (double sign = 1; sign >= (equal ? -1 : 1); sign -= 2) {
          List<Double> coefficients = new ArrayList<>();
          add(aim, sign, coefficients);
          int slack = variables();
          slacks++;
          // violations in units of the radius
          addTo(coefficients, slack, -radius);
          addTo(objective, slack, weight * radius);
          relate(coefficients, Relationship.LEQ, -sign * aims[aim]);
          List<Double> positive = new ArrayList<>();
          addTo(positive, slack, 1);
          relate(positive, Relationship.GEQ, 0);
        }
      }

      private void relate(List<Double> coefficients, Relationship relation, double value) {
        rows.add(coefficients.stream().mapToDouble(Double::doubleValue).toArray());
        relations.add(relation);
        right.add(value);
      }

      Optional<Step> solved() {
        for (int j = 0; j < n; j++) {
          List<Double> move = new ArrayList<>();
          addTo(move, j, 1);
          relate(move, Relationship.LEQ, Math.min(1, (1 - x[j]) / radius));
          relate(move, Relationship.GEQ, Math.max(-1, -x[j] / radius));
        }
        double[] found = new double[variables()];
        for (int round = 0; round < ROUNDS; round++) {
          Optional<double[]> solution = solution();
          if (solution.isEmpty()) {
            return Optional.empty();
          }
          found = solution.get();
          boolean complete = true;
          for (Bundle bundle : bundles) {
            complete &= !bundle.addExceeding(found);
          }
          if (complete) {
            break;
          }
        }
        return Optional.of(step(found));
      }

      private Step step(double[] found) {
        double[] to = x.clone();
        for (int j = 0; j < n; j++) {
          to[j] = Math.max(0, Math.min(1, x[j] + radius * found[j]));
        }
        double violation = 0;
        double merit = 0;
        for (int a = 0; a < aims.length; a++) {
          double value = modelled(a, to);
          switch (problem.aims().get(a).kind()) {
            case MINIMISE, RESIDUAL -> merit += value;
            case AT_MOST_ZERO -> violation += Math.max(0, value);
            case ZERO -> violation += Math.abs(value);
          }
        }
        return new Step(to, merit + weight * violation, violation);
      }

      /** Returns an aim of the linear models of the quantities. */
      private double modelled(int aim, double[] to) {
        double value = aims[aim];
        for (int j = 0; j < n; j++) {
          value += byVariable[aim][j] * (to[j] - x[j]);
        }
        for (int i = 0; i < made.count(); i++) {
          if (byQuantity[aim][i] != 0) {
            Optional<Composition.Extreme> extreme = extreme(i);
            double there = linear(extreme.isPresent() ? active(extreme.get()) : i, to);
            if (extreme.isPresent()) {
              Composition.Extreme e = extreme.get();
              for (int row = e.from(); row < e.to(); row++) {
                double other = linear(row, to);
                there = (e.largest() ? other > there : other < there) ? other : there;
              }
            }
            value += byQuantity[aim][i] * (there - quantities[i]);
          }
        }
        return value;
      }

      private double linear(int quantity, double[] to) {
        double value = quantities[quantity];
        for (int j = 0; j < n; j++) {
          value += slopes[quantity][j] * (to[j] - x[j]);
        }
        return value;
      }

      private Optional<double[]> solution() {
        int length = variables();
        List<LinearConstraint> constraints = new ArrayList<>();
        for (int i = 0; i < rows.size(); i++) {
          double[] row = Arrays.copyOf(rows.get(i), length);
          double size = Arrays.stream(row).map(Math::abs).max().orElse(0);
          if (size > 0) {
            constraints.add(
                new LinearConstraint(
                    Arrays.stream(row).map(c -> c / size).toArray(),
                    relations.get(i),
                    right.get(i) / size));
          }
        }
        grow(objective, length);
        double[] cost = objective.stream().mapToDouble(Double::doubleValue).toArray();
        double size = Math.max(Arrays.stream(cost).map(Math::abs).max().orElse(0), 1e-300);
        try {
          return Optional.of(
              new SimplexSolver(ACCURACY, ULPS, CUT_OFF)
                  .optimize(
                      new LinearObjectiveFunction(
                          Arrays.stream(cost).map(c -> c / size).toArray(), 0),
                      new LinearConstraintSet(constraints),
                      GoalType.MINIMIZE,
                      new NonNegativeConstraint(false))
                  .getPoint());
        } catch (MathRuntimeException e) {
          // rounding has made a program that always has a solution one without; the region shrinks
          return Optional.empty();
        }
      }

      /** An extreme in one aim: a variable, and the rows that it is not below, or not above. */
      private final class Bundle {
        final Composition.Extreme extreme;
        final int variable;

        /** By how much a row can change in the region. */
        final double size;

        private final int active;
        private final boolean[] taken;

        Bundle(Composition.Extreme extreme, int variable) {
          this.extreme = extreme;
          this.variable = variable;
          active = active(extreme);
          taken = new boolean[extreme.to() - extreme.from() + 1];
          double most = Double.MIN_NORMAL;
          for (int k = 0; k < taken.length; k++) {
            most = Math.max(most, radius * steepness(place(k)));
          }
          size = most;
          add(place(taken.length - 1));
          taken[taken.length - 1] = true;
          for (int k = 0; k < FIRST_ROWS; k++) {
            int best = -1;
            for (int r = 0; r < taken.length; r++) {
              if (!taken[r] && (best < 0 || reach(place(r)) > reach(place(best)))) {
                best = r;
              }
            }
            if (best < 0 || !(reach(place(best)) > 0)) {
              return;
            }
            taken[best] = true;
            add(place(best));
          }
        }

        /** Returns the place of one of the rows, the last one being the extreme one. */
        private int place(int k) {
          return k < taken.length - 1 ? extreme.from() + k : active;
        }

        private double steepness(int quantity) {
          double sum = 0;
          for (int j = 0; j < n; j++) {
            sum += Math.abs(slopes[quantity][j]);
          }
          return Double.isFinite(sum) ? sum : 0;
        }

        /** Returns how far a row is from being so low that the region cannot make it extreme. */
        private double reach(int quantity) {
          double off = quantities[quantity] - quantities[extreme.quantity()];
          double reach = (extreme.largest() ? off : -off) + size + radius * steepness(quantity);
          return Double.isFinite(reach) ? reach : Double.NEGATIVE_INFINITY;
        }

        /** Adds: variable · size is not below (above) the model of a row less the extreme. */
        private void add(int quantity) {
          List<Double> coefficients = new ArrayList<>();
          for (int j = 0; j < n; j++) {
            addTo(coefficients, j, -radius * slopes[quantity][j]);
          }
          addTo(coefficients, variable, size);
          relate(
              coefficients,
              extreme.largest() ? Relationship.GEQ : Relationship.LEQ,
              quantities[quantity] - quantities[extreme.quantity()]);
        }

        /** Adds the row that exceeds the variable most; returns whether one does. */
        boolean addExceeding(double[] found) {
          int worst = -1;
          double most = EXCEEDS * size;
          for (int k = 0; k < taken.length; k++) {
            if (!taken[k]) {
              double model = quantities[place(k)] - quantities[extreme.quantity()];
              for (int j = 0; j < n; j++) {
                model += radius * slopes[place(k)][j] * found[j];
              }
              double by = (extreme.largest() ? 1 : -1) * (model - found[variable] * size);
              if (by > most) {
                most = by;
                worst = k;
              }
            }
          }
          if (worst >= 0) {
            taken[worst] = true;
            add(place(worst));
          }
          return worst >= 0;
        }
      }
    }
  }
}

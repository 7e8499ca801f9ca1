package org.mechservice.study.optimise;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;

/**
 * The Pareto front of two objectives: points at which neither can become smaller unless the other
 * grows. Its ends are the optima of each objective alone. Between them the first objective is
 * minimised while the second one is held below evenly spaced values (the constraint method: Haimes,
 * Lasdon and Wismer, IEEE Trans. SMC 1, 1971), each time from the point before; so fronts that are
 * not convex have all their points, too.
 *
 * @param problem what was asked
 * @param method the method that found the points
 * @param points from the least first objective to the least second one; at least one
 * @param runs how many runs were made
 * @param failures how many of them failed
 */
public record Front(
    DesignProblem problem, Method method, List<Point> points, int runs, int failures) {
  /** Points between the ends and at them, at the least. */
  public static final int FEWEST = 3;

  /** Part of an objective's range that its own end gives away, so that the other one may settle. */
  private static final double OPEN = 1e-5;

  public Front {
    points = List.copyOf(points);
  }

  /**
   * One point of the front.
   *
   * @param point values of the variables
   * @param values values of all aims
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  public record Point(double[] point, double[] values) {}

  /**
   * Computes the front.
   *
   * @param problem two objectives, and constraints
   * @param count points to look for; the front has fewer where constraints leave none, or where
   *     both objectives agree
   * @throws IllegalArgumentException if there are not two objectives, fewer than three points, or
   *     the method does not fit
   * @throws PointFailedException if no point can be computed, or none satisfies all constraints
   * @throws InterruptedException if the thread is interrupted
   */
  public static Front of(DesignProblem problem, OptimiserSettings settings, int count)
      throws PointFailedException, InterruptedException {
    int[] objectives = problem.objectives();
    if (objectives.length != 2) {
      throw new IllegalArgumentException(
          "a front needs two objectives; there are " + objectives.length);
    }
    if (count < FEWEST) {
      throw new IllegalArgumentException(
          "a front of " + count + " points is none; ask for " + FEWEST + " or more");
    }
    Method method = settings.method().chosenFor(problem);
    return new Search(problem, settings.with(method), objectives[0], objectives[1]).front(count);
  }

  /** Returns the places of the two objectives among the aims. */
  public int[] objectives() {
    return problem.objectives();
  }

  /** The optimisations of one front. */
  private static final class Search {
    private final DesignProblem problem;
    private final OptimiserSettings settings;
    private final int first;
    private final int second;
    private final List<Point> found = new ArrayList<>();
    private int runs;
    private int failures;

    Search(DesignProblem problem, OptimiserSettings settings, int first, int second) {
      this.problem = problem;
      this.settings = settings;
      this.first = first;
      this.second = second;
    }

    Front front(int count) throws PointFailedException, InterruptedException {
      Point from = end(first);
      Point to = end(second);
      double highest = from.values()[second];
      double lowest = to.values()[second];
      if (highest > lowest) {
        Point before = from;
        Optional<Point> next = Optional.empty();
        for (int k = count - 2; k > 0; k--) {
          double atMost = lowest + (highest - lowest) * k / (count - 1);
          DesignProblem between = between(second, atMost, highest - lowest, before);
          Optional<Point> found = best(between);
          before = found.orElse(before);
          next = next.or(() -> found);
        }
        settle(from, first, next.orElse(to));
        settle(to, second, before);
      }
      return new Front(problem, settings.method(), notDominated(), runs, failures);
    }

    /**
     * Lets the other objective decide what an end leaves open, and replaces the end. The search
     * begins at the point beside it, since the slope of what is held vanishes at the end itself.
     */
    private void settle(Point end, int held, Point beside)
        throws PointFailedException, InterruptedException {
      double range = Math.abs(beside.values()[held] - end.values()[held]);
      if (range > 0) {
        double atMost = end.values()[held] + OPEN * range;
        if (best(between(held, atMost, range, beside)).isPresent()) {
          found.remove(end);
        }
      }
    }

    private Optional<Point> best(DesignProblem each)
        throws PointFailedException, InterruptedException {
      Optimum optimum = counted(each);
      if (!optimum.best().isFeasible()) {
        return Optional.empty();
      }
      Point point = new Point(optimum.best().point(), whole(optimum.best().point()));
      found.add(point);
      return Optional.of(point);
    }

    /** Returns the optimum of one objective alone. */
    private Point end(int objective) throws PointFailedException, InterruptedException {
      int other = objective == first ? second : first;
      int[] kept = IntStream.range(0, problem.aims().size()).filter(i -> i != other).toArray();
      DesignProblem alone =
          new DesignProblem(
              problem.variables(),
              Arrays.stream(kept).mapToObj(problem.aims()::get).toList(),
              x -> chosen(problem.response().at(x), kept),
              problem.slopes().map(slopes -> x -> chosen(slopes.at(x), kept)),
              problem.composition().map(made -> made.withAims(values -> chosen(values, kept))));
      return best(alone)
          .orElseThrow(() -> new PointFailedException("no point satisfies all constraints"));
    }

    /** One objective with the other one held below a value. */
    private DesignProblem between(int held, double atMost, double scale, Point from) {
      List<Aim> aims = new ArrayList<>(problem.aims());
      aims.set(held, new Aim(Aim.Kind.AT_MOST_ZERO, aims.get(held).text(), scale));
      List<DesignVariable> variables = new ArrayList<>();
      for (int j = 0; j < from.point().length; j++) {
        variables.add(problem.variables().get(j).startingAt(from.point()[j]));
      }
      UnaryOperator<double[]> lowered =
          values -> {
            double[] less = values.clone();
            less[held] -= atMost;
            return less;
          };
      return new DesignProblem(
          variables,
          aims,
          x -> lowered.apply(problem.response().at(x)),
          problem.slopes(),
          problem.composition().map(made -> made.withAims(lowered)));
    }

    private Optimum counted(DesignProblem each) throws PointFailedException, InterruptedException {
      Optimum optimum = Optimiser.minimise(each, settings);
      runs += optimum.runs();
      failures += optimum.failures();
      return optimum;
    }

    private double[] whole(double[] point) throws PointFailedException {
      runs++;
      return problem.response().at(point);
    }

    /** Returns the points that no other one betters in both objectives, in order. */
    private List<Point> notDominated() {
      return found.stream()
          .filter(a -> found.stream().noneMatch(b -> dominates(b, a)))
          .sorted(Comparator.comparingDouble(point -> point.values()[first]))
          .toList();
    }

    private boolean dominates(Point a, Point b) {
      double[] x = a.values();
      double[] y = b.values();
      return x[first] <= y[first]
          && x[second] <= y[second]
          && (x[first] < y[first] || x[second] < y[second]);
    }

    private static double[] chosen(double[] values, int[] kept) {
      return Arrays.stream(kept).mapToDouble(i -> values[i]).toArray();
    }

    private static double[][] chosen(double[][] rows, int[] kept) {
      return Arrays.stream(kept).mapToObj(i -> rows[i]).toArray(double[][]::new);
    }
  }
}

package org.mechservice.report.solution;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.mechservice.report.method.ModelPhases;
import org.mechservice.report.method.ModelProblem;
import org.mechservice.report.reference.ExtrapolationCode;
import org.mechservice.report.reference.RadauCode;
import org.mechservice.report.reference.ReferenceCode;

/**
 * Makes a reference: two codes on two formulations, their difference being what is known of its
 * error; a run from a start changed by one unit in the last place, what rounding alone does; and
 * one changed by 1e-9, by what the scene amplifies. What happens along a run parts it into phases
 * that the codes solve one by one.
 */
public final class ReferenceMaker {
  /** Tolerance of the collocation codes' estimate, of much lower order than the solution. */
  private static final double RADAU_TOLERANCE = 1e-12;

  private static final double EXTRAPOLATION_TOLERANCE = 1e-13;

  /** Where loops are closed near a singular position, tighter tolerances are lost in rounding. */
  private static final double LOOSER = 1e4;

  private static final double AMPLIFIED = 1e-9;

  /** To see how far a run goes: no digit of that matters beyond those of an output interval. */
  private static final double ROUGH_TOLERANCE = 1e-6;

  /** A code beyond this number of unknowns would spend its time in dense matrices. */
  private static final int DENSE_LIMIT = 120;

  /**
   * Something that may be solved.
   *
   * @param name formulation, for the page
   * @param fresh makes the problem, for one solution
   */
  public record Source(String name, Supplier<ModelProblem> fresh) {}

  @SuppressWarnings("ArrayRecordComponent") // states as the codes hand them out; not changed
  private record Solved(
      String how, Attempt attempt, double[][] states, Optional<ModelPhases> course) {
    List<Double> jumps() {
      return course.map(ModelPhases::jumps).orElse(List.of());
    }

    Solved at(int[] kept) {
      double[][] some = Arrays.stream(kept).mapToObj(i -> states[i]).toArray(double[][]::new);
      return new Solved(how, attempt, some, course);
    }
  }

  private record Attempt(Source source, ReferenceCode code, double tolerance) {
    String how() {
      return String.format(
          Locale.ROOT, "%s, tolerance %.0e, on %s", code.name(), tolerance, source.name());
    }
  }

  /** Tolerances of extrapolation on a large mechanism; the first that its time allows is taken. */
  private static final double[] LARGE_TOLERANCES = {1e-13, 1e-12, 1e-11, 1e-10, 1e-9};

  private static final int EVERY = 5;

  private final StateDistance distance;
  private final double secondsPerCode;
  private final double secondsForLarge;
  private final double radauTolerance;
  private final double extrapolationTolerance;

  /**
   * @param secondsPerCode time limit of one solution, s
   */
  public ReferenceMaker(StateDistance distance, double secondsPerCode) {
    this(distance, secondsPerCode, RADAU_TOLERANCE, EXTRAPOLATION_TOLERANCE);
  }

  /**
   * @param secondsPerCode time limit of one solution, s
   * @param secondsForLarge the same of a mechanism too large for dense matrices, whose tolerance is
   *     chosen so that a solution is likely to end in that time, s
   */
  public ReferenceMaker(StateDistance distance, double secondsPerCode, double secondsForLarge) {
    this(distance, secondsPerCode, secondsForLarge, RADAU_TOLERANCE, EXTRAPOLATION_TOLERANCE);
  }

  /**
   * @param secondsPerCode time limit of one solution, s
   * @param radauTolerance of the collocation codes' estimate
   * @param extrapolationTolerance of the other
   */
  public ReferenceMaker(
      StateDistance distance,
      double secondsPerCode,
      double radauTolerance,
      double extrapolationTolerance) {
    this(distance, secondsPerCode, secondsPerCode, radauTolerance, extrapolationTolerance);
  }

  private ReferenceMaker(
      StateDistance distance,
      double secondsPerCode,
      double secondsForLarge,
      double radauTolerance,
      double extrapolationTolerance) {
    this.distance = distance;
    this.secondsPerCode = secondsPerCode;
    this.secondsForLarge = secondsForLarge;
    this.radauTolerance = radauTolerance;
    this.extrapolationTolerance = extrapolationTolerance;
  }

  /**
   * Returns the times to judge a scene at. The codes end a step at each, so a mechanism that is
   * large has every fifth alone.
   */
  public static double[] times(Source source, double[] all) {
    if (!isLarge(source)) {
      return all;
    }
    return IntStream.range(0, all.length)
        .filter(i -> i % EVERY == 0 || i == all.length - 1)
        .mapToDouble(i -> all[i])
        .toArray();
  }

  /**
   * Makes a reference.
   *
   * @param sources at least one; the second should be another formulation than the first
   * @param times increasing; the first is the start
   * @return empty if no code solves the problem in its time
   */
  public Optional<Reference> make(List<Source> sources, double[] times) {
    List<String> said = new ArrayList<>();
    List<Solved> solved = new ArrayList<>();
    for (Attempt attempt : attempts(sources, times, said)) {
      Optional<Solved> found = solve(attempt, times, 0);
      if (found.isPresent()) {
        solved.add(found.get());
        if (solved.size() == 2) {
          break;
        }
      } else {
        said.add(attempt.how() + ": not solved, for " + (long) limit(attempt) + " s at most");
      }
    }
    return solved.isEmpty() ? Optional.empty() : comparable(solved, times, said);
  }

  /**
   * How far a run can be judged.
   *
   * @param grid output times
   * @param why it is not the whole of it, in a sentence; empty if it is
   */
  public record Extent(RunGrid grid, String why) {}

  /**
   * Returns how far a run goes: one that something ends before its time has as many output times,
   * closer to each other, but for the very last, which another method may not reach.
   */
  public Extent extent(Source source, RunGrid whole) {
    ModelProblem problem = source.fresh().get();
    double[] times = {whole.start(), whole.start() + whole.step() * (whole.rows() - 1)};
    if (!problem.course().map(ModelPhases::mayEnd).orElse(false)) {
      return new Extent(whole, "");
    }
    ReferenceCode code = isLarge(source) ? new ExtrapolationCode(6) : new RadauCode(5);
    Optional<double[][]> states =
        code.solve(problem, times, problem.start(), ROUGH_TOLERANCE, deadline(source));
    ModelPhases course = problem.course().orElseThrow();
    if (states.isEmpty() || states.get().length == times.length) {
      return new Extent(whole, "");
    }
    RunGrid shorter = RunGrid.uniform(whole.start(), course.endTime(), whole.rows() - 1);
    RunGrid judged = new RunGrid(shorter.start(), shorter.step(), shorter.rows() - 1);
    return new Extent(judged, course.end());
  }

  private static boolean isLarge(Source source) {
    return source.fresh().get().dimension() > DENSE_LIMIT;
  }

  private List<Attempt> attempts(List<Source> sources, double[] times, List<String> said) {
    Source first = sources.get(0);
    Source second = sources.get(Math.min(1, sources.size() - 1));
    if (isLarge(first)) {
      double tolerance = largeTolerance(first, times, said);
      // The first has independent coordinates, if the scene closes loops: it evaluates faster.
      return List.of(
          new Attempt(first, new ExtrapolationCode(8), tolerance),
          new Attempt(second, new ExtrapolationCode(6), tolerance),
          new Attempt(first, new ExtrapolationCode(6), tolerance));
    }
    Attempt extrapolation = new Attempt(second, new ExtrapolationCode(8), extrapolationTolerance);
    return List.of(
        new Attempt(first, new RadauCode(7), radauTolerance),
        extrapolation,
        new Attempt(second, new RadauCode(5), radauTolerance),
        new Attempt(first, new RadauCode(7), LOOSER * radauTolerance),
        new Attempt(second, new RadauCode(5), LOOSER * radauTolerance));
  }

  private Optional<Solved> solve(Attempt attempt, double[] times, double change) {
    ModelProblem problem = attempt.source().fresh().get();
    double[] y0 = problem.start();
    if (change > 0) {
      perturb(problem, times[0], y0, change);
    } else if (problem.dimension() > DENSE_LIMIT) {
      problem.takePart();
    }
    return attempt
        .code()
        .solve(problem, times, y0, attempt.tolerance(), deadline(attempt.source(), change))
        .map(states -> new Solved(attempt.how(), attempt, states, problem.course()));
  }

  /**
   * The tightest tolerance that a solution is likely to reach in its time: the steps of a code of
   * order p grow with the p-th root of the tolerance, from those of a rough solution.
   */
  private double largeTolerance(Source source, double[] times, List<String> said) {
    ExtrapolationCode code = new ExtrapolationCode(8);
    double rough = seconds(code, source, times);
    if (rough < secondsForLarge / 3) {
      // The first is slow because the program is not compiled yet.
      rough = seconds(code, source, times);
    }
    for (double tolerance : LARGE_TOLERANCES) {
      boolean fits = rough * Math.pow(ROUGH_TOLERANCE / tolerance, 1.0 / 15) <= secondsForLarge;
      if (tolerance >= extrapolationTolerance && fits) {
        if (tolerance > extrapolationTolerance) {
          said.add(looser(rough, tolerance));
        }
        return tolerance;
      }
    }
    double loosest = LARGE_TOLERANCES[LARGE_TOLERANCES.length - 1];
    said.add(looser(rough, loosest));
    return loosest;
  }

  private double seconds(ExtrapolationCode code, Source source, double[] times) {
    ModelProblem problem = source.fresh().get();
    long started = System.nanoTime();
    code.solve(problem, times, problem.start(), ROUGH_TOLERANCE, deadline(source));
    return (System.nanoTime() - started) * 1e-9;
  }

  private String looser(double rough, double tolerance) {
    return String.format(
        Locale.ROOT,
        "Large mechanism: a solution at %.0e took %.3g s, so the codes have a tolerance of %.0e in"
            + " place of %.0e to end within %.3g s.",
        ROUGH_TOLERANCE,
        rough,
        tolerance,
        extrapolationTolerance,
        secondsForLarge);
  }

  private double limit(Attempt attempt) {
    return isLarge(attempt.source()) ? secondsForLarge : secondsPerCode;
  }

  private long deadline(Source source) {
    return deadline(source, 0);
  }

  /** A changed start has as far to go as a solution got in its time, and more than that time. */
  private long deadline(Source source, double change) {
    double large = change > 0 ? 2 * secondsForLarge : secondsForLarge;
    double seconds = isLarge(source) ? large : secondsPerCode;
    return System.nanoTime() + (long) (seconds * TimeUnit.SECONDS.toNanos(1));
  }

  /** Keeps the times that all solutions reach and at which a state that jumps can be compared. */
  private Optional<Reference> comparable(List<Solved> solved, double[] times, List<String> said) {
    int reached = solved.stream().mapToInt(one -> one.states().length).min().orElse(0);
    int[] kept =
        ComparableTimes.of(
            Arrays.copyOf(times, reached), solved.stream().map(Solved::jumps).toList());
    if (kept.length < 2) {
      return Optional.empty();
    }
    boolean ended = solved.stream().anyMatch(ReferenceMaker::ended);
    if (reached < times.length && !ended) {
      said.add(
          String.format(
              Locale.ROOT,
              "Large mechanism: in %.3g s the codes reached %.3g s; the time before is judged.",
              secondsForLarge,
              times[reached - 1]));
    }
    double[] clear = Arrays.stream(kept).mapToDouble(i -> times[i]).toArray();
    List<String> all = new ArrayList<>(said);
    List<ModelPhases> courses = solved.stream().flatMap(one -> one.course().stream()).toList();
    all.addAll(JumpNotes.of(courses, clear[clear.length - 1], kept.length, times.length));
    courses.stream().map(ModelPhases::end).filter(end -> !end.isEmpty()).limit(1).forEach(all::add);
    return Optional.of(judged(solved.stream().map(one -> one.at(kept)).toList(), clear, all));
  }

  private static boolean ended(Solved one) {
    return one.course().map(course -> !course.end().isEmpty()).orElse(false);
  }

  /** Changes every component that is free by the same part of 1 + |y|, signs drawn. */
  private static void perturb(ModelProblem problem, double t, double[] y, double change) {
    Random signs = new Random(1);
    for (int i = 0; i < y.length; i++) {
      double moved = change * (1 + Math.abs(y[i]));
      if (signs.nextBoolean() && problem.independent(i)) {
        y[i] += moved;
      } else if (problem.independent(i)) {
        y[i] -= moved;
      }
    }
    problem.close(t, y);
  }

  private Reference judged(List<Solved> solved, double[] times, List<String> said) {
    Solved best = solved.get(0);
    List<String> sources = new ArrayList<>();
    sources.add("Reference: " + best.how() + ".");
    double[] floor = new double[times.length];
    Optional<double[]> rounding = grown(best, times, Math.ulp(1.0) / 2);
    Optional<double[]> amplified = grown(best, times, AMPLIFIED);
    rounding.ifPresent(moved -> raise(floor, moved));
    if (solved.size() == 2) {
      double[] apart = distances(best.states(), solved.get(1).states());
      raise(floor, apart);
      sources.add(
          String.format(
              Locale.ROOT,
              "Checked by: %s; they differ by %.1e at most.",
              solved.get(1).how(),
              largest(apart)));
    } else {
      sources.add(Reference.NOT_CHECKED);
    }
    rounding.ifPresent(
        moved ->
            sources.add(
                String.format(
                    Locale.ROOT,
                    "A start changed by one unit in the last place moves the end by %.1e.",
                    moved[moved.length - 1])));
    sources.addAll(said);
    return new Reference(
        times,
        best.states(),
        floor,
        rounding.orElseGet(() -> new double[times.length]),
        amplified.map(ReferenceMaker::perUnit),
        best.jumps(),
        sources);
  }

  private static double[] perUnit(double[] moved) {
    double[] factors = new double[moved.length];
    for (int i = 0; i < moved.length; i++) {
      factors[i] = moved[i] / AMPLIFIED;
    }
    return factors;
  }

  private Optional<double[]> grown(Solved solved, double[] times, double change) {
    return solve(solved.attempt(), times, change)
        .map(moved -> distances(moved.states(), solved.states()));
  }

  /** Where one of them has ended before, nothing is known. */
  private double[] distances(double[][] moved, double[][] states) {
    double[] apart = new double[states.length];
    Arrays.setAll(
        apart, i -> i < moved.length ? distance.of(moved[i], states[i]) : Double.POSITIVE_INFINITY);
    return apart;
  }

  private static void raise(double[] floor, double[] to) {
    for (int i = 0; i < floor.length; i++) {
      floor[i] = Math.max(floor[i], to[i]);
    }
  }

  private static double largest(double[] values) {
    double largest = 0;
    for (double value : values) {
      largest = Math.max(largest, value);
    }
    return largest;
  }
}

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
   * A problem that may be solved.
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

  /**
   * Columns of extrapolation on a large mechanism: with more, a step adds up so many evaluations
   * that their rounding is as large as a tight tolerance, and shorter steps do not help.
   */
  private static final int LARGE_COLUMNS = 6;

  private static final int LARGE_CHECK_COLUMNS = 5;

  /**
   * Solutions of a large mechanism: the reference, its check by other equations, which may take
   * twice as long, and one from a changed start.
   */
  private static final double LARGE_SOLUTIONS = 4;

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
   * @param secondsForLarge time limit of all solutions of a mechanism too large for dense matrices
   *     together, s; their tolerance is the tightest that they keep in that time
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
    this(
        distance,
        secondsPerCode,
        LARGE_SOLUTIONS * secondsPerCode,
        radauTolerance,
        extrapolationTolerance);
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
    if (isLarge(sources.get(0))) {
      return makeLarge(sources, times);
    }
    List<String> said = new ArrayList<>();
    List<Solved> solved = new ArrayList<>();
    for (Attempt attempt : attempts(sources)) {
      Optional<Solved> found = solve(attempt, times, 0, secondsPerCode);
      if (found.isPresent()) {
        solved.add(found.get());
        if (solved.size() == 2) {
          break;
        }
      } else {
        said.add(attempt.how() + ": not solved, for " + (long) secondsPerCode + " s at most");
      }
    }
    return solved.isEmpty() ? Optional.empty() : comparable(solved, times, said, secondsPerCode);
  }

  /**
   * The first source has independent coordinates, if the scene closes loops. Its tolerance is the
   * tightest that its code keeps, and the second checks it at the same tolerance in the time left.
   */
  private Optional<Reference> makeLarge(List<Source> sources, double[] times) {
    double end = clock() + secondsForLarge;
    Source first = sources.get(0);
    Source second = sources.get(Math.min(1, sources.size() - 1));
    Optional<ToleranceLadder.Rung<Solved>> rung =
        new ToleranceLadder<Solved>(ReferenceMaker::clock, LARGE_SOLUTIONS)
            .climb(
                (tolerance, seconds) ->
                    solve(
                        new Attempt(first, new ExtrapolationCode(LARGE_COLUMNS), tolerance),
                        times,
                        0,
                        seconds),
                one -> one.states().length == times.length || ended(one),
                secondsForLarge);
    if (rung.isEmpty()) {
      return Optional.empty();
    }
    List<String> said = new ArrayList<>();
    Solved solved = rung.get().solution();
    said.add(
        String.format(
            Locale.ROOT,
            "Large mechanism: %.3g s were for the reference; %.0e is the tightest tolerance that a"
                + " solution kept in its part of them, %.3g s.",
            secondsForLarge,
            solved.attempt().tolerance(),
            rung.get().seconds()));
    List<Solved> all = new ArrayList<>(List.of(solved));
    double[] reached = Arrays.copyOf(times, solved.states().length);
    double ownTime = rung.get().seconds();
    List<Attempt> checks =
        List.of(
            new Attempt(
                second, new ExtrapolationCode(LARGE_CHECK_COLUMNS), solved.attempt().tolerance()),
            new Attempt(
                first, new ExtrapolationCode(LARGE_CHECK_COLUMNS), solved.attempt().tolerance()));
    for (Attempt check : checks) {
      double left = Math.max(end - clock() - ownTime, ownTime);
      Optional<Solved> found = solve(check, reached, 0, left);
      if (found.isPresent()) {
        all.add(found.get());
        break;
      }
      said.add(String.format(Locale.ROOT, "%s: not solved, for %.3g s at most", check.how(), left));
    }
    return comparable(all, times, said, Math.max(end - clock(), ownTime));
  }

  private static double clock() {
    return System.nanoTime() * 1e-9;
  }

  /**
   * The part of a run that can be judged.
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
        code.solve(
            problem,
            times,
            problem.start(),
            ROUGH_TOLERANCE,
            deadline(isLarge(source) ? secondsForLarge / LARGE_SOLUTIONS : secondsPerCode));
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

  private List<Attempt> attempts(List<Source> sources) {
    Source first = sources.get(0);
    Source second = sources.get(Math.min(1, sources.size() - 1));
    Attempt extrapolation = new Attempt(second, new ExtrapolationCode(8), extrapolationTolerance);
    return List.of(
        new Attempt(first, new RadauCode(7), radauTolerance),
        extrapolation,
        new Attempt(second, new RadauCode(5), radauTolerance),
        new Attempt(first, new RadauCode(7), LOOSER * radauTolerance),
        new Attempt(second, new RadauCode(5), LOOSER * radauTolerance));
  }

  private Optional<Solved> solve(Attempt attempt, double[] times, double change, double seconds) {
    ModelProblem problem = attempt.source().fresh().get();
    double[] y0 = problem.start();
    if (change > 0) {
      perturb(problem, times[0], y0, change);
    } else if (problem.dimension() > DENSE_LIMIT) {
      problem.takePart();
    }
    return attempt
        .code()
        .solve(problem, times, y0, attempt.tolerance(), deadline(seconds))
        .map(states -> new Solved(attempt.how(), attempt, states, problem.course()));
  }

  private static long deadline(double seconds) {
    return System.nanoTime() + (long) (seconds * TimeUnit.SECONDS.toNanos(1));
  }

  /** Keeps the times that all solutions reach and at which a state that jumps can be compared. */
  private Optional<Reference> comparable(
      List<Solved> solved, double[] times, List<String> said, double seconds) {
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
              "Large mechanism: in that time the codes reached %.3g s; the interval up to it is"
                  + " judged.",
              times[reached - 1]));
    }
    double[] clear = Arrays.stream(kept).mapToDouble(i -> times[i]).toArray();
    List<String> all = new ArrayList<>(said);
    List<ModelPhases> courses = solved.stream().flatMap(one -> one.course().stream()).toList();
    all.addAll(JumpNotes.of(courses, clear[clear.length - 1], kept.length, times.length));
    courses.stream().map(ModelPhases::end).filter(end -> !end.isEmpty()).limit(1).forEach(all::add);
    return Optional.of(
        judged(solved.stream().map(one -> one.at(kept)).toList(), clear, all, seconds));
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

  /**
   * @param seconds for each solution from a changed start
   */
  private Reference judged(List<Solved> solved, double[] times, List<String> said, double seconds) {
    Solved best = solved.get(0);
    List<String> sources = new ArrayList<>();
    sources.add("Reference: " + best.how() + ".");
    double[] floor = new double[times.length];
    Optional<double[]> amplified = grown(best, times, AMPLIFIED, seconds);
    // What a large mechanism does to rounding is read from a single changed start.
    Optional<double[]> rounding =
        isLarge(best.attempt().source())
            ? amplified.map(moved -> scaled(moved, Math.ulp(1.0) / 2 / AMPLIFIED))
            : grown(best, times, Math.ulp(1.0) / 2, seconds);
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
        amplified.map(moved -> scaled(moved, 1 / AMPLIFIED)),
        best.jumps(),
        sources);
  }

  private static double[] scaled(double[] moved, double factor) {
    return Arrays.stream(moved).map(one -> factor * one).toArray();
  }

  private Optional<double[]> grown(Solved solved, double[] times, double change, double seconds) {
    return solve(solved.attempt(), times, change, seconds)
        .map(moved -> distances(moved.states(), solved.states()));
  }

  /** Distances are unknown where one of them has ended before. */
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

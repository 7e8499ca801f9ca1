package org.mechservice.report.measure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.report.method.Candidate;

/**
 * The first run of each method at each tolerance, which has its error, within a part of the
 * report's {@link ReportBudget}.
 *
 * <p>A run is stopped after the effort's limit, and earlier where it takes {@link Effort#SENSELESS}
 * times what the fastest method takes at the same tolerance. Such a point is a failure that says
 * so. Where even the fastest method takes long, because the mechanism is large, the limit follows
 * it.
 *
 * <p>At the loosest tolerance, where nothing is known of a method, every one has its share of the
 * time, and what one does not use is for the others. Methods that were fast at a tolerance come
 * first at the next one, and a run whose time, forecast from looser tolerances, would be missing to
 * them is left out. A method that its share did not bring to the end is tried again with the time
 * that is left when all others have their points.
 */
final class FirstRuns {
  private static final String NOT_RUN = "not run: it did not finish at a looser tolerance";
  private static final String BUDGET = "stopped by the budget: ";

  /** Part of the report's remaining time for the first run of every point. */
  private static final double PART = 0.6;

  /** Part of that which the runs at the loosest tolerance may take, one of each method. */
  private static final double OF_LOOSEST = 0.5;

  /** Largest time of a run in times of the fastest method, however large the mechanism is. */
  private static final double BESIDE_FASTEST = 10;

  /** A run that was stopped is tried again with so many times what it had. */
  private static final double LONGER = 2;

  private final MethodRunner runner;
  private final MeasurementFile journal;
  private final Effort effort;
  private final ReportBudget budget;
  private final ReportProgress progress;
  private final Map<Candidate, Course> courses = new LinkedHashMap<>();

  /** Time by the clock beside that of the runs made here, s, and their number. */
  private double asideSeconds;

  private int firstRuns;

  FirstRuns(
      MethodRunner runner,
      MeasurementFile journal,
      Effort effort,
      ReportBudget budget,
      ReportProgress progress) {
    this.runner = runner;
    this.journal = journal;
    this.effort = effort;
    this.budget = budget;
    this.progress = progress;
  }

  /**
   * Runs the points that the file of measurements does not have yet.
   *
   * @return points that the report's time did not allow; they are not in the file
   */
  List<MeasuredRun> run(List<Candidate> candidates) throws IOException {
    candidates.forEach(candidate -> courses.put(candidate, new Course()));
    findErrors(candidates);
    return courses.values().stream()
        .flatMap(course -> course.firsts.stream())
        .filter(FirstRuns::isLeftOut)
        .toList();
  }

  /** Returns the time by the clock that a run took on average beside its own, s. */
  double asideOfOne() {
    return firstRuns == 0 ? 0 : asideSeconds / firstRuns;
  }

  /** First runs of a method, from the loosest tolerance on. */
  private static final class Course {
    private final List<MeasuredRun> firsts = new ArrayList<>();

    /** Time of its last run that reached the end, s; infinite if none did. */
    double last() {
      return firsts.stream()
          .filter(MeasuredRun::completed)
          .mapToDouble(MeasuredRun::seconds)
          .reduce(Double.POSITIVE_INFINITY, (earlier, later) -> later);
    }

    /** Time of its next run as the last two let expect, s; infinite if unknown. */
    double forecast() {
      List<MeasuredRun> done = firsts.stream().filter(MeasuredRun::completed).toList();
      if (done.size() < 2) {
        return last();
      }
      double before = done.get(done.size() - 2).seconds();
      return last() * Math.max(1, done.get(done.size() - 1).seconds() / before);
    }
  }

  private Course course(Candidate candidate) {
    return courses.computeIfAbsent(candidate, k -> new Course());
  }

  private static boolean isLeftOut(MeasuredRun run) {
    return run.cause().startsWith(Campaign.LEFT_OUT);
  }

  /** Runs tolerance by tolerance, so that the time of the fastest method is known at each. */
  private void findErrors(List<Candidate> candidates) throws IOException {
    double after = (1 - PART) * budget.left();
    double[] tolerances = effort.tolerances();
    int points = candidates.size() * tolerances.length;
    int done = 0;
    double spent = 0;
    Set<Candidate> hopeless = new HashSet<>();
    for (int i = 0; i < tolerances.length; i++) {
      Map<Candidate, MeasuredRun> found = new LinkedHashMap<>();
      for (Candidate candidate : fastestFirst(candidates)) {
        double left =
            spent == 0 ? Double.NaN : spent / done * (points - done + wholeRounds(points));
        progress.at(
            "errors: " + candidate.method(), 0.3 * done / points, Math.min(left, budget.left()));
        double all = processorTime(budget.left() - after);
        double time =
            i == 0
                ? OF_LOOSEST * all / (candidates.size() - found.size())
                : all - Math.min(all / 2, reserved(candidate, found, tolerances.length - 1 - i));
        MeasuredRun first =
            first(candidate, tolerances[i], hopeless, fastest(found.values()), time);
        found.put(candidate, first);
        spent += first.seconds();
        done++;
      }
      if (i == 0) {
        tryLonger(found, budget.left() - after);
      }
      conclude(candidates, found, hopeless);
    }
    tryAgain(candidates, budget.left() - after);
  }

  /** Processor time of a run that has some time by the clock, with what is done beside it. */
  private double processorTime(double clock) {
    return Math.max(0, clock - asideOfOne()) / runner.load();
  }

  private List<Candidate> fastestFirst(List<Candidate> candidates) {
    List<Candidate> ordered = new ArrayList<>(candidates);
    ordered.sort(Comparator.comparingDouble(candidate -> course(candidate).last()));
    return ordered;
  }

  /** Time that faster methods need at the tolerances to come, s. */
  private double reserved(Candidate candidate, Map<Candidate, MeasuredRun> found, int tolerances) {
    double own = course(candidate).forecast();
    double reserved = 0;
    for (Map.Entry<Candidate, MeasuredRun> other : found.entrySet()) {
      double seconds = other.getValue().seconds();
      if (other.getValue().completed() && seconds < own) {
        reserved += tolerances * seconds;
      }
    }
    return reserved;
  }

  private double wholeRounds(int points) {
    return (double) effort.fewestRepeats() * points;
  }

  private Optional<MeasuredRun> kept(Candidate candidate, double tolerance) {
    return journal.runs(candidate.method().name(), tolerance).stream().findFirst();
  }

  /**
   * The first run of a point.
   *
   * @param time for it, s
   */
  private MeasuredRun first(
      Candidate candidate,
      double tolerance,
      Set<Candidate> hopeless,
      Optional<MeasuredRun> best,
      double time) {
    Optional<MeasuredRun> kept = kept(candidate, tolerance);
    String method = candidate.method().name();
    if (kept.isPresent()) {
      return kept.get();
    }
    if (hopeless.contains(candidate)) {
      boolean leftOut = course(candidate).firsts.stream().anyMatch(FirstRuns::isLeftOut);
      String cause =
          leftOut ? Campaign.LEFT_OUT + "it was left out at a looser tolerance" : NOT_RUN;
      return MeasuredRun.notRun(method, tolerance, cause);
    }
    double forecast = course(candidate).forecast();
    boolean tooLong = Double.isFinite(forecast) && forecast > time;
    if (tooLong || (Double.isInfinite(forecast) && time < MethodRunner.SHORTEST_LIMIT)) {
      return MeasuredRun.notRun(method, tolerance, Campaign.LEFT_OUT + noTime(forecast, time));
    }
    double sense = best.map(FirstRuns::mostSeconds).orElse(Double.POSITIVE_INFINITY);
    double fastest =
        best.map(MeasuredRun::seconds)
            .orElseGet(
                () -> courses.values().stream().mapToDouble(Course::last).min().orElseThrow());
    double follows = Double.isFinite(fastest) ? BESIDE_FASTEST * fastest : 0;
    double usual = Math.max(effort.limitSeconds(), follows);
    double limit = Math.min(usual, Math.min(sense, time));
    MeasuredRun run = timed(candidate, tolerance, limit);
    if (!run.cause().startsWith(MethodRunner.NOT_FINISHED)) {
      return run;
    }
    if (limit == time) {
      return run.failed(Campaign.LEFT_OUT + run.cause() + ", and " + allows());
    }
    return limit == sense ? run.failed(BUDGET + run.cause() + compared(best.orElseThrow())) : run;
  }

  private MeasuredRun timed(Candidate candidate, double tolerance, double limit) {
    long started = System.nanoTime();
    MeasuredRun run = runner.run(candidate, tolerance, 0, limit);
    double clock = (System.nanoTime() - started) * 1e-9;
    asideSeconds += Math.max(0, clock - runner.load() * run.seconds());
    firstRuns++;
    return run;
  }

  private String noTime(double forecast, double time) {
    String takes =
        Double.isFinite(forecast)
            ? "a run would take about " + ReportBudget.inWords(forecast)
            : "it is not known how long a run takes";
    String left = time > 0 ? ReportBudget.inWords(time) : "nothing";
    return String.format(
        Locale.ROOT,
        "%s, and of the %s for the report %s is left beside faster methods",
        takes,
        ReportBudget.inWords(budget.seconds()),
        left);
  }

  private String allows() {
    return String.format(
        Locale.ROOT,
        "the %s for the report allow no more beside faster methods",
        ReportBudget.inWords(budget.seconds()));
  }

  /**
   * Gives methods more time at the loosest tolerance that were stopped before it was known what the
   * fastest takes, or if none of them came to the end.
   */
  private void tryLonger(Map<Candidate, MeasuredRun> found, double time) {
    Optional<MeasuredRun> fastest = fastest(found.values());
    double limit =
        fastest
            .map(run -> BESIDE_FASTEST * run.seconds())
            .orElseGet(() -> Math.min(BESIDE_FASTEST * effort.limitSeconds(), time / 2));
    double end = budget.left() - time;
    for (Map.Entry<Candidate, MeasuredRun> one : found.entrySet()) {
      boolean late = one.getValue().cause().startsWith(MethodRunner.NOT_FINISHED);
      double left = budget.left() - end;
      boolean kept = kept(one.getKey(), one.getValue().tolerance()).isPresent();
      double most = Math.min(limit, processorTime(left / 2));
      if (late && !kept && most > LONGER * one.getValue().seconds()) {
        progress.at("errors, with more time: " + one.getKey().method(), 0.1, left);
        MeasuredRun again = timed(one.getKey(), one.getValue().tolerance(), most);
        one.setValue(again);
        if (again.completed()) {
          limit = Math.min(limit, BESIDE_FASTEST * again.seconds());
        }
      }
    }
  }

  /**
   * Gives the time that is left for first runs to methods that their share of it did not bring to
   * the end of the loosest tolerance.
   */
  private void tryAgain(List<Candidate> candidates, double time) throws IOException {
    double end = budget.left() - time;
    List<Candidate> late =
        candidates.stream()
            .filter(candidate -> course(candidate).firsts.stream().allMatch(FirstRuns::isLeftOut))
            .toList();
    for (int i = 0; i < late.size(); i++) {
      Course course = course(late.get(i));
      MeasuredRun before = course.firsts.get(0);
      double left = processorTime(budget.left() - end) / (late.size() - i);
      if (left < Math.max(MethodRunner.SHORTEST_LIMIT, LONGER * before.seconds())) {
        continue;
      }
      progress.at("errors, with more time: " + late.get(i).method(), 0.3, budget.left());
      double limit = Math.min(left, BESIDE_FASTEST * effort.limitSeconds());
      MeasuredRun again = timed(late.get(i), before.tolerance(), limit);
      if (again.cause().startsWith(MethodRunner.NOT_FINISHED)) {
        course.firsts.set(0, again.failed(Campaign.LEFT_OUT + again.cause() + ", and " + allows()));
      } else {
        course.firsts.set(0, again);
        journal.add(again);
      }
    }
  }

  /** Keeps the first runs of a tolerance, in the order of the methods. */
  private void conclude(
      List<Candidate> candidates, Map<Candidate, MeasuredRun> found, Set<Candidate> hopeless)
      throws IOException {
    Optional<MeasuredRun> fastest = fastest(found.values());
    for (Candidate candidate : candidates) {
      MeasuredRun run = found.get(candidate);
      if (run == null) {
        continue;
      }
      MeasuredRun first = sensible(run, fastest);
      course(candidate).firsts.add(first);
      if (!isLeftOut(first) && kept(candidate, first.tolerance()).isEmpty()) {
        journal.add(first);
      }
      // A method that did not end in time will not do so at a tighter tolerance either.
      if (first.cause().startsWith(MethodRunner.NOT_FINISHED)
          || first.cause().equals(NOT_RUN)
          || isLeftOut(first)) {
        hopeless.add(candidate);
      }
    }
  }

  private static Optional<MeasuredRun> fastest(Collection<MeasuredRun> runs) {
    return runs.stream()
        .filter(MeasuredRun::completed)
        .min(Comparator.comparingDouble(MeasuredRun::seconds));
  }

  private static double mostSeconds(MeasuredRun fastest) {
    return Math.max(Effort.CHEAP_SECONDS, Effort.SENSELESS * fastest.seconds());
  }

  private static String compared(MeasuredRun fastest) {
    return String.format(
        Locale.ROOT, "; %s takes %.3g s at this tolerance", fastest.method(), fastest.seconds());
  }

  /** A run that ended before a far faster method was known. */
  private static MeasuredRun sensible(MeasuredRun run, Optional<MeasuredRun> fastest) {
    if (fastest.isEmpty() || !run.completed() || run.seconds() <= mostSeconds(fastest.get())) {
      return run;
    }
    String took = String.format(Locale.ROOT, "not timed, a run takes %.3g s", run.seconds());
    return run.failed(BUDGET + took + compared(fastest.get()));
  }
}

package org.mechservice.report.measure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.mechservice.report.method.Candidate;

/**
 * Runs all methods at all tolerances: first each once for its error, then in timed rounds with
 * every point once per round, so that disturbances of the machine affect all equally.
 *
 * <p>A run is stopped after the effort's limit, and earlier where it takes {@link Effort#SENSELESS}
 * times what the fastest method takes at the same tolerance. Such a point is a failure that says
 * so.
 */
public final class Campaign {
  private static final String NOT_RUN = "not run: it did not finish at a looser tolerance";
  private static final String BUDGET = "stopped by the budget: ";

  private final MethodRunner runner;
  private final MeasurementFile journal;
  private final Effort effort;
  private final ReportProgress progress;

  public Campaign(
      MethodRunner runner, MeasurementFile journal, Effort effort, ReportProgress progress) {
    this.runner = runner;
    this.journal = journal;
    this.effort = effort;
    this.progress = progress;
  }

  /** Runs the points that the file of measurements does not have yet. */
  public void run(List<Candidate> candidates) throws IOException {
    findErrors(candidates);
    warmUp(candidates);
    time(candidates);
  }

  /** Runs tolerance by tolerance, so that the time of the fastest method is known at each. */
  private void findErrors(List<Candidate> candidates) throws IOException {
    int points = candidates.size() * effort.tolerances().length;
    int done = 0;
    double spent = 0;
    Set<Candidate> hopeless = new HashSet<>();
    for (double tolerance : effort.tolerances()) {
      List<MeasuredRun> firsts = new ArrayList<>();
      for (Candidate candidate : candidates) {
        double left =
            spent == 0 ? Double.NaN : spent / done * (points - done + wholeRounds(points));
        progress.at("errors: " + candidate.method(), 0.3 * done / points, left);
        MeasuredRun first = first(candidate, tolerance, hopeless, fastest(firsts));
        firsts.add(first);
        spent += first.seconds();
        done++;
      }
      Optional<MeasuredRun> fastest = fastest(firsts);
      for (int i = 0; i < firsts.size(); i++) {
        MeasuredRun first = sensible(firsts.get(i), fastest);
        if (kept(candidates.get(i), tolerance).isEmpty()) {
          journal.add(first);
        }
        if (first.cause().startsWith(MethodRunner.NOT_FINISHED) || first.cause().equals(NOT_RUN)) {
          // A method that did not end in time will not do so at a tighter tolerance either.
          hopeless.add(candidates.get(i));
        }
      }
    }
  }

  private double wholeRounds(int points) {
    return (double) effort.fewestRepeats() * points;
  }

  private Optional<MeasuredRun> kept(Candidate candidate, double tolerance) {
    return journal.runs(candidate.method().name(), tolerance).stream().findFirst();
  }

  private MeasuredRun first(
      Candidate candidate, double tolerance, Set<Candidate> hopeless, Optional<MeasuredRun> best) {
    Optional<MeasuredRun> kept = kept(candidate, tolerance);
    if (kept.isPresent()) {
      return kept.get();
    }
    if (hopeless.contains(candidate)) {
      return MeasuredRun.notRun(candidate.method().name(), tolerance, NOT_RUN);
    }
    double sense = best.map(Campaign::mostSeconds).orElse(Double.POSITIVE_INFINITY);
    MeasuredRun run = runner.run(candidate, tolerance, 0, Math.min(effort.limitSeconds(), sense));
    boolean beyondSense =
        sense < effort.limitSeconds() && run.cause().startsWith(MethodRunner.NOT_FINISHED);
    return beyondSense ? run.failed(BUDGET + run.cause() + compared(best.orElseThrow())) : run;
  }

  private static Optional<MeasuredRun> fastest(List<MeasuredRun> runs) {
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

  /** In the same order as later the timed runs, so that the compiler sees the same. */
  private void warmUp(List<Candidate> candidates) {
    List<Due> due = due(candidates);
    if (!due.isEmpty() && effort.warmSeconds() > 0 && toDo(due) > 0) {
      double limit = 5 * effort.limitSeconds();
      WarmUpRounds.until(
          () ->
              due.stream()
                  .mapToDouble(d -> runner.run(d.candidate(), d.tolerance(), 0, limit).seconds())
                  .sum(),
          effort.warmSeconds(),
          progress,
          toDo(due));
    }
  }

  /** Returns the time of all timed runs that are not in the journal yet, s. */
  private double toDo(List<Due> due) {
    double seconds = 0;
    for (Due point : due) {
      for (int round = 1; round <= point.repeats(); round++) {
        seconds += isDone(point, round) ? 0 : point.seconds();
      }
    }
    return seconds;
  }

  private record Due(Candidate candidate, double tolerance, double seconds, int repeats) {}

  private void time(List<Candidate> candidates) throws IOException {
    List<Due> due = due(candidates);
    double left = toDo(due);
    double total = left;
    long started = System.nanoTime();
    for (int round = 1; round <= Effort.REPEATS; round++) {
      for (Due point : turned(due, round)) {
        if (round > point.repeats() || isDone(point, round)) {
          continue;
        }
        double elapsed = (System.nanoTime() - started) * 1e-9;
        double rate = left < 0.95 * total ? elapsed / (total - left) : 1;
        progress.at(
            "timing, round " + round + " of " + Effort.REPEATS + ": " + point.candidate().method(),
            0.3 + 0.65 * (1 - left / total),
            rate * left);
        double limit = 5 * effort.limitSeconds();
        journal.add(runner.run(point.candidate(), point.tolerance(), round, limit));
        left -= point.seconds();
      }
    }
  }

  /** Every round begins at another point, so that none always follows the same one's garbage. */
  private static List<Due> turned(List<Due> due, int round) {
    List<Due> turned = new ArrayList<>(due);
    Collections.rotate(turned, round * due.size() / Effort.REPEATS);
    return turned;
  }

  private boolean isDone(Due point, int round) {
    return journal.runs(point.candidate().method().name(), point.tolerance()).stream()
        .anyMatch(run -> run.round() == round);
  }

  /** Points that reached the end; those that take long are repeated less often. */
  private List<Due> due(List<Candidate> candidates) {
    List<Due> points = new ArrayList<>();
    for (Candidate candidate : candidates) {
      for (double tolerance : effort.tolerances()) {
        MeasuredRun first = kept(candidate, tolerance).orElseThrow();
        if (first.completed()) {
          points.add(new Due(candidate, tolerance, first.seconds(), Effort.REPEATS));
        }
      }
    }
    return affordable(points);
  }

  private List<Due> affordable(List<Due> points) {
    List<Due> cheapestFirst = new ArrayList<>(points);
    cheapestFirst.sort(Comparator.comparingDouble(Due::seconds));
    double left = effort.timingSeconds();
    List<Due> due = new ArrayList<>();
    for (int i = 0; i < cheapestFirst.size(); i++) {
      Due point = cheapestFirst.get(i);
      double share = left / (cheapestFirst.size() - i);
      int repeats = (int) Math.min(Effort.REPEATS, share / point.seconds());
      repeats = Math.max(effort.fewestRepeats(), repeats);
      left -= repeats * point.seconds();
      due.add(new Due(point.candidate(), point.tolerance(), point.seconds(), repeats));
    }
    // In the order of the page, which mixes methods with every tolerance.
    due.sort(Comparator.comparingDouble(Due::tolerance).reversed());
    return due;
  }
}

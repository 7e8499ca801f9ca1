package org.mechservice.report.measure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.mechservice.report.method.Candidate;

/**
 * Timed rounds of all points whose first run reached the end, every point once per round, so that
 * disturbances of the machine affect all equally. As many as a part of the report's {@link
 * ReportBudget} allows; points that take long are repeated less often.
 */
final class TimedRounds {
  /** Part of the report's remaining time for timed runs, and at most half of it to warm up. */
  private static final double PART = 0.7;

  private final MethodRunner runner;
  private final MeasurementFile journal;
  private final Effort effort;
  private final ReportBudget budget;
  private final ReportProgress progress;

  TimedRounds(
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
   * Repeats rounds in the order of the timed runs until the compiler has finished.
   *
   * @param aside time by the clock that a run takes beside its own, s
   */
  void warmUp(List<Candidate> candidates, double aside) {
    List<Due> due = due(candidates).stream().filter(point -> point.repeats() > 0).toList();
    double processor = due.stream().mapToDouble(Due::seconds).sum();
    double round = runner.load() * processor + due.size() * aside;
    double rounds = Math.max(2, 2 * effort.warmSeconds() / Math.max(processor, 1e-3));
    if (rounds * round > PART / 2 * budget.left()) {
      budget.saves(
          "Rounds to warm up were left out: one takes about " + ReportBudget.inWords(round) + ".");
      return;
    }
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

  /** Times the points that the file of measurements does not have yet. */
  void time(List<Candidate> candidates) throws IOException {
    List<Due> due = due(candidates);
    double left = toDo(due);
    double total = left;
    long started = System.nanoTime();
    double after = (1 - PART) * budget.left();
    for (int round = 1; round <= Effort.REPEATS; round++) {
      for (Due point : turned(due, round)) {
        if (round > point.repeats() || isDone(point, round)) {
          continue;
        }
        if (budget.left() - after < runner.load() * point.seconds()) {
          reportRepeats(due);
          return;
        }
        double elapsed = (System.nanoTime() - started) * 1e-9;
        double rate = left < 0.95 * total ? elapsed / (total - left) : 1;
        progress.at(
            "timing, round " + round + " of " + Effort.REPEATS + ": " + point.candidate().method(),
            0.3 + 0.65 * (1 - left / total),
            Math.min(rate * left, budget.left()));
        double limit = 5 * Math.max(effort.limitSeconds(), point.seconds());
        journal.add(runner.run(point.candidate(), point.tolerance(), round, limit));
        left -= point.seconds();
      }
    }
    reportRepeats(due);
  }

  private void reportRepeats(List<Due> due) {
    int fewest = due.stream().mapToInt(this::roundsOf).min().orElse(effort.fewestRepeats());
    int most = due.stream().mapToInt(this::roundsOf).max().orElse(0);
    if (fewest < effort.fewestRepeats()) {
      budget.saves(
          String.format(
              Locale.ROOT,
              "Points were timed %s, as far as the time for the report reached%s.",
              most == 0 ? "by their first run alone" : fewest + " to " + most + " times",
              fewest == 0 && most > 0
                  ? "; a point that was not timed has the time of its first run"
                  : ""));
    }
  }

  private int roundsOf(Due point) {
    return journal.runs(point.candidate().method().name(), point.tolerance()).size() - 1;
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
        journal.runs(candidate.method().name(), tolerance).stream()
            .findFirst()
            .filter(MeasuredRun::completed)
            .map(first -> new Due(candidate, tolerance, first.seconds(), Effort.REPEATS))
            .ifPresent(points::add);
      }
    }
    return affordable(points);
  }

  private List<Due> affordable(List<Due> points) {
    List<Due> cheapestFirst = new ArrayList<>(points);
    cheapestFirst.sort(Comparator.comparingDouble(Due::seconds));
    double time = PART * budget.left() / runner.load();
    double whole = points.stream().mapToDouble(Due::seconds).sum() * effort.fewestRepeats();
    int fewest = whole <= time ? effort.fewestRepeats() : 0;
    double left = Math.min(effort.timingSeconds(), time);
    List<Due> due = new ArrayList<>();
    for (int i = 0; i < cheapestFirst.size(); i++) {
      Due point = cheapestFirst.get(i);
      double share = left / (cheapestFirst.size() - i);
      int repeats = (int) Math.min(Effort.REPEATS, share / point.seconds());
      repeats = Math.max(fewest, repeats);
      left -= repeats * point.seconds();
      due.add(new Due(point.candidate(), point.tolerance(), point.seconds(), repeats));
    }
    // In the order of the page, which mixes methods with every tolerance.
    due.sort(Comparator.comparingDouble(Due::tolerance).reversed());
    return due;
  }
}

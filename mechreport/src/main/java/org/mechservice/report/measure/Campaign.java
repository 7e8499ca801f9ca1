package org.mechservice.report.measure;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.mechservice.report.method.Candidate;

/**
 * All methods at all tolerances: first each once, for its error, then timed in rounds, every point
 * once per round, so that whatever slows the machine down hits all alike.
 */
public final class Campaign {
  private final MethodRunner runner;
  private final Journal journal;
  private final Effort effort;
  private final Progress progress;

  public Campaign(MethodRunner runner, Journal journal, Effort effort, Progress progress) {
    this.runner = runner;
    this.journal = journal;
    this.effort = effort;
    this.progress = progress;
  }

  /** Runs what is not in the journal yet. */
  public void run(List<Candidate> candidates) throws IOException {
    findErrors(candidates);
    warmUp(candidates);
    time(candidates);
  }

  private void findErrors(List<Candidate> candidates) throws IOException {
    int points = candidates.size() * effort.tolerances().length;
    int done = 0;
    for (Candidate candidate : candidates) {
      boolean hopeless = false;
      for (double tolerance : effort.tolerances()) {
        progress.at("errors: " + candidate.method(), 0.3 * done++ / points, Double.NaN);
        List<MeasuredRun> before = journal.runs(candidate.method().name(), tolerance);
        MeasuredRun first =
            before.isEmpty() ? first(candidate, tolerance, hopeless) : before.get(0);
        if (before.isEmpty()) {
          journal.add(first);
        }
        hopeless |= tooLong(first);
      }
    }
  }

  /** What did not end in time will not do so at a tighter tolerance either. */
  private MeasuredRun first(Candidate candidate, double tolerance, boolean hopeless) {
    return runner.run(candidate, tolerance, 0, hopeless ? 0.01 : effort.limitSeconds());
  }

  private static boolean tooLong(MeasuredRun run) {
    return run.cause().startsWith("not finished");
  }

  /** Lets the JIT compiler finish with every method before any is timed. */
  private void warmUp(List<Candidate> candidates) {
    for (Candidate candidate : candidates) {
      progress.at("warming up: " + candidate.method(), 0.3, Double.NaN);
      long end = System.nanoTime() + (long) (effort.warmSeconds() * 1e9);
      boolean works = true;
      while (works && System.nanoTime() < end) {
        double limit = effort.limitSeconds();
        works = runner.run(candidate, effort.tolerances()[0], 0, limit).completed();
      }
    }
  }

  private record Due(Candidate candidate, double tolerance, double seconds, int repeats) {}

  private void time(List<Candidate> candidates) throws IOException {
    List<Due> due = due(candidates);
    double total = due.stream().mapToDouble(point -> point.seconds() * point.repeats()).sum();
    long started = System.nanoTime();
    double spent = 0;
    for (int round = 1; round <= Effort.REPEATS; round++) {
      for (Due point : due) {
        if (round > point.repeats() || isDone(point, round)) {
          continue;
        }
        double elapsed = (System.nanoTime() - started) * 1e-9;
        double left = spent > 0 ? elapsed * (total - spent) / spent : total;
        progress.at(
            "timing, round " + round + " of " + Effort.REPEATS + ": " + point.candidate().method(),
            0.3 + 0.7 * spent / Math.max(total, 1e-9),
            left);
        double limit = 5 * effort.limitSeconds();
        journal.add(runner.run(point.candidate(), point.tolerance(), round, limit));
        spent += point.seconds();
      }
    }
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
        MeasuredRun first = journal.runs(candidate.method().name(), tolerance).get(0);
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
      repeats = Math.max(Effort.FEWEST_REPEATS, repeats);
      left -= repeats * point.seconds();
      due.add(new Due(point.candidate(), point.tolerance(), point.seconds(), repeats));
    }
    // In the order of the page, which mixes methods with every tolerance.
    due.sort(Comparator.comparingDouble(Due::tolerance).reversed());
    return due;
  }
}

package org.mechservice.study.gradient;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.ode.solve.EndReason;
import org.mechservice.solver.ode.solve.FoundEvent;
import org.mechservice.solver.ode.solve.Ode;
import org.mechservice.solver.ode.solve.OdeCheckpoint;
import org.mechservice.solver.ode.solve.OdeOptions;
import org.mechservice.solver.ode.solve.OdeProblem;
import org.mechservice.solver.ode.solve.OdeSolution;

/**
 * A motion that can be evaluated anywhere, in a bounded memory: it is integrated in segments of
 * equally many steps. Once their steps take more than the bound, only a checkpoint is kept of the
 * oldest ones, and a segment that is asked for again is integrated again from there, with the same
 * bits. Read backwards, no segment is integrated more than twice.
 */
final class SolutionSegments {
  /** Orders of the methods, and what is kept beside them, in vectors of the state. */
  private static final int VECTORS = 15;

  private static final int FEWEST_STEPS = 50;
  private static final int LEAST_SEGMENTS = 4;

  private final OdeProblem problem;
  private final OdeOptions options;
  private final long segmentSteps;
  private final long mostKept;
  private final double t0;
  private final double[] y0;
  private final double tEnd;
  private final List<Segment> segments = new ArrayList<>();
  private final List<FoundEvent> events = new ArrayList<>();
  private long steps;
  private long counted;
  private int last = -1;

  /** A part of the motion. */
  private static final class Segment {
    final double start;
    final double end;
    final Optional<OdeCheckpoint> from;
    Optional<OdeSolution> solution;

    Segment(double start, double end, Optional<OdeCheckpoint> from, OdeSolution solution) {
      this.start = start;
      this.end = end;
      this.from = from;
      this.solution = Optional.of(solution);
    }
  }

  /**
   * Integrates.
   *
   * @param options without kept steps
   * @param memory bound for the kept steps, bytes
   */
  SolutionSegments(
      OdeProblem problem, OdeOptions options, double t0, double[] y0, double tEnd, long memory) {
    this.problem = problem;
    this.t0 = t0;
    this.y0 = y0.clone();
    this.tEnd = tEnd;
    long stepBytes = 8L * VECTORS * Math.max(1, y0.length);
    segmentSteps = Math.max(FEWEST_STEPS, memory / LEAST_SEGMENTS / stepBytes);
    mostKept = Math.max(2, memory / (segmentSteps * stepBytes));
    this.options =
        options
            .keepSteps(true)
            .onStep(
                step -> {
                  if (++counted == segmentSteps) {
                    step.stop();
                  }
                });
    integrate();
  }

  private void integrate() {
    Optional<OdeCheckpoint> from = Optional.empty();
    while (true) {
      OdeSolution solution = solved(from);
      segments.add(new Segment(solution.start(), solution.end(), from, solution));
      events.addAll(solution.events());
      steps += solution.statistics().steps();
      if (solution.endReason() != EndReason.STOPPED || solution.end() == tEnd) {
        return;
      }
      if (segments.size() > mostKept) {
        segments.get(segments.size() - 1 - (int) mostKept).solution = Optional.empty();
      }
      from = Optional.of(solution.checkpoint());
    }
  }

  private OdeSolution solved(Optional<OdeCheckpoint> from) {
    counted = 0;
    return from.isPresent()
        ? Ode.resume(problem, from.get(), options)
        : Ode.solve(problem, t0, y0, tEnd, options);
  }

  /** Returns the events in their order. */
  List<FoundEvent> events() {
    return events;
  }

  /** Returns whether an event has ended the motion. */
  boolean endedByEvent() {
    return solution(segments.size() - 1).endReason() == EndReason.EVENT;
  }

  /** Returns the end, s. */
  double end() {
    return segments.get(segments.size() - 1).end;
  }

  /** Returns the state at the end. */
  double[] endState() {
    return solution(segments.size() - 1).endState();
  }

  /** Returns the number of steps of the first integration. */
  long steps() {
    return steps;
  }

  /**
   * Evaluates the motion; behind an event, where one is.
   *
   * @param y overwritten
   */
  void at(double t, double[] y) {
    solution(segmentAt(t)).at(t, y);
  }

  private int segmentAt(double t) {
    int at = last < 0 ? segments.size() - 1 : last;
    while (at > 0 && t < segments.get(at).start) {
      at--;
    }
    while (at < segments.size() - 1 && t > segments.get(at).end) {
      at++;
    }
    last = at;
    return at;
  }

  private OdeSolution solution(int number) {
    Segment segment = segments.get(number);
    if (segment.solution.isEmpty()) {
      for (int i = number + (int) mostKept - 1; i < segments.size(); i++) {
        segments.get(i).solution = Optional.empty();
      }
      segment.solution = Optional.of(solved(segment.from));
    }
    return segment.solution.get();
  }
}

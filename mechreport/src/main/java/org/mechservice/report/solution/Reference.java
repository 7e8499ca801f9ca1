package org.mechservice.report.solution;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * The reference solution for runs.
 *
 * @param times where, increasing, the first is the start, s
 * @param states [q; v] there
 * @param floor per time, below which an error cannot be told from the reference's own or from
 *     rounding
 * @param rounding per time, by how much a start changed by one unit in the last place moves it
 * @param amplification per time, growth of a small change of the start; empty if not known
 * @param jumps at which the state jumps, increasing, s; no time is one of them
 * @param sources how it was made and checked, one sentence each
 */
@SuppressWarnings("ArrayRecordComponent") // states as the solver hands them out; not changed
public record Reference(
    double[] times,
    double[][] states,
    double[] floor,
    double[] rounding,
    Optional<double[]> amplification,
    List<Double> jumps,
    List<String> sources) {
  public Reference {
    jumps = List.copyOf(jumps);
    sources = List.copyOf(sources);
  }

  /** Of a motion without jumps. */
  public Reference(
      double[] times,
      double[][] states,
      double[] floor,
      double[] rounding,
      Optional<double[]> amplification,
      List<String> sources) {
    this(times, states, floor, rounding, amplification, List.of(), sources);
  }

  /** Said of one that a single code has made: its floor then knows nothing of the code's error. */
  static final String NOT_CHECKED = "Not checked: no second code solved the scene.";

  /** Returns whether a second code agrees, or the reference came with its own floor. */
  boolean isChecked() {
    return !sources.contains(NOT_CHECKED);
  }

  /** Returns the largest floor. */
  public double worstFloor() {
    return Arrays.stream(floor).max().orElse(0);
  }

  /** Returns the end, s. */
  public double end() {
    return times[times.length - 1];
  }

  /** Returns the same with a sentence more; without it if that is empty. */
  public Reference saying(String sentence) {
    if (sentence.isEmpty()) {
      return this;
    }
    List<String> all = new ArrayList<>(sources);
    all.add(sentence);
    return new Reference(times, states, floor, rounding, amplification, jumps, all);
  }

  /** Returns the first times alone. */
  public Reference upTo(int count) {
    return new Reference(
        Arrays.copyOf(times, count),
        Arrays.copyOf(states, count),
        Arrays.copyOf(floor, count),
        Arrays.copyOf(rounding, count),
        amplification.map(all -> Arrays.copyOf(all, count)),
        jumps.stream().filter(jump -> jump < times[count - 1]).toList(),
        sources);
  }
}

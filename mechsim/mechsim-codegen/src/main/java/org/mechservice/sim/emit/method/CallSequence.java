package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Consecutive calls of methods, once or repeated.
 *
 * @param calls the calls in order
 * @param count number of repetitions
 */
public record CallSequence(List<Call> calls, int count) {
  /** Smallest number of repetitions for a loop. */
  private static final int SHORTEST_LOOP = 3;

  /** Largest number of different calls in the body of a loop. */
  private static final int LONGEST_ROW = 4;

  /**
   * A call.
   *
   * @param method index among the plan's methods
   * @param numbers integer arguments of the first repetition
   * @param strides increment of each per repetition
   */
  public record Call(int method, List<Integer> numbers, List<Integer> strides) {
    /** A call that is not repeated. */
    public Call(int method, List<Integer> numbers) {
      this(method, numbers, Collections.nCopies(numbers.size(), 0));
    }

    /** Returns an integer argument as an expression of the loop's counter {@code i}. */
    public String text(int parameter) {
      int first = numbers.get(parameter);
      int stride = strides.get(parameter);
      if (stride == 0) {
        return Integer.toString(first);
      }
      String grown = Math.abs(stride) == 1 ? "i" : Math.abs(stride) + " * i";
      return first + (stride < 0 ? " - " : " + ") + grown;
    }
  }

  /** Returns whether it becomes a loop. */
  public boolean isLoop() {
    return count > 1;
  }

  /** Returns a single call without arguments. */
  public static CallSequence of(int method) {
    return new CallSequence(List.of(new Call(method, List.of())), 1);
  }

  /** Returns calls as steps, with loops wherever integer arguments grow by constant increments. */
  public static List<CallSequence> of(List<Call> calls) {
    List<CallSequence> steps = new ArrayList<>();
    for (int i = 0; i < calls.size(); ) {
      int row = 1;
      int times = 1;
      for (int length = 1; length <= LONGEST_ROW; length++) {
        int found = times(calls, i, length);
        if (found >= SHORTEST_LOOP && found * length > times * row) {
          row = length;
          times = found;
        }
      }
      steps.add(
          new CallSequence(times == 1 ? calls.subList(i, i + 1) : grown(calls, i, row), times));
      i += row * times;
    }
    return steps;
  }

  /** Returns the number of repetitions of a sequence of calls with constant increments. */
  private static int times(List<Call> calls, int start, int row) {
    if (start + 2 * row > calls.size()) {
      return 1;
    }
    List<Call> grown = grown(calls, start, row);
    int times = 1;
    while (start + (times + 1) * row <= calls.size() && continues(calls, grown, start, times)) {
      times++;
    }
    return times;
  }

  private static List<Call> grown(List<Call> calls, int start, int row) {
    List<Call> grown = new ArrayList<>();
    for (int i = start; i < start + row; i++) {
      Call call = calls.get(i);
      List<Integer> next = calls.get(i + row).numbers();
      List<Integer> strides = new ArrayList<>();
      for (int k = 0; k < Math.min(next.size(), call.numbers().size()); k++) {
        strides.add(next.get(k) - call.numbers().get(k));
      }
      grown.add(new Call(call.method(), call.numbers(), strides));
    }
    return grown;
  }

  private static boolean continues(List<Call> calls, List<Call> grown, int start, int times) {
    for (int i = 0; i < grown.size(); i++) {
      Call first = grown.get(i);
      Call call = calls.get(start + times * grown.size() + i);
      if (call.method() != first.method()) {
        return false;
      }
      for (int k = 0; k < first.numbers().size(); k++) {
        if (call.numbers().get(k) != first.numbers().get(k) + times * first.strides().get(k)) {
          return false;
        }
      }
    }
    return true;
  }
}

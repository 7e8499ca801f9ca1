package org.mechservice.solver.expression;

import java.util.List;
import java.util.Optional;

/**
 * A tape with its choices as plain lists, as printed code needs it.
 *
 * @param leafSlots slot of each leaf
 * @param resultSlots slot of each formula
 * @param initial contents of all slots before an evaluation: constants, zero elsewhere
 * @param steps in the order in which they are evaluated
 * @param choices in the order in which they are counted
 * @param canBeNarrow whether a formula can be large over a short way without a choice
 */
public record TapeListing(
    List<Integer> leafSlots,
    List<Integer> resultSlots,
    List<Double> initial,
    List<Step> steps,
    List<Choice> choices,
    boolean canBeNarrow) {
  public TapeListing {
    leafSlots = List.copyOf(leafSlots);
    resultSlots = List.copyOf(resultSlots);
    initial = List.copyOf(initial);
    steps = List.copyOf(steps);
    choices = List.copyOf(choices);
  }

  /**
   * A step: f(a) or f(a, b).
   *
   * @param operation name of the function, of a table {@code CURVE} or {@code MAP}
   * @param target slot that it writes
   * @param first slot of a
   * @param second slot of b; that of a again if there is one argument
   * @param choice index of the choice that it is, −1 if it is none
   * @param curve the table of one argument, if it is one
   * @param map the table of two arguments, if it is one
   */
  public record Step(
      String operation,
      int target,
      int first,
      int second,
      int choice,
      Optional<TableCurve> curve,
      Optional<MapSurface> map) {}

  /**
   * A choice.
   *
   * @param step index of its step
   * @param isSign whether its piece alone counts, whatever stands in its argument
   */
  public record Choice(int step, boolean isSign) {}
}

package org.mechservice.solver.ode.step;

import java.util.Optional;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.TrialOutcome;

/**
 * Looks at the steps that a method tries, and has some of them taken otherwise than their error
 * tests alone would. {@link #NONE}, which every integrator begins with, leaves the method as it is.
 *
 * <p>In the course of a step the method asks {@link #passes}; of a step that passed, {@link
 * #componentWithPole} and {@link #partToTake}; then {@link #accepted} or {@link #rejected} is told,
 * and {@link #aim}, {@link #atOrderOne} and {@link #longest} have a word in the next one.
 */
public interface StepWatch {
  /** Leaves every step to the method. */
  StepWatch NONE = new StepWatch() {};

  /** Returns what a saved integration calls it by: it goes on with the same watch only. */
  default String name() {
    return "none";
  }

  /**
   * Makes ready for a problem.
   *
   * @param step the step being tried, one object for all of them
   */
  default void prepare(TriedStep step) {}

  /** Begins without history: at the start, behind a jump, or where another method was at work. */
  default void begin(double t) {}

  /**
   * Returns whether the step that is estimated passes.
   *
   * @param error its error over the tolerance
   */
  default boolean passes(double error) {
    return error <= 1;
  }

  /**
   * Returns the component that grows beyond every bound inside of the step that passed; −1 if none
   * does.
   */
  default int componentWithPole() {
    return -1;
  }

  /**
   * Returns the part of the step that passed which is to be tried instead; 1: it is accepted as it
   * is.
   */
  default double partToTake() {
    return 1;
  }

  /**
   * Takes note that the step was accepted; {@link TriedStep#progress} is at its end.
   *
   * @return whether what lies before that is of no use for steps from there
   */
  default boolean accepted() {
    return false;
  }

  /**
   * Takes note that the step was rejected.
   *
   * @return whether nothing would come of shorter ones
   */
  default boolean rejected(TrialOutcome attempt) {
    return false;
  }

  /** Returns the size that the next step is to have at most, signed; infinite: the method's own. */
  default double aim() {
    return Double.POSITIVE_INFINITY;
  }

  /** Returns whether the step of that size is to be of order 1. */
  default boolean atOrderOne() {
    return false;
  }

  /** Returns the longest that the next step may be, positive. */
  default double longest() {
    return Double.POSITIVE_INFINITY;
  }

  /** Returns whether steps have become so much shorter that the next one is to be of order 1. */
  default boolean forgets() {
    return false;
  }

  /**
   * Returns whether the solution slides along a jump and would have to cross it for ever.
   *
   * @param h step to be tried next
   */
  default boolean slides(double h) {
    return false;
  }

  /** Returns whether something steep lies ahead that only an implicit method sees as a slope. */
  default boolean steepAhead() {
    return false;
  }

  /** Returns a further part that the watch has. */
  default <T> Optional<T> part(Class<T> type) {
    return type.isInstance(this) ? Optional.of(type.cast(this)) : Optional.empty();
  }

  /** Carries the state between two steps over. */
  default void transfer(SavedState state) {}
}

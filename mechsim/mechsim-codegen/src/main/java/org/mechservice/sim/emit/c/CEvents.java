package org.mechservice.sim.emit.c;

import java.util.List;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.symbol.Program;

/**
 * The events of a model in C, and the times at which its equations jump.
 *
 * @param kinds events in file order: names, directions and actions
 * @param triggers program from time and state to the functions whose zeros they are
 * @param assigned program from time and state to the values that they assign
 * @param assignments which event assigns which component of the state, in the order of the program
 * @param jumps times at which the equations jump, ascending
 * @param samplings times at which states are sampled
 */
public record CEvents(
    List<ModelEvents.Kind> kinds,
    Program triggers,
    Program assigned,
    List<Assignment> assignments,
    List<Jump> jumps,
    List<Sampled> samplings) {

  public CEvents {
    kinds = List.copyOf(kinds);
    assignments = List.copyOf(assignments);
    jumps = List.copyOf(jumps);
    samplings = List.copyOf(samplings);
  }

  /**
   * A time at which the equations jump.
   *
   * @param time of the jump, s
   * @param impulse whether a prescribed velocity jumps, so that the free ones change
   */
  public record Jump(double time, boolean impulse) {}

  /**
   * Times offset + k·period at which states are sampled.
   *
   * @param period s
   * @param offset s
   */
  public record Sampled(double period, double offset) {}

  /**
   * A component of the state that takes the value of an expression.
   *
   * @param event index of the event, or behind all events of the sampling
   * @param component index in x
   */
  public record Assignment(int event, int component) {}

  /** Returns the names of the events. */
  public List<String> names() {
    return kinds.stream().map(ModelEvents.Kind::name).toList();
  }
}

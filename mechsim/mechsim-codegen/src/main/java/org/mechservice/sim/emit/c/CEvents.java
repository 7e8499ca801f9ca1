package org.mechservice.sim.emit.c;

import java.util.List;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.api.capability.ModelEvents;

/**
 * The events of a model in C, and the times at which its equations jump.
 *
 * @param kinds events in file order: names, directions and actions
 * @param triggers program from time and state to the functions whose zeros they are
 * @param assigned program from time and state to the values that they assign
 * @param assignments which event assigns which component of the state, in the order of the program
 * @param jumpTimes times at which the equations jump, s, ascending
 */
public record CEvents(
    List<ModelEvents.Kind> kinds,
    Program triggers,
    Program assigned,
    List<Assignment> assignments,
    List<Double> jumpTimes) {

  public CEvents {
    kinds = List.copyOf(kinds);
    assignments = List.copyOf(assignments);
    jumpTimes = List.copyOf(jumpTimes);
  }

  /**
   * A component of the state that takes the value of an expression.
   *
   * @param event index of the event
   * @param component index in x
   */
  public record Assignment(int event, int component) {}

  /** Returns the names of the events. */
  public List<String> names() {
    return kinds.stream().map(ModelEvents.Kind::name).toList();
  }
}

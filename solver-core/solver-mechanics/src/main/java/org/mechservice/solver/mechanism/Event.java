package org.mechservice.solver.mechanism;

import java.util.List;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.expression.Expression;

/**
 * Something that happens where an expression passes through zero (MECHML §5).
 *
 * @param name name in the model file
 * @param trigger of time, parameters and the state
 * @param direction which passages count
 * @param action what happens
 * @param changes what {@code SET} sets; empty for other actions
 * @param origin where it was written down
 */
public record Event(
    String name,
    Expression trigger,
    ModelEvents.Direction direction,
    ModelEvents.Action action,
    List<StateChange> changes,
    Origin origin) {

  public Event {
    changes = List.copyOf(changes);
  }
}

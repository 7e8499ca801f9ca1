package org.mechservice.solver.mechanism;

import java.util.List;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.text.Origin;

/**
 * An action at the zero crossings of an expression (docs/mechml.md#simulations).
 *
 * @param name name in the model file
 * @param trigger of time, parameters and the state
 * @param direction direction of the crossings that count
 * @param action the action
 * @param changes assignments of {@code SET} to coordinates; empty for other actions
 * @param furtherChanges assignments of {@code SET} to further states; empty for other actions
 * @param origin position in the model file
 */
public record Event(
    String name,
    Expression trigger,
    ModelEvents.Direction direction,
    ModelEvents.Action action,
    List<StateChange> changes,
    List<FurtherChange> furtherChanges,
    Origin origin) {

  public Event {
    changes = List.copyOf(changes);
    furtherChanges = List.copyOf(furtherChanges);
  }

  /** Creates an event that sets no further states. */
  public Event(
      String name,
      Expression trigger,
      ModelEvents.Direction direction,
      ModelEvents.Action action,
      List<StateChange> changes,
      Origin origin) {
    this(name, trigger, direction, action, changes, List.of(), origin);
  }
}

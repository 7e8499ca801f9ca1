package org.mechservice.solver.mechanism;

import java.util.List;
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
    Direction direction,
    Action action,
    List<StateChange> changes,
    Origin origin) {

  /** Which passages through zero count. */
  public enum Direction {
    /** From below to above. */
    RISING,
    /** From above to below. */
    FALLING,
    /** Both. */
    BOTH
  }

  /** What happens at a passage. */
  public enum Action {
    /** The run ends there. */
    STOP,
    /** The instant becomes a row of the results. */
    RECORD,
    /** Coordinates take new values; the run goes on from there. */
    SET
  }

  public Event {
    changes = List.copyOf(changes);
  }
}

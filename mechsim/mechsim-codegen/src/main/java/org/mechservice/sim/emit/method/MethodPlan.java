package org.mechservice.sim.emit.method;

import java.util.List;
import java.util.Map;
import org.mechservice.sim.symbolic.Scalar;

/**
 * A stretch of a program that becomes one method.
 *
 * @param statements its statements, in order
 * @param places where values are found in it
 * @param originals of a method that several stretches share, the program's values its values are in
 *     the first of them, which give them their names; empty if its values are the program's own
 * @param parameters whole numbers it is given
 */
public record MethodPlan(
    List<Statement> statements,
    Map<Scalar, ValueLocation> places,
    Map<Scalar, Scalar> originals,
    int parameters) {
  /** A method without statements. */
  public static final MethodPlan EMPTY = new MethodPlan(List.of(), Map.of());

  /** A stretch of its own. */
  public MethodPlan(List<Statement> statements, Map<Scalar, ValueLocation> places) {
    this(statements, places, Map.of(), 0);
  }

  /** Returns whether the method can end the program. */
  public boolean checks() {
    for (Statement statement : statements) {
      if (statement instanceof Statement.Check) {
        return true;
      }
    }
    return false;
  }
}

package org.mechservice.sim.emit.method;

import java.util.List;
import java.util.Map;
import org.mechservice.solver.symbol.Scalar;

/**
 * The plan of one method, for one part of a program or for several equal parts.
 *
 * @param statements its statements, in order
 * @param places locations of values in it
 * @param originals for a method shared by several parts, the program's values that correspond to
 *     its values in the first part and name them; empty if its values are the program's own
 * @param parameters number of its integer parameters
 */
public record MethodPlan(
    List<Statement> statements,
    Map<Scalar, ValueLocation> places,
    Map<Scalar, Scalar> originals,
    int parameters) {
  /** A method without statements. */
  public static final MethodPlan EMPTY = new MethodPlan(List.of(), Map.of());

  /** Creates a method for one part. */
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

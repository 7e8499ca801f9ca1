package org.mechservice.sim.build.emit;

import java.util.List;
import java.util.Map;
import org.mechservice.sim.symbolic.Scalar;

/**
 * A stretch of a program that becomes one method.
 *
 * @param statements what it does, in order
 * @param places where values are found in it
 */
record MethodPlan(List<Statement> statements, Map<Scalar, Place> places) {

  /** Returns whether the method can end the program. */
  boolean checks() {
    for (Statement statement : statements) {
      if (statement instanceof Statement.Check) {
        return true;
      }
    }
    return false;
  }
}

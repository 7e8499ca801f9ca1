package org.mechservice.sim.build.emit;

import java.util.Map;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/** Estimates bytes of code, a little on the high side. */
final class CodeSize {
  /** A local variable beyond the first 128 doubles takes the wide form. */
  private static final int LOCAL = 3;

  private static final int SLOT = 5;
  private static final int CONSTANT = 3;
  private static final int RETURN_CHECK = 10;

  private CodeSize() {}

  /** Returns the estimate of each section of a program, were all in one method. */
  static int[] ofSections(Program program, Usage usage) {
    int[] bytes = new int[program.sections().size()];
    for (int s = 0; s < bytes.length; s++) {
      for (Scalar node : usage.placedIn(s)) {
        bytes[s] += LOCAL + sizeIn(usage, node);
      }
      Program.Section section = program.sections().get(s);
      bytes[s] += section.outputs().size() * (SLOT + LOCAL);
      bytes[s] += section.guards().size() * (2 * LOCAL + RETURN_CHECK);
    }
    return bytes;
  }

  private static int sizeIn(Usage usage, Scalar node) {
    int bytes = 1;
    for (Scalar operand : node.operands()) {
      boolean inline = !operand.operands().isEmpty() && !usage.isPlaced(operand);
      bytes += inline ? sizeIn(usage, operand) : LOCAL;
    }
    return bytes;
  }

  /** Returns the estimate of a planned method. */
  static int of(MethodPlan method) {
    int bytes = 0;
    for (Statement statement : method.statements()) {
      bytes += of(statement, method.places());
    }
    return bytes;
  }

  private static int of(Statement statement, Map<Scalar, Place> places) {
    if (statement instanceof Statement.Load load) {
      return LOCAL + of(load.from());
    } else if (statement instanceof Statement.Define define) {
      return LOCAL + ofOperation(define.value(), places);
    } else if (statement instanceof Statement.Store store) {
      return SLOT + of(store.value(), places);
    } else if (statement instanceof Statement.PutOut output) {
      return SLOT + of(output.value(), places);
    } else if (statement instanceof Statement.Check check) {
      return RETURN_CHECK + of(check.pivot(), places) + of(check.bound(), places);
    }
    return statement instanceof Statement.CopyInputs ? RETURN_CHECK : 0;
  }

  private static int of(Scalar node, Map<Scalar, Place> places) {
    Place place = places.get(node);
    if (place != null) {
      return of(place);
    }
    return node.isConstant() ? CONSTANT : ofOperation(node, places);
  }

  private static int ofOperation(Scalar node, Map<Scalar, Place> places) {
    int bytes = 1;
    for (Scalar operand : node.operands()) {
      bytes += of(operand, places);
    }
    return bytes;
  }

  private static int of(Place place) {
    return place instanceof Place.Local ? LOCAL : SLOT;
  }
}

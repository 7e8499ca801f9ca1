package org.mechservice.sim.build.emit;

import org.mechservice.solver.standalone.ShortestDecimal;

/** Numbers as Java literals of type double: the fewest digits that read back exactly. */
final class NumberText {
  private NumberText() {}

  /** Returns a finite number as a literal. */
  static String of(double value) {
    String shortest = ShortestDecimal.format(value);
    boolean whole = shortest.indexOf('.') < 0 && shortest.indexOf('e') < 0;
    return whole ? shortest + ".0" : shortest;
  }
}

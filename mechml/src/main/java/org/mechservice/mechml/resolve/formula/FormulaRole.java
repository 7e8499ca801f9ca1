package org.mechservice.mechml.resolve.formula;

/** Role of an expression: it determines the variables that the expression may use. */
public enum FormulaRole {
  /** A coefficient such as a stiffness: constant during a run. */
  COEFFICIENT("this value is constant during a run; use numbers and parameters only"),
  /** Prescribed motion. */
  MOTION("a prescribed motion depends on t and parameters only"),
  /** Acceleration of free fall. */
  GRAVITY("gravity depends on t and parameters only"),
  /** Height of a surface. */
  HEIGHT("a height depends on s, the arc length along the surface, and parameters only"),
  /** Relation between coordinates. */
  RELATION("a coupling depends on positions of joints and points, and t only"),
  /** Tension along a path. */
  TENSION("a tension depends on length, rate, t, states and parameters only"),
  /** Force, output, event. */
  STATE("");

  private final String rule;

  FormulaRole(String rule) {
    this.rule = rule;
  }

  /** Returns the rule in words, for messages. */
  String rule() {
    return rule;
  }

  boolean allowsTime() {
    return this == MOTION
        || this == GRAVITY
        || this == RELATION
        || this == TENSION
        || this == STATE;
  }

  boolean allowsStates() {
    return this == TENSION || this == STATE;
  }

  boolean allowsPositions() {
    return this == RELATION || this == STATE;
  }
}

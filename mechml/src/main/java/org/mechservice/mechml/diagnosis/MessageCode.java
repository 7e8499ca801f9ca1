package org.mechservice.mechml.diagnosis;

/** The catalogue of messages about model files; each has a page {@code docs/errors/CODE.md}. */
public enum MessageCode {
  NOT_WELL_FORMED("M-001"),
  UNREADABLE_TEXT("M-002"),
  FOREIGN_FILE("M-003"),
  TOO_LARGE("M-004"),
  OWN_DECLARATION("M-005"),
  UNKNOWN_ELEMENT("M-006"),
  UNKNOWN_ATTRIBUTE("M-007"),
  MISSING_ATTRIBUTE("M-008"),
  VALUE_NOT_IN_LIST("M-009"),
  WRONG_CONTENT("M-010"),
  STRAY_TEXT("M-011"),
  INVALID_DOCUMENT("M-012"),
  NOT_IN_THIS_VERSION("M-013"),
  UNKNOWN_NAME("M-014"),
  DUPLICATE_NAME("M-015"),
  UNUSABLE_NAME("M-016"),
  MORE_MESSAGES("M-019"),
  EXPRESSION_SYNTAX("M-020"),
  EXPRESSION_VALUE("M-021"),
  EXPRESSION_NAME("M-022"),
  UNKNOWN_UNIT("M-023"),
  WRONG_DIMENSION("M-024"),
  NEGATIVE_MASS("M-030"),
  NEGATIVE_INERTIA("M-031"),
  IMPOSSIBLE_INERTIA("M-032"),
  ZERO_VECTOR("M-033"),
  MISSING_VECTOR("M-040"),
  OPPOSITE_VECTORS("M-041"),
  SECOND_VECTOR("M-042"),
  JOINT_WITH_ITSELF("M-043"),
  ROOT_POSE("M-050"),
  LOOP("M-051"),
  NOT_CONNECTED("M-052"),
  VALUE_COUNT("M-053"),
  NOTHING_MOVES("M-054"),
  TIME_SET("M-060"),
  INTEGRATOR_SETTING("M-061"),
  UNKNOWN_INTEGRATOR("M-062"),
  FORMULATION("M-063");

  private final String code;

  MessageCode(String code) {
    this.code = code;
  }

  /** Returns the code users see, such as {@code M-014}. */
  public String code() {
    return code;
  }
}

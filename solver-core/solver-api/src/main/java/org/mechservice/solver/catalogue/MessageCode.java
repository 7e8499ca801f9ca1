package org.mechservice.solver.catalogue;

import static org.mechservice.solver.catalogue.Severity.ERROR;
import static org.mechservice.solver.catalogue.Severity.INFO;
import static org.mechservice.solver.catalogue.Severity.WARNING;

import java.util.Locale;
import java.util.Optional;

/**
 * The catalogue of messages. A message begins with the code of its entry; each entry has a
 * documentation {@link #page} with the meaning of the message and the remedy.
 *
 * <p>M: the model file; N: the numerics of a run; S: the service, its clients and the command line.
 * The severity is that of most messages with this code. The title of an entry is the first line of
 * its page and is not part of model JARs.
 */
public enum MessageCode {
  // The model file.
  NOT_WELL_FORMED("M-001"),
  UNREADABLE_TEXT("M-002"),
  REFERS_TO_OTHER_FILE("M-003"),
  MODEL_FILE_TOO_LARGE("M-004"),
  DOCTYPE_DECLARES("M-005"),
  UNKNOWN_ELEMENT("M-006"),
  UNKNOWN_ATTRIBUTE("M-007"),
  MISSING_ATTRIBUTE("M-008"),
  VALUE_NOT_IN_LIST("M-009"),
  WRONG_CONTENT("M-010"),
  STRAY_TEXT("M-011"),
  INVALID_DOCUMENT("M-012"),
  UNKNOWN_NAME("M-014"),
  DUPLICATE_NAME("M-015"),
  UNUSABLE_NAME("M-016"),
  TUNABLE_PARAMETER_MISPLACED("M-017"),
  CIRCULAR_PARAMETER("M-018"),
  MORE_MESSAGES("M-019", INFO),
  EXPRESSION_SYNTAX("M-020"),
  EXPRESSION_VALUE("M-021"),
  EXPRESSION_NAME("M-022"),
  UNKNOWN_UNIT("M-023"),
  WRONG_DIMENSION("M-024"),
  ANGLE_IN_DEGREES("M-025", WARNING),
  EXPRESSION_DIMENSION("M-026"),
  FORMULA_DIMENSION("M-027", WARNING),
  NEGATIVE_MASS("M-030"),
  NEGATIVE_INERTIA("M-031"),
  IMPOSSIBLE_INERTIA("M-032", WARNING),
  ZERO_VECTOR("M-033"),
  NOT_EULER_PARAMETERS("M-034"),
  EULER_PARAMETERS_NORMALIZED("M-035", WARNING),
  SHAPE_VALUES("M-036"),
  MISSING_VECTOR("M-040"),
  OPPOSITE_VECTORS("M-041"),
  SECOND_VECTOR("M-042"),
  JOINT_WITH_ITSELF("M-043"),
  VECTOR_WITHOUT_MEANING("M-044"),
  SCREW_PITCH("M-045"),
  JOINT_PLACE("M-046"),
  ROOT_POSE("M-050"),
  NOT_CONNECTED("M-052"),
  VALUE_COUNT("M-053"),
  NOTHING_MOVES("M-054"),
  DISTANCE_NOT_POSITIVE("M-056"),
  UNKNOWN_COORDINATE("M-057"),
  COUPLING_INCOMPLETE("M-058"),
  DRIVEN_JOINT("M-059"),
  TIME_SET("M-060"),
  INTEGRATOR_SETTING("M-061"),
  UNKNOWN_INTEGRATOR("M-062"),
  UNKNOWN_SIMULATION("M-064"),
  OUTPUT_INCOMPLETE("M-065"),
  EVENT_ACTION("M-066"),
  MOTION_JUMPS("M-067"),
  STATE_VALUE("M-068"),
  STATE_NOT_INTEGRATED("M-069"),
  FORCE_VALUE("M-070"),
  FORCE_ATTRIBUTES("M-071"),
  FORCE_CLASS_NAME("M-072"),
  SURFACE_PROFILE("M-073"),
  TABLE_POINTS("M-074"),
  INCLUDED_FILE("M-075"),
  FREQUENCIES("M-077"),
  NOT_A_ROBOT("M-080"),
  ROBOT_MISSING("M-081"),
  ROBOT_NUMBER("M-082"),
  ROBOT_TREE("M-083"),
  ROBOT_JOINT("M-084"),
  ROBOT_LOST("M-085", WARNING),
  URDF_CANNOT("M-086"),
  URDF_LOST("M-087", WARNING),
  ROBOT_LOST_CONTACT("M-088", WARNING),
  ROBOT_LOST_PICTURE("M-089", INFO),
  NO_GRAVITY("M-090", WARNING),
  PARAMETER_NOT_USED("M-091", WARNING),
  INERTIA_OFF_SIZE("M-092", WARNING),
  AXES_DIFFER("M-093", WARNING),
  TRIM_UNUSABLE("M-094"),
  FORCE_WITHIN_ONE_BODY("M-095", WARNING),
  ROBOT_FILE("M-096"),
  ROBOT_ROOT("M-097", INFO),

  // The numerics of a run.
  NOT_FINITE("N-001"),
  SINGULAR_INERTIA("N-002"),
  STEP_TOO_SMALL("N-003"),
  TOLERANCE_TOO_TIGHT("N-004"),
  TOO_MANY_STEPS("N-005"),
  NEWTON_DIVERGES("N-006"),
  SINGULAR_ITERATION_MATRIX("N-007"),
  NEARLY_SINGULAR_INERTIA("N-008", WARNING),
  DENSE_FACTORISATION("N-009", INFO),
  EULER_PARAMETER_NORM("N-010", INFO),
  NO_CONSISTENT_INITIAL_VALUES("N-011"),
  EVENT_OCCURRED("N-012", INFO),
  EVENT_VALUE_NOT_FINITE("N-013"),
  EVENT_BREAKS_LOOPS("N-014"),
  METHOD_SWITCHED("N-015", INFO),
  ENERGY_DRIFT("N-016"),
  MOMENTUM_DRIFT("N-017"),
  MOMENTUM_BALANCE("N-018", INFO),
  VERY_MANY_STEPS("N-019", WARNING),
  LOOPS_NOT_CLOSED("N-020"),
  EVENTS_ACCUMULATE("N-021"),
  EVENT_FUNCTION_NOT_FINITE("N-022"),
  SINGULAR_POSITION("N-023"),
  CONSTRAINT_NO_LONGER_REDUNDANT("N-024"),
  DRIVEN_POSITION_JUMPS("N-026"),
  DRIVEN_VELOCITY_JUMPED("N-027", INFO),
  FORCE_JUMPS_WITH_VELOCITY("N-028", WARNING),
  ABSOLUTE_TOLERANCE_TOO_LARGE("N-029", WARNING),
  FORCE_NOT_FINITE("N-030"),
  FORCE_WITHOUT_DIRECTION("N-031"),
  FORCE_COEFFICIENT("N-032"),
  USER_FORCE_FAILED("N-033"),
  ENERGY_BALANCE_OFF("N-034", WARNING),
  EVENT_NOT_COUNTED("N-035", INFO),
  BODY_STAYS_AT_REST("N-036", WARNING),
  SHAPES_OVERLAP("N-037", WARNING),
  STEP_NOT_SEARCHED("N-038", WARNING),
  START_POSITION_CORRECTED("N-040", WARNING),
  START_VELOCITY_CORRECTED("N-041", WARNING),
  START_POSITION_NOT_CLOSED("N-042"),
  NO_START_VELOCITY("N-043"),
  REDUNDANT_CONSTRAINTS("N-044", WARNING),
  START_POSITION_SINGULAR("N-045", WARNING),
  SINGULAR_POSITION_PASSED("N-046", WARNING),
  INDEPENDENT_COORDINATES_CHANGED("N-047", WARNING),
  PENALTY_SETTINGS("N-048", INFO),
  CONSTRAINT_PULLS("N-059", WARNING),
  PRESCRIBED_MOTION_INCOMPLETE("N-060"),
  PRESCRIBED_MOTION_IMPOSSIBLE("N-061"),
  PRESCRIBED_MOTION_SINGULAR("N-062"),
  NO_EQUILIBRIUM("N-063"),
  UNSTABLE_EQUILIBRIUM("N-064", WARNING),
  EQUILIBRIUM_NOT_UNIQUE("N-065", WARNING),
  SMALL_MOTION_WITHOUT_INERTIA("N-066"),
  FORCES_CANNOT_DRIVE("N-067"),
  NO_TRIM("N-068"),
  TRIM_NOT_UNIQUE("N-069", WARNING),
  DENSE_MATRICES("N-070", WARNING),
  TOLERANCE_NEAR_ROUNDING("N-071", WARNING),
  SYSTEM_WITHOUT_INPUT("N-075"),
  RESPONSE_AT_POLE("N-076"),

  // The service, its clients and the command line.
  INTERNAL_SERVER_ERROR("S-001"),
  NO_SERVER_ANSWERS("S-002"),
  PORT_IN_USE("S-003"),
  LISTEN_ADDRESS("S-004"),
  WRONG_SERVER_VERSION("S-005"),
  SERVER_ADDRESS("S-006"),
  NOT_AVAILABLE("S-007"),
  OPTION_VALUE("S-008"),
  WRONG_STATE("S-009"),
  LIMIT_EXCEEDED("S-010"),
  NO_SUCH_OBJECT("S-011"),
  NO_PLACE_FOR_SESSION("S-012"),
  HOST_NOT_REGISTERED("S-013"),
  RESULTS_NOT_KEPT("S-014"),
  LIMIT_VALUE("S-015"),
  MODEL_FILE_UNUSABLE("S-016"),
  SERVER_CHOICE("S-017", INFO),
  CANCELLED_BY_OPERATOR("S-018", WARNING),
  HOST_DROPPED("S-019", WARNING),
  NAMING_SERVICE("S-020"),
  SERVER_UNREACHABLE("S-030"),
  CONNECTION_LOST("S-031"),
  SERVER_TIMEOUT("S-032"),
  SESSION_UNKNOWN("S-033"),
  ACCESS_REFUSED("S-034"),
  ANSWER_NOT_UNDERSTOOD("S-035"),
  JAR_REFUSED("S-036"),
  CACHE_UNUSABLE("S-037", WARNING),
  LISTENER_FAILED("S-038", WARNING),
  SOLVER_REFUSED("S-039"),
  UNKNOWN_OPTION("S-040"),
  OPTION_UNUSABLE("S-041"),
  FILE_UNUSABLE("S-042"),
  RESULT_FILE_NAME("S-044"),
  RUN_STOPPED("S-045"),
  OUTPUT_PLACE("S-046"),
  UNCLEAN_CLOSE("S-048", WARNING),
  LAUNCHER_FAILED("S-049"),
  INTERNAL_ERROR("S-050"),
  COLUMN_GROUP_MISSING("S-060"),
  EQUATION_FORM_MISSING("S-061"),
  TIME_SETTING("S-062"),
  INTEGRATOR_UNKNOWN("S-063"),
  RESULTS_NOT_WRITTEN("S-064"),
  STANDALONE_USAGE("S-065"),
  INTEGRATOR_SETTINGS("S-066"),
  MODEL_DATA_DAMAGED("S-067"),
  FORCE_CLASS_UNUSABLE("S-068"),
  STANDALONE_JAR_DAMAGED("S-069"),
  CHECKPOINT_UNUSABLE("S-071"),
  MODEL_CANNOT_BE_SAVED("S-072"),
  CHECKPOINT_OPTIONS("S-073"),
  ROWS_WOULD_BE_LOST("S-074"),
  CHECKPOINT_NOT_KEPT("S-075", WARNING),
  FORMULATION_NOT_AVAILABLE("S-081"),
  INTEGRATOR_NOT_AVAILABLE("S-082"),
  NAME_CANNOT_BE_KEPT("S-083"),
  NO_COMPILER("S-084"),
  MODEL_CLASS_TOO_LARGE("S-085"),
  JOINT_MOVES_NO_MASS("S-086", WARNING),
  LOOPS_REDUNDANT("S-090", WARNING),
  LOOPS_START_SINGULAR("S-091", WARNING),
  LOOPS_OPEN_AT_START("S-092"),
  TOO_MANY_SESSIONS("S-100"),
  TOO_MANY_SIMULATIONS("S-101"),
  TOO_MANY_RUNS("S-102"),
  TOO_MANY_CURSORS("S-103"),
  QUEUE_FULL("S-104"),
  MODEL_TOO_LARGE("S-105"),
  RESULTS_TOO_LARGE("S-106"),
  SPOOL_FULL("S-107"),
  RUN_TOO_LONG("S-108"),
  PROCESSOR_TIME_EXCEEDED("S-109"),
  OUT_OF_MEMORY("S-110"),
  TOO_MANY_CONNECTIONS("S-111"),
  RUN_CUT_OFF("S-112"),
  SIMULATION_LOST("S-113"),
  SPOOL_FOLDER("S-114"),
  HOST_DRAINING("S-115", WARNING),
  RUN_STAYS_ON_DRAINING_HOST("S-116", INFO),
  RUN_MOVED("S-117", INFO),
  RUN_PLACED_AGAIN("S-118", INFO),
  TOO_MANY_BUILDS("S-119"),
  USER_CODE_NOT_ALLOWED("S-120"),
  USER_CLASS_MISSING("S-121"),
  USER_CLASS_DUPLICATE("S-122"),
  USER_SOURCE_DOES_NOT_COMPILE("S-123"),
  USER_CLASS_FILE_UNUSABLE("S-124"),
  PARAMETER_FIXED("S-125"),
  PARAMETER_NOT_A_NUMBER("S-126"),
  IMPORT_WOULD_LOSE("S-127"),
  NOTHING_OF_THAT_NAME("S-130"),
  AMBIGUOUS_NAME("S-131"),
  TOKEN_NEEDED("S-132"),
  TOKEN_READ_ONLY("S-133"),
  CROSS_SITE_REQUEST("S-134"),
  REQUEST_UNUSABLE("S-135"),
  TOKENS_UNUSABLE("S-136"),
  CONSOLE_AUDIT_LOG("S-137"),
  TOO_MANY_PAGES("S-138"),
  WATCH_NEEDS_TERMINAL("S-139"),
  CERTIFICATES_UNUSABLE("S-150"),
  TLS_MISMATCH("S-151"),
  NO_TRUST("S-152"),
  CERTIFICATE_NOT_ALLOWED("S-153"),
  JAR_SIGNATURE("S-154"),
  KEYS_NOT_MADE("S-155"),
  USER_CLASS_NOT_PERMITTED("S-156"),
  WORKER_ENDED("S-157"),
  NO_SERVER_USABLE("S-161"),
  REFERENCE_NOT_WRITTEN("S-162"),
  SERVER_AUDIT_LOG("S-163"),
  WARNINGS_REFUSED("S-164"),
  ENERGY_BALANCE_NOT_WATCHED("S-166"),
  NOT_THE_OWNER("S-167"),
  NO_CONFINEMENT("S-168"),
  USER_CODE_NEEDS_CONSENT("S-169"),
  NO_C_CODE("S-170"),
  CERTIFICATE_EXPIRES("S-171"),
  CERTIFICATES_NOT_REPLACED("S-172"),
  CERTIFICATE_REVOKED("S-173"),
  DISK_FULL("S-174"),
  USER_CODE_UNCONFINED("S-175", WARNING),
  RESULT_TOO_LARGE("S-176"),
  RESULT_UNREADABLE("S-177"),
  WORKER_KILLED("S-178"),
  STUDY_UNUSABLE("S-180"),
  STUDY_CHANGED("S-181"),
  STUDY_PARTS("S-182"),
  NO_SPARK("S-183"),
  RUN_CANNOT_BE_STEPPED("S-195"),
  SAMPLES_TOO_MANY("S-196"),
  DESIGN_UNUSABLE("S-210"),
  NO_POINT_COMPUTED("S-211"),
  NO_POINT_FEASIBLE("S-212"),
  MEASUREMENTS_UNUSABLE("S-213"),
  NOT_IDENTIFIABLE("S-214", WARNING),
  START_ENDED("S-215", WARNING),
  GRADIENT_UNUSABLE("S-216"),
  GRADIENT_FAILED("S-217"),
  SET_UP_TOO_LONG("S-230"),
  SOLVER_NOT_ACCEPTED("S-231"),
  MODEL_CLASS_NOT_PERMITTED("S-232");

  private final String code;
  private final Severity severity;

  MessageCode(String code) {
    this(code, ERROR);
  }

  MessageCode(String code, Severity severity) {
    this.code = code;
    this.severity = severity;
  }

  /** Returns the code that users see, such as {@code M-014}. */
  public String code() {
    return code;
  }

  /** Returns the severity that messages of this code usually have. */
  public Severity severity() {
    return severity;
  }

  /** Returns the documentation page, a path in the source tree: {@code docs/errors/M-014.md}. */
  public String page() {
    return "docs/errors/" + code + ".md";
  }

  /** Returns the entry of a code such as {@code M-014}; empty if the catalogue has none. */
  public static Optional<MessageCode> find(String code) {
    for (MessageCode entry : values()) {
      if (entry.code.equals(code)) {
        return Optional.of(entry);
      }
    }
    return Optional.empty();
  }

  /** Returns the name by which a warning is silenced, such as {@code no-gravity}. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /**
   * Returns the warning of a name such as {@code no-gravity}, or of a code such as {@code M-090};
   * empty if no warning of the catalogue has it.
   */
  public static Optional<MessageCode> warning(String nameOrCode) {
    for (MessageCode entry : values()) {
      boolean meant = entry.code.equals(nameOrCode) || entry.word().equals(nameOrCode);
      if (meant && entry.severity == WARNING) {
        return Optional.of(entry);
      }
    }
    return Optional.empty();
  }

  /**
   * Returns the entry of a code such as {@code M-014}.
   *
   * @throws IllegalArgumentException if the catalogue has none
   */
  public static MessageCode of(String code) {
    return find(code)
        .orElseThrow(
            () -> new IllegalArgumentException("there is no message code \"" + code + '"'));
  }

  /** Returns {@link #code}: a message is written {@code MessageCode.X + " what happened"}. */
  @Override
  public String toString() {
    return code;
  }
}

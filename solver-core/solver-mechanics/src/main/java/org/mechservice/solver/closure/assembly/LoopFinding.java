package org.mechservice.solver.closure.assembly;

import java.util.Locale;
import org.mechservice.solver.api.RunNotes.Note;

/**
 * Something about a mechanism's loops that its user should know.
 *
 * @param kind what it is
 * @param part the constraint, or the constraints, and which of their equations; empty if none can
 *     be named
 * @param amount residual or other number that belongs to it, in {@code unit}
 * @param unit SI unit of the amount
 * @param time when, s
 */
public record LoopFinding(Kind kind, String part, double amount, String unit, double time) {

  /** Kinds of findings. */
  public enum Kind {
    /** The start positions did not close the loops and were moved; the amount is the residual. */
    START_MOVED("N-040", true),
    /** The start velocities did not fit the loops and were changed. */
    START_VELOCITY_CHANGED("N-041", true),
    /** No positions near the start close the loops; the amount is the least residual found. */
    NOT_CLOSED("N-042", false),
    /** No velocities fit the loops; the amount is the least residual found. */
    NO_VELOCITIES("N-043", false),
    /** Equations that say nothing new and are left out; the amount is their number. */
    REDUNDANT("N-044", true),
    /** The loops start in a singular position; the amount is the number of equations it hides. */
    SINGULAR_START("N-045", true),
    /**
     * The loops came through a singular position, or very near to one; the amount is the smallest
     * pivot of their equations over the largest it was in the run.
     */
    SINGULAR_PASSED("N-046", true),
    /** Other coordinates are independent from here; the part names them. */
    CHOSEN_ANEW("N-047", true);

    private final String code;
    private final boolean warning;

    Kind(String code, boolean warning) {
      this.code = code;
      this.warning = warning;
    }

    /** Returns the entry of the error catalogue. */
    public String code() {
      return code;
    }

    /** Returns whether a run may go on. */
    public boolean isWarning() {
      return warning;
    }
  }

  /** Returns the finding as a note of the run report. */
  public Note note() {
    boolean remarkable = kind != Kind.REDUNDANT && kind != Kind.CHOSEN_ANEW;
    return new Note(kind.code(), time, remarkable, message());
  }

  /** Returns the finding as one message, without code and time. */
  public String message() {
    String number = String.format(Locale.ROOT, "%.1e", amount);
    return switch (kind) {
      case START_MOVED ->
          "The start does not close the loops: the residual of "
              + part
              + " is "
              + number
              + " "
              + unit
              + "; positions were moved to close it.";
      case START_VELOCITY_CHANGED ->
          "The start velocities do not fit the loops: the rate of "
              + part
              + " is "
              + number
              + " "
              + unit
              + "; velocities were changed to fit.";
      case NOT_CLOSED ->
          "The loops cannot be closed: the residual of "
              + part
              + " stays at "
              + number
              + " "
              + unit
              + ".";
      case NO_VELOCITIES ->
          "No velocities fit the loops: the rate of "
              + part
              + " stays at "
              + number
              + " "
              + unit
              + ".";
      case REDUNDANT ->
          (long) amount
              + " equations of the loops follow from the others and are left out: "
              + part
              + ". The motion does not depend on which; reactions are those of least size.";
      case SINGULAR_START ->
          "The loops start in a singular position, which hides "
              + (long) amount
              + " of their"
              + " equations: the motion may branch here. Affected: "
              + part
              + ".";
      case SINGULAR_PASSED ->
          "The loops came through a singular position, or very near to one: the smallest pivot of"
              + " their equations sank to "
              + number
              + " of what it was, at "
              + part
              + ". The motion went on with continuous velocities; another branch begins there.";
      case CHOSEN_ANEW -> "From here the independent coordinates are " + part + ".";
    };
  }
}

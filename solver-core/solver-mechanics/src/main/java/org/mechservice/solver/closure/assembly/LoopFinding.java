package org.mechservice.solver.closure.assembly;

import java.util.Locale;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A finding about a mechanism's loops for its user.
 *
 * @param kind kind of finding
 * @param part the constraint or constraints and their equations; empty if none can be named
 * @param amount residual or other number, in {@code unit}
 * @param unit SI unit of the amount
 * @param time time of the finding, s
 */
public record LoopFinding(Kind kind, String part, double amount, String unit, double time) {

  /** Kinds of findings. */
  public enum Kind {
    /** The start positions did not close the loops and were moved; the amount is the residual. */
    START_MOVED(MessageCode.START_POSITION_CORRECTED, true),
    /** The start velocities did not fit the loops and were changed. */
    START_VELOCITY_CHANGED(MessageCode.START_VELOCITY_CORRECTED, true),
    /** No positions near the start close the loops; the amount is the least residual found. */
    NOT_CLOSED(MessageCode.START_POSITION_NOT_CLOSED, false),
    /** No velocities fit the loops; the amount is the least residual found. */
    NO_VELOCITIES(MessageCode.NO_START_VELOCITY, false),
    /** Redundant equations were left out; the amount is their number. */
    REDUNDANT(MessageCode.REDUNDANT_CONSTRAINTS, true),
    /** The loops start in a singular position; the amount is the loss of rank. */
    SINGULAR_START(MessageCode.START_POSITION_SINGULAR, true),
    /**
     * The loops passed a singular position, or came very near to one; the amount is the smallest
     * pivot of their equations over the largest it was in the run.
     */
    SINGULAR_PASSED(MessageCode.SINGULAR_POSITION_PASSED, true),
    /** The independent coordinates have changed; the part names the new ones. */
    CHOSEN_ANEW(MessageCode.INDEPENDENT_COORDINATES_CHANGED, true);

    private final MessageCode code;
    private final boolean warning;

    Kind(MessageCode code, boolean warning) {
      this.code = code;
      this.warning = warning;
    }

    /** Returns the entry of the error catalogue. */
    public MessageCode code() {
      return code;
    }

    /** Returns whether a run may continue. */
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
          (amount == 1
                  ? "One equation of the loops follows from the others and is left out: "
                  : (long) amount
                      + " equations of the loops follow from the others and are left out: ")
              + part
              + ". The motion does not depend on which; reactions are those of least norm.";
      case SINGULAR_START ->
          "The loops start in a singular position, which hides "
              + (amount == 1 ? "one" : (long) amount)
              + " of their equations: the motion may branch here. Affected: "
              + part
              + ".";
      case SINGULAR_PASSED ->
          "The loops passed a singular position, or came very near to one: the smallest pivot of"
              + " their equations sank to "
              + number
              + " of what it was, at "
              + part
              + ". The motion went on with continuous velocities; another branch passes through there, or"
              + " very near.";
      case CHOSEN_ANEW -> "From here the independent coordinates are " + part + ".";
    };
  }
}

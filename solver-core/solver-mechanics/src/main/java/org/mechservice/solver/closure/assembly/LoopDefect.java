package org.mechservice.solver.closure.assembly;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;

/** Defects of closed loops that end a run. */
public final class LoopDefect {
  private LoopDefect() {}

  /**
   * The loops lock or branch at the last accepted state.
   *
   * @param formulation label of the formulation that runs, which is not advised
   * @param penalty whether the closure is penalty
   */
  public static Defect singular(
      String equation, double closeness, String formulation, boolean penalty) {
    return new Defect(
        MessageCode.SINGULAR_POSITION,
        equation,
        "The loops are in a singular position, in which the mechanism locks or branches: the"
            + " smallest pivot of their equations has sunk to "
            + number(closeness)
            + " of what it was.",
        "Start or drive the mechanism so that it keeps away from this position, or end the run"
            + " before; "
            + other(formulation, penalty)
            + ", or a looser tolerance, may step across."
            + (solvesPenalty(formulation, penalty)
                ? " Where alpha is below its default of 1e7, use that: with less, fewer runs pass."
                : ""));
  }

  /** Returns the method that is most likely to step across, other than the one that runs. */
  private static String other(String formulation, boolean penalty) {
    boolean solvesThere =
        formulation.equals(Formulation.RR_JF.label()) || solvesPenalty(formulation, penalty);
    if (solvesThere) {
      return penalty ? "DSR with ode113" : "DSR with penalty closure and ode113";
    }
    return formulation.equals(Formulation.RR.label()) ? "RR-JF" : "RR-JF with ode15sR";
  }

  /** Returns whether implicit steps are solved with the forces of the penalty. */
  private static boolean solvesPenalty(String formulation, boolean penalty) {
    return penalty && !formulation.equals(Formulation.DSR.label());
  }

  /** The start hides equations, so that no independent coordinates can be chosen. */
  public static Defect singularStart(String equation) {
    return new Defect(
        MessageCode.SINGULAR_POSITION,
        equation,
        "The loops start in a singular position: fewer of their equations are independent than at"
            + " neighbouring positions, and no independent coordinates can be chosen.",
        "Start at a neighbouring position, or choose penalty closure, which needs no independent"
            + " coordinates.");
  }

  /**
   * A coordinate that differs between two assemblies of a loop that meet.
   *
   * @param name of the coordinate
   * @param value where they meet, rad or m
   * @param grows whether it is larger in the first of them
   */
  public record Way(String name, double value, boolean grows) {}

  /**
   * Two assemblies of a loop meet.
   *
   * @param t time at which they meet, s
   * @param ways the coordinates that differ between them
   * @param crossing whether positions exist beyond
   */
  public static Defect assembliesMeet(String equation, double t, List<Way> ways, boolean crossing) {
    String values =
        ways.stream()
            .map(way -> String.format(Locale.ROOT, "%s = %.6g", way.name, way.value))
            .collect(Collectors.joining(", "));
    return new Defect(
        MessageCode.LOOPS_NOT_CLOSED,
        equation,
        String.format(Locale.ROOT, "Two assemblies of this loop meet at t = %.6g s", t)
            + (values.isEmpty() ? ": " : ", at " + values + ": ")
            + branches(ways)
            + (crossing
                ? " Both continue beyond, and nothing in the motion says which one follows."
                : " Neither continues beyond: the loop locks there."),
        "Change a dimension or the range of the drive, so that the loop keeps away from this"
            + " position, or end the run before.");
  }

  private static String branches(List<Way> ways) {
    String first = names(ways, true);
    String second = names(ways, false);
    if (first.isEmpty() || second.isEmpty()) {
      String only = first + second;
      return only.isEmpty() ? "" : "in one of them " + only + " is larger than in the other.";
    }
    return "in one of them " + first + " is larger and " + second + " smaller than in the other.";
  }

  private static String names(List<Way> ways, boolean grows) {
    return ways.stream()
        .filter(way -> way.grows == grows)
        .map(Way::name)
        .collect(Collectors.joining(", "));
  }

  /** No positions or velocities fit the independent ones. */
  public static Defect open(String equation, double residual, String unit) {
    return new Defect(
        MessageCode.LOOPS_NOT_CLOSED,
        equation,
        "The loops cannot be closed: there are no positions and velocities for the independent"
            + " coordinates; the residual of this constraint is "
            + number(residual)
            + " "
            + unit
            + ".",
        "The mechanism locks or branches there; check its dimensions, or end the run before.");
  }

  /** An equation that was redundant at the start no longer is. */
  public static Defect leftOut(String equation, double residual, String unit) {
    return new Defect(
        MessageCode.CONSTRAINT_NO_LONGER_REDUNDANT,
        equation,
        "An equation of the loops that followed from the others at the start no longer does: its"
            + " residual has grown to "
            + number(residual)
            + " "
            + unit
            + ".",
        "The mechanism has fewer degrees of freedom than at the start; check its dimensions, or"
            + " choose penalty closure, which keeps all equations.");
  }

  private static String number(double x) {
    return String.format(Locale.ROOT, "%.1e", x);
  }
}

package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;

/** What is simulated without generated code. */
public final class GenerationLimits {
  /** More names would hide the message. */
  private static final int MOST_NAMES = 5;

  private GenerationLimits() {}

  /**
   * Elements of a Jacobian, or of the mass matrix of a tree whose loops are closed: the largest of
   * which code is generated. Each takes some 350 bytes, and a class file ends at 65535 constants.
   */
  private static final int MOST_ELEMENTS = 2500;

  /**
   * Operations of a Jacobian: the most of which code is generated. Some 7 to 15 bytes each make
   * methods of 6000, and what calls them all is a method, too, which ends at 8000.
   */
  private static final int MOST_OPERATIONS = 200_000;

  /**
   * Operations of forward dynamics by composite inertias: the most of which code is generated. They
   * grow with the cube of a chain's length, and data take them in short loops. Measured on chains
   * of Hooke joints and balls, code against data, until 10 000 evaluations are done: 0.57 of the
   * time at 14 234 operations, 0.91 at 24 494, 4 times at 41 439, where an evaluation by compiled
   * code takes as long as one by data. What grows with the length alone has no such limit: the
   * residual's class of 68 147 operations takes 0.48 of the time. Terms of loops, of which the mass
   * matrix is one, take 0.54 at 10 923 and 1.7 times as long at 26 676.
   */
  private static final int MOST_OF_COMPOSITE_INERTIAS = 30_000;

  /**
   * Returns what data evaluate no slower than code, if anything.
   *
   * @param formulation the equations are written in
   * @param operations of the derivative of the state in this formulation; with loops, of their terms
   */
  public static List<String> noFaster(String formulation, int operations) {
    return formulation.equals("DSR") && operations > MOST_OF_COMPOSITE_INERTIAS
        ? List.of(
            "DSR of more than "
                + MOST_OF_COMPOSITE_INERTIAS
                + " operations (it has "
                + operations
                + "), which data evaluate as fast")
        : List.of();
  }

  /**
   * Returns what no code is generated for because of its length, if anything.
   *
   * @param operations of the Jacobian; 0 without one
   */
  public static List<String> tooLong(int operations) {
    return operations <= MOST_OPERATIONS
        ? List.of()
        : List.of(
            "a Jacobian of more than "
                + MOST_OPERATIONS
                + " operations (it has "
                + operations
                + ")");
  }

  /** Returns what no code is generated for, such as {@code forces "f1", "f2"}. */
  public static List<String> notGenerated(Mechanism mechanism, FormulationChoice choice) {
    List<String> beyond = new ArrayList<>();
    boolean loops = !mechanism.closures().isEmpty();
    int elements = choice.formulation().equals("RR-JF") || loops ? elements(mechanism) : 0;
    if (elements > MOST_ELEMENTS) {
      beyond.add(
          (loops ? "loops of bodies with a mass matrix" : "a Jacobian")
              + " of more than "
              + MOST_ELEMENTS
              + " elements (it has "
              + elements
              + ")");
    }
    add(beyond, "coordinates of cut joints in", CutCoordinateUses.names(mechanism).stream());
    add(
        beyond,
        "tunable parameters in coefficients of forces",
        SettledCoefficients.withParameters(mechanism).stream());
    return beyond;
  }

  /** Returns how many velocities there are, and pairs of them with one on the way of the other. */
  private static int elements(Mechanism mechanism) {
    int[] onWay = new int[mechanism.bodies().size()];
    int sum = 0;
    for (int j : mechanism.outward()) {
      Joint joint = mechanism.joints().get(j);
      int own = mechanism.isDriven(j) ? 0 : joint.type().velocityCount();
      int parent = joint.attachment().parent();
      int above = parent == Mechanism.ROOT ? 0 : onWay[parent];
      sum += own * above + own * (own + 1) / 2;
      onWay[joint.attachment().child()] = above + own;
    }
    return sum;
  }

  private static void add(List<String> beyond, String kind, Stream<String> names) {
    List<String> quoted = names.map(name -> "\"" + name + "\"").toList();
    if (!quoted.isEmpty()) {
      int more = quoted.size() - MOST_NAMES;
      beyond.add(
          kind
              + " "
              + String.join(", ", quoted.subList(0, Math.min(MOST_NAMES, quoted.size())))
              + (more > 0 ? " and " + more + " more" : ""));
    }
  }
}

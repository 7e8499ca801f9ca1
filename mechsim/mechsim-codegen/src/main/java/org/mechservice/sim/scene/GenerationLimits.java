package org.mechservice.sim.scene;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntSupplier;
import java.util.stream.IntStream;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.closure.PenaltySettings;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Joint;

/** Limits beyond which a scene is simulated from data instead of generated code. */
public final class GenerationLimits {
  private GenerationLimits() {}

  /**
   * Largest number of elements of a Jacobian, or of the mass matrix of a tree with loops, for which
   * code is generated. Each takes about 350 bytes, and a class file has at most 65535 constants.
   */
  private static final int MOST_ELEMENTS = 2500;

  /**
   * Largest number of operations of a Jacobian for which code is generated. With 7 to 15 bytes
   * each, a class has up to 3 MB; larger ones have not been measured.
   */
  private static final int MOST_OPERATIONS = 200_000;

  /**
   * Largest number of operations of forward dynamics by composite inertias for which code is
   * generated. The number grows with the cube of a chain's length, and data-driven algorithms
   * evaluate them in short loops. Measured on chains of Hooke joints and balls, code against data,
   * until 10 000 evaluations are done: 0.57 of the time at 14 234 operations, 0.91 at 24 494, 4
   * times at 41 439, where an evaluation by compiled code takes as long as one by data. Operations
   * that grow linearly with the length have no such limit: the residual's class of 68 147
   * operations takes 0.48 of the time. Terms of loops, of which the mass matrix is one, take 0.54
   * at 10 923 and 1.7 times as long at 26 676.
   */
  private static final int MOST_OF_COMPOSITE_INERTIAS = 30_000;

  /**
   * Largest number of operations of the derivatives of a residual with loops for which code is
   * generated. They are evaluated about a hundred times in a run, and therefore rarely compiled by
   * the optimising compiler. Measured in new processes, processor time of code against data until
   * 300, 1000 and 10 000 evaluations are done, by projection and by penalty. Without forces, where
   * data are fastest: 0.4, 0.5 and 0.2 (0.4, 0.6, 0.2) at 4192 operations; 0.7, 0.9, 0.5 (0.9, 1.3,
   * 0.4) at 10 044; 1.2, 1.4, 0.5 (1.0, 1.5, 0.8) at 46 738; 2.3, 2.1, 1.0 (1.7, 2.4, 1.2) at 76
   * 511. With forces of every kind: from 0.2, 0.3, 0.1 (0.2, 0.2, 0.1) at 2453 to 0.3, 0.5, 0.2
   * (0.4, 0.6, 0.2) at 20 000.
   */
  private static final int MOST_OF_LOOP_DERIVATIVES = 50_000;

  /**
   * Largest number of equations of large loops for which code is generated. Few equations leave
   * links with the same operations, which share their code.
   */
  private static final int MOST_EQUATIONS = 20;

  /**
   * Largest number of velocities of loops that are exported with dense matrices: an instance has up
   * to 6 MB, and an evaluation factors a matrix of this size.
   */
  private static final int MOST_VELOCITIES = 300;

  /**
   * Largest number of velocities of a tree for which code of articulated bodies is generated unless
   * its layout is asked for. Data run the printed steps of the recursion, which need no equations
   * of the model: of trees of random axes, in new processes, code takes 22 times the processor time
   * of steps until 1 000 evaluations are done and 7 times until 10 000, with 200 velocities as with
   * 1 000, and as long for one evaluation afterwards; that of a chain of 200 is then twice as fast,
   * which pays after some 200 000. The equations of 50 000 velocities need more than 2 GB.
   */
  private static final int MOST_OF_TREE = 200;

  /** Reason why derivatives of a residual with loops are computed from data. */
  public static final String TOO_LONG_DERIVATIVES =
      "they take more than "
          + MOST_OF_LOOP_DERIVATIVES
          + " operations, which data evaluate as fast";

  /** Returns whether derivatives of a residual with loops are faster as code than from data. */
  public static boolean areWorthCode(int operations) {
    return operations <= MOST_OF_LOOP_DERIVATIVES;
  }

  /**
   * Returns the part that data evaluate at least as fast as code, if there is one.
   *
   * @param formulation formulation of the equations
   * @param operations number of operations of the derivative of the state; with loops, of their
   *     terms
   */
  public static List<String> noFaster(String formulation, int operations) {
    return noFaster(formulation, operations, "it has " + operations);
  }

  private static List<String> noFaster(String formulation, long operations, String which) {
    return formulation.equals(Formulation.DSR.label()) && operations > MOST_OF_COMPOSITE_INERTIAS
        ? List.of(
            "DSR of more than "
                + MOST_OF_COMPOSITE_INERTIAS
                + " operations ("
                + which
                + "), which data evaluate as fast")
        : List.of();
  }

  /**
   * Returns the part that is too long to be generated as code, if there is one.
   *
   * @param operations number of operations of the Jacobian; 0 without one
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

  /**
   * Returns whether the code of a mechanism is that of large loops, which forms no mass matrix:
   * accelerations by recursion.
   */
  public static boolean isRecursive(Mechanism mechanism) {
    return !mechanism.closures().isEmpty() && mechanism.velocityCount() > LoopEquations.LARGE;
  }

  /**
   * Returns the parts of large loops for which no code with a mass matrix is generated: C solves
   * them by the penalty closure with dense matrices, as smaller ones.
   */
  public static List<String> largeWithMassMatrix(Mechanism mechanism) {
    int velocities = mechanism.velocityCount();
    int elements = elements(mechanism);
    List<String> beyond = new ArrayList<>();
    if (velocities > MOST_VELOCITIES) {
      beyond.add(
          "loops of more than "
              + MOST_VELOCITIES
              + " velocities (it has "
              + velocities
              + "), whose dense matrices would make an evaluation slow and an instance large");
    } else if (elements > MOST_ELEMENTS) {
      beyond.add(
          "loops of bodies with a mass matrix of more than "
              + MOST_ELEMENTS
              + " elements (it has "
              + elements
              + "), whose code would be too long to compile");
    }
    return beyond;
  }

  /**
   * Returns the parts for which no code is generated, such as {@code forces "f1", "f2"}.
   *
   * @param independent returns the number of independent equations of the loops
   */
  public static List<String> notGenerated(
      Mechanism mechanism, FormulationChoice choice, IntSupplier independent) {
    List<String> beyond = new ArrayList<>();
    boolean loops = !mechanism.closures().isEmpty();
    boolean recursive = isRecursive(mechanism);
    int elements =
        Formulation.of(choice.formulation()).hasRecursiveJacobian() || (loops && !recursive)
            ? elements(mechanism)
            : 0;
    if (elements > MOST_ELEMENTS) {
      beyond.add(
          (loops ? "loops of bodies with a mass matrix" : "a Jacobian")
              + " of more than "
              + MOST_ELEMENTS
              + " elements (it has "
              + elements
              + ")");
    }
    if (recursive) {
      largeLoops(mechanism, choice, independent)
          .ifPresent(
              which ->
                  beyond.add(
                      "loops of more than "
                          + LoopEquations.LARGE
                          + " velocities (it has "
                          + mechanism.velocityCount()
                          + ") "
                          + which));
    }
    if (!loops) {
      // checked before the equations are derived, because deriving those of a long chain takes too
      // much memory
      long factors = factors(mechanism);
      beyond.addAll(noFaster(choice.formulation(), factors, "its factors alone take " + factors));
    }
    ForceReach ways = ForceReach.of(mechanism);
    if (ways.areTooMany()) {
      beyond.add(
          "forces between bodies far apart in the tree (their ways have "
              + ways.steps()
              + " joints), which data evaluate sooner");
    }
    return beyond;
  }

  /**
   * Returns the parts for which data are better than code: those without code, and trees whose
   * printed steps are sooner done.
   *
   * @param independent as of {@link #notGenerated}
   */
  public static List<String> leftToData(
      Mechanism mechanism, FormulationChoice choice, IntSupplier independent) {
    List<String> left = new ArrayList<>(notGenerated(mechanism, choice, independent));
    boolean isTree = mechanism.closures().isEmpty();
    int velocities = mechanism.velocityCount();
    if (isTree
        && choice.formulation().equals(Formulation.DTR.label())
        && velocities > MOST_OF_TREE) {
      left.add(
          "articulated bodies of more than "
              + MOST_OF_TREE
              + " velocities (it has "
              + velocities
              + "), whose printed steps are sooner done");
    }
    return left;
  }

  /** Returns what keeps large loops from being code, to follow "loops of ... velocities". */
  private static Optional<String> largeLoops(
      Mechanism mechanism, FormulationChoice choice, IntSupplier independent) {
    if (!choice.formulation().equals(Formulation.DSR.label())
        || PenaltySettings.isPenalty(choice.closure())) {
      return Optional.of("by another method than DSR with projection");
    }
    if (mechanism.closures().stream().anyMatch(GenerationLimits::isOfAnotherKind)) {
      return Optional.of("with couplings, rolling, knife edges or rods that have mass");
    }
    if (!UnwrappedAngles.of(mechanism).isEmpty()) {
      return Optional.of("whose turns are counted");
    }
    if (mechanism.forces().stream().anyMatch(UserForceElement.class::isInstance)) {
      return Optional.of("with forces given as classes");
    }
    int equations = new LoopEquations(new TreeGeometry(mechanism)).count();
    if (equations > MOST_EQUATIONS) {
      return Optional.of(
          "and more than "
              + MOST_EQUATIONS
              + " equations (it has "
              + equations
              + "), which data evaluate sooner");
    }
    return independent.getAsInt() < equations
        ? Optional.of("of whose equations some follow from the others")
        : Optional.empty();
  }

  /** Returns whether an equation is no function of the pose of two bodies alone. */
  private static boolean isOfAnotherKind(LoopClosure closure) {
    boolean ofTwoBodies =
        closure instanceof JointClosure
            || closure instanceof PointOnPlaneClosure
            || closure instanceof PointOnLineClosure
            || (closure instanceof DistanceClosure distance && !distance.hasRod());
    return !ofTwoBodies;
  }

  /** Returns the number of velocities plus the number of pairs of a velocity and an ancestor. */
  private static int elements(Mechanism mechanism) {
    return velocitiesOnWay(mechanism).map(onWay -> onWay + 1).sum();
  }

  /**
   * Returns the number of operations of the factorisation LᵀDL: d divisions and d (d + 1) others
   * for a velocity with d ancestors.
   */
  private static long factors(Mechanism mechanism) {
    return velocitiesOnWay(mechanism).mapToLong(d -> (long) d * (d + 2)).sum();
  }

  /** Returns for each velocity the number of its ancestors. */
  private static IntStream velocitiesOnWay(Mechanism mechanism) {
    int[] onWay = new int[mechanism.bodies().size()];
    IntStream.Builder velocities = IntStream.builder();
    for (int j : mechanism.outward()) {
      Joint joint = mechanism.joints().get(j);
      int own = mechanism.isDriven(j) ? 0 : joint.type().velocityCount();
      int parent = joint.attachment().parent();
      int above = parent == Mechanism.ROOT ? 0 : onWay[parent];
      IntStream.range(above, above + own).forEach(velocities::add);
      onWay[joint.attachment().child()] = above + own;
    }
    return velocities.build();
  }
}

package org.mechservice.guard;

import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The allow-list of solver classes for the generated classes of a model that comes from elsewhere:
 * what a model is, and the parts of the solver that generated code calls. None of them opens a file
 * or a connection. Anything not listed is refused.
 */
final class AllowedSolver {
  private static final String SOLVER = "org/mechservice/solver/";

  /** Packages of which every class is allowed. */
  private static final Set<String> PACKAGES =
      Set.of(
          SOLVER + "api/capability", SOLVER + "api/result", SOLVER + "api/run", SOLVER + "spatial");

  private static final Set<String> CLASSES =
      Stream.of(
              "api/Model",
              "api/ModelDescription",
              "api/ModelSource",
              "api/JointVariables",
              "api/JointType",
              "api/StateVariable",
              "api/TunableParameter",
              "api/UserForce",
              "analysis/EquilibriumSource",
              "analysis/ExtendedSource",
              "analysis/LinearSource",
              "analysis/PrescribedSource",
              "analysis/Trim",
              "catalogue/Accuracy",
              "closure/PenaltySettings",
              "closure/UserForcedTerms",
              "closure/equations/LoopTerms",
              "compact/CompactModel",
              "compact/CompactSource",
              "compact/DataDrivenLoops",
              "compact/DataDrivenTree",
              "dynamics/TreeStepModel",
              "dynamics/UserForcedModel",
              "dynamics/UserLoads",
              "dynamics/event/WrittenValues",
              "expression/MapSurface",
              "expression/TableCurve",
              "force/formula/WrittenFormulas",
              "force/user/UserForceSource",
              "kinematics/StateCoordinates",
              "mechanism/Mechanism",
              "symbol/MathFunction")
          .map(SOLVER::concat)
          .collect(Collectors.toUnmodifiableSet());

  private AllowedSolver() {}

  /** Returns whether a class, or one that it encloses, may be used. */
  static boolean isClass(String internalName) {
    int nested = internalName.indexOf('$');
    String outer = nested < 0 ? internalName : internalName.substring(0, nested);
    int folder = outer.lastIndexOf('/');
    return CLASSES.contains(outer) || (folder > 0 && PACKAGES.contains(outer.substring(0, folder)));
  }
}

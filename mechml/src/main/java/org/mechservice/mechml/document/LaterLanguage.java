package org.mechservice.mechml.document;

import java.util.Map;
import java.util.Set;

/**
 * The words of MechML that its grammar does not hold yet: a file using one is told so, instead of
 * being told of a typing error.
 */
public final class LaterLanguage {
  /** How messages describe what is there. */
  public static final String PRESENT =
      "this version holds open chains of R and P joints under gravity, simulated with <dynamic>";

  private static final Set<String> ELEMENTS =
      Set.of(
          "kinematic",
          "static",
          "inverseDynamic",
          "linearize",
          "output",
          "event",
          "Parameters",
          "parameter",
          "Outputs",
          "CoordConstraint",
          "PointOnPlane",
          "PointOnLine",
          "JointConstraint",
          "springDamper",
          "torsionSpringDamper",
          "bushing",
          "forceTorque",
          "jointForce",
          "contact",
          "friction");

  private static final Map<String, Set<String>> ATTRIBUTES =
      Map.of(
          "joint",
          Set.of(
              "pitch",
              "lead",
              "cut",
              "stiffness",
              "damping",
              "freePosition",
              "friction",
              "lower",
              "upper"),
          "jointVal",
          Set.of("fixed", "driven"),
          "formulation",
          Set.of("closure"));

  private LaterLanguage() {}

  static boolean hasElement(String element) {
    return ELEMENTS.contains(element);
  }

  static boolean hasAttribute(String element, String attribute) {
    return ATTRIBUTES.getOrDefault(element, Set.of()).contains(attribute);
  }
}

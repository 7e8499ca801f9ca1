package org.mechservice.sim.scene;

import java.util.Locale;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Joint;

/**
 * The formulation a scene's equations are written in.
 *
 * @param formulation its name
 * @param reason why this one
 */
public record FormulationChoice(String formulation, String reason) {
  private static final String DTR = "DTR";

  /**
   * Resolves what was asked for.
   *
   * @param requested {@code auto} or the name of a formulation
   * @param scene what it is for
   * @throws ModelBuildException S-081 if the formulation is unknown or not in this version, or no
   *     formulation of this version takes one of the joints
   */
  public static FormulationChoice of(String requested, SceneAnalysis scene) {
    requireKnownJoints(scene);
    String fits = "the scene is an open chain, which articulated bodies solve in O(n)";
    return switch (requested.toUpperCase(Locale.ROOT)) {
      case "AUTO" -> new FormulationChoice(DTR, "auto: " + fits);
      case DTR -> new FormulationChoice(DTR, "asked for; it fits: " + fits);
      case "DSR", "RR", "RR-JF" ->
          throw new ModelBuildException(
              "S-081",
              "formulation "
                  + requested
                  + " is not in this version; use DTR or auto, which suit model \""
                  + scene.mechanism().name()
                  + "\": its joints form a tree");
      default ->
          throw new ModelBuildException(
              "S-081", "there is no formulation \"" + requested + "\"; use DTR or auto");
    };
  }

  private static void requireKnownJoints(SceneAnalysis scene) {
    for (Joint joint : scene.mechanism().joints()) {
      if (joint.type() != JointType.R && joint.type() != JointType.P) {
        throw new ModelBuildException(
            "S-081",
            "joint \""
                + joint.name()
                + "\" is of type "
                + joint.type()
                + "; code is generated for joints of type R and P in this version");
      }
    }
  }
}

package org.mechservice.sim.model;

import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;

/** Checks whether the names of a model can stand in the lists of a generated class. */
final class GeneratedNames {
  private GeneratedNames() {}

  /**
   * @throws ModelBuildException S-083 if a name contains a control character
   */
  static void requireUsable(Mechanism mechanism) {
    mechanism.joints().forEach(joint -> requirePrintable(joint.name()));
    mechanism.bodies().forEach(body -> requirePrintable(body.name()));
    mechanism.forces().forEach(force -> requirePrintable(force.name()));
    requirePrintable(mechanism.name());
  }

  private static void requirePrintable(String name) {
    for (int i = 0; i < name.length(); i++) {
      requirePrintable(name, name.charAt(i));
    }
  }

  private static void requirePrintable(String name, char c) {
    if (Character.isISOControl(c)) {
      throw new ModelBuildException(
          MessageCode.NAME_CANNOT_BE_KEPT,
          "the name \""
              + name.replaceAll("\\p{Cntrl}", "?")
              + "\" contains a control character (shown as ?); leave it out");
    }
  }
}

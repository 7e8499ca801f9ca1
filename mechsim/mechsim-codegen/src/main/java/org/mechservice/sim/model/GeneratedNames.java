package org.mechservice.sim.model;

import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.joint.Joint;

/** Checks whether a generated class can store the names of a model. */
final class GeneratedNames {
  /** Bytes of one constant in a class file (JVMS §4.4.7). */
  private static final int LONGEST_CONSTANT = 65535;

  private GeneratedNames() {}

  /**
   * @throws ModelBuildException S-083 if a name contains a control character, or the names together
   *     are too long for one constant
   */
  static void requireUsable(Mechanism mechanism) {
    int bytes = 0;
    for (Joint joint : mechanism.joints()) {
      bytes += printable(joint.name());
    }
    requireShort("joints", bytes);
    bytes = 0;
    for (Body body : mechanism.bodies()) {
      bytes += printable(body.name());
    }
    requireShort("bodies", bytes);
    for (ForceElement force : mechanism.forces()) {
      printable(force.name());
    }
    bytes = 0;
    for (Variable column : ForceColumnNames.of(mechanism)) {
      bytes += bytes(column.name()) + 1;
    }
    requireShort("forces", bytes);
    requireShort("model", printable(mechanism.name()));
  }

  /** Returns the number of bytes of a name in a list. */
  private static int printable(String name) {
    for (int i = 0; i < name.length(); i++) {
      requirePrintable(name, name.charAt(i));
    }
    return bytes(name) + 1;
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

  private static void requireShort(String whose, int length) {
    if (length > LONGEST_CONSTANT) {
      throw new ModelBuildException(
          MessageCode.NAME_CANNOT_BE_KEPT,
          "the names of the "
              + whose
              + " take "
              + length
              + " bytes together; a model class holds "
              + LONGEST_CONSTANT
              + ": use shorter names");
    }
  }

  /** Returns the number of bytes of a name in a class file: one to three per character. */
  private static int bytes(String name) {
    int bytes = 0;
    for (int i = 0; i < name.length(); i++) {
      char c = name.charAt(i);
      bytes += c <= 0x7F ? 1 : c <= 0x7FF ? 2 : 3;
    }
    return bytes;
  }
}

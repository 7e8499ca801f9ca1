package org.mechservice.sim.build;

import java.util.List;
import java.util.stream.Stream;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.Variable;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;

/** What names a generated class can carry. */
final class ModelNames {
  /** Bytes of one constant in a class file (JVMS §4.4.7). */
  private static final int LONGEST_CONSTANT = 65535;

  private ModelNames() {}

  /**
   * @throws ModelBuildException S-083 if a name contains a control character, or the names together
   *     are too long for one constant
   */
  static void requireUsable(Mechanism mechanism) {
    List<String> joints = mechanism.joints().stream().map(Joint::name).toList();
    List<String> bodies = mechanism.bodies().stream().map(Body::name).toList();
    List<String> forces = mechanism.forces().stream().map(ForceElement::name).toList();
    Stream.of(List.of(mechanism.name()), joints, bodies, forces)
        .flatMap(List::stream)
        .forEach(ModelNames::requirePrintable);
    requireShort("joints", joints);
    requireShort("bodies", bodies);
    requireShort("forces", ForceColumns.of(mechanism).stream().map(Variable::name).toList());
    requireShort("model", List.of(mechanism.name()));
  }

  private static void requirePrintable(String name) {
    if (name.chars().anyMatch(Character::isISOControl)) {
      throw new ModelBuildException(
          "S-083",
          "the name \""
              + name.replaceAll("\\p{Cntrl}", "?")
              + "\" contains a control character (shown as ?); leave it out");
    }
  }

  private static void requireShort(String whose, List<String> names) {
    int length = names.stream().mapToInt(name -> bytes(name) + 1).sum();
    if (length > LONGEST_CONSTANT) {
      throw new ModelBuildException(
          "S-083",
          "the names of the "
              + whose
              + " take "
              + length
              + " bytes together; a model class holds "
              + LONGEST_CONSTANT
              + ": use shorter names");
    }
  }

  /** Returns how many bytes a class file takes for a name: one to three a character. */
  private static int bytes(String name) {
    return name.chars().map(c -> c <= 0x7F ? 1 : c <= 0x7FF ? 2 : 3).sum();
  }
}

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
  /** Bytes of one constant in a class file (JVMS §4.4.7); UTF-8 takes at most three a character. */
  private static final int LONGEST_CONSTANT = 65535 / 3;

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
    int length = names.stream().mapToInt(name -> name.length() + 1).sum();
    if (length > LONGEST_CONSTANT) {
      throw new ModelBuildException(
          "S-083",
          "the names of the "
              + whose
              + " have "
              + length
              + " characters together; a model class holds "
              + LONGEST_CONSTANT
              + ": use shorter names");
    }
  }
}

package org.mechservice.sim.build.emit;

import java.util.List;
import java.util.Optional;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * What the class of a model contains.
 *
 * @param mechanism the model
 * @param description what it says of itself
 * @param derivative program from [q; v] to [q'; v']
 * @param energy program from [q; v] to kinetic and potential energy
 * @param poses program from [q; v] to the poses of the bodies, if they are asked for
 * @param notes further paragraphs of the class comment, for people
 */
public record ModelClass(
    Mechanism mechanism,
    ModelDescription description,
    Program derivative,
    Program energy,
    Optional<Program> poses,
    List<String> notes) {
  /** The package of generated models. */
  public static final String PACKAGE = "org.mechservice.model";

  /** Returns the class's simple name. */
  public String simpleName() {
    return JavaText.className(description.name());
  }

  /** Returns the joints of a mechanism as the description lists them. */
  public static List<JointVariables> joints(Mechanism mechanism) {
    return mechanism.joints().stream().map(ModelClass::variables).toList();
  }

  private static JointVariables variables(Joint joint) {
    return new JointVariables(joint.name(), joint.type());
  }
}

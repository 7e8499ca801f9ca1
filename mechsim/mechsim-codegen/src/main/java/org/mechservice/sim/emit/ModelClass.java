package org.mechservice.sim.emit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.sim.emit.source.JavaText;
import org.mechservice.sim.equations.derivatives.ResidualDerivatives;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.symbol.Program;

/**
 * The contents of the class of a model.
 *
 * @param mechanism the model
 * @param description its description
 * @param derivative program from [q; v] to [q'; v']
 * @param residual program from [q; v] and [q'; v'] to the residual, if the formulation has one
 * @param derivatives derivatives of the residual, if the formulation has them
 * @param energy program from [q; v] to kinetic and potential energy
 * @param poses program from [q; v] to the poses of the bodies, if they are requested
 * @param power program from [q; v] to the power of forces without potential energy, if there are
 *     any
 * @param forces values of forces, if they are requested
 * @param formulas subexpressions of the formulas of forces, if any can be undefined
 * @param notes further paragraphs of the class comment
 */
public record ModelClass(
    Mechanism mechanism,
    ModelDescription description,
    Program derivative,
    Optional<Program> residual,
    Optional<ResidualDerivatives.Derived> derivatives,
    Program energy,
    Optional<Program> poses,
    Optional<Program> power,
    Optional<ForceValues> forces,
    Optional<FormulaParts> formulas,
    List<String> notes) {
  /**
   * Output values of forces.
   *
   * @param columns names and units
   * @param program from [q; v] to the values
   */
  public record ForceValues(List<Variable> columns, Program program) {}

  /**
   * Subexpressions of the formulas of forces, to find the one without a value after a failure.
   *
   * @param lines descriptions of the values
   * @param count of the values
   * @param program from [q; v] to the values
   */
  public record FormulaParts(String lines, int count, Program program) {}

  /** The package of generated models. */
  public static final String PACKAGE = "org.mechservice.model";

  /** Returns whether the model has user forces. */
  boolean hasUserForces() {
    return hasUserForces(mechanism);
  }

  /** Returns whether a mechanism has user forces. */
  public static boolean hasUserForces(Mechanism mechanism) {
    return mechanism.hasUserClasses();
  }

  /** Returns the class's simple name. */
  public String simpleName() {
    return JavaText.className(description.name());
  }

  /** Returns the joints that have states, in state order. */
  public static List<JointVariables> joints(Mechanism mechanism) {
    List<JointVariables> joints = new ArrayList<>();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      if (!mechanism.isDriven(j)) {
        joints.add(new JointVariables(joint.name(), joint.type()));
      }
    }
    return joints;
  }
}

package org.mechservice.sim.emit;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.symbol.Program;

/**
 * Contents of the class of the terms of a model with loops ({@link
 * org.mechservice.solver.closure.equations.LoopTerms}).
 *
 * @param modelName the model's name in its file
 * @param hasUserForces whether the class receives loads of user forces
 * @param recursive whether it is for a large mechanism: the equations give accelerations
 * @param stateCount number of states [q; v; s] and counted angles
 * @param velocityCount number of v among them
 * @param loops program of the method of that name
 * @param equations program of the method of that name
 * @param energy program of the method of that name
 * @param power program of the method of that name
 * @param poses program of the method of that name, if the poses of the bodies are requested
 * @param further program of the method of that name, if there are further states
 * @param ofResidual programs of the recursive residual, if the formulation has one
 * @param notes further paragraphs of the class comment
 */
public record TermsClass(
    String modelName,
    boolean hasUserForces,
    boolean recursive,
    int stateCount,
    int velocityCount,
    Program loops,
    Program equations,
    Program energy,
    Program power,
    Optional<Program> poses,
    Optional<Program> further,
    Optional<OfResidual> ofResidual,
    List<String> notes) {
  /** Returns the program of the derivatives of the residual, if the class has it. */
  public Optional<Program> derivatives() {
    return ofResidual.flatMap(OfResidual::derivatives);
  }

  /** Returns the same without that program. */
  public TermsClass withoutDerivatives() {
    return new TermsClass(
        modelName,
        hasUserForces,
        recursive,
        stateCount,
        velocityCount,
        loops,
        equations,
        energy,
        power,
        poses,
        further,
        ofResidual.map(
            programs -> new OfResidual(programs.offset(), programs.residual(), Optional.empty())),
        notes);
  }

  /**
   * Programs of the recursive residual.
   *
   * @param offset program of the method of that name
   * @param residual program of the method of that name
   * @param derivatives program of the method of that name, if the class has it
   */
  public record OfResidual(Program offset, Program residual, Optional<Program> derivatives) {}
}

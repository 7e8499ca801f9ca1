package org.mechservice.sim.emit;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.emit.source.JavaText;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.symbol.Program;

/** Plans the class of the terms of a model with loops. */
public final class TermsPlan {
  private static final MethodSignature.Argument TIME =
      new MethodSignature.Argument("t", false, Program.TIME);
  private static final MethodSignature.Argument STATE = new MethodSignature.Argument("y", true, 0);
  private static final String TERMS = "terms";

  private TermsPlan() {}

  /** Plans a class. */
  public static GeneratedClass of(TermsClass content, CodeForm form) {
    ProgramsClass programs =
        new ProgramsClass(
            JavaText.className(content.modelName()),
            documentation(content),
            interfaces(content),
            content.hasUserForces(),
            form);
    programs.add(ofState("loops", TERMS, false), content.loops());
    programs.add(
        ofState("equations", content.recursive() ? "accelerations" : TERMS, true),
        content.equations());
    programs.add(ofState("energy", "energy", false), content.energy());
    programs.add(ofState("power", "power", false), content.power());
    content.poses().ifPresent(program -> programs.add(ofState("poses", "poses", false), program));
    content
        .further()
        .ifPresent(program -> programs.add(ofState("further", "rates", false), program));
    content.ofResidual().ifPresent(given -> add(given, content, programs));
    return programs;
  }

  private static void add(TermsClass.OfResidual given, TermsClass content, ProgramsClass programs) {
    MethodSignature.Argument accelerations =
        new MethodSignature.Argument("a", true, content.stateCount());
    programs.add(ofState("offset", TERMS, false), given.offset());
    programs.add(
        new MethodSignature(
            "residual", List.of(TIME, STATE, accelerations), "residual", true, true),
        given.residual());
    given
        .derivatives()
        .ifPresent(
            derivatives ->
                programs.add(ofDerivatives(accelerations, content.velocityCount()), derivatives));
  }

  private static MethodSignature ofState(String name, String output, boolean returnsResult) {
    return new MethodSignature(name, List.of(TIME, STATE), output, returnsResult, true);
  }

  /** Returns the method of the derivatives; multipliers follow the accelerations. */
  private static MethodSignature ofDerivatives(MethodSignature.Argument given, int velocities) {
    MethodSignature.Argument lambda =
        new MethodSignature.Argument("lambda", true, given.first() + velocities);
    return new MethodSignature(
        "derivatives", List.of(TIME, STATE, given, lambda), "derivatives", true, true);
  }

  private static List<Class<?>> interfaces(TermsClass content) {
    List<Class<?>> interfaces = new ArrayList<>();
    interfaces.add(
        content
            .ofResidual()
            .<Class<?>>map(
                programs ->
                    programs.derivatives().isPresent()
                        ? LoopTerms.OfDerivatives.class
                        : LoopTerms.OfResidual.class)
            .orElse(content.recursive() ? LoopTerms.Recursive.class : LoopTerms.class));
    content.poses().ifPresent(program -> interfaces.add(LoopTerms.OfPoses.class));
    return interfaces;
  }

  private static List<String> documentation(TermsClass content) {
    List<String> lines = new ArrayList<>();
    lines.add(
        JavaText.comment(
            "Terms of the equations of motion of model \""
                + content.modelName()
                + "\", whose loops the solver closes; generated."));
    List<String> notes = new ArrayList<>(content.notes());
    content
        .derivatives()
        .ifPresent(program -> notes.add(program.operationCount() + " give its derivatives."));
    for (String note : notes) {
      lines.add("");
      lines.add("<p>" + JavaText.comment(note));
    }
    lines.add("");
    lines.add("<p>" + ModelSourceWriter.LEGEND);
    return lines;
  }
}

package org.mechservice.sim.emit;

import java.util.List;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.emit.source.JavaText;
import org.mechservice.solver.dynamics.event.WrittenValues;
import org.mechservice.solver.symbol.Program;

/** Plans the class of the triggers and assignments of a model's events, and of its outputs. */
public final class ValuesPlan {
  private static final List<MethodSignature.Argument> STATE =
      List.of(
          new MethodSignature.Argument("t", false, Program.TIME),
          new MethodSignature.Argument("y", true, 0));

  private ValuesPlan() {}

  /**
   * Plans the class.
   *
   * @param modelName the model's name in its file
   * @param triggers program of the method of that name
   * @param assignments program of the method of that name
   * @param watched program of the method of that name
   * @param outputs program of the method of that name
   */
  public static GeneratedClass of(
      String modelName,
      Program triggers,
      Program assignments,
      Program watched,
      Program outputs,
      CodeForm form) {
    ProgramsClass programs =
        new ProgramsClass(
            JavaText.className(modelName) + "Values",
            documentation(modelName),
            List.of(WrittenValues.class),
            false,
            form);
    programs.add(head("triggers"), triggers);
    programs.add(head("assignments"), assignments);
    programs.add(head("watched"), watched);
    programs.add(head("outputs"), outputs);
    return programs;
  }

  private static MethodSignature head(String name) {
    return new MethodSignature(name, STATE, "values", false, true);
  }

  private static List<String> documentation(String modelName) {
    return List.of(
        JavaText.comment(
            "What the events and the steps of model \""
                + modelName
                + "\" watch and assign, and its outputs; generated."),
        "",
        "<p>" + ModelSourceWriter.LEGEND);
  }
}

package org.mechservice.sim.build.emit;

import java.util.List;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.solver.dynamics.WrittenValues;

/** The class of what the events of a model watch and assign, and of its outputs, planned. */
public final class ValuesPlan implements WrittenClass {
  private static final List<Head.Argument> STATE =
      List.of(new Head.Argument("t", false, Program.TIME), new Head.Argument("y", true, 0));

  private final String modelName;
  private final ProgramsClass programs;

  /**
   * Plans the class.
   *
   * @param modelName the model's name in its file
   * @param hasInputs whether the class is given the values of parameters
   * @param triggers program of the method of that name
   * @param assignments program of the method of that name
   * @param outputs program of the method of that name
   */
  public ValuesPlan(
      String modelName,
      boolean hasInputs,
      Program triggers,
      Program assignments,
      Program outputs,
      CodeForm form) {
    this.modelName = modelName;
    String name = JavaText.className(modelName) + "Values";
    programs = new ProgramsClass(name, List.of(WrittenValues.class), hasInputs, form);
    programs.add(head("triggers"), triggers);
    programs.add(head("assignments"), assignments);
    programs.add(head("outputs"), outputs);
  }

  private static Head head(String name) {
    return new Head(name, STATE, "values", false, true);
  }

  @Override
  public String simpleName() {
    return programs.simpleName();
  }

  @Override
  public String code() {
    return programs.code();
  }

  @Override
  public String source() {
    return programs.source(
        List.of(
            JavaText.comment(
                "What the events of model \""
                    + modelName
                    + "\" watch and assign, and its outputs;"
                    + " generated."),
            "",
            "<p>" + ModelSource.LEGEND));
  }

  @Override
  public byte[] classFile() {
    return programs.classFile();
  }
}

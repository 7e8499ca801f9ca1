package org.mechservice.sim.emit;

import java.util.List;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.solver.symbol.Program;

/** Plans a class with one method that runs one program on a state and further numbers. */
public final class FunctionPlan {
  /**
   * Name of the planned method: {@code int run(double t, double[] y, double[] x, double[] out)}.
   */
  public static final String METHOD = "run";

  private FunctionPlan() {}

  /**
   * Plans the class.
   *
   * @param simpleName name of the class
   * @param type interface with {@link #METHOD} as its only method
   * @param program its inputs below {@code further} are read from {@code y}, the others from {@code
   *     x}
   * @param further first input that is read from {@code x}
   */
  public static GeneratedClass of(String simpleName, Class<?> type, Program program, int further) {
    ProgramsClass programs =
        new ProgramsClass(
            simpleName,
            List.of("A function and its derivatives; generated."),
            List.of(type),
            false,
            CodeForm.AUTO);
    programs.add(
        new MethodSignature(
            METHOD,
            List.of(
                new MethodSignature.Argument("t", false, Program.TIME),
                new MethodSignature.Argument("y", true, 0),
                new MethodSignature.Argument("x", true, further)),
            "out",
            true,
            true),
        program);
    return programs;
  }
}

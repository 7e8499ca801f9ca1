package org.mechservice.sim.gradient;

import org.mechservice.sim.emit.FunctionPlan;
import org.mechservice.sim.emit.GeneratedClass;
import org.mechservice.solver.symbol.Program;

/** A program as code. Workspace of one thread. */
public interface ProgramCode {
  /** Result of {@link #run} if no guard has failed. */
  int REGULAR = -1;

  /**
   * Runs the program.
   *
   * @param t time, s
   * @param y state; not modified
   * @param x further inputs; not modified
   * @param out outputs by index; overwritten where the program puts something out
   * @return {@link #REGULAR}, or the result of the guard that failed
   */
  int run(double t, double[] y, double[] x, double[] out);

  /**
   * Writes a program as a class and loads it, unless an equal one is loaded.
   *
   * @param further first input that is read from the further inputs
   * @param parameters values of the model's parameters, SI; read at each run, so they may change
   *     between runs
   * @throws org.mechservice.sim.scene.ModelBuildException if the class is too large (S-085)
   */
  static ProgramCode of(Program program, int further, double[] parameters) {
    GeneratedClass plan = FunctionPlan.of("GradientFunction", ProgramCode.class, program, further);
    try {
      Class<?> type = LoadedCode.type(plan);
      Object made =
          plan.takesNumbers()
              ? type.getConstructor(double[].class).newInstance((Object) parameters)
              : type.getConstructor().newInstance();
      return (ProgramCode) made;
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(
          "the generated class " + plan.simpleName() + " cannot be loaded", e);
    }
  }
}

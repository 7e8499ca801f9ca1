package org.mechservice.sim.emit.plan;

import java.util.Arrays;
import java.util.Locale;
import java.util.function.Supplier;
import org.mechservice.sim.emit.method.CodeSize;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.solver.symbol.Program;

/**
 * Chooses between a straight line and shared kernels (docs/theory/formulations.md#methods), whose
 * results are the same.
 */
public final class CodeLayout {
  /**
   * Smallest ratio of lengths at which shared kernels are chosen. Class files of chains whose links
   * differ only in numbers are 2.6 times smaller with 60 links and 3.7 times with 200, names and
   * tables included; in trees of random joints few sections are alike, and the calls cost more than
   * they save.
   */
  private static final double LEAST_GAIN = 2;

  private CodeLayout() {}

  /**
   * Plans a program for the virtual machine, whose compiler takes methods up to a length.
   *
   * @param head the method that runs it
   * @param form the requested form
   * @param table receives the constants in which calls of a method differ, and the rows that the
   *     program reads
   */
  public static ProgramPlan plan(
      Program program, MethodSignature head, CodeForm form, ConstantTable table) {
    table.addRows(program);
    return switch (form) {
      case STRAIGHT -> StraightLinePlanner.plan(program, table);
      case SHARED -> KernelPlanner.plan(program, head, table);
      case AUTO ->
          isShort(program)
              ? StraightLinePlanner.plan(program, table)
              : shorter(program, table, () -> KernelPlanner.plan(program, head, table));
    };
  }

  /** Plans a program in the form that suits it, for C; arguments as for {@link #plan}. */
  public static ProgramPlan inC(Program program, MethodSignature head, ConstantTable table) {
    table.addRows(program);
    return isShort(program)
        ? StraightLinePlanner.plan(program, table)
        : shorter(program, table, () -> KernelPlanner.inC(program, head, table));
  }

  private static boolean isShort(Program program) {
    return program.operationCount() < CodeForm.LEAST_OPERATIONS;
  }

  private static ProgramPlan shorter(
      Program program, ConstantTable table, Supplier<ProgramPlan> kernels) {
    int before = table.size();
    ProgramPlan shared = kernels.get();
    double straight = Arrays.stream(CodeSize.ofSections(program, shared.usage())).sum();
    double gain = straight / shared.codeBytes();
    if (gain >= LEAST_GAIN) {
      return shared.because(
          String.format(Locale.ROOT, "%.0f times shorter than as a straight line", gain));
    }
    table.cutBack(before);
    return StraightLinePlanner.plan(program, table)
        .because(
            String.format(
                Locale.ROOT, "shared kernels would take %.0f %% of its code", 100 / gain));
  }
}

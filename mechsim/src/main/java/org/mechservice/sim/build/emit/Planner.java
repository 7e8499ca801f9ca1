package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.symbolic.Program;

/**
 * Plans a program as straight-line methods: sections in order, as many to a method as the compiler
 * of the virtual machine likes to see together (CODEGEN §9: a method above 8 000 bytes is never
 * compiled, about 6 000 runs fastest).
 */
final class Planner {
  /** Bytes of code aimed at. */
  private static final int METHOD_BYTES = 6000;

  /** Estimated bytes above which sections are distributed anew. */
  private static final int TOO_LONG = 6600;

  private Planner() {}

  /** Plans a program. */
  static ProgramPlan plan(Program program) {
    Usage usage = new Usage(program);
    int[] bytes = CodeSize.ofSections(program, usage);
    for (int limit = METHOD_BYTES; ; limit = limit * 9 / 10) {
      ProgramPlan plan = new MethodPlanner(program, usage, chunks(bytes, limit)).plan();
      int longest = plan.methods().stream().mapToInt(CodeSize::of).max().orElse(0);
      if (longest <= TOO_LONG || limit < METHOD_BYTES / 4) {
        return plan;
      }
    }
  }

  /** Returns the method of each section: consecutive sections up to a limit of bytes. */
  private static List<Integer> chunks(int[] bytes, int limit) {
    List<Integer> chunks = new ArrayList<>();
    int chunk = 0;
    int filled = 0;
    for (int size : bytes) {
      if (filled > 0 && filled + size > limit) {
        chunk++;
        filled = 0;
      }
      filled += size;
      chunks.add(chunk);
    }
    return chunks;
  }
}

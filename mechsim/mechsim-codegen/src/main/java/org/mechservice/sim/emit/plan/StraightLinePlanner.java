package org.mechservice.sim.emit.plan;

import java.util.function.IntFunction;
import org.mechservice.sim.emit.method.CodeSize;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.solver.symbol.Program;

/**
 * Plans a program as straight-line methods: sections in order, as many per method as run fastest
 * (docs/theory/formulations.md#methods).
 */
final class StraightLinePlanner {
  /** Intended bytes of code of a method. */
  static final int METHOD_BYTES = 6000;

  /** Bytes above which sections are distributed again. */
  static final int TOO_LONG = 6600;

  /** Smallest intended size; a smaller method would consist of calls only. */
  private static final int LEAST_BYTES = METHOD_BYTES / 8;

  private StraightLinePlanner() {}

  /**
   * Plans a program.
   *
   * @param table holds the rows that it reads
   */
  static ProgramPlan plan(Program whole, ConstantTable table) {
    return within(
        limit -> {
          SectionSplitter.Division division = SectionSplitter.divided(whole, limit);
          int[] chunks = chunks(division.bytes(), limit);
          return new MethodPlanner(division.program(), division.usage(), chunks, true).plan(table);
        });
  }

  /**
   * Plans for ever shorter methods until none is too long.
   *
   * @param planner plans methods for a given number of bytes; longer sections are divided
   */
  static ProgramPlan within(IntFunction<ProgramPlan> planner) {
    int limit = METHOD_BYTES;
    while (true) {
      ProgramPlan plan = planner.apply(limit);
      int longest = longest(plan);
      if (limit < LEAST_BYTES || longest <= TOO_LONG) {
        return plan;
      }
      limit = Math.min(limit * 9 / 10, (int) ((long) limit * METHOD_BYTES / longest));
    }
  }

  private static int longest(ProgramPlan plan) {
    int longest = 0;
    for (MethodPlan method : plan.methods()) {
      longest = Math.max(longest, CodeSize.of(method));
    }
    return longest;
  }

  /** Returns the method of each section: consecutive sections up to a limit of bytes. */
  private static int[] chunks(int[] bytes, int limit) {
    int[] chunks = new int[bytes.length];
    int chunk = 0;
    int filled = 0;
    for (int section = 0; section < bytes.length; section++) {
      if (filled > 0 && filled + bytes[section] > limit) {
        chunk++;
        filled = 0;
      }
      filled += bytes[section];
      chunks[section] = chunk;
    }
    return chunks;
  }
}

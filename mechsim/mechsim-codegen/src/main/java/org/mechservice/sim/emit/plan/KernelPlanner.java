package org.mechservice.sim.emit.plan;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.mechservice.sim.emit.method.CallSequence;
import org.mechservice.sim.emit.method.CodeSize;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.method.ValueUsage;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;

/**
 * Plans a program as shared kernels (docs/theory/formulations.md#methods): sections that compute
 * the same operations in the same order, such as those of bodies on joints of one type, become one
 * method, called with their differences as arguments. All other sections become methods as in a
 * straight line.
 */
final class KernelPlanner {
  /** Bytes of code below which a call is not shorter. */
  private static final int SHORTEST_KERNEL = 60;

  private final Program program;
  private final ValueUsage usage;
  private final MethodSignature head;
  private final ConstantTable table;
  private final int limit;
  private final int numbersAt;
  private final Expressions common = new Expressions();
  private final List<MethodPlan> methods = new ArrayList<>();
  private final List<CallSequence.Call> calls = new ArrayList<>();

  private KernelPlanner(
      SectionSplitter.Division division, MethodSignature head, ConstantTable table, int limit) {
    this.program = division.program();
    this.usage = division.usage();
    this.head = head;
    this.table = table;
    this.limit = limit;
    this.numbersAt = table.addNumbers(program.expressions());
  }

  /**
   * Plans a program.
   *
   * @param head the method that runs it
   * @param table receives the constants in which calls differ
   */
  static ProgramPlan plan(Program whole, MethodSignature head, ConstantTable table) {
    int before = table.size();
    return StraightLinePlanner.within(
        limit -> {
          table.cutBack(before);
          return new KernelPlanner(SectionSplitter.divided(whole, limit), head, table, limit)
              .plan();
        });
  }

  /** Plans a program for C, where a function may be of any length; arguments as above. */
  static ProgramPlan inC(Program whole, MethodSignature head, ConstantTable table) {
    int limit = StraightLinePlanner.METHOD_BYTES;
    return new KernelPlanner(SectionSplitter.divided(whole, limit), head, table, limit).plan();
  }

  private ProgramPlan plan() {
    int sections = program.sections().size();
    int[] alone = IntStream.range(0, sections).toArray();
    List<MethodPlan> single = new MethodPlanner(program, usage, alone, false).methods();
    int[] chunks = chunks(single, shared(single));
    MethodPlanner planner = new MethodPlanner(program, usage, chunks, false);
    write(planner.methods());
    return new ProgramPlan(
        program, usage, methods, CallSequence.of(calls), planner.slotCount(), table, "");
  }

  private MethodPlan shape(MethodPlan method) {
    return KernelBody.of(method, head, common, numbersAt).shape();
  }

  /** Returns the sections whose shape another one has, too. */
  private BitSet shared(List<MethodPlan> single) {
    Map<MethodPlan, Integer> met = new HashMap<>();
    BitSet shared = new BitSet();
    for (int section = 0; section < single.size(); section++) {
      if (CodeSize.of(single.get(section)) >= SHORTEST_KERNEL) {
        Integer first = met.putIfAbsent(shape(single.get(section)), section);
        if (first != null) {
          shared.set(first);
          shared.set(section);
        }
      }
    }
    return shared;
  }

  /**
   * Returns the method of each section: one for each shared section, and one for consecutive others
   * up to a limit.
   */
  private int[] chunks(List<MethodPlan> single, BitSet shared) {
    int[] chunks = new int[single.size()];
    int chunk = -1;
    // above the limit a new method begins
    int full = limit + 1;
    int filled = full;
    for (int section = 0; section < chunks.length; section++) {
      int bytes = CodeSize.of(single.get(section));
      boolean alone = shared.get(section);
      if (alone || filled + bytes > limit) {
        chunk++;
        filled = 0;
      }
      filled = alone ? full : filled + bytes;
      chunks[section] = chunk;
    }
    return chunks;
  }

  private void write(List<MethodPlan> chunks) {
    Map<MethodPlan, List<KernelBody>> alike = new LinkedHashMap<>();
    List<KernelBody> bodies = new ArrayList<>();
    for (MethodPlan chunk : chunks) {
      KernelBody body = KernelBody.of(chunk, head, common, numbersAt);
      bodies.add(body);
      alike.computeIfAbsent(body.shape(), key -> new ArrayList<>()).add(body);
    }
    Map<MethodPlan, Kernel> kernels = new HashMap<>();
    Map<MethodPlan, Integer> numbers = new HashMap<>();
    Map<MethodPlan, Integer> callCount = new HashMap<>();
    for (int i = 0; i < chunks.size(); i++) {
      MethodPlan shape = bodies.get(i).shape();
      List<KernelBody> sections = alike.getOrDefault(shape, List.of());
      if (chunks.get(i).statements().isEmpty()) {
        continue;
      }
      if (sections.size() == 1) {
        calls.add(new CallSequence.Call(methods.size(), List.of()));
        methods.add(chunks.get(i));
        continue;
      }
      Kernel kernel = kernels.get(shape);
      if (kernel == null) {
        kernel = new Kernel(sections, table);
        kernels.put(shape, kernel);
        numbers.put(shape, methods.size());
        methods.add(kernel.method());
      }
      int call = callCount.merge(shape, 1, Integer::sum) - 1;
      List<Integer> given = kernel.numbersOf(call);
      calls.add(new CallSequence.Call(numbers.getOrDefault(shape, 0), given));
    }
  }
}

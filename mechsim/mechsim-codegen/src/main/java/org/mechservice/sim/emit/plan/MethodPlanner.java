package org.mechservice.sim.emit.plan;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import org.mechservice.sim.emit.method.CallSequence;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.IndexExpression;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.Statement;
import org.mechservice.sim.emit.method.ValueLocation;
import org.mechservice.sim.emit.method.ValueUsage;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * Writes the methods of a plan for a given assignment of sections to methods ("chunks").
 *
 * <p>A value computed in one chunk and used in a later one goes through the workspace, even if it
 * is used once. A chunk loads such a value into a local variable, which has the name of the value.
 * It also loads array elements that it uses more than once, because otherwise a write to one array
 * would force another array to be read again. In a straight line, sections that read their operands
 * again load them in the same way.
 */
final class MethodPlanner {
  /** Smallest number of consecutive inputs that are copied in a loop. */
  private static final int SHORTEST_COPY = 3;

  /**
   * Uses of a value in one chunk: their number, the first section, and the sections that read it
   * again.
   */
  private record Use(Scalar value, int count, int firstSection, SortedSet<Integer> sectionsAnew) {}

  private final Program program;
  private final ValueUsage usage;
  private final int[] chunkOfSection;
  private final boolean straight;
  private final WorkspaceSlots slots;
  private final List<List<Use>> usesOfChunk = new ArrayList<>();

  /**
   * @param chunkOfSection method of each section, in order; not modified
   * @param straight whether the layout is a straight line: an element of the workspace is reused
   *     after the last use of its value, and loaded again in sections that read their operands
   *     again
   */
  MethodPlanner(Program program, ValueUsage usage, int[] chunkOfSection, boolean straight) {
    this.program = program;
    this.usage = usage;
    this.chunkOfSection = chunkOfSection;
    this.straight = straight;
    this.slots = new WorkspaceSlots(program, usage, chunkOfSection, straight);
    int chunks = chunkOfSection.length == 0 ? 0 : chunkOfSection[chunkOfSection.length - 1] + 1;
    for (int chunk = 0; chunk < chunks; chunk++) {
      usesOfChunk.add(new ArrayList<>());
    }
    collectUses();
  }

  private void collectUses() {
    int[] counts = new int[usesOfChunk.size()];
    int[] firsts = new int[usesOfChunk.size()];
    for (Scalar node : usage.given()) {
      collectUses(node, counts, firsts);
    }
    for (int section = 0; section < chunkOfSection.length; section++) {
      for (Scalar node : usage.placedIn(section)) {
        collectUses(node, counts, firsts);
      }
    }
  }

  /**
   * @param counts zeros, one per chunk; zeros again afterwards
   * @param firsts scratch, one per chunk; overwritten
   */
  private void collectUses(Scalar node, int[] counts, int[] firsts) {
    int uses = usage.useCount(node);
    Map<Integer, SortedSet<Integer>> anew = new HashMap<>();
    for (int i = 0; i < uses; i++) {
      int section = usage.user(node, i);
      int chunk = chunkOfSection[section];
      if (straight && program.sections().get(section).readsAnew()) {
        anew.computeIfAbsent(chunk, key -> new TreeSet<>()).add(section);
      }
      firsts[chunk] = counts[chunk] == 0 ? section : Math.min(firsts[chunk], section);
      counts[chunk]++;
    }
    for (int i = 0; i < uses; i++) {
      int chunk = chunkOfSection[usage.user(node, i)];
      if (counts[chunk] > 0) {
        SortedSet<Integer> sectionsAnew = anew.getOrDefault(chunk, Collections.emptySortedSet());
        usesOfChunk.get(chunk).add(new Use(node, counts[chunk], firsts[chunk], sectionsAnew));
        counts[chunk] = 0;
      }
    }
  }

  /**
   * Returns a plan that calls every method once.
   *
   * @param table holds the rows that the program reads
   */
  ProgramPlan plan(ConstantTable table) {
    List<MethodPlan> methods = new ArrayList<>();
    List<CallSequence> steps = new ArrayList<>();
    for (MethodPlan method : methods()) {
      if (!method.statements().isEmpty()) {
        steps.add(CallSequence.of(methods.size()));
        methods.add(method);
      }
    }
    return new ProgramPlan(program, usage, methods, steps, slots.count(), table, "");
  }

  /** Returns the length of workspace needed. */
  int slotCount() {
    return slots.count();
  }

  /** Returns the method of every chunk; some are empty. */
  List<MethodPlan> methods() {
    List<MethodPlan> methods = new ArrayList<>();
    int section = 0;
    for (int chunk = 0; chunk < usesOfChunk.size(); chunk++) {
      int end = section;
      while (end < chunkOfSection.length && chunkOfSection[end] == chunk) {
        end++;
      }
      methods.add(method(chunk, section, end));
      section = end;
    }
    return methods;
  }

  private MethodPlan method(int chunk, int firstSection, int endSection) {
    Map<Scalar, ValueLocation> places = new HashMap<>();
    Map<Integer, List<Statement>> loads = new HashMap<>();
    int firstNode = firstSection == 0 ? 0 : program.sections().get(firstSection).firstNode();
    for (Use use : usesOfChunk.get(chunk)) {
      if (ValueUsage.isComputed(use.value()) && use.value().id() >= firstNode) {
        places.put(use.value(), new ValueLocation.Local(use.value()));
      } else {
        take(use, places, loads);
      }
    }
    List<Statement> statements = new ArrayList<>();
    for (int section = firstSection; section < endSection; section++) {
      write(section, loads.getOrDefault(section, List.of()), places, statements);
    }
    return new MethodPlan(statements, places);
  }

  /** Determines the location in a chunk of a value from outside it. */
  private void take(
      Use use, Map<Scalar, ValueLocation> places, Map<Integer, List<Statement>> loads) {
    Scalar node = use.value();
    boolean isInput = node.operation() == ScalarOperation.INPUT;
    if (isInput && (use.count() == 1 || node.index() == Program.TIME)) {
      places.put(node, new ValueLocation.Input(node.index()));
      return;
    }
    ValueLocation outside =
        isInput ? new ValueLocation.Input(node.index()) : new ValueLocation.Slot(slots.of(node));
    load(use.firstSection(), new Statement.Load(node, outside, false), loads);
    for (int section : use.sectionsAnew()) {
      if (section != use.firstSection()) {
        load(section, new Statement.Load(node, outside, true), loads);
      }
    }
    places.put(node, new ValueLocation.Local(node));
  }

  private static void load(int section, Statement.Load load, Map<Integer, List<Statement>> loads) {
    loads.computeIfAbsent(section, key -> new ArrayList<>()).add(load);
  }

  private void write(
      int index,
      List<Statement> loads,
      Map<Scalar, ValueLocation> places,
      List<Statement> statements) {
    Program.Section section = program.sections().get(index);
    List<Statement> body = new ArrayList<>(loads);
    for (Scalar node : usage.placedIn(index)) {
      if (places.containsKey(node)) {
        body.add(new Statement.Define(node));
      }
      if (slots.has(node)) {
        body.add(new Statement.Store(slots.of(node), node));
      }
    }
    putOut(section.outputs(), body);
    for (Program.Guard guard : section.guards()) {
      body.add(
          new Statement.Check(
              guard.pivot(), guard.bound(), IndexExpression.of(guard.result()), guard.meaning()));
    }
    if (!body.isEmpty()) {
      if (!section.title().isEmpty()) {
        statements.add(new Statement.Comment(section.title()));
      }
      statements.addAll(body);
    }
  }

  private static void putOut(List<Program.Output> outputs, List<Statement> body) {
    for (int i = 0; i < outputs.size(); ) {
      int run = runOfInputs(outputs, i);
      Program.Output first = outputs.get(i);
      if (run >= SHORTEST_COPY) {
        body.add(new Statement.CopyInputs(first.value().index(), first.index(), run));
        i += run;
      } else {
        body.add(new Statement.PutOut(first.index(), first.value()));
        i++;
      }
    }
  }

  /** Returns the number of outputs from {@code start} on that are consecutive inputs. */
  private static int runOfInputs(List<Program.Output> outputs, int start) {
    Program.Output first = outputs.get(start);
    int run = 0;
    while (start + run < outputs.size()) {
      Program.Output next = outputs.get(start + run);
      boolean follows =
          next.value().operation() == ScalarOperation.INPUT
              && next.index() == first.index() + run
              && next.value().index() == first.value().index() + run;
      if (!follows) {
        return run;
      }
      run++;
    }
    return run;
  }
}

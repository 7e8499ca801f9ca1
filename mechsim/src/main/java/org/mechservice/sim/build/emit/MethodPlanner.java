package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/**
 * Writes the methods of a plan, given which section goes into which method ("chunk").
 *
 * <p>A value computed in one chunk and used in a later one goes through the workspace, even if it
 * is used once. What a chunk takes from there it loads into a local variable, which gives it its
 * name again; so it does with a component of the state that it uses more than once, lest a write to
 * one array force another to be read again.
 */
final class MethodPlanner {
  /** Fewer inputs than this are put out one by one. */
  private static final int SHORTEST_COPY = 3;

  private final Program program;
  private final Usage usage;
  private final List<Integer> chunkOfSection;
  private final LocalNames names;
  private final WorkspaceSlots slots;
  private final List<Scalar> angles;

  MethodPlanner(Program program, Usage usage, List<Integer> chunkOfSection) {
    this.program = program;
    this.usage = usage;
    this.chunkOfSection = chunkOfSection;
    this.names = new LocalNames(program, usage);
    this.angles = usage.angles();
    this.slots = new WorkspaceSlots(program, usage, chunkOfSection);
  }

  ProgramPlan plan() {
    List<MethodPlan> methods = new ArrayList<>();
    int count = chunkOfSection.isEmpty() ? 0 : chunkOfSection.get(chunkOfSection.size() - 1) + 1;
    for (int chunk = 0; chunk < count; chunk++) {
      MethodPlan method = method(chunk);
      if (!method.statements().isEmpty()) {
        methods.add(method);
      }
    }
    return new ProgramPlan(angles, methods, slots.count());
  }

  private MethodPlan method(int chunk) {
    Map<Scalar, Place> places = new HashMap<>();
    Map<Integer, List<Statement>> loads = new HashMap<>();
    for (Scalar node : usage.given()) {
      take(chunk, node, places, loads);
    }
    for (int section = 0; section < chunkOfSection.size(); section++) {
      for (Scalar node : usage.placedIn(section)) {
        if (chunkOfSection.get(section) < chunk) {
          take(chunk, node, places, loads);
        } else if (chunkOfSection.get(section) == chunk && usesIn(chunk, node) > 0) {
          places.put(node, new Place.Local(names.of(node)));
        }
      }
    }
    List<Statement> statements = new ArrayList<>();
    for (int section = 0; section < chunkOfSection.size(); section++) {
      if (chunkOfSection.get(section) == chunk) {
        write(section, loads.getOrDefault(section, List.of()), places, statements);
      }
    }
    return new MethodPlan(statements, places);
  }

  private int usesIn(int chunk, Scalar node) {
    int uses = 0;
    for (int section : usage.sectionsUsing(node)) {
      uses += chunkOfSection.get(section) == chunk ? 1 : 0;
    }
    return uses;
  }

  /** Finds a place in a chunk for a value that comes from outside it. */
  private void take(
      int chunk, Scalar node, Map<Scalar, Place> places, Map<Integer, List<Statement>> loads) {
    int uses = usesIn(chunk, node);
    if (uses == 0) {
      return;
    }
    Place outside =
        node.operation() == Operation.INPUT
            ? new Place.Input(node.index())
            : new Place.Slot(slots.of(node));
    if (uses == 1 && outside instanceof Place.Input) {
      places.put(node, outside);
      return;
    }
    int first =
        usage.sectionsUsing(node).stream()
            .filter(section -> chunkOfSection.get(section) == chunk)
            .mapToInt(Integer::intValue)
            .min()
            .orElseThrow();
    String name = names.of(node);
    loads.computeIfAbsent(first, key -> new ArrayList<>()).add(new Statement.Load(name, outside));
    places.put(node, new Place.Local(name));
  }

  private void write(
      int index, List<Statement> loads, Map<Scalar, Place> places, List<Statement> statements) {
    Program.Section section = program.sections().get(index);
    List<Statement> body = new ArrayList<>(loads);
    for (Scalar node : usage.placedIn(index)) {
      if (places.containsKey(node)) {
        body.add(new Statement.Define(names.of(node), node));
      }
      if (slots.has(node)) {
        body.add(new Statement.Store(slots.of(node), node, names.of(node)));
      }
    }
    putOut(section.outputs(), body);
    for (Program.Guard guard : section.guards()) {
      body.add(new Statement.Check(guard.pivot(), guard.bound(), guard.result(), guard.meaning()));
    }
    if (!body.isEmpty()) {
      statements.add(new Statement.Comment(section.title()));
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

  /** Returns how many outputs from {@code start} on are consecutive inputs. */
  private static int runOfInputs(List<Program.Output> outputs, int start) {
    Program.Output first = outputs.get(start);
    int run = 0;
    while (start + run < outputs.size()) {
      Program.Output next = outputs.get(start + run);
      boolean follows =
          next.value().operation() == Operation.INPUT
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

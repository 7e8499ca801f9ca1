package org.mechservice.sim.emit.c;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.emit.plan.CodeLayout;
import org.mechservice.sim.emit.plan.ProgramPlan;
import org.mechservice.sim.emit.source.ProgramPrinter;
import org.mechservice.sim.emit.source.SourceLines;
import org.mechservice.solver.symbol.Program;

/**
 * The programs of a model as static functions in C: the equations of motion and their derivatives
 * along directions, the conditions of events, and the groups of outputs. They share one table of
 * constants and the workspace of the instance, which is as long as the longest of them needs.
 */
final class CPrograms {
  /** Function of the derivatives of the equations of motion along a direction. */
  static final String TANGENT = "along";

  /** Function of the derivatives of the further rates along a direction, of a model with loops. */
  static final String FURTHER_TANGENT = "further_along";

  /** Functions of what the steps of a model watch: its quantities, and how deep shapes overlap. */
  static final String WATCHED = "watched_quantities";

  static final String OVERLAPS = "overlap_depths";

  private record Part(MethodSignature head, ProgramPlan plan) {}

  private final String name;
  private final ConstantTable constants = new ConstantTable();
  private final List<Part> parts = new ArrayList<>();

  /**
   * Plans the programs of a model.
   *
   * @param watch what its steps watch, if they are to be searched
   */
  CPrograms(CModel model, Optional<CWatch> watch) {
    this.name = model.name();
    int states = model.states().size();
    CTangents tangents = new CTangents(states, model.parameterSlots());
    if (model.motion() instanceof CMotion.Tree tree) {
      add("derivative", "dx", true, tree.derivative());
      add(TANGENT, "dx", true, tangents.of(tree.derivative(), states), argument("seed", states));
    } else if (model.motion() instanceof CLoops loops) {
      addLoops(loops, tangents, states, model.description().velocityCount());
    }
    CEvents events = model.events();
    if (!events.kinds().isEmpty()) {
      add("triggers", "values", false, events.triggers());
    }
    if (!events.assignments().isEmpty()) {
      add("assigned", "values", false, events.assigned());
    }
    watch.ifPresent(this::addWatched);
    add(COutputs.ENERGIES, "energy", false, model.energy());
    for (COutputs group : model.groups()) {
      if (!group.name().equals(COutputs.ENERGIES)) {
        add(group.name(), "values", false, group.program());
      }
    }
  }

  private void addWatched(CWatch watch) {
    add(WATCHED, "values", false, watch.quantities());
    if (!watch.contacts().isEmpty()) {
      add(OVERLAPS, "values", false, watch.overlaps());
    }
  }

  private void addLoops(CLoops loops, CTangents tangents, int states, int velocities) {
    add("loop_terms", "terms", false, loops.loops());
    add("all_terms", "terms", true, loops.equations());
    add("mass_matrix", "terms", false, loops.mass());
    loops.further().ifPresent(program -> add("further_rates", "rates", false, program));
    int given = states + loops.angleStarts().size();
    int seed = given + velocities + loops.rows();
    add(
        TANGENT,
        "rates",
        false,
        tangents.ofLoops(loops, velocities, given, seed),
        argument("given", given),
        argument("seed", seed));
    loops
        .further()
        .ifPresent(
            program ->
                add(
                    FURTHER_TANGENT,
                    "rates",
                    false,
                    tangents.of(program, seed),
                    argument("given", given),
                    argument("seed", seed)));
    loops.angles().ifPresent(program -> add("cut_angles", "angles", false, program));
  }

  private static MethodSignature.Argument argument(String array, int first) {
    return new MethodSignature.Argument(array, true, first);
  }

  private void add(
      String function,
      String output,
      boolean returnsResult,
      Program program,
      MethodSignature.Argument... further) {
    List<MethodSignature.Argument> state = new ArrayList<>();
    state.add(new MethodSignature.Argument("t", false, Program.TIME));
    state.add(argument("x", 0));
    state.addAll(List.of(further));
    MethodSignature head = new MethodSignature(function, state, output, returnsResult, false);
    parts.add(new Part(head, CodeLayout.inC(program, head, constants)));
  }

  /** Returns the length of the workspace that an instance needs. */
  int slots() {
    return parts.stream().mapToInt(part -> part.plan().slots()).max().orElse(0);
  }

  /** Writes the constants, then the prototypes, then the functions. */
  void write(SourceLines source) {
    if (!constants.isEmpty()) {
      source.line("static const double " + ConstantTable.FIELD + "[] = {");
      for (String text : constants.texts()) {
        source.line("    " + text.strip().replace(" ", ", ") + ",");
      }
      source.line("};").blank();
    }
    SourceLines functions = new SourceLines();
    List<String> prototypes = new ArrayList<>();
    for (Part part : parts) {
      ProgramPrinter printer =
          new ProgramPrinter(functions, part.head(), part.plan(), new CSyntax(name + "_t"));
      printer.method(List.of(), List.of());
      prototypes.addAll(printer.prototypes());
    }
    prototypes.forEach(prototype -> source.line(prototype + ";"));
    source.append(functions);
  }
}

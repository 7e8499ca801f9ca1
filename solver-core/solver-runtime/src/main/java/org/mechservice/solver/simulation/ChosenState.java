package org.mechservice.solver.simulation;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.simulation.equations.ModelEquations;

/**
 * Closes the loops at a state that a program has chosen for a run to go on from: coordinates that
 * it set are held, to the tolerances of the run, and the others follow.
 */
final class ChosenState {
  private final ModelEquations equations;
  private final int coordinates;
  private final double relativeTolerance;
  private final List<Double> absoluteTolerances;

  ChosenState(ModelEquations equations, RunSettings settings) {
    this.equations = equations;
    ModelDescription description = equations.model().description();
    coordinates = description.positionCount() + description.velocityCount();
    relativeTolerance = settings.relativeTolerance();
    absoluteTolerances = equations.absoluteTolerances(settings);
  }

  /**
   * Closes the loops.
   *
   * @param present unknowns that the run has reached; not modified
   * @param unknowns the chosen ones: a coordinate that is another one is held; overwritten
   * @throws IllegalArgumentException S-195 if the loops do not close so, with the coordinates that
   *     are in the way; the model then goes on from the present state
   */
  void close(double t, double[] present, double[] unknowns) {
    boolean[] set = new boolean[unknowns.length];
    for (int i = 0; i < coordinates; i++) {
      set[i] = unknowns[i] != present[i];
    }
    List<Integer> held = IntStream.range(0, coordinates).filter(i -> set[i]).boxed().toList();
    if (held.isEmpty()) {
      return;
    }
    normalise(unknowns, set);
    double[] chosen = unknowns.clone();
    boolean closed = equations.closeLoopsAfterJump(t, unknowns, set);
    List<String> moved = new ArrayList<>();
    for (int i : held) {
      double most = relativeTolerance * Math.abs(chosen[i]) + absoluteTolerances.get(i);
      if (!(Math.abs(unknowns[i] - chosen[i]) <= most)) {
        moved.add(equations.name(i) + " would be " + unknowns[i] + " instead of " + chosen[i]);
      }
    }
    if (!closed || !moved.isEmpty()) {
      equations.closeLoopsAfterJump(t, present.clone(), new boolean[set.length]);
      throw refused(
          "the loops do not close with "
              + held.stream().map(equations::name).collect(Collectors.joining(", "))
              + " as set"
              + (closed ? ": " + String.join(", ", moved) : "")
              + "; set fewer coordinates, and the others follow");
    }
  }

  /** Gives Euler parameters that were set the norm one. */
  private void normalise(double[] unknowns, boolean[] set) {
    for (int group = 0; group < equations.groupCount(); group++) {
      int from = equations.groupStart(group);
      int to = from + equations.groupSize(group);
      if (IntStream.range(from, to).anyMatch(i -> set[i])) {
        double square = 0;
        for (int i = from; i < to; i++) {
          square += unknowns[i] * unknowns[i];
        }
        if (!(square > 0)) {
          throw refused("Euler parameters from " + equations.name(from) + " on are all zero");
        }
        for (int i = from; i < to; i++) {
          unknowns[i] /= Math.sqrt(square);
        }
      }
    }
  }

  private static IllegalArgumentException refused(String why) {
    return new IllegalArgumentException(
        MessageCode.RUN_CANNOT_BE_STEPPED + " the state cannot be set: " + why);
  }
}

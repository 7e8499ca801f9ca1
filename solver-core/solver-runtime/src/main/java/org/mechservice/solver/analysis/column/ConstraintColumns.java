package org.mechservice.solver.analysis.column;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;

/**
 * Residuals of the loops and the forces that close them. A tilt is multiplied by the mechanism's
 * length, so that all residuals are in m. The forces of an equation are −λ times its gradient: a
 * rod in tension has a positive multiplier.
 */
final class ConstraintColumns implements ColumnValues {
  /** Part of the largest multiplier that is rounding: a rope without load has no tension. */
  private static final double ROUNDING = 1e-9;

  private final EquationsOfMotion equations;
  private final List<Variable> columns = new ArrayList<>();

  /** Rows whose multiplier has one sign in reality: 1 for a tension, −1 for a push; else 0. */
  private final int[] oneSided;

  /** First note of each row; empty before it, and of rows without one. */
  private final List<Optional<Note>> noted;

  /** Largest multiplier seen, N. */
  private double largest;

  ConstraintColumns(EquationsOfMotion equations) {
    this.equations = equations;
    LoopEquations loops = equations.loops;
    oneSided = new int[loops.count()];
    noted = new ArrayList<>(Collections.nCopies(loops.count(), Optional.empty()));
    if (loops.count() > 0) {
      columns.add(new Variable("constraint.position", "m"));
      columns.add(new Variable("constraint.velocity", "m/s"));
    }
    for (int row = 0; row < loops.count(); row++) {
      int first = row;
      while (first > 0 && loops.closure(first - 1) == loops.closure(row)) {
        first--;
      }
      oneSided[row] = first == row ? side(loops.closure(row)) : 0;
      boolean single =
          first == row
              && (row + 1 == loops.count() || loops.closure(row + 1) != loops.closure(row));
      String index = single ? "" : "[" + (row - first) + "]";
      columns.add(new Variable(loops.closure(row).name() + ".lambda" + index, unit(loops, row)));
    }
  }

  /** Returns the sign that a real rope or wheel gives the first multiplier, 0 for any. */
  private static int side(LoopClosure closure) {
    if (closure instanceof CoordinateClosure coupling && !coupling.points().isEmpty()) {
      return 1;
    }
    return closure instanceof RollingClosure ? -1 : 0;
  }

  private static String unit(LoopEquations loops, int row) {
    return switch (loops.unit(row)) {
      case "m" -> "N";
      case "rad" -> "N·m";
      default -> loops.unit(row);
    };
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  @Override
  public void write(double t, double[] values, int at) {
    LoopEquations loops = equations.loops;
    if (loops.count() == 0) {
      return;
    }
    double position = 0;
    double velocity = 0;
    for (int row = 0; row < loops.count(); row++) {
      position = Math.max(position, Math.abs(loops.value[row]) / loops.size(row));
      velocity = Math.max(velocity, Math.abs(loops.rate[row]) / loops.size(row));
    }
    values[at] = position * loops.length();
    values[at + 1] = velocity * loops.length();
    System.arraycopy(equations.lambda, 0, values, at + 2, loops.count());
    observe(t);
  }

  @Override
  public boolean observes() {
    return Arrays.stream(oneSided).anyMatch(side -> side != 0);
  }

  /** Notes the first time at which a rope pushes, or at which a plane pulls what rolls on it. */
  @Override
  public void observe(double t) {
    for (int row = 0; row < oneSided.length; row++) {
      largest = Math.max(largest, Math.abs(equations.lambda[row]));
    }
    for (int row = 0; row < oneSided.length; row++) {
      double wrong = -oneSided[row] * equations.lambda[row];
      if (wrong > ROUNDING * largest && noted.get(row).isEmpty()) {
        noted.set(row, Optional.of(note(t, equations.loops.closure(row), wrong)));
      }
    }
  }

  private static Note note(double t, LoopClosure closure, double size) {
    String text =
        closure instanceof RollingClosure
            ? "The plane of \"%s\" pulls with %.4g N at what rolls on it, which would lift off. Use a"
                + " contact or a tyre where it does."
            : "The rope \"%s\" pushes with %.4g N; a real one goes slack. Use an elasticRope where it"
                + " does.";
    return new Note(
        MessageCode.CONSTRAINT_PULLS,
        t,
        true,
        String.format(Locale.ROOT, text, closure.name(), size));
  }

  @Override
  public List<Note> notes() {
    return noted.stream().flatMap(Optional::stream).toList();
  }
}

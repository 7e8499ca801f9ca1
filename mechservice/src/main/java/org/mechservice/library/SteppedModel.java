package org.mechservice.library;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.simulation.SteppedRun;

/**
 * A run that is stepped from outside: a program sets the inputs of the model, advances by one step
 * of communication, reads any column, and so on. A controller of one's own thus meets the model:
 *
 * <pre>{@code
 * SteppedModel run = MechModel.read(Path.of("arm.xml")).until(2).stepped(0.005);
 * while (run.isRunning()) {
 *   run.input("torque", 40 * (0.5 - run.value("hinge.q")) - 8 * run.value("hinge.v"));
 *   run.step();
 * }
 * }</pre>
 *
 * <p>Inputs are constant within a step. Samples and events at the end of a step come before the
 * inputs that are set there. Belongs to one thread.
 */
public final class SteppedModel {
  /** The last row. */
  private static final class LastRow implements ResultSink {
    private List<Variable> columns = List.of();
    private double[] values = {};

    @Override
    public void begin(List<Variable> announced) {
      columns = List.copyOf(announced);
      values = new double[columns.size()];
    }

    @Override
    public void row(double[] row) {
      System.arraycopy(row, 0, values, 0, values.length);
    }
  }

  private final LastRow row;
  private final SteppedRun run;
  private final List<FurtherState> further;
  private final int furtherOffset;
  private final double[] y;

  private SteppedModel(LastRow row, SteppedRun run, Mechanism mechanism) {
    this.row = row;
    this.run = run;
    further = mechanism.furtherStates();
    furtherOffset = mechanism.furtherOffset();
    y = new double[mechanism.stateCount()];
  }

  static SteppedModel begin(Model model, RunRequest request, String hash, Mechanism mechanism) {
    SteppedModel stepped = of(model, request, hash, mechanism);
    try {
      stepped.run.begin();
    } catch (IOException e) {
      throw noFile(e);
    }
    stepped.requireNoFailure();
    return stepped;
  }

  static SteppedModel restored(
      Model model, RunRequest request, String hash, Mechanism mechanism, byte[] saved) {
    SteppedModel stepped = of(model, request, hash, mechanism);
    stepped.run.restore(saved);
    return stepped;
  }

  private static SteppedModel of(
      Model model, RunRequest request, String hash, Mechanism mechanism) {
    LastRow row = new LastRow();
    try {
      return new SteppedModel(row, RuntimeSolver.stepped(model, request, row, hash), mechanism);
    } catch (IOException e) {
      throw noFile(e);
    }
  }

  private static IllegalStateException noFile(IOException e) {
    return new IllegalStateException("rows in memory are not written", e);
  }

  /** Returns the names and units of the inputs, in file order. */
  public List<Variable> inputs() {
    return further.stream()
        .filter(state -> state.role() == FurtherState.Role.INPUT)
        .map(state -> new Variable(state.name(), state.unit()))
        .toList();
  }

  /**
   * Sets an input for the steps from here on.
   *
   * @param value in the unit of the input
   * @throws IllegalArgumentException S-195 if there is none of that name, or the value is not
   *     finite
   */
  public void input(String name, double value) {
    for (int i = 0; i < further.size(); i++) {
      if (further.get(i).name().equals(name) && further.get(i).role() == FurtherState.Role.INPUT) {
        run.set(furtherOffset + i, finite("input \"" + name + "\"", value));
        return;
      }
    }
    List<String> names = inputs().stream().map(Variable::name).toList();
    throw refused(
        "there is no input \""
            + name
            + "\"; "
            + (names.isEmpty() ? "the model has none" : "there are " + String.join(", ", names)));
  }

  private static double finite(String what, double value) {
    if (!Double.isFinite(value)) {
      throw refused(what + " is set to " + value + "; it must be finite");
    }
    return value;
  }

  private static IllegalArgumentException refused(String why) {
    return new IllegalArgumentException(MessageCode.RUN_CANNOT_BE_STEPPED + " " + why);
  }

  /**
   * Advances by one step.
   *
   * @throws IllegalStateException if the run has ended
   * @throws RunFailedException if it cannot go on; says why
   */
  public void step() {
    try {
      run.step();
    } catch (IOException e) {
      throw noFile(e);
    }
    requireNoFailure();
  }

  private void requireNoFailure() {
    if (run.ended().isPresent() && run.ended().get() instanceof Outcome.Failed failed) {
      throw new RunFailedException(failed.failure(), run.report(), Optional.empty());
    }
  }

  /** Returns whether the end time is not reached yet. */
  public boolean isRunning() {
    return run.ended().isEmpty();
  }

  /** Returns the time reached, s. */
  public double time() {
    return run.time();
  }

  /** Returns the columns in order, the first is time. */
  public List<Variable> columns() {
    return row.columns;
  }

  /** Returns the values of all columns at the time reached, before inputs are set there. */
  public double[] row() {
    return row.values.clone();
  }

  /**
   * Returns the value of a column at the time reached; those of a restored run come with its first
   * step.
   *
   * @throws IllegalArgumentException S-195 if there is none of that name
   */
  public double value(String column) {
    for (int i = 0; i < row.columns.size(); i++) {
      if (row.columns.get(i).name().equals(column)) {
        return row.values[i];
      }
    }
    List<String> names = new ArrayList<>(row.columns.stream().map(Variable::name).toList());
    throw refused("there is no column \"" + column + "\"; there are " + String.join(", ", names));
  }

  /** Returns the state [q; v; s] from which the next step begins, SI, states in their own units. */
  public double[] state() {
    run.state(y);
    return y.clone();
  }

  /**
   * Sets the state from which the next step begins; loops are closed from there.
   *
   * @param state as {@link #state} returns it; not modified
   * @throws IllegalArgumentException S-195 if its length is wrong or a number is not finite
   */
  public void state(double[] state) {
    if (state.length != y.length) {
      throw refused("a state has " + y.length + " numbers, not " + state.length);
    }
    Arrays.stream(state).forEach(number -> finite("a state", number));
    for (int i = 0; i < state.length; i++) {
      run.set(i, state[i]);
    }
  }

  /** Returns what has happened so far. */
  public RunReport report() {
    return run.report();
  }

  /** Returns the run between two steps as bytes; {@link MechModel#stepped(double, byte[])}. */
  public byte[] save() {
    return run.save();
  }
}

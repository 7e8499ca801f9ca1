package org.mechservice.solver.api.program;

import java.io.IOException;
import java.nio.DoubleBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.StateVariable;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.StepwiseRun;
import org.mechservice.solver.catalogue.MessageCode;

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
  private final StepwiseRun run;
  private final List<Variable> further;
  private final Set<String> inputs;
  private final int furtherOffset;

  /** Which of the further states are inputs. */
  private final int[] inputIndex;

  private final double[] y;

  /** The run at its start. */
  private byte[] start = {};

  /**
   * The run behind it, and what its state is made of.
   *
   * @param coordinates the number of positions and velocities, with which a state begins
   * @param furtherStates those that follow them
   * @param inputs names of the further states that are inputs
   */
  public record Source(
      Start start, int coordinates, List<Variable> furtherStates, Set<String> inputs) {
    public Source {
      furtherStates = List.copyOf(furtherStates);
      inputs = Set.copyOf(inputs);
    }

    /**
     * Returns a run in this process.
     *
     * @param model one that no other run uses, built for inputs from outside
     * @param hash identifies the model in saved runs
     */
    public static Source of(
        Solver solver, Model model, RunRequest request, String hash, Set<String> inputs) {
      ModelDescription description = model.description();
      return new Source(
          rows -> solver.stepped(model, request, rows, hash),
          description.positionCount() + description.velocityCount(),
          description.furtherStates().stream().map(StateVariable::variable).toList(),
          inputs);
    }
  }

  /** Makes the run. */
  public interface Start {
    /**
     * Returns a run that has not begun.
     *
     * @param rows takes its rows
     */
    StepwiseRun with(ResultSink rows) throws IOException;
  }

  private SteppedModel(LastRow row, StepwiseRun run, Source source) {
    this.row = row;
    this.run = run;
    further = source.furtherStates();
    inputs = source.inputs();
    furtherOffset = source.coordinates();
    inputIndex =
        IntStream.range(0, further.size())
            .filter(i -> this.inputs.contains(further.get(i).name()))
            .toArray();
    y = new double[furtherOffset + further.size()];
  }

  /**
   * Begins a run.
   *
   * @param solver takes the steps
   * @param model one that no other run uses, built for inputs from outside
   * @param request its settings; the rows are its steps
   * @param hash identifies the model in saved runs
   * @param inputs those of its further states that are inputs
   * @throws IllegalArgumentException if the request does not fit the model, or the simulation is
   *     not integrated in time (S-195)
   * @throws RunFailedException if the run cannot begin
   */
  public static SteppedModel begin(
      Solver solver, Model model, RunRequest request, String hash, Set<String> inputs) {
    return begin(Source.of(solver, model, request, hash, inputs));
  }

  /**
   * Begins a run that is somewhere else.
   *
   * @throws IllegalArgumentException if its request does not fit the model
   * @throws RunFailedException if the run cannot begin
   */
  public static SteppedModel begin(Source source) {
    SteppedModel stepped = of(source);
    try {
      stepped.run.begin();
    } catch (IOException e) {
      throw noFile(e);
    }
    stepped.requireNoFailure();
    if (stepped.isRunning()) {
      stepped.start = stepped.run.save();
    }
    return stepped;
  }

  /**
   * Goes on with a saved run; parameters as of {@link #begin}.
   *
   * @param saved from {@link #save}
   * @throws IllegalArgumentException S-071 if the bytes do not belong to such a run of this model
   */
  public static SteppedModel restored(
      Solver solver,
      Model model,
      RunRequest request,
      String hash,
      Set<String> inputs,
      byte[] saved) {
    return restored(Source.of(solver, model, request, hash, inputs), saved);
  }

  /** Goes on with a saved run that is somewhere else. */
  public static SteppedModel restored(Source source, byte[] saved) {
    SteppedModel stepped = of(source);
    stepped.start = saved.clone();
    stepped.reset();
    return stepped;
  }

  private static SteppedModel of(Source source) {
    LastRow row = new LastRow();
    try {
      return new SteppedModel(row, source.start().with(row), source);
    } catch (IOException e) {
      throw noFile(e);
    }
  }

  private static IllegalStateException noFile(IOException e) {
    return new IllegalStateException("rows in memory are not written", e);
  }

  /** Returns the names and units of the inputs, in file order. */
  public List<Variable> inputs() {
    return further.stream().filter(state -> inputs.contains(state.name())).toList();
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
      if (further.get(i).name().equals(name) && inputs.contains(name)) {
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

  /**
   * Sets all inputs and advances by one step: one call instead of many, for programs in other
   * languages, which share the memory of the buffers.
   *
   * @param inputs a value for each of {@link #inputs}, in their order and units; not modified
   * @param row receives the values of all {@link #columns} at the time reached; overwritten
   * @return whether the end time is not reached yet
   * @throws IllegalStateException if the run has ended
   * @throws IllegalArgumentException S-195 if an input is not finite
   * @throws RunFailedException if it cannot go on; says why
   */
  public boolean step(DoubleBuffer inputs, DoubleBuffer row) {
    for (int k = 0; k < inputIndex.length; k++) {
      double value = inputs.get(k);
      if (!Double.isFinite(value)) {
        throw refused(
            "input \""
                + further.get(inputIndex[k]).name()
                + "\" is set to "
                + value
                + "; it must be finite");
      }
      run.set(furtherOffset + inputIndex[k], value);
    }
    step();
    row.put(0, this.row.values);
    return isRunning();
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

  /** Returns the present value of each input, in the order of {@link #inputs}. */
  public double[] inputValues() {
    run.state(y);
    return Arrays.stream(inputIndex).mapToDouble(i -> y[furtherOffset + i]).toArray();
  }

  /** Returns the values of all columns at the time reached, before inputs are set there. */
  public double[] row() {
    return row.values.clone();
  }

  /**
   * Returns the value of a column at the time reached.
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
   * Sets the state from which the next step begins; {@link #row} and {@link #value} are those of it
   * at once. Coordinates that are others than before are held, and the loops make the rest follow.
   *
   * @param state as {@link #state} returns it; not modified
   * @throws IllegalArgumentException S-195 if its length is wrong, a number is not finite, or the
   *     loops do not close so; the state is that before then
   * @throws IllegalStateException if the run has ended
   * @throws RunFailedException if the run cannot go on from there; says why
   */
  public void state(double[] state) {
    if (state.length != y.length) {
      throw refused("a state has " + y.length + " numbers, not " + state.length);
    }
    Arrays.stream(state).forEach(number -> finite("a state", number));
    for (int i = 0; i < state.length; i++) {
      run.set(i, state[i]);
    }
    settle();
  }

  /**
   * Goes back to where this run began: time, state, inputs and all that a step depends on.
   *
   * @throws IllegalStateException if a worker of the run is lost, or the run began at its end
   */
  public void reset() {
    if (start.length == 0) {
      throw new IllegalStateException("the run begins at its end, so it cannot begin again");
    }
    run.restore(start);
    settle();
  }

  private void settle() {
    try {
      run.settle();
    } catch (IOException e) {
      throw noFile(e);
    }
    requireNoFailure();
  }

  /**
   * Ends a step that another thread takes, at the last step of the integrator, and with it the run.
   * Nothing happens if there is none. The only method for other threads.
   */
  public void interrupt() {
    run.interrupt();
  }

  /** Returns what has happened so far. */
  public RunReport report() {
    return run.report();
  }

  /** Returns the run between two steps as bytes; the model's {@code stepped} takes them. */
  public byte[] save() {
    return run.save();
  }
}

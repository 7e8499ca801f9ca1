package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.StateVariable;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.text.WellFormedText;

/**
 * A worker's description of its model.
 *
 * @param settings the settings of its file
 * @param parameters those that may be changed before a run
 * @param coordinates the number of its positions and velocities
 * @param furtherStates those that follow them in its state
 */
public record WorkerDescription(
    RunSettings settings,
    List<TunableParameter> parameters,
    int coordinates,
    List<Variable> furtherStates) {
  private static final int MOST_PARAMETERS = 100_000;
  private static final int MOST_STATES = 10_000_000;

  public WorkerDescription {
    parameters = List.copyOf(parameters);
    furtherStates = List.copyOf(furtherStates);
  }

  static WorkerDescription of(ModelSource source) {
    ModelDescription model = source.model().description();
    return new WorkerDescription(
        model.defaults(),
        source.parameters(),
        model.positionCount() + model.velocityCount(),
        model.furtherStates().stream().map(StateVariable::variable).toList());
  }

  void write(DataOutputStream out) throws IOException {
    WorkerOrder.writeSettings(out, settings);
    out.writeInt(parameters.size());
    for (TunableParameter parameter : parameters) {
      out.writeUTF(parameter.name());
      out.writeUTF(parameter.unit());
      out.writeDouble(parameter.value());
    }
    out.writeInt(coordinates);
    out.writeInt(furtherStates.size());
    for (Variable state : furtherStates) {
      out.writeUTF(state.name());
      out.writeUTF(state.unit());
    }
  }

  /** Reads what a worker says, which may be anything. */
  static WorkerDescription read(DataInputStream in) throws IOException {
    try {
      RunSettings settings = WorkerOrder.readSettings(in);
      int count = in.readInt();
      if (count < 0 || count > MOST_PARAMETERS) {
        throw new StreamCorruptedException(count + " parameters");
      }
      List<TunableParameter> parameters = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        String name = WellFormedText.of(in.readUTF());
        String unit = WellFormedText.of(in.readUTF());
        parameters.add(new TunableParameter(name, unit, in.readDouble()));
      }
      int coordinates = in.readInt();
      int further = in.readInt();
      if (coordinates < 0 || coordinates > MOST_STATES || further < 0 || further > MOST_STATES) {
        throw new StreamCorruptedException(coordinates + " and " + further + " states");
      }
      List<Variable> states = new ArrayList<>();
      for (int i = 0; i < further; i++) {
        String name = WellFormedText.of(in.readUTF());
        states.add(new Variable(name, WellFormedText.of(in.readUTF())));
      }
      return new WorkerDescription(settings, parameters, coordinates, states);
    } catch (IllegalArgumentException e) {
      throw new StreamCorruptedException("settings that are none: " + e.getMessage());
    }
  }
}

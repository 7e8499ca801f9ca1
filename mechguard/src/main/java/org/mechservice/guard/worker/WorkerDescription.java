package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.StreamCorruptedException;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.TunableParameter;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.text.WellFormedText;

/**
 * What a program must know of a model before a worker runs it.
 *
 * @param settings the settings of its file
 * @param parameters those that may be changed before a run
 */
public record WorkerDescription(RunSettings settings, List<TunableParameter> parameters) {
  private static final int MOST_PARAMETERS = 100_000;

  public WorkerDescription {
    parameters = List.copyOf(parameters);
  }

  static WorkerDescription of(ModelSource source) {
    return new WorkerDescription(source.model().description().defaults(), source.parameters());
  }

  void write(DataOutputStream out) throws IOException {
    WorkerOrder.writeSettings(out, settings);
    out.writeInt(parameters.size());
    for (TunableParameter parameter : parameters) {
      out.writeUTF(parameter.name());
      out.writeUTF(parameter.unit());
      out.writeDouble(parameter.value());
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
      return new WorkerDescription(settings, parameters);
    } catch (IllegalArgumentException e) {
      throw new StreamCorruptedException("settings that are none: " + e.getMessage());
    }
  }
}

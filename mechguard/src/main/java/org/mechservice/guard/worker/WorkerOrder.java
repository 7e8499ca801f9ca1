package org.mechservice.guard.worker;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The run that a worker computes.
 *
 * @param model what runs
 * @param values numbers of tunable parameters, by name
 * @param request what is wanted of the run
 */
public record WorkerOrder(WorkerModel model, Map<String, String> values, RunRequest request) {

  /** Writes all but the model, which the worker has before. */
  void write(DataOutputStream out) throws IOException {
    out.writeInt(values.size());
    for (Map.Entry<String, String> value : values.entrySet()) {
      out.writeUTF(value.getKey());
      out.writeUTF(value.getValue());
    }
    writeSettings(out, request.settings());
    out.writeInt(request.columns().size());
    for (ColumnGroup group : request.columns()) {
      out.writeUTF(group.name());
    }
    out.writeBoolean(request.strict());
    out.writeDouble(request.maxDrift().orElse(Double.NaN));
    out.writeInt(request.silenced().size());
    for (MessageCode warning : request.silenced()) {
      out.writeUTF(warning.code());
    }
  }

  static void writeSettings(DataOutputStream out, RunSettings settings) throws IOException {
    out.writeDouble(settings.tStart());
    out.writeDouble(settings.tEnd());
    out.writeDouble(settings.tStep());
    out.writeUTF(settings.integrator());
    out.writeDouble(settings.relativeTolerance());
    out.writeDouble(settings.absoluteTolerance());
    out.writeDouble(settings.maxStep());
    out.writeDouble(settings.initialStep());
    out.writeInt(settings.maxOrder());
    out.writeDouble(settings.angleTolerance());
    out.writeDouble(settings.velocityTolerance());
    out.writeDouble(settings.angularVelocityTolerance());
    out.writeUTF(settings.accuracy().name());
  }

  static WorkerOrder read(WorkerModel model, DataInputStream in) throws IOException {
    Map<String, String> values = new LinkedHashMap<>();
    for (int left = in.readInt(); left > 0; left--) {
      String name = in.readUTF();
      values.put(name, in.readUTF());
    }
    RunSettings settings = readSettings(in);
    Set<ColumnGroup> columns = EnumSet.noneOf(ColumnGroup.class);
    for (int left = in.readInt(); left > 0; left--) {
      columns.add(ColumnGroup.valueOf(in.readUTF()));
    }
    return new WorkerOrder(
        model,
        values,
        new RunRequest(
            settings, columns, in.readBoolean(), number(in.readDouble()), readWarnings(in)));
  }

  private static Set<MessageCode> readWarnings(DataInputStream in) throws IOException {
    Set<MessageCode> warnings = EnumSet.noneOf(MessageCode.class);
    for (int left = in.readInt(); left > 0; left--) {
      warnings.add(MessageCode.of(in.readUTF()));
    }
    return warnings;
  }

  /** Reads NaN as none. */
  private static OptionalDouble number(double written) {
    return Double.isNaN(written) ? OptionalDouble.empty() : OptionalDouble.of(written);
  }

  static RunSettings readSettings(DataInputStream in) throws IOException {
    return new RunSettings(
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readUTF(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        in.readInt(),
        in.readDouble(),
        in.readDouble(),
        in.readDouble(),
        Accuracy.valueOf(in.readUTF()));
  }
}

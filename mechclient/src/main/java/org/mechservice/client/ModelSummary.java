package org.mechservice.client;

import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.RemoteCalls;
import org.mechservice.idl.ModelInfo;
import org.mechservice.solver.api.result.Variable;

/**
 * The server's summary of a loaded model.
 *
 * @param name the model's name in its file
 * @param sha256 hash of the file
 * @param settings the file's settings, in the keys of options
 * @param formulation formulation that {@code auto} chooses
 * @param formulationReason reason of the choice
 * @param states names and units of the states, positions first
 * @param warnings warnings of the reader
 */
public record ModelSummary(
    String name,
    String sha256,
    Map<String, String> settings,
    String formulation,
    String formulationReason,
    List<Variable> states,
    List<ModelMessage> warnings) {
  public ModelSummary {
    settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
    states = List.copyOf(states);
    warnings = List.copyOf(warnings);
  }

  static ModelSummary of(ModelInfo info) {
    return new ModelSummary(
        info.modelName,
        info.sha256,
        RemoteCalls.textsOf(info.settings),
        info.formulation,
        info.formulationReason,
        Arrays.stream(info.states).map(state -> new Variable(state.name, state.unit)).toList(),
        ModelMessage.listOf(info.warnings));
  }
}

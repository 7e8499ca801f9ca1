package org.mechservice.view.player;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.Base64;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.api.result.Variable;

/**
 * A model that a page simulates itself.
 *
 * @param module WebAssembly module with the functions of {@code mech_wasm.c}, in Base64
 * @param columns of its rows: time, states, outputs
 * @param parameters parameters with a slider
 * @param starts start values with a slider
 * @param events names of its events, by number
 * @param from start time, s
 * @param to end time, s
 * @param step distance of the rows, s
 * @param relativeTolerance of the integrator
 */
public record LiveModel(
    String module,
    List<Variable> columns,
    List<Slider> parameters,
    List<Slider> starts,
    List<String> events,
    double from,
    double to,
    double step,
    double relativeTolerance) {
  private static final Set<String> ENERGIES = Set.of("energy.kinetic", "energy.potential");

  public LiveModel {
    columns = List.copyOf(columns);
    parameters = List.copyOf(parameters);
    starts = List.copyOf(starts);
    events = List.copyOf(events);
  }

  /** Returns a module's bytes as the page holds them. */
  public static String text(byte[] module) {
    return Base64.getEncoder().encodeToString(module);
  }

  /**
   * A number with a slider.
   *
   * @param name its name
   * @param unit SI unit
   * @param index among the parameters, or among the states
   * @param value in the file
   * @param least smallest value of the slider
   * @param most largest value of the slider
   */
  public record Slider(
      String name, String unit, int index, double value, double least, double most) {}

  JsonObject json() {
    JsonObject live = new JsonObject();
    live.addProperty("module", module);
    live.addProperty("from", from);
    live.addProperty("to", to);
    live.addProperty("step", step);
    live.addProperty("rtol", relativeTolerance);
    live.add("parameters", json(parameters));
    live.add("starts", json(starts));
    JsonArray names = new JsonArray();
    events.forEach(names::add);
    live.add("events", names);
    JsonArray energies = new JsonArray();
    for (int i = 0; i < columns.size(); i++) {
      if (ENERGIES.contains(columns.get(i).name())) {
        energies.add(i);
      }
    }
    live.add("energies", energies);
    return live;
  }

  private static JsonArray json(List<Slider> sliders) {
    JsonArray array = new JsonArray();
    for (Slider slider : sliders) {
      JsonObject one = new JsonObject();
      one.addProperty("name", slider.name());
      one.addProperty("unit", slider.unit());
      one.addProperty("index", slider.index());
      one.addProperty("value", slider.value());
      one.addProperty("least", slider.least());
      one.addProperty("most", slider.most());
      array.add(one);
    }
    return array;
  }
}

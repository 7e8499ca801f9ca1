package org.mechservice.sim.fmu;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/** Models written in C by hand. */
final class CModels {
  private CModels() {}

  /** A ball that bounces: an event with a jump, a parameter, an output that is a state. */
  static FmuModel ball() {
    return model(
        "ball",
        List.of(new FmuVariable("z.x", "m", "Height", 1), new FmuVariable("z.v", "m/s", "", 0)),
        List.of(new FmuVariable("e", "", "Restitution & \"bounce\" < 1", 0.7)),
        List.of(),
        List.of(new FmuVariable("z.x", "m", "", 0), new FmuVariable("E", "J/kg", "Energy", 0)),
        List.of("hit"));
  }

  /** A point on a circle in redundant coordinates, with an input. */
  static FmuModel circle() {
    return model(
        "circle",
        List.of(
            new FmuVariable("x", "m", "", 1),
            new FmuVariable("y", "m", "", 0),
            new FmuVariable("vx", "m/s", "", 0),
            new FmuVariable("vy", "m/s", "", 0)),
        List.of(
            new FmuVariable("gravity", "m/s^2", "", 9.81), new FmuVariable("pull", "1/s", "", 0)),
        List.of(new FmuVariable("force", "N", "", 0)),
        List.of(new FmuVariable("E", "J/kg", "", 0), new FmuVariable("drift", "m", "", 0)),
        List.of());
  }

  /** The same model, integrated in Co-Simulation by the method for stiff models. */
  static FmuModel stiff(FmuModel model) {
    FmuModel.Experiment run = model.experiment();
    return new FmuModel(
        model.name(),
        model.identifier(),
        model.states(),
        model.parameters(),
        model.inputs(),
        model.outputs(),
        model.events(),
        new FmuModel.Experiment(
            run.start(),
            run.end(),
            run.step(),
            run.relativeTolerance(),
            run.absoluteTolerance(),
            run.maxStep(),
            true),
        model.sources());
  }

  private static FmuModel model(
      String name,
      List<FmuVariable> states,
      List<FmuVariable> parameters,
      List<FmuVariable> inputs,
      List<FmuVariable> outputs,
      List<String> events) {
    SortedMap<String, String> sources = new TreeMap<>();
    for (String file : List.of(name + ".c", name + ".h")) {
      sources.put(file, resource(file));
    }
    FmuModel.Experiment run =
        new FmuModel.Experiment(0, 2, 0.01, 1e-8, 1e-10, Double.POSITIVE_INFINITY, false);
    return new FmuModel(name, name, states, parameters, inputs, outputs, events, run, sources);
  }

  /** Returns the text of a file beside this class. */
  static String resource(String name) {
    try (InputStream in = CModels.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("no file " + name);
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}

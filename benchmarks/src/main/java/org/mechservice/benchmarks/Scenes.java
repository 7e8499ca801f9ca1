package org.mechservice.benchmarks;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Set;
import org.mechservice.mechml.MechmlException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.MechmlReader;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.sim.build.BuildOptions;
import org.mechservice.sim.build.ModelFactory;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.RunSettings;

/** The mechanisms whose equations are measured. */
final class Scenes {
  /** What a model carries; nothing here depends on it. */
  static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "ode113", 1e-6, 1e-6);

  private Scenes() {}

  /** Returns {@code pendulum}, {@code driver}, or a chain such as {@code chain200}. */
  static MechmlModel named(String name) {
    return switch (name) {
      case "pendulum" -> read("pendulum/pendulum.xml");
      case "driver" -> read("driver/driver-free-c0.xml");
      default ->
          new MechmlModel(
              LinkChain.of(Integer.parseInt(name.substring("chain".length()))),
              new SimulationSettings(SETTINGS, "auto"),
              List.of());
    };
  }

  private static MechmlModel read(String resource) {
    try (InputStream in = Scenes.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IllegalStateException(resource + " is missing");
      }
      return MechmlReader.read(resource, in.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (MechmlException e) {
      throw new IllegalStateException(resource, e);
    }
  }

  /** Returns the code generated for a scene, at work. */
  static Model generated(MechmlModel scene) {
    BuildOptions options = new BuildOptions("DTR", Set.of(), SETTINGS);
    return ModelFactory.compile(scene, options, ModelFactory.generate(scene, options))
        .newInstance();
  }
}

package org.mechservice.benchmarks;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.dynamics.LinearisedResidualModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Mechanism;

/** The mechanisms whose equations are measured. */
public final class MeasuredScenes {
  /** Settings that a model carries; no measurement here depends on them. */
  public static final RunSettings SETTINGS = new RunSettings(0, 1, 0.1, "ode113", 1e-6, 1e-6);

  private MeasuredScenes() {}

  /**
   * Returns {@code pendulum}, {@code driver}, {@code fourbar}, a model that is compared with other
   * programs ({@code pend5}, {@code pend5s}, {@code driver41}, {@code spatial200}), or a chain such
   * as {@code chain200}.
   */
  public static MechmlModel named(String name) {
    return switch (name) {
      case "pendulum" -> read("pendulum/pendulum.xml");
      case "driver" -> read("driver/driver-free-c0.xml");
      case "fourbar" -> read("extremes/fourbar_redundant.xml");
      case "pend5", "pend5s", "driver41" -> table(name, name);
      case "spatial200" -> table("chain200", name);
      default ->
          new MechmlModel(
              LinkChain.of(Integer.parseInt(name.substring("chain".length()))),
              new SimulationSettings(SETTINGS, "auto"),
              List.of());
    };
  }

  private static MechmlModel table(String file, String name) {
    return new MechmlModel(
        TimingTable.read(new String(bytes(file + ".csv"), StandardCharsets.UTF_8), name),
        new SimulationSettings(SETTINGS, "auto"),
        List.of());
  }

  private static MechmlModel read(String resource) {
    try {
      return MechmlReader.read(resource, bytes(resource));
    } catch (MechmlException e) {
      throw new IllegalStateException(resource, e);
    }
  }

  private static byte[] bytes(String resource) {
    try (InputStream in = MeasuredScenes.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IllegalStateException(resource + " is missing");
      }
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the code generated for a scene in a formulation, at work. */
  public static Model generated(MechmlModel scene, String formulation) {
    BuildOptions options = options(formulation);
    return ModelFactory.compile(scene, options, ModelFactory.generate(scene, options))
        .newInstance();
  }

  /** Returns the equations of RR-JF driven by data. */
  static LinearisedResidualModel linearised(Mechanism mechanism) {
    return new LinearisedResidualModel(
        mechanism, SETTINGS, UserForceSource.NONE, LinearisedResidualModel.Mode.FULL);
  }

  /** Returns the formulation in which the accelerations of a scene are measured beside others. */
  public static String forwardDynamics(MechmlModel scene) {
    return scene.mechanism().closures().isEmpty() ? "DTR" : "DSR";
  }

  /** Returns how a model is built in a formulation, with an integrator that goes with it. */
  public static BuildOptions options(String formulation) {
    boolean explicit = formulation.startsWith("D");
    RunSettings settings = explicit ? SETTINGS : new RunSettings(0, 1, 0.1, "ode15sR", 1e-6, 1e-6);
    return new BuildOptions(formulation, Set.of(), settings);
  }
}

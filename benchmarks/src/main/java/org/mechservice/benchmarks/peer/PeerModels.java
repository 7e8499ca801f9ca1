package org.mechservice.benchmarks.peer;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.mechservice.benchmarks.MeasuredScenes;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.GeneratedModel;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * Writes models for other programs: as MuJoCo reads them, as C, and the state they are timed at.
 */
public final class PeerModels {
  private PeerModels() {}

  /**
   * Writes {@code NAME.state}, the last acceleration in it, {@code NAME.value}, of models without
   * loops {@code NAME.c} and, if they have no forces either, {@code NAME.xml} and the state in its
   * order, {@code NAME.order}.
   *
   * @param args folder, names of models
   */
  public static void main(String[] args) throws IOException {
    Path folder = Files.createDirectories(Path.of(args[0]));
    for (int i = 1; i < args.length; i++) {
      write(folder, args[i]);
    }
  }

  private static void write(Path folder, String name) throws IOException {
    MechmlModel model = MeasuredScenes.named(name);
    Mechanism mechanism = model.mechanism();
    // C gets the code that is written out; Java the form that the generator chooses.
    BuildOptions options =
        new BuildOptions(MeasuredScenes.forwardDynamics(model), Set.of(), MeasuredScenes.SETTINGS)
            .in(CodeForm.STRAIGHT);
    GeneratedModel generated = ModelFactory.generate(model, options);
    double[] y = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(y);
    double[] yDot = new double[y.length];
    ExplicitModel explicit =
        (ExplicitModel) ModelFactory.compile(model, options, generated).newInstance();
    explicit.derivative(0, y, yDot);
    StringBuilder state = new StringBuilder();
    for (double value : y) {
      state.append(value).append('\n');
    }
    Files.writeString(folder.resolve(name + ".state"), state);
    Files.writeString(folder.resolve(name + ".value"), yDot[y.length - 1] + "\n");
    if (!mechanism.closures().isEmpty()) {
      return;
    }
    Files.writeString(folder.resolve(name + ".c"), CText.of(generated.source(), y.length));
    if (mechanism.forces().isEmpty()) {
      MujocoText text = new MujocoText(mechanism);
      Files.writeString(folder.resolve(name + ".xml"), text.model());
      Files.writeString(folder.resolve(name + ".order"), text.state(y));
    }
  }
}

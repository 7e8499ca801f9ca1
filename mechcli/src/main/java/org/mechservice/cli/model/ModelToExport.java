package org.mechservice.cli.model;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelColumns;
import org.mechservice.sim.scene.IntegratorSelection;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.text.ModelFiles;

/**
 * A model that is read and generated here, without a server, for what leaves this program.
 *
 * @param model the model of the file
 * @param options how it is generated
 */
record ModelToExport(MechmlModel model, BuildOptions options) {

  /**
   * Reads a model.
   *
   * @param reading simulation and parameters
   * @param method formulation, integrator, closure, columns
   * @throws IOException if the file cannot be read
   * @throws UsageException with the messages of the reader if it is no valid model; if its
   *     simulation is no motion
   */
  static ModelToExport read(Path file, ReadOptions reading, ModelOptions method)
      throws IOException {
    try {
      byte[] content = ModelFiles.inlined(Files.readAllBytes(file), file);
      MechmlModel model = MechmlReader.read(String.valueOf(file.getFileName()), content, reading);
      return new ModelToExport(model, options(file, model, method));
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }

  private static BuildOptions options(Path file, MechmlModel model, ModelOptions method) {
    SimulationSettings asked = method.addTo(model.settings());
    if (!(asked.task() instanceof SimulationTask.Dynamic)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " the simulation of "
              + file
              + " is <"
              + asked.task().element()
              + ">, and only a motion, <dynamic>, can leave as a model: choose another with"
              + " --simulation");
    }
    String closure = method.closure().isEmpty() ? asked.closure() : method.closure();
    IntegratorSelection chosen =
        asked.run().integrator().equals(MethodNames.AUTO)
            ? IntegratorSelection.of(asked.formulation(), model.mechanism(), asked.run())
            : new IntegratorSelection(asked.run().integrator(), Optional.empty());
    return new BuildOptions(
        asked.formulation(),
        closure,
        false,
        CodeForm.AUTO,
        ModelColumns.shown(asked),
        asked.run().withIntegrator(chosen.integrator()),
        chosen.reason());
  }
}

package org.mechservice.cli.model;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.SimulationTask;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.emit.c.CModel;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.sim.fmu.FmuModel;
import org.mechservice.sim.fmu.WebAssemblyModule;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelColumns;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.IntegratorSelection;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.text.ModelFiles;

/**
 * A model that is read and generated here, without a server, for what leaves this program.
 *
 * @param model the model of the file
 * @param options how it is generated
 */
public record ModelToExport(MechmlModel model, BuildOptions options) {

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
    MechmlModel model = read(file, reading);
    return new ModelToExport(
        model, options(file, model, method.addTo(model.settings()), method.closure()));
  }

  /**
   * Reads a model, to be exported with some groups of columns and as its file says else.
   *
   * @throws IOException if the file cannot be read
   * @throws UsageException as above
   */
  public static ModelToExport read(Path file, ReadOptions reading, Set<ColumnGroup> columns)
      throws IOException {
    MechmlModel model = read(file, reading);
    SimulationSettings settings =
        model.settings().withColumns(columns.stream().map(ColumnGroup::label).toList());
    return new ModelToExport(model, options(file, model, settings, ""));
  }

  /**
   * Reads a model that is no file, to be exported as its text says.
   *
   * @param content of a model without parts in other files
   * @throws UsageException as above
   */
  public static ModelToExport read(byte[] content, ReadOptions reading) {
    Path name = Path.of("model.xml");
    MechmlModel model = read(name, content, reading);
    return new ModelToExport(model, options(name, model, model.settings(), ""));
  }

  private static MechmlModel read(Path file, ReadOptions reading) throws IOException {
    return read(file, ModelFiles.inlined(Files.readAllBytes(file), file), reading);
  }

  private static MechmlModel read(Path file, byte[] content, ReadOptions reading) {
    try {
      return MechmlReader.read(String.valueOf(file.getFileName()), content, reading);
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }

  /**
   * Derives the model's code in C.
   *
   * @param asInputs names of forces written as classes whose loads become inputs
   * @throws UsageException if the model cannot be exported, or names a formulation or closure that
   *     there is none of
   */
  public FmuModel inC(Set<String> asInputs) {
    return FmuModel.of(codeInC(asInputs), options.settings());
  }

  /**
   * Derives the model's code in C, whose states are independent coordinates alone.
   *
   * @param asInputs names of forces written as classes whose loads become inputs
   * @param wanted names of positions or joints that are to be states; none to choose them
   * @throws UsageException as {@link #inC}
   * @throws IllegalArgumentException if the model has no such coordinates
   */
  FmuModel inIndependentCoordinates(Set<String> asInputs, List<String> wanted) {
    return FmuModel.inIndependentCoordinates(codeInC(asInputs), options.settings(), wanted);
  }

  /**
   * Derives the model's files in C: header, code, elementary functions and an example.
   *
   * @throws UsageException as {@link #inC}
   */
  Map<String, String> filesInC(Set<String> asInputs) {
    return codeInC(asInputs).files();
  }

  private CModel codeInC(Set<String> asInputs) {
    try {
      // Refuses names of formulations and closures that there are not; C has one formulation.
      FormulationChoice.of(options.formulation(), options.closure(), options.settings(), model);
      return ModelFactory.inC(model, options, asInputs);
    } catch (ModelBuildException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }

  /**
   * Compiles the model to a WebAssembly module.
   *
   * @throws UsageException as {@link #inC}, or if no compiler for WebAssembly is here
   * @throws IOException if the compiler fails
   */
  public byte[] module() throws IOException {
    FmuModel code = inC(Set.of());
    try {
      return WebAssemblyModule.of(code);
    } catch (IllegalArgumentException e) {
      throw new UsageException(MessageCode.OPTION_UNUSABLE + " " + e.getMessage());
    }
  }

  private static BuildOptions options(
      Path file, MechmlModel model, SimulationSettings asked, String givenClosure) {
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
    String closure = givenClosure.isEmpty() ? asked.closure() : givenClosure;
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

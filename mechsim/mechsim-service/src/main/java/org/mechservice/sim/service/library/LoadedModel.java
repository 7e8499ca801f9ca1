package org.mechservice.sim.service.library;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.idl.Channel;
import org.mechservice.idl.ModelInfo;
import org.mechservice.idl.OPT_ABS_TOL;
import org.mechservice.idl.OPT_FORMULATION;
import org.mechservice.idl.OPT_INTEGRATOR;
import org.mechservice.idl.OPT_REL_TOL;
import org.mechservice.idl.OPT_T_END;
import org.mechservice.idl.OPT_T_STEP;
import org.mechservice.idl.RoadmapEntry;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.sim.service.contract.ContractTypes;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.sim.user.UserFile;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.text.Sha256;

/**
 * A model file as a session holds it.
 *
 * @param fileName its name, for messages
 * @param content its bytes; not to be modified
 * @param options the simulation chosen, and the values of parameters
 * @param sha256 SHA-256 of its bytes, lower-case hexadecimal
 * @param text its bytes as UTF-8, for people to look at
 * @param model as read
 * @param userClasses the classes that its forces name
 */
@SuppressWarnings("ArrayRecordComponent") // never compared; bytes as they came
public record LoadedModel(
    String fileName,
    byte[] content,
    ReadOptions options,
    String sha256,
    String text,
    MechmlModel model,
    UserClasses userClasses) {

  /**
   * Reads a model file and the classes that come with it.
   *
   * @param compile whether sources of users may be compiled here
   * @throws MechmlException if it or one of the classes cannot be used
   */
  public static LoadedModel read(
      String fileName, byte[] content, List<UserFile> userFiles, boolean compile)
      throws MechmlException {
    MechmlModel model = MechmlReader.read(fileName, content);
    return new LoadedModel(
        fileName,
        content,
        ReadOptions.NONE,
        Sha256.of(content),
        new String(content, StandardCharsets.UTF_8),
        model,
        UserClasses.admit(model.mechanism(), userFiles, compile));
  }

  /**
   * Reads the file anew with other options.
   *
   * @throws MechmlException if they do not fit it, or it cannot be used with them
   */
  public LoadedModel with(ReadOptions other) throws MechmlException {
    return other.equals(options)
        ? this
        : new LoadedModel(
            fileName,
            content,
            other,
            sha256,
            text,
            MechmlReader.read(fileName, content, other),
            userClasses);
  }

  /** Returns the warnings of the reader and of the scene. */
  public List<Diagnostic> warnings() {
    return ModelWarnings.of(model);
  }

  /** Returns name, settings, formulation and states, in the type of the contract. */
  public ModelInfo info() {
    FormulationChoice choice = formulation();
    return new ModelInfo(
        model.mechanism().name(),
        sha256,
        ContractTypes.nameValues(asOptions(model.settings())),
        choice.formulation(),
        choice.reason(),
        states(),
        ContractTypes.diagnostics(model.warnings()));
  }

  private FormulationChoice formulation() {
    SimulationSettings asked = model.settings();
    try {
      return FormulationChoice.of(asked.formulation(), asked.closure(), asked.run(), model);
    } catch (ModelBuildException e) {
      return new FormulationChoice(
          asked.formulation(), asked.closure(), String.valueOf(e.getMessage()));
    }
  }

  private static Map<String, String> asOptions(SimulationSettings settings) {
    RunSettings run = settings.run();
    Map<String, String> map = new LinkedHashMap<>();
    map.put(OPT_FORMULATION.value, settings.formulation());
    map.put(OPT_INTEGRATOR.value, run.integrator());
    map.put(OPT_REL_TOL.value, Double.toString(run.relativeTolerance()));
    map.put(OPT_ABS_TOL.value, Double.toString(run.absoluteTolerance()));
    if (run.accuracy() != Accuracy.STANDARD) {
      map.put(Accuracy.OPTION, run.accuracy().label());
    }
    map.put(OPT_T_END.value, Double.toString(run.tEnd()));
    map.put(OPT_T_STEP.value, Double.toString(run.tStep()));
    return map;
  }

  private Channel[] states() {
    Mechanism mechanism = model.mechanism();
    List<JointVariables> joints =
        mechanism.joints().stream()
            .map(joint -> new JointVariables(joint.name(), joint.type()))
            .toList();
    RunSettings settings = model.settings().run();
    return ContractTypes.channels(
        new ModelDescription(mechanism.name(), "", joints, mechanism.stateVariables(), settings)
            .states());
  }

  /** Returns the place of each joint in the state. */
  public RoadmapEntry[] roadmap() {
    return SceneAnalysis.of(model.mechanism()).roadmap().stream()
        .map(
            joint ->
                new RoadmapEntry(
                    joint.joint(),
                    joint.type().name(),
                    joint.axis(),
                    joint.positionUnit(),
                    joint.position(),
                    joint.velocity()))
        .toArray(RoadmapEntry[]::new);
  }
}

package org.mechservice.sim.service;

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
import org.mechservice.mechml.SimulationSettings;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.sim.scene.SceneAnalysis;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.mechanism.Mechanism;

/** What can be said of a loaded model before it is built, in the types of the contract. */
final class ModelFacts {
  private ModelFacts() {}

  /** Returns name, settings, formulation and states. */
  static ModelInfo info(LoadedModel loaded) {
    FormulationChoice choice = formulation(loaded);
    return new ModelInfo(
        loaded.model().mechanism().name(),
        loaded.sha256(),
        Wire.nameValues(ofFile(loaded.model().settings())),
        choice.formulation(),
        choice.reason(),
        states(loaded),
        Wire.diagnostics(loaded.model().warnings()));
  }

  private static FormulationChoice formulation(LoadedModel loaded) {
    SimulationSettings asked = loaded.model().settings();
    try {
      return FormulationChoice.of(
          asked.formulation(), asked.closure(), asked.run(), loaded.model().mechanism());
    } catch (ModelBuildException e) {
      return new FormulationChoice(
          asked.formulation(), asked.closure(), String.valueOf(e.getMessage()));
    }
  }

  private static Map<String, String> ofFile(SimulationSettings settings) {
    RunSettings run = settings.run();
    Map<String, String> map = new LinkedHashMap<>();
    map.put(OPT_FORMULATION.value, settings.formulation());
    map.put(OPT_INTEGRATOR.value, run.integrator());
    map.put(OPT_REL_TOL.value, Double.toString(run.relativeTolerance()));
    map.put(OPT_ABS_TOL.value, Double.toString(run.absoluteTolerance()));
    map.put(OPT_T_END.value, Double.toString(run.tEnd()));
    map.put(OPT_T_STEP.value, Double.toString(run.tStep()));
    return map;
  }

  private static Channel[] states(LoadedModel loaded) {
    Mechanism mechanism = loaded.model().mechanism();
    List<JointVariables> joints =
        mechanism.joints().stream()
            .map(joint -> new JointVariables(joint.name(), joint.type()))
            .toList();
    RunSettings settings = loaded.model().settings().run();
    return Wire.channels(new ModelDescription(mechanism.name(), "", joints, settings).states());
  }

  /** Returns where each joint is in the state. */
  static RoadmapEntry[] roadmap(LoadedModel loaded) {
    return SceneAnalysis.of(loaded.model().mechanism()).roadmap().stream()
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

package org.mechservice.view.model;

import java.util.HashMap;
import java.util.Map;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.document.Element;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneVerdict;

/** Models as scenes for pictures: poses at the start, with closed loops. */
public final class ModelScene {
  private ModelScene() {}

  /**
   * Returns the scene of a model.
   *
   * @param model the model
   * @param file the outermost element of its file, which names the geometry of bodies
   */
  public static SceneDescription of(MechmlModel model, Element file) {
    Map<String, String> geometries = geometries(file);
    Mechanism mechanism = model.mechanism();
    ClosedStart start = model.closedStart(model.settings().run().tStart());
    TreeMotion motion = new TreeMotion(start.tree());
    motion.sweep(start.time(), start.state());
    SceneParts parts = new SceneParts(motion, start.time());
    SceneGears gears = new SceneGears(mechanism, parts);
    gears.find();
    CheckReport check = CheckReport.of(model);
    SceneVerdict verdict =
        new SceneVerdict(
            check.degreesOfFreedom(),
            check.loops().equations(),
            check.loops().redundant(),
            start.isAssembled(),
            check.warnings());
    return new SceneDescription(
        mechanism.name(),
        mechanism.root().name(),
        parts.rootPose(),
        geometries.getOrDefault(mechanism.root().name(), ""),
        SceneParts.solids(model.solids(mechanism.root().name())),
        SceneParts.looks(model.looks(mechanism.root().name())),
        SceneParts.point(mechanism.gravity()),
        parts.bodies(geometries, model),
        parts.joints(),
        parts.constraints(),
        parts.forces(),
        gears.wheels(),
        gears.belts(),
        parts.ropes(model.routes()),
        parts.roads(model.roads()),
        verdict);
  }

  /** Returns the geometry files of the bodies that name one. */
  private static Map<String, String> geometries(Element file) {
    Map<String, String> geometries = new HashMap<>();
    file.children("MBSmodel").stream()
        .flatMap(model -> model.children("Bodies").stream())
        .flatMap(bodies -> bodies.children("body").stream())
        .forEach(
            body ->
                body.attribute("graphSrc")
                    .ifPresent(source -> geometries.put(body.required("name"), source)));
    return geometries;
  }
}

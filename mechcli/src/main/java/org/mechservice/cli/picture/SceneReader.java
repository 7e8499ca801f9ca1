package org.mechservice.cli.picture;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.mechml.robot.RobotImport;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.text.ModelFiles;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneVerdict;
import org.mechservice.view.web.ModelReader;

/** Reads model files as scenes for pictures: poses at the start, with closed loops. */
public final class SceneReader {
  private static final List<String> ROBOTS = List.of(".urdf", ".sdf", ".mjcf");

  private SceneReader() {}

  /**
   * Reads a model file.
   *
   * @param file a MechML file, or a robot if its name ends in {@code .urdf}, {@code .sdf} or {@code
   *     .mjcf}
   * @param options the simulation whose start is shown, and values of parameters
   * @throws IOException if the file cannot be read
   * @throws UsageException with the messages of the reader if it is no valid model; if options are
   *     given for a robot, which has neither simulations nor parameters
   */
  public static SceneDescription read(Path file, ReadOptions options) throws IOException {
    byte[] content = ModelFiles.inlined(Files.readAllBytes(file), file);
    String fileName = String.valueOf(file.getFileName());
    try {
      if (ROBOTS.stream().anyMatch(fileName.toLowerCase(Locale.ROOT)::endsWith)) {
        if (!options.equals(ReadOptions.NONE)) {
          throw new UsageException(
              MessageCode.OPTION_UNUSABLE
                  + " "
                  + file
                  + " is a robot, which has no parameters and simulations to choose");
        }
        RobotImport robot = RobotImport.of(fileName, content);
        return scene(robot.model(), geometries(robot.document().root()));
      }
      MechmlModel model = MechmlReader.read(fileName, content, options);
      return scene(model, geometries(MechmlReader.whole(fileName, content)));
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }

  /**
   * Reads a model that is no file, for the page of {@code mech web}.
   *
   * @param text the model in MechML
   * @param choice the simulation whose start is shown, and values of parameters
   * @throws UsageException with the messages of the reader if it is no valid model
   */
  static ModelReader.ReadModel read(String text, ModelReader.Choice choice) {
    byte[] content = text.getBytes(StandardCharsets.UTF_8);
    String name = "model.xml";
    try {
      MechmlModel model =
          MechmlReader.read(
              name, content, new ReadOptions(choice.simulation(), choice.parameters(), Set.of()));
      return new ModelReader.ReadModel(
          scene(model, geometries(MechmlReader.whole(name, content))),
          model.parameters().stream()
              .map(one -> new ModelReader.Parameter(one.name(), one.unit(), one.value()))
              .toList(),
          model.simulations().stream()
              .map(one -> (one.name() + " <" + one.task().element() + ">").strip())
              .toList());
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }

  /** Returns the geometry files of the bodies that name one. */
  private static Map<String, String> geometries(Element root) {
    Map<String, String> geometries = new HashMap<>();
    root.children("MBSmodel").stream()
        .flatMap(model -> model.children("Bodies").stream())
        .flatMap(bodies -> bodies.children("body").stream())
        .forEach(
            body ->
                body.attribute("graphSrc")
                    .ifPresent(source -> geometries.put(body.required("name"), source)));
    return geometries;
  }

  private static SceneDescription scene(MechmlModel model, Map<String, String> geometries) {
    Mechanism mechanism = model.mechanism();
    ClosedStart start = model.closedStart(model.settings().run().tStart());
    TreeMotion motion = new TreeMotion(start.tree());
    motion.sweep(start.time(), start.state());
    SceneParts parts = new SceneParts(motion, start.time());
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
        SceneParts.point(mechanism.gravity()),
        parts.bodies(geometries),
        parts.joints(),
        parts.constraints(),
        parts.forces(),
        verdict);
  }
}

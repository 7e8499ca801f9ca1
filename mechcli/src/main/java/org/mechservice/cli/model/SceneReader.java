package org.mechservice.cli.model;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.robot.ImportOptions;
import org.mechservice.robot.RobotImport;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ModelFiles;
import org.mechservice.view.model.ModelScene;
import org.mechservice.view.scene.SceneDescription;
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
        RobotImport robot = RobotImport.read(file, ImportOptions.NONE);
        return ModelScene.of(robot.model(), robot.document().root());
      }
      MechmlModel model = MechmlReader.read(fileName, content, options);
      return ModelScene.of(model, MechmlReader.whole(fileName, content));
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }

  /**
   * Returns the groups of columns that a simulation of a model file asks for.
   *
   * @throws IOException if the file cannot be read
   * @throws UsageException with the messages of the reader if it is no valid model
   */
  public static Set<ColumnGroup> columns(Path file, ReadOptions options) throws IOException {
    try {
      byte[] content = ModelFiles.inlined(Files.readAllBytes(file), file);
      List<String> labels =
          MechmlReader.read(String.valueOf(file.getFileName()), content, options)
              .settings()
              .columns();
      return labels.contains("all")
          ? EnumSet.allOf(ColumnGroup.class)
          : labels.isEmpty() ? Set.of() : ColumnGroup.of(String.join(",", labels));
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
  public static ModelReader.ReadModel read(String text, ModelReader.Choice choice) {
    byte[] content = text.getBytes(StandardCharsets.UTF_8);
    String name = "model.xml";
    try {
      MechmlModel model =
          MechmlReader.read(
              name, content, new ReadOptions(choice.simulation(), choice.parameters(), Set.of()));
      return new ModelReader.ReadModel(
          ModelScene.of(model, MechmlReader.whole(name, content)),
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
}

package org.mechservice.robot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.DocumentReader;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.document.Limits;
import org.mechservice.mechml.resolve.ModelResolver;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A robot translated to MechML.
 *
 * @param document the model file
 * @param losses the parts of the robot's file that are not in it, in file order, each with the code
 *     of its {@link LossGrade}
 * @param notes what the import has chosen where the format leaves a choice: M-097
 * @param looks the files of what bodies look like, by the names that the model has for them;
 *     whoever writes the model writes them beside it
 * @param model what the model file says; its places are those of the robot's file
 */
public record RobotImport(
    Document document,
    List<Diagnostic> losses,
    List<Diagnostic> notes,
    Map<String, byte[]> looks,
    MechmlModel model) {
  public RobotImport {
    losses = List.copyOf(losses);
    notes = List.copyOf(notes);
    looks = Map.copyOf(looks);
  }

  /**
   * Translates a robot; its outermost element tells the format. Only the given bytes are read:
   * included files are refused, and masses that come from meshes are losses.
   *
   * @param fileName name for messages
   * @param content bytes of a file in URDF, SDF or MJCF; not modified
   * @throws MechmlException if it is no robot, contradicts itself, or is no mechanism; positions
   *     are those of the robot's file
   */
  public static RobotImport of(String fileName, byte[] content) throws MechmlException {
    return of(fileName, content, RobotFiles.none(), ImportOptions.NONE);
  }

  /**
   * Translates a robot with the files that it names.
   *
   * @param file in URDF, SDF or MJCF
   * @throws IOException if the file cannot be read
   * @throws MechmlException if it is no robot, contradicts itself, names a file that does not
   *     exist, or is no mechanism
   */
  public static RobotImport read(Path file, ImportOptions options)
      throws IOException, MechmlException {
    Path folder = file.toAbsolutePath().normalize().getParent();
    return read(
        file.toString(),
        Files.readAllBytes(file),
        Objects.requireNonNullElse(folder, Path.of("")),
        options);
  }

  /**
   * Translates a robot whose bytes are known, with the files that it names.
   *
   * @param fileName name for messages
   * @param content bytes of the file; not modified
   * @param folder in which the files lie that it names
   * @throws MechmlException as {@link #read(Path, ImportOptions)}
   */
  public static RobotImport read(
      String fileName, byte[] content, Path folder, ImportOptions options) throws MechmlException {
    return of(fileName, content, RobotFiles.in(folder, options.paths()), options);
  }

  private static RobotImport of(
      String fileName, byte[] content, RobotFiles files, ImportOptions options)
      throws MechmlException {
    Diagnostics diagnostics = new Diagnostics(fileName);
    Element robot = DocumentReader.readForeign(content, diagnostics);
    RobotFormat format = format(robot, options, diagnostics);
    ImportLosses losses = new ImportLosses(fileName);
    Robot read =
        switch (format) {
          case URDF -> new UrdfReader(files, diagnostics, losses).read(robot);
          case SDF -> new SdfReader(files, diagnostics, losses).read(robot);
          case MJCF ->
              new MjcfReader(files, options.looks().isPresent(), diagnostics, losses)
                  .read(robot, options.keyframe());
        };
    if (format != RobotFormat.MJCF && options.keyframe().isPresent()) {
      diagnostics.error(
          MessageCode.UNKNOWN_NAME,
          robot.position(),
          "a robot in " + format.title() + " has no keyframes; leave out --keyframe");
    }
    if (read.links().size() > Limits.BODIES) {
      diagnostics.error(
          MessageCode.MODEL_FILE_TOO_LARGE,
          robot.position(),
          Phrase.of("the robot has %d links; %d are allowed", read.links().size(), Limits.BODIES));
    }
    diagnostics.throwIfErrors();
    List<Diagnostic> notes = new ArrayList<>();
    // MuJoCo refuses what no body can have, and so does MechML.
    Robot possible = format == RobotFormat.MJCF ? read : PossibleInertia.of(read, losses);
    Robot rooted = RobotRoot.of(possible, options.floating(), fileName, notes);
    RobotTree tree = RobotTree.of(rooted, diagnostics);
    diagnostics.throwIfErrors();
    RobotLooks looks = new RobotLooks(options.looks(), losses);
    Document document = new MechmlRobot(fileName, rooted, tree, looks).document();
    // The elements keep the positions of the robot's elements, so messages point into the robot's
    // file.
    MechmlModel model = ModelResolver.resolve(document.root(), ReadOptions.NONE, diagnostics);
    return new RobotImport(document, losses.inFileOrder(), notes, looks.files(), model);
  }

  private static RobotFormat format(Element robot, ImportOptions options, Diagnostics diagnostics)
      throws MechmlException {
    Optional<RobotFormat> format = RobotFormat.of(robot);
    if (format.isEmpty() || options.format().filter(asked -> asked != format.get()).isPresent()) {
      diagnostics.error(
          MessageCode.NOT_A_ROBOT,
          robot.position(),
          Phrase.of(
              "the outermost element is <%s>; %s",
              Quoted.plain(robot.name()),
              options
                  .format()
                  .map(asked -> "that of the format asked for is " + asked.outermost())
                  .orElseGet(() -> "that of a robot is one of " + RobotFormat.roots())));
    }
    refuseMacros(robot, diagnostics);
    diagnostics.throwIfErrors();
    return format.orElseThrow();
  }

  private static void refuseMacros(Element element, Diagnostics diagnostics) {
    for (Element child : element.children()) {
      if (child.name().startsWith("xacro:")) {
        diagnostics.error(
            MessageCode.NOT_A_ROBOT,
            child.position(),
            Phrase.of(
                "<%s> is a macro; mech import expands it if the program xacro is installed (pip"
                    + " install xacro)",
                Quoted.plain(child.name())));
        return;
      }
      refuseMacros(child, diagnostics);
    }
  }
}

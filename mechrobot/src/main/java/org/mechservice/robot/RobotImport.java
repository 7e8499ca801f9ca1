package org.mechservice.robot;

import java.util.List;
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
 * @param losses the parts of the robot's file that are not in it, in file order: warnings M-085
 * @param model what the model file says; its places are those of the robot's file
 */
public record RobotImport(Document document, List<Diagnostic> losses, MechmlModel model) {
  public RobotImport {
    losses = List.copyOf(losses);
  }

  /**
   * Translates a robot; its outermost element tells the format. Only the given bytes are read;
   * meshes keep their file names.
   *
   * @param fileName name for messages
   * @param content bytes of a file in URDF, SDF or MJCF; not modified
   * @throws MechmlException if it is no robot, contradicts itself, or is no mechanism; positions
   *     are those of the robot's file
   */
  public static RobotImport of(String fileName, byte[] content) throws MechmlException {
    Diagnostics diagnostics = new Diagnostics(fileName);
    Element robot = DocumentReader.readForeign(content, diagnostics);
    RobotFormat format = format(robot, diagnostics);
    ImportLosses losses = new ImportLosses(fileName);
    Robot read =
        switch (format) {
          case URDF -> new UrdfReader(diagnostics, losses).read(robot);
          case SDF -> new SdfReader(diagnostics, losses).read(robot);
          case MJCF -> new MjcfReader(diagnostics, losses).read(robot);
        };
    if (read.links().size() > Limits.BODIES) {
      diagnostics.error(
          MessageCode.MODEL_FILE_TOO_LARGE,
          robot.position(),
          Phrase.of("the robot has %d links; %d are allowed", read.links().size(), Limits.BODIES));
    }
    diagnostics.throwIfErrors();
    RobotTree tree = RobotTree.of(read, diagnostics);
    diagnostics.throwIfErrors();
    Document document = new MechmlRobot(fileName, read, tree).document();
    // The elements keep the positions of the robot's elements, so messages point into the robot's
    // file.
    MechmlModel model = ModelResolver.resolve(document.root(), ReadOptions.NONE, diagnostics);
    return new RobotImport(document, losses.inFileOrder(), model);
  }

  private static RobotFormat format(Element robot, Diagnostics diagnostics) throws MechmlException {
    Optional<RobotFormat> format = RobotFormat.of(robot);
    if (format.isEmpty()) {
      diagnostics.error(
          MessageCode.NOT_A_ROBOT,
          robot.position(),
          Phrase.of(
              "the outermost element is <%s>; that of a robot is one of %s",
              Quoted.plain(robot.name()), RobotFormat.roots()));
    }
    requireWhole(robot, diagnostics);
    diagnostics.throwIfErrors();
    return format.orElseThrow();
  }

  /** Reports elements that stand for text elsewhere: only the given bytes are read. */
  private static void requireWhole(Element element, Diagnostics diagnostics) {
    for (Element child : element.children()) {
      if (child.name().startsWith("xacro:")) {
        diagnostics.error(
            MessageCode.NOT_A_ROBOT,
            child.position(),
            Phrase.of(
                "<%s> is a macro; convert the file to URDF with xacro first",
                Quoted.plain(child.name())));
        return;
      }
      if (child.name().equals("include")) {
        diagnostics.error(
            MessageCode.NOT_A_ROBOT,
            child.position(),
            "<include> names another file, and only this one is read; write the robot as one file"
                + " first (SDF: gz sdf -p; MJCF: save it from MuJoCo)");
        return;
      }
      requireWhole(child, diagnostics);
    }
  }
}

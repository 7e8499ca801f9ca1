package org.mechservice.mechml.urdf;

import java.util.List;
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
import org.mechservice.mechml.resolve.ModelResolver;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A robot translated to MechML.
 *
 * @param document the model file
 * @param losses the parts of the robot's file that are not in it, in file order: warnings M-085
 * @param model what the model file says; its places are those of the robot's file
 */
public record UrdfImport(Document document, List<Diagnostic> losses, MechmlModel model) {
  private static final String ROBOT = "robot";

  public UrdfImport {
    losses = List.copyOf(losses);
  }

  /**
   * Translates a robot. Only the given bytes are read; meshes keep their file names.
   *
   * @param fileName name for messages
   * @param content bytes of a URDF file; not modified
   * @throws MechmlException if it is no URDF, contradicts itself, or is no mechanism; positions are
   *     those of the URDF file
   */
  public static UrdfImport of(String fileName, byte[] content) throws MechmlException {
    Diagnostics diagnostics = new Diagnostics(fileName);
    Element robot = DocumentReader.readForeign(content, diagnostics);
    requireRobot(robot, diagnostics);
    ImportLosses losses = new ImportLosses(fileName);
    UrdfRobot read = new UrdfReader(diagnostics, losses).read(robot);
    diagnostics.throwIfErrors();
    UrdfTree tree = UrdfTree.of(read, diagnostics);
    diagnostics.throwIfErrors();
    Document document = new MechmlRobot(fileName, read, tree).document();
    // The elements keep the positions of the URDF elements, so messages point into the robot's
    // file.
    MechmlModel model = ModelResolver.resolve(document.root(), ReadOptions.NONE, diagnostics);
    return new UrdfImport(document, losses.inFileOrder(), model);
  }

  private static void requireRobot(Element robot, Diagnostics diagnostics) throws MechmlException {
    if (!robot.name().equals(ROBOT)) {
      diagnostics.error(
          MessageCode.NOT_URDF,
          robot.position(),
          Phrase.of(
              "the outermost element is <%s>; that of a URDF file is <robot>",
              Quoted.plain(robot.name())));
    }
    robot.children().stream()
        .filter(child -> child.name().startsWith("xacro:"))
        .findFirst()
        .ifPresent(
            xacro ->
                diagnostics.error(
                    MessageCode.NOT_URDF,
                    xacro.position(),
                    Phrase.of(
                        "<%s> is a macro; convert the file to URDF with xacro first",
                        Quoted.plain(xacro.name()))));
    diagnostics.throwIfErrors();
  }
}

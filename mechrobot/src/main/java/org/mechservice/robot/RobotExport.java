package org.mechservice.robot;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Comment;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.document.Element;

/**
 * A mechanism translated to URDF or MJCF, which the import reads back as the same mechanism.
 *
 * @param text the file
 * @param losses the parts of the model that are not in it: warnings M-087
 */
public record RobotExport(String text, List<Diagnostic> losses) {
  public RobotExport {
    losses = List.copyOf(losses);
  }

  /**
   * Translates a mechanism to URDF: bodies with their inertia and shapes, joints of types R, P, F
   * and W with their limits, damping and friction, joints C and U as two of them, and coordinates
   * that follow others.
   *
   * @param fileName name of the model file, for messages
   * @param model what the file says
   * @param file its outermost element, which has the shapes
   * @throws MechmlException M-086 for every part without which the mechanism would be another one:
   *     closed loops, constraints, and joints of other types
   */
  public static RobotExport of(String fileName, MechmlModel model, Element file)
      throws MechmlException {
    return of(
        fileName,
        losses -> new UrdfWriter(model, file, new UrdfShapes(model, file, losses), losses).robot());
  }

  /**
   * Translates a mechanism to MJCF: bodies with their inertia and shapes, joints of types R, P, S,
   * F and W, also C, U and PL, with their limits, springs, damping, friction and armature, loops,
   * linear couplings, springs between points and along couplings, motors and the start.
   *
   * @param fileName name of the model file, for messages
   * @param model what the file says
   * @throws MechmlException M-086 for every part without which the mechanism would be another one:
   *     other constraints and joints, bodies without mass that nothing joins to one with mass
   */
  public static RobotExport mjcf(String fileName, MechmlModel model) throws MechmlException {
    return of(fileName, losses -> new MjcfWriter(model, losses).mujoco());
  }

  private static RobotExport of(String fileName, Function<ExportLosses, Element> writer)
      throws MechmlException {
    Diagnostics refused = new Diagnostics(fileName);
    ExportLosses losses = new ExportLosses(fileName, refused);
    Element robot = writer.apply(losses);
    refused.throwIfErrors();
    Comment origin =
        new Comment(" Made from " + fileName.replaceAll("-{2,}|\\p{Cntrl}", "_") + ". ");
    Document document = new Document(Optional.empty(), List.of(origin), robot, List.of());
    return new RobotExport(
        DocumentWriter.write(document),
        losses.all().stream().sorted(Comparator.comparingInt(Diagnostic::line)).toList());
  }
}

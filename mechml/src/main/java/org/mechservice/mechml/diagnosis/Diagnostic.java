package org.mechservice.mechml.diagnosis;

import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;

/**
 * A message about a model file.
 *
 * @param severity whether the model can still be used
 * @param code entry of the error catalogue, such as {@code M-014}
 * @param message what was found, what was expected, and what to write instead
 * @param file name of the file
 * @param line line in the file, from 1; 0 if unknown
 * @param column column in the file, from 1; 0 if unknown
 * @param path path of the element, such as {@code MechML/MBSmodel/Joints/joint[j2]}; empty if
 *     unknown
 */
public record Diagnostic(
    Severity severity,
    MessageCode code,
    String message,
    String file,
    int line,
    int column,
    String path) {

  /**
   * Returns {@code file:line:column: code message}, with the parts of the position that are known.
   */
  @Override
  public String toString() {
    String position =
        file + (line > 0 ? ":" + line : "") + (line > 0 && column > 0 ? ":" + column : "");
    return position + ": " + code + " " + message;
  }
}

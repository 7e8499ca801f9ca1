package org.mechservice.mechml.diagnosis;

/**
 * A position in a model file.
 *
 * @param line from 1; 0 if unknown
 * @param column from 1; 0 if unknown
 * @param path path of the element, such as {@code MechML/MBSmodel/Joints/joint[j2]}; empty if there
 *     is none
 */
public record SourcePosition(int line, int column, String path) {
  /** The file as a whole. */
  public static final SourcePosition FILE = new SourcePosition(0, 0, "");
}

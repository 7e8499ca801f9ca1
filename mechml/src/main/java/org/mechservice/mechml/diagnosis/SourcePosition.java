package org.mechservice.mechml.diagnosis;

/**
 * A position in a model file or in a file that it includes.
 *
 * @param line from 1; 0 if unknown
 * @param column from 1; 0 if unknown
 * @param path path of the element, such as {@code MechML/MBSmodel/Joints/joint[j2]}; empty if there
 *     is none
 * @param included name of the included file; empty in the model file itself
 */
public record SourcePosition(int line, int column, String path, String included) {
  /** The file as a whole. */
  public static final SourcePosition FILE = new SourcePosition(0, 0, "");

  /** A position in the model file itself. */
  public SourcePosition(int line, int column, String path) {
    this(line, column, path, "");
  }

  /** Returns the same position in an included file. */
  public SourcePosition in(String file) {
    return new SourcePosition(line, column, path, file);
  }

  /** Returns {@code line 12}, with the file if it is an included one. */
  public String inWords() {
    return "line " + line + (included.isEmpty() ? "" : " of " + included);
  }
}

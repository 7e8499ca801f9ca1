package org.mechservice.solver.text;

/**
 * The position of a part of a mechanism in the model file, for messages.
 *
 * @param file name of the file; empty if there is none
 * @param line line in the file, from 1; 0 if there is none
 */
public record Origin(String file, int line) {
  public static final Origin NONE = new Origin("", 0);

  @Override
  public String toString() {
    return file.isEmpty() ? "" : file + ":" + line;
  }
}

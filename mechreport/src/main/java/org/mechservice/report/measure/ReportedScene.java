package org.mechservice.report.measure;

/**
 * The scene of a report.
 *
 * @param model the model's name
 * @param file its file's name
 * @param freedoms number of independent velocities
 * @param end end of the run in the file, s
 */
public record ReportedScene(String model, String file, int freedoms, double end) {
  /** Returns the name of the file with every run. */
  public String runs() {
    return named(file, ".csv");
  }

  /** Returns the name of the file with what the report's own codes made. */
  public String reference() {
    return named(file, "-reference.csv");
  }

  /**
   * Returns the name of a file of a report.
   *
   * @param file the model's file
   * @param ending put in the place of that of the model's file
   */
  public static String named(String file, String ending) {
    return file.replaceFirst("\\.xml$", "") + ending;
  }
}

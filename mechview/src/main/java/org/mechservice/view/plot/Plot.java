package org.mechservice.view.plot;

import java.util.List;

/**
 * A diagram: panels over a common horizontal axis.
 *
 * @param title what it shows
 * @param xName name of the column on the horizontal axis
 * @param xUnit its unit; empty if it is not known
 * @param runs names of the files; their curves differ in dashes
 * @param panels from top to bottom
 * @param notes what it does not show
 */
public record Plot(
    String title,
    String xName,
    String xUnit,
    List<String> runs,
    List<Panel> panels,
    List<String> notes) {
  public Plot {
    runs = List.copyOf(runs);
    panels = List.copyOf(panels);
    notes = List.copyOf(notes);
  }

  /**
   * Curves with one vertical axis.
   *
   * @param quantity what they have in common, such as {@code q}; may be empty
   * @param unit their unit; empty if it is not known
   * @param curves in the order of the columns, runs within columns
   */
  public record Panel(String quantity, String unit, List<Curve> curves) {
    public Panel {
      curves = List.copyOf(curves);
    }
  }

  /**
   * One column of one file.
   *
   * @param name the column's
   * @param run index of its file
   * @param colour index of the column in its panel
   * @param table values of the file, shared by its curves: rows of x and columns
   * @param column which of the row's values is on the vertical axis; 0 is x
   */
  public record Curve(String name, int run, int colour, List<double[]> table, int column) {
    /** Returns the number of rows. */
    int size() {
      return table.size();
    }

    double x(int row) {
      return table.get(row)[0];
    }

    double y(int row) {
      return table.get(row)[column];
    }
  }
}

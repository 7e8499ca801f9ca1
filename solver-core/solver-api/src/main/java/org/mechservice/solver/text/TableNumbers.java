package org.mechservice.solver.text;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Pattern;

/** The numbers of CSV files that tables and maps of a model file name. */
final class TableNumbers {
  private static final Pattern WHOLE = Pattern.compile("[1-9]\\d{0,3}");

  private TableNumbers() {}

  /**
   * Returns the attributes of {@code table} that hold the points of a file.
   *
   * @param xColumn name or number of the column of arguments, if the table has one
   * @param yColumn name or number of the column of values
   * @param csv the file
   * @param charset of the model
   * @throws IOException if it cannot be read or holds no such columns; the message says which
   */
  static String attributes(
      Optional<String> xColumn, Optional<String> yColumn, Path csv, Charset charset)
      throws IOException {
    byte[] content = Files.readAllBytes(csv);
    CsvTable table = CsvTable.of(csv, content, charset);
    int x = column(table, xColumn.orElse("1"));
    int y = column(table, yColumn.orElse("2"));
    StringBuilder arguments = new StringBuilder();
    StringBuilder values = new StringBuilder();
    for (int i = table.isNumber(0, x) ? 0 : 1; i < table.size(); i++) {
      arguments.append(arguments.isEmpty() ? "" : ";").append(table.number(i, x));
      values.append(values.isEmpty() ? "" : ";").append(table.number(i, y));
    }
    return " x=\"" + arguments + "\" y=\"" + values + "\"" + origin(table, content);
  }

  /**
   * Returns the attributes of {@code map} that hold the grid of a file: the second arguments in its
   * first row, behind any word, and in each further row a first argument and the values there.
   *
   * @param csv the file
   * @param charset of the model
   * @throws IOException if it cannot be read or holds no grid; the message says where
   */
  static String ofMap(Path csv, Charset charset) throws IOException {
    byte[] content = Files.readAllBytes(csv);
    CsvTable table = CsvTable.of(csv, content, charset);
    if (table.size() < 3 || table.width() < 3) {
      throw table.refusal(
          "a map has a first row with two second arguments at least, behind a word, and two further"
              + " rows at least, each a first argument and its values");
    }
    StringBuilder x = new StringBuilder();
    StringBuilder y = new StringBuilder();
    StringBuilder z = new StringBuilder();
    for (int i = 0; i < table.size(); i++) {
      if (i > 0) {
        x.append(i == 1 ? "" : ";").append(table.number(i, 0));
      }
      for (int j = 1; j < table.width(); j++) {
        StringBuilder list = i == 0 ? y : z;
        list.append(list.isEmpty() ? "" : ";").append(table.number(i, j));
      }
    }
    return " x=\"%s\" y=\"%s\" z=\"%s\"%s".formatted(x, y, z, origin(table, content));
  }

  /** Returns the attributes that say how a file was read, and which one it was. */
  private static String origin(CsvTable table, byte[] content) {
    return " layout=\"%s\" sha256=\"%s\"".formatted(table.layout(), Sha256.of(content));
  }

  private static int column(CsvTable table, String asked) throws IOException {
    int named = table.head().indexOf(asked);
    if (named >= 0) {
      return named;
    }
    if (WHOLE.matcher(asked).matches()) {
      return Integer.parseInt(asked) - 1;
    }
    throw table.refusal(
        "there is no column \"" + asked + "\"; there are " + String.join(", ", table.head()));
  }
}

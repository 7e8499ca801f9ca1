package org.mechservice.solver.text;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/** The numbers of CSV files that tables and maps of a model file name. */
final class TableNumbers {
  private static final Pattern NUMBER =
      Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
  private static final Pattern WHOLE = Pattern.compile("[1-9]\\d{0,3}");

  private TableNumbers() {}

  /**
   * Returns the attributes of {@code table} that hold the points of a file.
   *
   * @param element the tag
   * @param csv the file
   * @throws IOException if it cannot be read or holds no such columns; the message says which
   */
  static String attributes(String element, Path csv) throws IOException {
    byte[] content = Files.readAllBytes(csv);
    List<String[]> rows = rows(content);
    int x = column(csv, rows, ModelFiles.attribute(element, "xColumn").orElse("1"));
    int y = column(csv, rows, ModelFiles.attribute(element, "yColumn").orElse("2"));
    boolean headed = !rows.isEmpty() && !isNumber(rows.get(0), x);
    StringBuilder arguments = new StringBuilder();
    StringBuilder values = new StringBuilder();
    for (int i = headed ? 1 : 0; i < rows.size(); i++) {
      arguments.append(arguments.isEmpty() ? "" : ";").append(number(csv, rows.get(i), x));
      values.append(values.isEmpty() ? "" : ";").append(number(csv, rows.get(i), y));
    }
    return " x=\"" + arguments + "\" y=\"" + values + "\" sha256=\"" + Sha256.of(content) + "\"";
  }

  /**
   * Returns the attributes of {@code map} that hold the grid of a file: the second arguments in its
   * first row, behind any word, and in each further row a first argument and the values there.
   *
   * @param csv the file
   * @throws IOException if it cannot be read or holds no grid; the message says where
   */
  static String ofMap(Path csv) throws IOException {
    byte[] content = Files.readAllBytes(csv);
    List<String[]> rows = rows(content);
    int columns = rows.isEmpty() ? 0 : rows.get(0).length;
    if (rows.size() < 3 || columns < 3) {
      throw new FileSystemException(
          csv.toString(),
          null,
          "a map has a first row with two second arguments at least, behind a word, and two further"
              + " rows at least, each a first argument and its values");
    }
    StringBuilder x = new StringBuilder();
    StringBuilder y = new StringBuilder();
    StringBuilder z = new StringBuilder();
    for (int i = 0; i < rows.size(); i++) {
      String[] row = rows.get(i);
      if (row.length != columns) {
        throw new FileSystemException(
            csv.toString(),
            null,
            "the row \""
                + String.join(",", row)
                + "\" has "
                + row.length
                + " columns, not "
                + columns);
      }
      if (i > 0) {
        x.append(i == 1 ? "" : ";").append(number(csv, row, 0));
      }
      for (int j = 1; j < columns; j++) {
        StringBuilder list = i == 0 ? y : z;
        list.append(list.isEmpty() ? "" : ";").append(number(csv, row, j));
      }
    }
    return " x=\"%s\" y=\"%s\" z=\"%s\" sha256=\"%s\"".formatted(x, y, z, Sha256.of(content));
  }

  private static List<String[]> rows(byte[] content) {
    String text = new String(content, StandardCharsets.UTF_8).replace("\uFEFF", "");
    List<String[]> rows = new ArrayList<>();
    for (String line : text.split("\\R", -1)) {
      if (!line.isBlank() && !line.startsWith("#")) {
        String[] cells = line.split("[,;\t]", -1);
        for (int i = 0; i < cells.length; i++) {
          cells[i] = cells[i].strip().replaceAll("^\"(.*)\"$", "$1");
        }
        rows.add(cells);
      }
    }
    return rows;
  }

  private static int column(Path csv, List<String[]> rows, String asked) throws IOException {
    String[] head = rows.isEmpty() ? new String[0] : rows.get(0);
    for (int i = 0; i < head.length; i++) {
      if (head[i].equals(asked)) {
        return i;
      }
    }
    if (WHOLE.matcher(asked).matches()) {
      return Integer.parseInt(asked) - 1;
    }
    throw new FileSystemException(
        csv.toString(),
        null,
        "there is no column \"" + asked + "\"; there are " + String.join(", ", head));
  }

  private static boolean isNumber(String[] row, int column) {
    return column < row.length && NUMBER.matcher(row[column]).matches();
  }

  private static String number(Path csv, String[] row, int column) throws IOException {
    if (!isNumber(row, column)) {
      throw new FileSystemException(
          csv.toString(),
          null,
          "the row \""
              + String.join(",", row)
              + "\" has no number in column "
              + (column + 1)
              + "; decimals are written with a point");
    }
    return row[column];
  }
}

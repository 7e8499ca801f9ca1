package org.mechservice.solver.text;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The CSV files that tables of a model file name. Whoever reads a model from a folder writes their
 * numbers into its text, so that the text holds the whole model when it travels: {@code <table
 * file="road.csv"/>} gets {@code x}, {@code y} and the {@code sha256} of the file. A table that has
 * points keeps them.
 */
public final class TableFiles {
  private static final Pattern COMMENT_OR_TABLE =
      Pattern.compile("<!--.*?-->|<!\\[CDATA\\[.*?]]>|<table\\s[^<>]*>", Pattern.DOTALL);
  private static final Pattern NUMBER =
      Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
  private static final Pattern WHOLE = Pattern.compile("[1-9]\\d{0,3}");

  private TableFiles() {}

  /**
   * Returns a model file with the numbers of the files that its tables name.
   *
   * @param model its bytes; not modified
   * @param file the model file, beside which or below whose folder the CSV files lie
   * @throws IOException if a file cannot be read or holds no such columns; the message says which
   */
  public static byte[] inlined(byte[] model, Path file) throws IOException {
    String text = new String(model, StandardCharsets.ISO_8859_1);
    if (!text.contains("<table")) {
      return model;
    }
    StringBuilder all = new StringBuilder();
    Matcher found = COMMENT_OR_TABLE.matcher(text);
    int from = 0;
    while (found.find()) {
      String element = found.group();
      Optional<String> name = attribute(element, "file");
      boolean toFill = attribute(element, "x").isEmpty() && attribute(element, "y").isEmpty();
      if (element.startsWith("<table") && name.isPresent() && toFill) {
        all.append(text, from, found.start()).append(filled(element, name.get(), file));
        from = found.end();
      }
    }
    return from == 0
        ? model
        : all.append(text.substring(from)).toString().getBytes(StandardCharsets.ISO_8859_1);
  }

  private static Optional<String> attribute(String element, String name) {
    Matcher found =
        Pattern.compile("\\s" + name + "\\s*=\\s*(\"([^\"]*)\"|'([^']*)')").matcher(element);
    return found.find()
        ? Optional.of(found.group(2) != null ? found.group(2) : found.group(3))
        : Optional.empty();
  }

  private static String filled(String element, String name, Path model) throws IOException {
    String utf = new String(name.getBytes(StandardCharsets.ISO_8859_1), StandardCharsets.UTF_8);
    Path csv = beside(model, utf);
    byte[] content = Files.readAllBytes(csv);
    List<String[]> rows = rows(content);
    int x = column(csv, rows, attribute(element, "xColumn").orElse("1"));
    int y = column(csv, rows, attribute(element, "yColumn").orElse("2"));
    boolean headed = !rows.isEmpty() && !isNumber(rows.get(0), x);
    StringBuilder arguments = new StringBuilder();
    StringBuilder values = new StringBuilder();
    for (int i = headed ? 1 : 0; i < rows.size(); i++) {
      arguments.append(arguments.isEmpty() ? "" : ";").append(number(csv, rows.get(i), x));
      values.append(values.isEmpty() ? "" : ";").append(number(csv, rows.get(i), y));
    }
    int end = element.length() - (element.endsWith("/>") ? 2 : 1);
    return element.substring(0, end)
        + " x=\""
        + arguments
        + "\" y=\""
        + values
        + "\" sha256=\""
        + Sha256.of(content)
        + "\""
        + element.substring(end);
  }

  private static Path beside(Path model, String name) throws IOException {
    Path folder = model.toAbsolutePath().normalize().getParent();
    Path csv = folder == null ? Path.of(name) : folder.resolve(name).normalize();
    if (folder == null || !csv.startsWith(folder) || Path.of(name).isAbsolute()) {
      throw new FileSystemException(
          name, null, "the file of a table lies in the model's folder or below it");
    }
    if (!Files.isRegularFile(csv)) {
      throw new FileSystemException(
          csv.toString(), null, "a table names this file, which does not exist");
    }
    return csv;
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

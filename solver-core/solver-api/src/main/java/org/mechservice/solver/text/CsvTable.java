package org.mechservice.solver.text;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;

/**
 * A CSV file. The delimiter is found once for the whole file: it is the first of semicolon, tab and
 * comma that divides every row into as many cells, two or more. Where it is no comma, decimals may
 * have a comma instead of a point, in all cells alike. Lines behind {@code #} and empty ones are no
 * rows; a cell may stand in quotes.
 *
 * <p>What fits no rule is refused, and not guessed.
 */
final class CsvTable {
  private static final Pattern POINT =
      Pattern.compile("[-+]?(\\d+\\.?\\d*|\\.\\d+)([eE][-+]?\\d+)?");
  private static final Pattern COMMA = Pattern.compile("[-+]?(\\d+,\\d*|,\\d+)([eE][-+]?\\d+)?");
  private static final List<Character> DELIMITERS = List.of(';', '\t', ',');

  private final Path file;
  private final char delimiter;
  private final boolean decimalComma;
  private final List<List<String>> rows;

  private CsvTable(Path file, char delimiter, List<List<String>> rows) throws IOException {
    this.file = file;
    this.delimiter = delimiter;
    this.rows = rows;
    boolean commas = false;
    boolean points = false;
    for (List<String> row : rows) {
      for (String cell : row) {
        commas |= COMMA.matcher(cell).matches();
        points |= POINT.matcher(cell).matches() && cell.indexOf('.') >= 0;
      }
    }
    if (commas && points) {
      throw refusal(
          "it has numbers with a decimal comma and others with a point; write one of them");
    }
    decimalComma = commas;
  }

  /**
   * Reads a file.
   *
   * @param file its name, for messages
   * @param content its bytes, in UTF-8 or else in {@code charset}; not modified
   * @param charset that of the model which names the file
   * @throws IOException if no delimiter divides its rows alike, or its decimals are mixed
   */
  static CsvTable of(Path file, byte[] content, Charset charset) throws IOException {
    List<String> lines = new ArrayList<>();
    for (String line : text(content, charset).replace("\uFEFF", "").split("\\R", -1)) {
      if (!line.isBlank() && !line.startsWith("#")) {
        lines.add(line);
      }
    }
    for (char delimiter : DELIMITERS) {
      List<List<String>> rows = lines.stream().map(line -> cells(line, delimiter)).toList();
      long widths = rows.stream().map(List::size).distinct().count();
      if (widths == 1 && rows.get(0).size() > 1) {
        return new CsvTable(file, delimiter, rows);
      }
    }
    throw new FileSystemException(file.toString(), null, uneven(lines));
  }

  private static String text(byte[] content, Charset charset) {
    try {
      return StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(content)).toString();
    } catch (CharacterCodingException e) {
      return new String(content, charset);
    }
  }

  /** Says which row has another number of cells, by the delimiter that most rows hold. */
  private static String uneven(List<String> lines) {
    char best = ',';
    for (char delimiter : DELIMITERS) {
      char before = best;
      if (count(lines, delimiter) > count(lines, before)) {
        best = delimiter;
      }
    }
    if (lines.isEmpty()) {
      return "it has no rows";
    }
    int width = cells(lines.get(0), best).size();
    for (String line : lines) {
      int own = cells(line, best).size();
      if (own != width) {
        return "the row \"%s\" has %d cells between %s, and the first row has %d"
            .formatted(line, own, name(best), width);
      }
    }
    return "its rows have one cell; columns are divided by semicolons, tabs or commas";
  }

  private static long count(List<String> lines, char delimiter) {
    return lines.stream().filter(line -> line.indexOf(delimiter) >= 0).count();
  }

  private static String name(char delimiter) {
    return delimiter == ';' ? "semicolons" : delimiter == ',' ? "commas" : "tabs";
  }

  private static List<String> cells(String line, char delimiter) {
    List<String> cells = new ArrayList<>();
    StringBuilder cell = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (c == '"' && quoted && i + 1 < line.length() && line.charAt(i + 1) == '"') {
        cell.append(c);
        i++;
      } else if (c == '"') {
        quoted = !quoted;
      } else if (c == delimiter && !quoted) {
        cells.add(cell.toString().strip());
        cell.setLength(0);
      } else {
        cell.append(c);
      }
    }
    cells.add(cell.toString().strip());
    return cells;
  }

  /** Returns how the file is written, in words: what divides its cells, and its decimal mark. */
  String layout() {
    return "cells between %s, decimals with a %s"
        .formatted(name(delimiter), decimalComma ? "comma" : "point");
  }

  /** Returns the number of rows. */
  int size() {
    return rows.size();
  }

  /** Returns the number of cells in each row. */
  int width() {
    return rows.isEmpty() ? 0 : rows.get(0).size();
  }

  /** Returns the cells of the first row, which may be names. */
  List<String> head() {
    return rows.isEmpty() ? List.of() : rows.get(0);
  }

  /** Returns whether a cell is a number. */
  boolean isNumber(int row, int column) {
    String cell = column < width() ? rows.get(row).get(column) : "";
    return POINT.matcher(cell).matches() || COMMA.matcher(cell).matches();
  }

  /**
   * Returns a number with a decimal point.
   *
   * @throws IOException if the cell is none
   */
  String number(int row, int column) throws IOException {
    if (!isNumber(row, column)) {
      throw refusal(
          "the row \"%s\" has no number in column %d; the file has %s"
              .formatted(
                  String.join(String.valueOf(delimiter), rows.get(row)), column + 1, layout()));
    }
    return rows.get(row).get(column).replace(',', '.');
  }

  /** Returns a refusal of the file. */
  FileSystemException refusal(String why) {
    return new FileSystemException(file.toString(), null, why);
  }
}

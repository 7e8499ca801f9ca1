package org.mechservice.sim.emit.c;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.mechservice.sim.emit.method.NumberText;
import org.mechservice.sim.emit.source.SourceLines;

/** Writes constant arrays in C; one without elements gets a zero, since C has no empty arrays. */
public final class CArrays {
  private static final int NUMBERS_PER_LINE = 12;

  private final SourceLines source;
  private final NumberText numbers;
  private final String linkage;

  CArrays(SourceLines source, NumberText numbers) {
    this(source, numbers, "static ");
  }

  private CArrays(SourceLines source, NumberText numbers, String linkage) {
    this.source = source;
    this.numbers = numbers;
    this.linkage = linkage;
  }

  /** Writes arrays that other files of the model read. */
  static CArrays shared(SourceLines source, NumberText numbers) {
    return new CArrays(source, numbers, "");
  }

  void integers(String array, List<Integer> values) {
    array("int", array, values.stream().map(String::valueOf).toList());
  }

  /** Writes numbers of one byte each. */
  void bytes(String array, List<Integer> values) {
    array("signed char", array, values.stream().map(String::valueOf).toList());
  }

  void doubles(String array, List<Double> values) {
    array("double", array, values.stream().map(numbers::of).toList());
  }

  private void array(String type, String array, List<String> texts) {
    source.line(linkage + "const " + type + " " + array + "[] = {");
    if (texts.isEmpty()) {
      source.line("    0,");
    }
    for (int i = 0; i < texts.size(); i += NUMBERS_PER_LINE) {
      List<String> part = texts.subList(i, Math.min(texts.size(), i + NUMBERS_PER_LINE));
      source.line("    " + String.join(", ", part) + ",");
    }
    source.line("};");
  }

  /** Writes texts, with an empty one behind them. */
  void texts(String array, List<String> texts) {
    source.line(linkage + "const char *const " + array + "[] = {");
    texts.forEach(text -> source.line("    " + literal(text) + ","));
    source.line("    \"\",").line("};");
  }

  /** Returns a literal in UTF-8 by octal escapes, which no following digit joins. */
  public static String literal(String text) {
    StringBuilder literal = new StringBuilder("\"");
    for (byte b : text.getBytes(StandardCharsets.UTF_8)) {
      boolean plain = b >= ' ' && b <= '~' && b != '"' && b != '\\' && b != '?';
      literal.append(plain ? Character.toString(b) : "\\%03o".formatted(b & 0xff));
    }
    return literal.append('"').toString();
  }
}

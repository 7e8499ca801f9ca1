package org.mechservice.client.failure;

import java.util.Arrays;
import java.util.List;
import org.mechservice.idl.Diagnostic;

/**
 * A message of the server about a model.
 *
 * @param severity its severity
 * @param code entry of the error catalogue, such as {@code M-014}
 * @param text what was found, what was expected, and what to write instead
 * @param fileName the file it is about; empty if none
 * @param line line in the file, from 1; 0 if unknown
 * @param column column in the file, from 1; 0 if unknown
 * @param path path of the element in the file; empty if none
 */
public record ModelMessage(
    Severity severity,
    String code,
    String text,
    String fileName,
    int line,
    int column,
    String path) {

  /** Severity of a message. */
  public enum Severity {
    /** Information. */
    INFO,
    /** Probable mistake; the model is used nevertheless. */
    WARNING,
    /** The model cannot be used. */
    ERROR
  }

  public static List<ModelMessage> listOf(Diagnostic[] diagnostics) {
    return Arrays.stream(diagnostics).map(ModelMessage::of).toList();
  }

  private static ModelMessage of(Diagnostic said) {
    return new ModelMessage(
        Severity.values()[said.level.value()],
        said.code,
        said.text,
        said.fileName,
        said.lineNo,
        said.columnNo,
        said.path);
  }

  /** Returns the same message with another name of the file. */
  public ModelMessage inFile(String name) {
    return new ModelMessage(severity, code, text, name, line, column, path);
  }

  /** Returns {@code file:line:column: code text}, with the known parts of the position. */
  @Override
  public String toString() {
    String place =
        fileName + (line > 0 ? ":" + line : "") + (line > 0 && column > 0 ? ":" + column : "");
    return place.isEmpty() ? codeAndText() : place + ": " + codeAndText();
  }

  /** Returns {@code code text}, without the position. */
  public String codeAndText() {
    return text.startsWith(code) ? text : code + " " + text;
  }
}

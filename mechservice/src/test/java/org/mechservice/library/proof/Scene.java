package org.mechservice.library.proof;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * A scene of a set, with its right end.
 *
 * @param kind what it is about
 * @param detail what else tells it from others of its kind
 * @param method how it runs
 * @param text the model
 * @param shortest a time, s, in which much of what could be passed over happens
 * @param expected right values of the last row
 */
record Scene(
    String kind,
    String detail,
    Method method,
    String text,
    double shortest,
    List<Expected> expected) {
  Scene {
    expected = List.copyOf(expected);
  }

  /** Returns the model with steps that see everything, whatever the integrator knows. */
  Scene inShortSteps() {
    String limited = text.replace(" relTol=", " maxStep='" + shortest / 10 + "' relTol=");
    return new Scene(kind, detail, method, limited, shortest, expected);
  }

  /** Returns the scene with right values. */
  Scene expecting(List<Expected> values) {
    return new Scene(kind, detail, method, text, shortest, values);
  }

  /** Writes the model, and its kind and right values as CSV, into a folder. */
  void write(Path folder, String name) throws IOException {
    Files.createDirectories(folder);
    Files.writeString(folder.resolve(name + ".xml"), text);
    StringBuilder values = new StringBuilder("kind," + kind + "\n");
    expected.forEach(e -> values.append(e.column() + "," + e.value() + "\n"));
    Files.writeString(folder.resolve(name + ".csv"), values);
  }
}

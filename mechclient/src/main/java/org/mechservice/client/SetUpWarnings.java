package org.mechservice.client;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.idl.NameValue;
import org.mechservice.solver.catalogue.MessageCode;

/** Warnings of the server about a run before it begins, among the facts of its set-up. */
final class SetUpWarnings {
  /** Code, file, line, column, path and text. */
  private static final int FIELDS = 6;

  private SetUpWarnings() {}

  /**
   * Returns all warnings of the run; empty if they are those of its file, or the server sends none.
   */
  static Optional<List<ModelMessage>> in(NameValue[] facts) {
    Map<String, String> said =
        Arrays.stream(facts)
            .filter(fact -> fact.key.startsWith("warning"))
            .collect(Collectors.toMap(fact -> fact.key, fact -> fact.text, (a, b) -> a));
    if (!said.containsKey("warnings")) {
      return Optional.empty();
    }
    List<ModelMessage> warnings = new ArrayList<>();
    for (int i = 1; said.containsKey("warning." + i); i++) {
      String[] fields = said.getOrDefault("warning." + i, "").split("\t", FIELDS);
      if (fields.length == FIELDS) {
        warnings.add(message(fields));
      }
    }
    return Optional.of(warnings);
  }

  /** Returns the warnings that the model or the options silence; a code unknown here is none. */
  static Set<MessageCode> silenced(NameValue[] facts) {
    return Arrays.stream(facts)
        .filter(fact -> fact.key.equals("silenced"))
        .flatMap(fact -> Stream.of(fact.text.split(" ", -1)))
        .flatMap(code -> MessageCode.find(code).stream())
        .collect(Collectors.toSet());
  }

  private static ModelMessage message(String[] fields) {
    return new ModelMessage(
        ModelMessage.Severity.WARNING,
        fields[0],
        fields[5],
        fields[1],
        number(fields[2]),
        number(fields[3]),
        fields[4]);
  }

  private static int number(String text) {
    return text.matches("\\d{1,9}") ? Integer.parseInt(text) : 0;
  }
}

package org.mechservice.client;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.ServerFailureException;
import org.mechservice.idl.NameValue;
import org.mechservice.solver.catalogue.MessageCode;

/** What a server says of a run that it has set up, or whose JAR it has built. */
final class SetUpFacts {
  /** Code, file, line, column, path and text. */
  private static final int WARNING_FIELDS = 6;

  private final NameValue[] said;

  /**
   * @param said the server's answer; not modified
   */
  SetUpFacts(NameValue[] said) {
    this.said = said.clone();
  }

  /** Returns the host that set the run up. */
  String hostName() {
    return text("hostName");
  }

  /** Returns what identifies the model, and why the server chose its formulation. */
  Map<String, Object> ofModel() {
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put("modelSha256", text("modelSha256"));
    facts.put("formulationReason", text("formulationReason"));
    return facts;
  }

  private String text(String name) {
    return Arrays.stream(said)
        .filter(fact -> fact.key.equals(name))
        .map(fact -> fact.text)
        .findFirst()
        .orElse("");
  }

  /**
   * Returns the times that the session has taken at the server so far.
   *
   * @throws ServerFailureException if a time is no number
   */
  ServerTimes times() {
    return ServerTimes.of(
        Arrays.stream(said)
            .filter(fact -> fact.key.matches("t\\dc?s?|tcc"))
            .toArray(NameValue[]::new));
  }

  /**
   * Returns all warnings of the run; empty if they are those of its file, or the server sends none.
   */
  Optional<List<ModelMessage>> warnings() {
    Map<String, String> texts =
        Arrays.stream(said)
            .filter(fact -> fact.key.startsWith("warning"))
            .collect(Collectors.toMap(fact -> fact.key, fact -> fact.text, (a, b) -> a));
    if (!texts.containsKey("warnings")) {
      return Optional.empty();
    }
    List<ModelMessage> warnings = new ArrayList<>();
    for (int i = 1; texts.containsKey("warning." + i); i++) {
      String[] fields = texts.getOrDefault("warning." + i, "").split("\t", WARNING_FIELDS);
      if (fields.length == WARNING_FIELDS) {
        warnings.add(warning(fields));
      }
    }
    return Optional.of(warnings);
  }

  /** Returns the warnings that the model or the options silence; a code unknown here is none. */
  Set<MessageCode> silenced() {
    return Arrays.stream(said)
        .filter(fact -> fact.key.equals("silenced"))
        .flatMap(fact -> Stream.of(fact.text.split(" ", -1)))
        .flatMap(code -> MessageCode.find(code).stream())
        .collect(Collectors.toSet());
  }

  private static ModelMessage warning(String[] fields) {
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

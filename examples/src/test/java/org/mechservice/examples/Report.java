package org.mechservice.examples;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;

/** A run report as {@code --json} prints it. */
final class Report {
  private final JsonObject json;

  private Report(JsonObject json) {
    this.json = json;
  }

  /** Reads the report; fails the test if standard output holds anything else. */
  static Report printedBy(Terminal.Ended command) {
    return new Report(JsonParser.parseString(command.orFail().stdout()).getAsJsonObject());
  }

  /** Reads the report of a command run in this process. */
  static Report printedBy(Mechanic.Done command) {
    return new Report(JsonParser.parseString(command.orFail().out()).getAsJsonObject());
  }

  boolean has(String key) {
    return json.has(key);
  }

  double number(String key) {
    return value(key).getAsDouble();
  }

  String text(String key) {
    return value(key).getAsString();
  }

  private JsonElement value(String key) {
    JsonElement value = json.get(key);
    if (value == null) {
      throw new AssertionError("no \"" + key + "\" in the report: " + json);
    }
    return value;
  }
}

package org.mechservice.client.run;

import com.google.gson.JsonElement;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Pattern;
import org.mechservice.client.failure.ServerFailureException;
import org.mechservice.solver.catalogue.MessageCode;

/** Reads the run report that a server sends as one flat JSON object. */
final class ReportJson {
  private static final Pattern COUNT = Pattern.compile("-?[0-9]{1,18}");

  private ReportJson() {}

  /**
   * Returns the report's entries in order; numbers of digits only, which are counts, as {@link
   * Long}, others as {@link Double}; null, which represents NaN, is left out.
   *
   * @throws ServerFailureException if it is not a flat JSON object
   */
  static Map<String, Object> parse(String json) {
    try {
      Map<String, Object> report = new LinkedHashMap<>();
      for (Map.Entry<String, JsonElement> entry :
          JsonParser.parseString(json).getAsJsonObject().entrySet()) {
        if (!entry.getValue().isJsonNull()) {
          report.put(entry.getKey(), value(entry.getValue()));
        }
      }
      return report;
    } catch (JsonParseException | IllegalStateException e) {
      throw new ServerFailureException(
          MessageCode.ANSWER_NOT_UNDERSTOOD.code(),
          "the server's run report is not a flat JSON object: " + e.getMessage(),
          "");
    }
  }

  private static Object value(JsonElement element) {
    JsonPrimitive value = element.getAsJsonPrimitive();
    if (value.isBoolean()) {
      return value.getAsBoolean();
    }
    return value.isNumber() ? number(value.getAsString()) : value.getAsString();
  }

  private static Object number(String text) {
    if (COUNT.matcher(text).matches()) {
      return Long.valueOf(text);
    }
    return Double.valueOf(text);
  }
}

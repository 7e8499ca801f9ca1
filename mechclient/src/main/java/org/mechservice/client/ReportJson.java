package org.mechservice.client;

import com.google.gson.JsonElement;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.JsonPrimitive;
import java.math.BigDecimal;
import java.util.LinkedHashMap;
import java.util.Map;

/** Reads the run report that a server sends as one flat JSON object. */
final class ReportJson {
  private ReportJson() {}

  /**
   * Returns the report's entries in order; whole numbers as {@link Long}, others as {@link Double};
   * null, a number that is none, is left out.
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
          "S-035", "the server's run report is not a flat JSON object: " + e.getMessage(), "");
    }
  }

  private static Object value(JsonElement element) {
    JsonPrimitive value = element.getAsJsonPrimitive();
    if (value.isBoolean()) {
      return value.getAsBoolean();
    }
    return value.isNumber() ? number(value.getAsBigDecimal()) : value.getAsString();
  }

  private static Object number(BigDecimal number) {
    boolean whole = number.scale() <= 0 && number.precision() - number.scale() <= 18;
    if (whole) {
      return number.longValueExact();
    }
    return number.doubleValue();
  }
}

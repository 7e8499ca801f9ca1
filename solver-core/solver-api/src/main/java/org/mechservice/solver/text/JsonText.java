package org.mechservice.solver.text;

import java.util.Iterator;
import java.util.Map;

/** Writes a flat map as one JSON object (RFC 8259), keys in the map's order. */
public final class JsonText {
  private JsonText() {}

  /**
   * Returns the map as JSON, one line per entry.
   *
   * @param map values are {@link String}, {@link Long}, {@link Integer}, {@link Boolean} or {@link
   *     Double}; a double that is not finite becomes {@code null}
   * @throws IllegalArgumentException if a value is of another type
   */
  public static String write(Map<String, Object> map) {
    StringBuilder json = new StringBuilder("{");
    Iterator<Map.Entry<String, Object>> entries = map.entrySet().iterator();
    while (entries.hasNext()) {
      Map.Entry<String, Object> entry = entries.next();
      json.append("\n  ");
      appendString(json, entry.getKey());
      json.append(": ");
      appendValue(json, entry.getValue());
      if (entries.hasNext()) {
        json.append(',');
      }
    }
    return json.append(map.isEmpty() ? "}" : "\n}").toString();
  }

  /** Returns a text as a JSON string, in quotation marks. */
  public static String quoted(String text) {
    StringBuilder json = new StringBuilder();
    appendString(json, text);
    return json.toString();
  }

  private static void appendValue(StringBuilder json, Object value) {
    if (value instanceof String text) {
      appendString(json, text);
    } else if (value instanceof Double number) {
      json.append(Double.isFinite(number) ? ShortestDecimal.format(number) : "null");
    } else if (value instanceof Long || value instanceof Integer || value instanceof Boolean) {
      json.append(value);
    } else {
      throw new IllegalArgumentException("no JSON form for " + value.getClass());
    }
  }

  private static void appendString(StringBuilder json, String text) {
    json.append('"');
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '"' || c == '\\') {
        json.append('\\').append(c);
      } else if (c < ' ') {
        json.append("\\u00").append(Character.forDigit(c >> 4, 16));
        json.append(Character.forDigit(c & 15, 16));
      } else {
        json.append(c);
      }
    }
    json.append('"');
  }
}

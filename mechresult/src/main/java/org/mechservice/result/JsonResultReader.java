package org.mechservice.result;

import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Reads the JSON object that {@link JsonWriter} writes, row by row. */
final class JsonResultReader {
  private JsonResultReader() {}

  static SignalTable read(Path file) throws IOException {
    List<String> names = new ArrayList<>();
    Map<String, String> units = new LinkedHashMap<>();
    GrowingTable table = new GrowingTable(names);
    try (JsonReader json = new JsonReader(Files.newBufferedReader(file))) {
      json.beginObject();
      while (json.hasNext()) {
        switch (json.nextName()) {
          case "columns" -> {
            json.beginArray();
            while (json.hasNext()) {
              names.add(json.nextString());
            }
            json.endArray();
            table = new GrowingTable(names);
          }
          case "units" -> {
            json.beginObject();
            while (json.hasNext()) {
              units.put(json.nextName(), json.nextString());
            }
            json.endObject();
          }
          case "rows" -> readRows(json, table);
          default -> json.skipValue();
        }
      }
      json.endObject();
    }
    return table.table(units);
  }

  private static void readRows(JsonReader json, GrowingTable table) throws IOException {
    double[] row = new double[table.columnCount() + 1];
    json.beginArray();
    while (json.hasNext()) {
      int count = 0;
      json.beginArray();
      while (json.hasNext() && count < row.length) {
        row[count++] = number(json);
      }
      table.add(row, count);
      json.endArray();
    }
    json.endArray();
  }

  private static double number(JsonReader json) throws IOException {
    if (json.peek() == JsonToken.NULL) {
      json.nextNull();
      return Double.NaN;
    }
    return json.nextDouble();
  }
}

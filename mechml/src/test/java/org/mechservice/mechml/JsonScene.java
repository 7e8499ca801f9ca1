package org.mechservice.mechml;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.spatial.Vector3;

/** A reference scene: SI numbers, all frames parallel at zero, Ground at the world's origin. */
record JsonScene(JsonObject object) {

  /** Reads a scene of the solver's tests. */
  static JsonScene read(String name) throws IOException {
    String file = "/org/mechservice/solver/scenes/" + name + ".json";
    return new JsonScene(JsonParser.parseString(Resources.text(file)).getAsJsonObject());
  }

  List<JsonObject> list(String name) {
    List<JsonObject> list = new ArrayList<>();
    for (JsonElement element : object.getAsJsonArray(name)) {
      list.add(element.getAsJsonObject());
    }
    return list;
  }

  static double number(JsonObject object, String name) {
    return object.get(name).getAsDouble();
  }

  static String text(JsonObject object, String name) {
    return object.get(name).getAsString();
  }

  static List<Double> numbers(JsonObject object, String name) {
    List<Double> numbers = new ArrayList<>();
    object.getAsJsonArray(name).forEach(n -> numbers.add(n.getAsDouble()));
    return numbers;
  }

  static Vector3 vector(JsonObject object, String name) {
    return vector(object.getAsJsonArray(name));
  }

  static Vector3 vector(JsonArray array) {
    return new Vector3(
        array.get(0).getAsDouble(), array.get(1).getAsDouble(), array.get(2).getAsDouble());
  }
}

package org.mechservice.admin.web;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.math.BigDecimal;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.admin.AdminAction;
import org.mechservice.orb.http.RefusedRequestException;

/**
 * The action that a button requests.
 *
 * @param server address of the server it is about
 * @param action the action of that server
 */
record ActionRequest(String server, AdminAction action) {
  /**
   * Reads a request.
   *
   * @throws RefusedRequestException with code S-135 if it cannot be understood
   */
  static ActionRequest read(JsonObject json) {
    try {
      return new ActionRequest(text(json, "server"), action(json));
    } catch (IllegalArgumentException e) {
      throw new RefusedRequestException(400, String.valueOf(e.getMessage()));
    }
  }

  private static AdminAction action(JsonObject json) {
    String name = text(json, "action");
    return switch (name) {
      case "stop" -> new AdminAction.StopSimulation(text(json, "id"), text(json, "reason"));
      case "end" ->
          new AdminAction.EndSessions(text(json, "user"), text(json, "id"), text(json, "reason"));
      case "drain" -> new AdminAction.Drain(text(json, "host"));
      case "undrain" -> new AdminAction.Undrain(text(json, "host"));
      case "shutdown" ->
          new AdminAction.Shutdown(Math.toIntExact(number("grace", json.get("grace"))));
      case "limits" -> new AdminAction.SetLimits(text(json, "host"), limits(json.get("limits")));
      case "placement" -> new AdminAction.SetPlacement(text(json, "policy"));
      default -> throw RefusedRequestException.notUnderstood("there is no action \"" + name + "\"");
    };
  }

  private static String text(JsonObject json, String name) {
    JsonElement member = json.get(name);
    if (member == null || !member.isJsonPrimitive()) {
      throw RefusedRequestException.notUnderstood("it lacks \"" + name + "\"");
    }
    return member.getAsString();
  }

  private static long number(String name, JsonElement element) {
    try {
      return new BigDecimal(element.getAsString()).longValueExact();
    } catch (RuntimeException e) { // absent, no number, or not a whole one
      String written =
          element != null && element.isJsonPrimitive()
              ? element.getAsString()
              : String.valueOf(element);
      throw RefusedRequestException.notUnderstood(
          name + " takes a whole number, not \"" + written + "\"");
    }
  }

  private static Map<String, Long> limits(JsonElement element) {
    if (element == null || !element.isJsonObject() || element.getAsJsonObject().isEmpty()) {
      throw RefusedRequestException.notUnderstood("it lacks \"limits\"");
    }
    Map<String, Long> limits = new TreeMap<>();
    element
        .getAsJsonObject()
        .asMap()
        .forEach((name, value) -> limits.put(name, number(name, value)));
    return limits;
  }

  /** Returns the action in words, with the command line that does the same. */
  JsonObject preview() {
    JsonObject json = new JsonObject();
    json.addProperty("server", server);
    json.addProperty("summary", action.summary());
    json.addProperty("command", action.commandLine(server));
    return json;
  }
}

package org.mechservice.admin.web;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** A request of a browser, and the ways to answer it. */
final class Request {
  private static final int LONGEST_BODY = 64 * 1024;
  private static final String BEARER = "Bearer ";

  /**
   * Nothing from elsewhere is loaded, nothing on the page can become a script, no other page can
   * frame it or send a form to it.
   */
  private static final Map<String, String> PROTECTION =
      Map.of(
          "Content-Security-Policy",
              "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self';"
                  + " connect-src 'self'; base-uri 'none'; form-action 'none';"
                  + " frame-ancestors 'none'; require-trusted-types-for 'script';"
                  + " trusted-types 'none'",
          "X-Content-Type-Options", "nosniff",
          "Referrer-Policy", "no-referrer",
          "Cross-Origin-Opener-Policy", "same-origin",
          "Cross-Origin-Resource-Policy", "same-origin",
          "Cache-Control", "no-store");

  private final HttpExchange exchange;
  private final Map<String, String> parameters = new HashMap<>();

  Request(HttpExchange exchange) {
    this.exchange = exchange;
    String query = exchange.getRequestURI().getRawQuery();
    if (query != null) {
      for (String pair : query.split("&", -1)) {
        int equals = pair.indexOf('=');
        if (equals > 0) {
          parameters.put(pair.substring(0, equals), decoded(pair.substring(equals + 1)));
        }
      }
    }
    PROTECTION.forEach(exchange.getResponseHeaders()::set);
  }

  private static String decoded(String text) {
    try {
      return URLDecoder.decode(text, StandardCharsets.UTF_8);
    } catch (IllegalArgumentException e) {
      throw Refused.notUnderstood("its address is not encoded as it should be");
    }
  }

  String path() {
    return exchange.getRequestURI().getPath();
  }

  boolean isPost() {
    return exchange.getRequestMethod().equals("POST");
  }

  boolean isGet() {
    return exchange.getRequestMethod().equals("GET");
  }

  /** Returns a header, or an empty text. */
  String header(String name) {
    return Optional.ofNullable(exchange.getRequestHeaders().getFirst(name)).orElse("");
  }

  /** Returns the token it carries, or an empty text. */
  String token() {
    String header = header("Authorization");
    return header.startsWith(BEARER) ? header.substring(BEARER.length()) : "";
  }

  /** Returns the name of the caller, as far as it is known. */
  String from() {
    return exchange.getRemoteAddress().getAddress().getHostAddress();
  }

  /** Returns a parameter of the address, or an empty text. */
  String parameter(String name) {
    return parameters.getOrDefault(name, "");
  }

  /** Reads the JSON object that was sent. */
  JsonObject body() throws IOException {
    if (!header("Content-Type").startsWith("application/json")) {
      throw Refused.notUnderstood("it must be application/json");
    }
    byte[] bytes = exchange.getRequestBody().readNBytes(LONGEST_BODY + 1);
    if (bytes.length > LONGEST_BODY) {
      throw Refused.notUnderstood("it is longer than " + LONGEST_BODY + " bytes");
    }
    try {
      return JsonParser.parseString(new String(bytes, StandardCharsets.UTF_8)).getAsJsonObject();
    } catch (JsonParseException | IllegalStateException e) {
      throw Refused.notUnderstood("it is no JSON object");
    }
  }

  /** Answers with JSON. */
  void answer(int status, JsonElement json) throws IOException {
    answer(status, "application/json", json.toString().getBytes(StandardCharsets.UTF_8));
  }

  /** Answers with a file. */
  void answer(int status, String type, byte[] content) throws IOException {
    exchange.getResponseHeaders().set("Content-Type", type);
    exchange.sendResponseHeaders(status, content.length == 0 ? -1 : content.length);
    try (OutputStream out = exchange.getResponseBody()) {
      out.write(content);
    }
  }

  /** Begins a stream that stays open until one of the two closes it. */
  EventStream stream() throws IOException {
    exchange.getResponseHeaders().set("Content-Type", "text/event-stream");
    exchange.sendResponseHeaders(200, 0);
    return new EventStream(exchange.getResponseBody());
  }
}

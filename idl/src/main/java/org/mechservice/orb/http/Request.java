package org.mechservice.orb.http;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.OutputStream;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** A request of a browser, and the ways to answer it. */
public final class Request {
  private static final int LONGEST_BODY = 64 * 1024;
  private static final String BEARER = "Bearer ";
  private static final String POLICY = "Content-Security-Policy";

  /**
   * Nothing from elsewhere is loaded, nothing on the page can become a script, no other page can
   * frame it or send a form to it.
   */
  private static final Map<String, String> PROTECTION =
      Map.of(
          POLICY,
          "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self';"
              + " connect-src 'self'; base-uri 'none'; form-action 'none';"
              + " frame-ancestors 'none'; require-trusted-types-for 'script';"
              + " trusted-types 'none'",
          "X-Content-Type-Options",
          "nosniff",
          "Referrer-Policy",
          "no-referrer",
          "Cross-Origin-Opener-Policy",
          "same-origin",
          "Cross-Origin-Resource-Policy",
          "same-origin",
          "Cache-Control",
          "no-store");

  private final HttpExchange exchange;
  private final Map<String, String> parameters = new HashMap<>();

  public Request(HttpExchange exchange) {
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
      throw RefusedRequestException.notUnderstood("its address is not encoded as it should be");
    }
  }

  public String path() {
    return exchange.getRequestURI().getPath();
  }

  public boolean isPost() {
    return exchange.getRequestMethod().equals("POST");
  }

  public boolean isGet() {
    return exchange.getRequestMethod().equals("GET");
  }

  /** Returns a header, or an empty text. */
  public String header(String name) {
    return Optional.ofNullable(exchange.getRequestHeaders().getFirst(name)).orElse("");
  }

  /** Returns the token it carries, or an empty text. */
  public String token() {
    String header = header("Authorization");
    return header.startsWith(BEARER) ? header.substring(BEARER.length()) : "";
  }

  /** Returns the name of the caller, as far as it is known. */
  public String from() {
    return exchange.getRemoteAddress().getAddress().getHostAddress();
  }

  /** Returns a parameter of the address, or an empty text. */
  public String parameter(String name) {
    return parameters.getOrDefault(name, "");
  }

  /**
   * Returns whether a browser made it for a page of this server, or the user did. A browser says
   * which name it asked and which site made it ask. Neither can be forged by a site: one that gives
   * its own name our address, or sends forms here, is found out.
   *
   * @param port this server listens on
   */
  public boolean isFromOwnSite(int port) {
    String host = header("Host");
    String origin = header("Origin");
    String site = header("Sec-Fetch-Site");
    return Set.of("127.0.0.1:" + port, "localhost:" + port, "[::1]:" + port).contains(host)
        && (origin.isEmpty() || origin.equals("http://" + host))
        && (site.isEmpty() || site.equals("same-origin") || site.equals("none"));
  }

  /** Reads the JSON object that was sent, of at most 64 KiB. */
  public JsonObject body() throws IOException {
    return body(LONGEST_BODY);
  }

  /**
   * Reads the JSON object that was sent.
   *
   * @param longest largest number of bytes taken
   */
  public JsonObject body(int longest) throws IOException {
    if (!header("Content-Type").startsWith("application/json")) {
      throw RefusedRequestException.notUnderstood("it must be application/json");
    }
    byte[] bytes = exchange.getRequestBody().readNBytes(longest + 1);
    if (bytes.length > longest) {
      throw RefusedRequestException.notUnderstood("it is longer than " + longest + " bytes");
    }
    try {
      return JsonParser.parseString(new String(bytes, StandardCharsets.UTF_8)).getAsJsonObject();
    } catch (JsonParseException | IllegalStateException e) {
      throw RefusedRequestException.notUnderstood("it is no JSON object");
    }
  }

  /** Answers with JSON. */
  public void answer(int status, JsonElement json) throws IOException {
    answer(status, "application/json", json.toString().getBytes(StandardCharsets.UTF_8));
  }

  /** Answers with a file. */
  public void answer(int status, String type, byte[] content) throws IOException {
    exchange.getResponseHeaders().set("Content-Type", type);
    exchange.sendResponseHeaders(status, content.length == 0 ? -1 : content.length);
    try (OutputStream out = exchange.getResponseBody()) {
      out.write(content);
    }
  }

  /**
   * Answers with a file that is copied, however large.
   *
   * @param type its media type
   */
  public void answer(String type, Path file) throws IOException {
    exchange.getResponseHeaders().set("Content-Type", type);
    exchange.sendResponseHeaders(200, Files.size(file));
    try (OutputStream out = exchange.getResponseBody()) {
      Files.copy(file, out);
    }
  }

  /** Permits the page to show pictures that its own scripts have made. */
  public void allowOwnPictures() {
    exchange
        .getResponseHeaders()
        .set(
            POLICY,
            PROTECTION.getOrDefault(POLICY, "").replace("img-src 'self'", "img-src 'self' blob:"));
  }

  /**
   * Answers under another policy, for a page whose own style and script are in it.
   *
   * @param policy a whole content security policy
   */
  public void allowOnly(String policy) {
    exchange.getResponseHeaders().set(POLICY, policy);
  }

  /** Begins a stream that stays open until one of the two closes it. */
  public EventStream stream() throws IOException {
    exchange.getResponseHeaders().set("Content-Type", "text/event-stream");
    exchange.sendResponseHeaders(200, 0);
    return new EventStream(exchange.getResponseBody());
  }
}

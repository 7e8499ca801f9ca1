package org.mechservice.report.page;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;

/** What all pages have around their content: style and script, inside the page itself. */
public final class PageFrame {
  private PageFrame() {}

  /**
   * Returns a page.
   *
   * @param title plain text
   * @param content HTML
   */
  public static String of(String title, String content) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
        + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
        + Html.escape(title)
        + "</title>\n<style>\n"
        + resource("page.css")
        + "</style></head><body><main>\n"
        + content
        + "</main>\n<div id=\"hover\"></div>\n<script>\n"
        + resource("page.js")
        + "</script></body></html>\n";
  }

  /** Returns a diagram as a file of its own, with the colours of the pages. */
  static String svg(String diagram) {
    return diagram.replaceFirst(
        "<svg class=\"chart\"([^>]*)>",
        java.util.regex.Matcher.quoteReplacement("<svg xmlns=\"http://www.w3.org/2000/svg\"")
            + "$1 class=\"chart\"><style>"
            + java.util.regex.Matcher.quoteReplacement(resource("page.css"))
            + "</style><rect width=\"100%\" height=\"100%\" style=\"fill:var(--page)\"/>");
  }

  /** Returns a text with the characters of HTML markup escaped. */
  public static String escaped(String text) {
    return Html.escape(text);
  }

  private static String resource(String name) {
    try (InputStream in = PageFrame.class.getResourceAsStream("/org/mechservice/report/" + name)) {
      if (in == null) {
        throw new IllegalStateException("resource " + name + " is missing");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}

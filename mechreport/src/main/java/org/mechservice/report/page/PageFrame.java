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

  /** Returns a text with what HTML would take for markup escaped. */
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

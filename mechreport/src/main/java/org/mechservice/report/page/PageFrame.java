package org.mechservice.report.page;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import org.mechservice.solver.text.Sha256;

/** The frame that all pages have around their content: style and script, inside the page itself. */
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
        + "</title>\n<style>"
        + style()
        + "</style></head><body><main>\n"
        + content
        + "</main>\n<div id=\"hover\"></div>\n<script>"
        + own("page.js")
        + "</script></body></html>\n";
  }

  /**
   * Returns a content security policy under which these pages can be served: nothing is loaded, and
   * style and script are the pages' own, told by their digests.
   */
  public static String policy() {
    return "default-src 'none'; style-src "
        + digest(style())
        + "; script-src "
        + digest(own("page.js"))
        + "; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
  }

  /** Returns the style of all pages with that of reports. */
  private static String style() {
    return own("pages.css") + resource("page.css");
  }

  /** Returns the text of a style or script element. */
  private static String own(String name) {
    return "\n" + resource(name);
  }

  private static String digest(String text) {
    byte[] sha = Sha256.digest().digest(text.getBytes(StandardCharsets.UTF_8));
    return "'sha256-" + Base64.getEncoder().encodeToString(sha) + "'";
  }

  /** Returns a diagram as a file of its own, with the colours of the pages. */
  static String svg(String diagram) {
    return diagram.replaceFirst(
        "<svg class=\"chart\"([^>]*)>",
        java.util.regex.Matcher.quoteReplacement("<svg xmlns=\"http://www.w3.org/2000/svg\"")
            + "$1 class=\"chart\"><style>"
            + java.util.regex.Matcher.quoteReplacement(style())
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

package org.mechservice.admin.web;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.commonmark.ext.gfm.tables.TablesExtension;
import org.commonmark.node.Node;
import org.commonmark.parser.Parser;
import org.commonmark.renderer.html.HtmlRenderer;

/** The pages of the message catalogue, as the browser shows them. */
final class ErrorPages {
  /** The only names there are, so that none can lead anywhere else. */
  private static final Pattern NAME = Pattern.compile("README|[MNS]-\\d{3}");

  private final List<TablesExtension> extensions = List.of(extension());
  private final Parser parser = Parser.builder().extensions(extensions).build();
  private final HtmlRenderer renderer =
      HtmlRenderer.builder().extensions(extensions).escapeHtml(true).sanitizeUrls(true).build();

  private static TablesExtension extension() {
    return (TablesExtension) TablesExtension.create();
  }

  /**
   * Returns a page as HTML, if there is one.
   *
   * @param name code of the message, or README for all of them
   */
  Optional<String> page(String name) throws IOException {
    if (!NAME.matcher(name).matches()) {
      return Optional.empty();
    }
    try (InputStream in = ErrorPages.class.getResourceAsStream("errors/" + name + ".md")) {
      if (in == null) {
        return Optional.empty();
      }
      Node document = parser.parse(new String(in.readAllBytes(), StandardCharsets.UTF_8));
      String title = name.equals("README") ? "Messages" : name;
      return Optional.of(framed(title, renderer.render(document)));
    }
  }

  private static String framed(String title, String text) {
    return """
    <!doctype html>
    <html lang="en">
    <head>
    <meta charset="utf-8">
    <meta name="viewport" content="width=device-width, initial-scale=1">
    <title>%s · MechAdmin</title>
    <link rel="icon" href="/page/icon.svg">
    <link rel="stylesheet" href="/page/pages.css">
    <link rel="stylesheet" href="/page/style.css">
    </head>
    <body><main class="document">
    <p><a href="/docs/errors/README.md">All messages</a></p>
    %s</main></body>
    </html>
    """
        .formatted(title, text);
  }
}

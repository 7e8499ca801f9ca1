package org.mechservice.site;

import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The frame around the text of a page: head, search, chapters, headings, links to the next pages.
 */
final class Frame {
  private static final int CONTENTS = 3;

  private static final String PAGE =
      """
      <!doctype html>
      <html lang="en">
      <head>
      <meta charset="utf-8">
      <meta name="viewport" content="width=device-width, initial-scale=1">
      <title>%1$s · MechService</title>
      <link rel="icon" href="%2$sassets/icon.svg">
      <link rel="stylesheet" href="%2$sassets/pages.css">
      <link rel="stylesheet" href="%2$sassets/site.css">
      <script src="%2$sassets/site.js" data-top="%2$s" defer></script>
      </head>
      <body>
      <a class="skip" href="#text">To the text</a>
      <header class="bar">
      <button id="menu" aria-expanded="false" aria-controls="chapters">Chapters</button>
      <a class="brand" href="%2$sdocs/index.html">MechService</a>
      <div class="search" role="search"><input id="search" type="search" placeholder="Search ( / )" aria-label="Search the guide" autocomplete="off" role="combobox" aria-expanded="false" aria-controls="found"><ul id="found" role="listbox" aria-label="Found" hidden></ul></div>
      </header>
      <div class="page">
      <nav id="chapters" aria-label="Chapters">
      %3$s</nav>
      <main id="text" tabindex="-1">
      %4$s
      <nav class="on" aria-label="Way on">%5$s</nav>
      </main>
      <aside aria-label="On this page">%6$s</aside>
      </div>
      </body>
      </html>
      """;

  private final Navigation navigation;

  Frame(Navigation navigation) {
    this.navigation = navigation;
  }

  /** Returns the whole page. */
  String around(GuidePage page) {
    Path target = GuidePage.target(page.source());
    String top = "../".repeat(target.getNameCount() - 1);
    String way =
        Stream.of(step(target, -1, "← "), step(target, 1, "→ "))
            .flatMap(Optional::stream)
            .collect(Collectors.joining());
    if (way.isEmpty()) {
      way = navigation.above(target).map(entry -> way(target, entry, "↑ ")).orElse("");
    }
    String tables = page.html().replace("<table>", "<div class=\"wide\" tabindex=\"0\"><table>");
    return PAGE.formatted(
        escaped(page.title()),
        top,
        navigation.html(target),
        tables.replace("</table>", "</table></div>"),
        way,
        contents(page));
  }

  private Optional<String> step(Path from, int steps, String arrow) {
    return navigation.beside(from, steps).map(entry -> way(from, entry, arrow));
  }

  private static String way(Path from, Navigation.Entry to, String arrow) {
    return "<a href=\"%s\">%s%s</a>".formatted(link(from, to.page()), arrow, escaped(to.label()));
  }

  private static String contents(GuidePage page) {
    String items =
        page.sections().stream()
            .filter(section -> !section.anchor().isEmpty() && section.level() <= CONTENTS)
            .map(
                section ->
                    "<li class=\"h%d\"><a href=\"#%s\">%s</a></li>"
                        .formatted(section.level(), section.anchor(), escaped(section.heading())))
            .collect(Collectors.joining("\n"));
    return items.isEmpty() ? "" : "<h2>On this page</h2><ul>" + items + "</ul>";
  }

  /** Returns the relative link from a page to another. */
  static String link(Path from, Path to) {
    Path folder = from.getParent() == null ? Path.of("") : from.getParent();
    return folder.relativize(to).toString().replace('\\', '/');
  }

  /** Returns text as it stands in HTML. */
  static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}

package org.mechservice.site;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The guide as pages: every link leads somewhere, every page can be reached. */
class SiteTest {
  private static final Path TOP = Path.of("..");
  private static final Pattern LINK = Pattern.compile(" (?:href|src)=\"([^\"]*)\"");
  private static final Pattern ID = Pattern.compile(" id=\"([^\"]+)\"");

  private static Path site = Path.of("");

  @BeforeAll
  static void write(@TempDir Path folder) throws IOException {
    site = folder;
    assertThat(new Site(TOP, site).writeGuide()).isGreaterThan(100);
  }

  private static List<Path> pages() throws IOException {
    try (Stream<Path> all = Files.walk(site)) {
      return all.filter(file -> file.toString().endsWith(".html"))
          // Reports are pages of their own, copied as they are.
          .filter(
              file ->
                  !file.toString()
                      .contains("reports" + file.getFileSystem().getSeparator() + "pages"))
          .toList();
    }
  }

  private static Set<String> anchors(String html) {
    return ID.matcher(html).results().map(id -> id.group(1)).collect(Collectors.toSet());
  }

  @Test
  void everyLinkLeadsToAPageAndAPlaceOnIt() throws IOException {
    List<String> broken = new ArrayList<>();
    int followed = 0;
    for (Path page : pages()) {
      for (MatchResult link : LINK.matcher(Files.readString(page)).results().toList()) {
        String address = link.group(1);
        if (address.matches("[a-z]+:.*")) {
          continue;
        }
        String[] parts = address.split("#", 2);
        Path file = parts[0].isEmpty() ? page : page.resolveSibling(parts[0]).normalize();
        boolean there =
            Files.isRegularFile(file)
                && (parts.length == 1
                    || !file.toString().endsWith(".html")
                    || anchors(Files.readString(file)).contains(parts[1]));
        if (!there) {
          broken.add(site.relativize(page) + " -> " + address);
        }
        followed++;
      }
    }
    // Each of more than a hundred pages has a list of chapters.
    assertThat(followed).isGreaterThan(1000);
    assertThat(broken).isEmpty();
  }

  @Test
  void everyPageOfTheGuideIsInTheListOfChapters() throws IOException {
    Set<Path> listed =
        Navigation.read(TOP.resolve("docs/chapters.txt")).entries().stream()
            .map(Navigation.Entry::file)
            .collect(Collectors.toSet());
    for (String folder : List.of("docs", "docs/how-to", "docs/reference", "docs/theory")) {
      try (Stream<Path> files = Files.list(TOP.resolve(folder))) {
        assertThat(files.filter(file -> file.toString().endsWith(".md")).map(TOP::relativize))
            .allSatisfy(file -> assertThat(listed).contains(file));
      }
    }
  }

  @Test
  void searchFindsSectionsByAnchor() throws IOException {
    assertThat(site.resolve("assets/places.js"))
        .content()
        .contains(
            "{\"u\":\"docs/mechml.html#groups-of-columns\",\"p\":\"MechML, the language of"
                + " models\"")
        .contains("\"u\":\"docs/errors/M-006.html\"");
  }

  @Test
  void pageOpensItsChapterAndNamesThePagesBesideIt() throws IOException {
    assertThat(site.resolve("docs/results.html"))
        .content()
        .contains("<title>Results · MechService</title>")
        .contains("<a href=\"results.html\" aria-current=\"page\">Results</a>")
        .contains("<a href=\"mechml.html\">← MechML, the language</a>")
        .contains("<a href=\"curves.html\">→ Curves and drawings</a>");
  }

  @Test
  void pageBesideTheChaptersLeadsToTheOneOfItsFolder() throws IOException {
    assertThat(site.resolve("docs/errors/M-006.html"))
        .content()
        .contains("<a href=\"index.html\" aria-current=\"true\">Messages</a>")
        .contains("<a href=\"index.html\">↑ Messages</a>");
  }

  @Test
  void beginningIsThePageOfAllPages() throws IOException {
    assertThat(site.resolve("index.html")).content().contains("url=docs/index.html");
  }
}

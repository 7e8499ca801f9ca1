package org.mechservice.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * The chapters of the guide, in the order in which they are read.
 *
 * @param chapters from the file {@code docs/chapters.txt}
 */
record Navigation(List<Chapter> chapters) {
  /** A group of entries under a title. */
  record Chapter(String title, List<Entry> entries) {}

  /**
   * A page in the list.
   *
   * @param file a Markdown file, or a page that another program writes, relative to the top
   */
  record Entry(Path file, String label) {
    /** Returns the page's place below the folder of the site. */
    Path page() {
      return file.toString().endsWith(".md") ? GuidePage.target(file) : file;
    }
  }

  /**
   * Reads the list. A line that begins with {@code #} opens a chapter; every other line has a file
   * and its label, with a space between.
   *
   * @throws IOException if the file cannot be read, or a line has no label
   */
  static Navigation read(Path list) throws IOException {
    List<Chapter> chapters = new ArrayList<>();
    for (String line : Files.readAllLines(list)) {
      String[] words = line.strip().split(" ", 2);
      if (words.length < 2) {
        throw new IOException(list + ": \"" + line + "\" has no label; write FILE LABEL");
      } else if (words[0].equals("#")) {
        chapters.add(new Chapter(words[1], new ArrayList<>()));
      } else if (chapters.isEmpty()) {
        throw new IOException(list + ": a line # TITLE must stand before \"" + line + "\"");
      } else {
        chapters.get(chapters.size() - 1).entries().add(new Entry(Path.of(words[0]), words[1]));
      }
    }
    return new Navigation(chapters);
  }

  /** Returns all entries in order. */
  List<Entry> entries() {
    return chapters.stream().flatMap(chapter -> chapter.entries().stream()).toList();
  }

  /** Returns the list without pages that are not there. */
  Navigation only(Predicate<Entry> there) {
    return new Navigation(
        chapters.stream()
            .map(c -> new Chapter(c.title(), c.entries().stream().filter(there).toList()))
            .filter(chapter -> !chapter.entries().isEmpty())
            .toList());
  }

  /**
   * Returns the page of the list that leads to a page which is not in it: that of its folder, or of
   * one above it.
   */
  Optional<Entry> above(Path page) {
    List<Entry> all = entries();
    for (Path folder = page.getParent(); folder != null; folder = folder.getParent()) {
      Path index = folder.resolve(GuidePage.INDEX);
      Optional<Entry> found = all.stream().filter(e -> e.page().equals(index)).findFirst();
      if (found.isPresent()) {
        return found.filter(entry -> !entry.page().equals(page));
      }
    }
    return Optional.empty();
  }

  /** Returns the list as HTML, as seen from a page, with its chapter open and its entry marked. */
  String html(Path page) {
    boolean listed = entries().stream().anyMatch(entry -> entry.page().equals(page));
    Path place = listed ? page : above(page).map(Entry::page).orElse(page);
    StringBuilder html = new StringBuilder();
    for (Chapter chapter : chapters) {
      boolean open = chapter.entries().stream().anyMatch(entry -> entry.page().equals(place));
      html.append("<details").append(open || chapter.equals(chapters.get(0)) ? " open" : "");
      html.append("><summary>").append(Frame.escaped(chapter.title())).append("</summary><ul>\n");
      for (Entry entry : chapter.entries()) {
        html.append("<li><a href=\"").append(Frame.link(page, entry.page())).append('"');
        html.append(entry.page().equals(page) ? " aria-current=\"page\"" : "");
        html.append(!listed && entry.page().equals(place) ? " aria-current=\"true\">" : ">");
        html.append(Frame.escaped(entry.label())).append("</a></li>\n");
      }
      html.append("</ul></details>\n");
    }
    return html.toString();
  }

  /** Returns the entry before or after a page's own. */
  Optional<Entry> beside(Path page, int steps) {
    List<Entry> all = entries();
    for (int i = 0; i < all.size(); i++) {
      if (all.get(i).page().equals(page)) {
        int other = i + steps;
        return other >= 0 && other < all.size() ? Optional.of(all.get(other)) : Optional.empty();
      }
    }
    return Optional.empty();
  }
}

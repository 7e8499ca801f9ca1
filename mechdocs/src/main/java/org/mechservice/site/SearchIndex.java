package org.mechservice.site;

import com.google.gson.Gson;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/**
 * The entries that the search field finds: sections of the guide, types of the Java reference,
 * functions of the Python reference. A script and not JSON: browsers read no data beside a page
 * that is a file.
 */
final class SearchIndex {
  /** Longest text kept of a section; its beginning says what it is about. */
  private static final int TEXT = 1200;

  private static final Pattern JAVA_TYPE =
      Pattern.compile("\\{\"p\":\"([\\w.]+)\",\"l\":\"([\\w.]+)\"(?:,\"u\":\"([^\"]+)\")?\\}");
  private static final Pattern PYTHON_NAME = Pattern.compile("<section id=\"([\\w.]+)\"");

  /**
   * One place that can be found.
   *
   * @param u its address below the folder of the site
   * @param p title of its page
   * @param h its heading
   * @param t its text
   */
  private record Place(String u, String p, String h, String t) {}

  private final List<Place> places = new ArrayList<>();

  /** Adds the sections of a page. */
  void add(GuidePage page) {
    String address = GuidePage.target(page.source()).toString();
    for (GuidePage.Section section : page.sections()) {
      String text = section.text().replaceAll("\\s+", " ").strip();
      places.add(
          new Place(
              section.anchor().isEmpty() ? address : address + "#" + section.anchor(),
              page.title(),
              section.heading(),
              text.substring(0, Math.min(TEXT, text.length()))));
    }
  }

  /** Adds the types of a Java reference, whose own search index names them. */
  void addJava(Path site, Path folder) throws IOException {
    Path types = site.resolve(folder).resolve("type-search-index.js");
    if (Files.exists(types)) {
      for (MatchResult type : JAVA_TYPE.matcher(Files.readString(types)).results().toList()) {
        String page = type.group(1).replace('.', '/') + "/" + type.group(2) + ".html";
        places.add(
            new Place(folder + "/" + page, "Java", type.group(2), "class in " + type.group(1)));
      }
    }
  }

  /** Adds the functions and classes of a Python reference. */
  void addPython(Path site, Path page) throws IOException {
    Path file = site.resolve(page);
    if (Files.exists(file)) {
      PYTHON_NAME
          .matcher(Files.readString(file))
          .results()
          .map(name -> name.group(1))
          .forEach(name -> places.add(new Place(page + "#" + name, "Python", name, "")));
    }
  }

  /** Returns the script. */
  String script() {
    return "window.mechPlaces = " + new Gson().toJson(places) + ";\n";
  }
}

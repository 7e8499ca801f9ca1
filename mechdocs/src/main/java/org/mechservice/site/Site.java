package org.mechservice.site;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Writes the site: {@code java -jar mechdocs.jar TOP DIR [guide]}; {@code mechdocs/build-site}
 * calls it.
 */
public final class Site {
  private static final List<String> ASSETS =
      List.of("pages.css", "site.css", "site.js", "icon.svg");

  /** Folders whose Markdown files are pages. */
  private static final List<String> FOLDERS = List.of("docs", "examples", "benchmarks", "python");

  private static final List<String> TOP_PAGES = List.of("CONTRIBUTING.md", "README.md");

  /** Where the site begins. */
  private static final String BEGIN =
      """
      <!doctype html>
      <html lang="en"><head><meta charset="utf-8"><title>MechService</title>
      <meta http-equiv="refresh" content="0; url=docs/index.html"></head>
      <body><a href="docs/index.html">The user guide of MechService</a></body></html>
      """;

  /** A list of the files of a folder that has no page. */
  private static final String FOLDER =
      """
      <!doctype html>
      <html lang="en"><head><meta charset="utf-8"><title>%1$s</title>
      <meta name="viewport" content="width=device-width, initial-scale=1">
      <link rel="stylesheet" href="%2$sassets/pages.css">
      <link rel="stylesheet" href="%2$sassets/site.css"></head>
      <body><main><h1>%1$s</h1><ul>
      %3$s</ul></main></body></html>
      """;

  private static final Path JAVA = Path.of("java");
  private static final Path PYTHON = Path.of("python-api", "mechservice.html");

  private final Path top;
  private final Path target;

  /**
   * @param top of the repository
   * @param target folder of the site; made if need be
   */
  Site(Path top, Path target) {
    this.top = top;
    this.target = target;
  }

  /**
   * Writes the site.
   *
   * @param arguments the top of the repository, the folder of the site, and {@code guide} to leave
   *     the Java reference out
   */
  public static void main(String[] arguments) throws IOException {
    if (arguments.length < 2 || arguments.length > 3) {
      System.err.println("usage: java -jar mechdocs.jar TOP DIR [guide]");
      System.exit(2);
    }
    Site site = new Site(Path.of(arguments[0]), Path.of(arguments[1]));
    if (arguments.length == 2) {
      site.writeJava();
    }
    int pages = site.writeGuide();
    System.out.println(pages + " pages; begin with " + site.target.resolve("index.html"));
  }

  private void writeJava() throws IOException {
    Path style = Files.createTempFile("javadoc-", ".css");
    try {
      copyAsset("javadoc.css", style);
      JavaReference.write(top, target.resolve(JAVA), style);
    } finally {
      Files.deleteIfExists(style);
    }
  }

  /** Writes the guide, with the references that are there by now; returns the number of pages. */
  int writeGuide() throws IOException {
    Map<Path, GuidePage> pages = pages();
    Navigation navigation =
        Navigation.read(top.resolve("docs/chapters.txt"))
            .only(e -> pages.containsKey(e.file()) || Files.exists(target.resolve(e.file())));
    Frame frame = new Frame(navigation);
    SearchIndex index = new SearchIndex();
    Set<Path> files = new LinkedHashSet<>();
    for (GuidePage page : pages.values()) {
      write(GuidePage.target(page.source()), frame.around(page));
      index.add(page);
      files.addAll(page.files());
    }
    files.removeAll(pages.keySet());
    for (Path file : files) {
      copy(file);
    }
    index.addJava(target, JAVA);
    index.addPython(target, PYTHON);
    write(Path.of("assets", "places.js"), index.script());
    write(Path.of("index.html"), BEGIN);
    for (String asset : ASSETS) {
      Path file = target.resolve("assets").resolve(asset);
      Files.createDirectories(target.resolve("assets"));
      copyAsset(asset, file);
    }
    return pages.size();
  }

  private Map<Path, GuidePage> pages() throws IOException {
    List<Path> sources = new ArrayList<>();
    TOP_PAGES.forEach(name -> sources.add(Path.of(name)));
    for (String folder : FOLDERS) {
      try (Stream<Path> all = Files.walk(top.resolve(folder))) {
        all.map(top::relativize)
            .filter(file -> file.toString().endsWith(".md"))
            .filter(file -> !file.toString().matches(".*(target|build|\\.venv|dist)/.*"))
            .sorted()
            .forEach(sources::add);
      }
    }
    Map<Path, GuidePage> pages = new LinkedHashMap<>();
    for (Path source : sources) {
      pages.put(
          source,
          GuidePage.of(
              source,
              Files.readString(top.resolve(source)),
              file -> Files.isDirectory(top.resolve(file))));
    }
    return pages;
  }

  /** Copies a file that a page links; of a folder without a page all files, with a list of them. */
  private void copy(Path file) throws IOException {
    Path from = top.resolve(file);
    if (Files.isDirectory(from) && !Files.exists(from.resolve("README.md"))) {
      List<Path> inside;
      try (Stream<Path> all = Files.list(from)) {
        inside = all.filter(Files::isRegularFile).map(Path::getFileName).sorted().toList();
      }
      StringBuilder list = new StringBuilder();
      for (Path name : inside) {
        copy(file.resolve(name));
        list.append("<li><a href=\"%1$s\">%1$s</a></li>%n".formatted(name));
      }
      String up = "../".repeat(file.getNameCount());
      write(file.resolve("index.html"), FOLDER.formatted(file, up, list));
    } else if (Files.isRegularFile(from)) {
      Path to = target.resolve(file);
      Files.createDirectories(to.toAbsolutePath().getParent());
      Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  private void write(Path page, String text) throws IOException {
    Path file = target.resolve(page);
    Files.createDirectories(file.toAbsolutePath().getParent());
    Files.writeString(file, text);
  }

  private static void copyAsset(String name, Path to) throws IOException {
    try (InputStream in = Site.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IOException(name + " is missing in this program");
      }
      Files.copy(in, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }
}

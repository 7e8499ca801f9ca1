package org.mechservice.cli.model;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/** The examples, which are part of the program: folders with a page, models and what they need. */
public final class Examples implements AutoCloseable {
  /** The page of an example. */
  static final String README = "README.md";

  private static final String RESOURCE = "examples";

  private final Optional<FileSystem> archive;
  private final Path root;

  private Examples(Optional<FileSystem> archive, Path root) {
    this.archive = archive;
    this.root = root;
  }

  /** Opens the examples in the program's archive, or in a folder of classes. */
  public static Examples open() throws IOException {
    try {
      URI place = Objects.requireNonNull(Examples.class.getResource(RESOURCE), RESOURCE).toURI();
      if (!place.getScheme().equals("jar")) {
        return new Examples(Optional.empty(), Path.of(place));
      }
      FileSystem archive = FileSystems.newFileSystem(place, Map.of());
      return new Examples(Optional.of(archive), archive.provider().getPath(place));
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns the names, sorted. */
  List<String> names() throws IOException {
    try (Stream<Path> folders = Files.list(root)) {
      return folders
          .map(folder -> folder.getFileName().toString().replace("/", ""))
          .sorted()
          .toList();
    }
  }

  /** Returns the heading of an example's page. */
  String title(String name) throws IOException {
    return text(name + "/" + README).lines().findFirst().orElse("").replaceFirst("^# *", "");
  }

  /**
   * Returns a file's text.
   *
   * @param file name of the example and of the file in it, with a slash between
   */
  public String text(String file) throws IOException {
    return Files.readString(root.resolve(file), StandardCharsets.UTF_8);
  }

  /**
   * Copies all files of an example.
   *
   * @param to folder, which does not exist yet
   */
  void copy(String name, Path to) throws IOException {
    Path from = root.resolve(name);
    try (Stream<Path> files = Files.walk(from)) {
      for (Path file : files.toList()) {
        Path copied = to.resolve(from.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(copied);
        } else {
          Files.copy(file, copied);
        }
      }
    }
  }

  @Override
  public void close() {
    archive.ifPresent(
        opened -> {
          try {
            opened.close();
          } catch (IOException e) {
            throw new UncheckedIOException(e);
          }
        });
  }
}

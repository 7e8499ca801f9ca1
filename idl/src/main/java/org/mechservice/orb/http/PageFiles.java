package org.mechservice.orb.http;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.Optional;

/** The files of the page, all of them in the program's own JAR. */
public final class PageFiles {
  /**
   * A file.
   *
   * @param type media type
   * @param content bytes
   */
  @SuppressWarnings("ArrayRecordComponent") // made once, written once, never compared
  public record PageFile(String type, byte[] content) {}

  private static final Map<String, String> TYPES =
      Map.of(
          "html", "text/html; charset=utf-8",
          "css", "text/css; charset=utf-8",
          "js", "text/javascript; charset=utf-8",
          "svg", "image/svg+xml");

  private final Class<?> owner;
  private final String folder;

  /**
   * @param owner class beside whose package the files are
   * @param folder where they are, relative to it, with a slash at its end; or empty
   */
  public PageFiles(Class<?> owner, String folder) {
    this.owner = owner;
    this.folder = folder;
  }

  /** Returns a file of the page, or one that all pages share, if there is one of this name. */
  public Optional<PageFile> file(String name) throws IOException {
    String type = TYPES.get(name.substring(name.lastIndexOf('.') + 1));
    if (type == null || !name.matches("[a-z]+[0-9a-z]*\\.[a-z]+")) {
      return Optional.empty();
    }
    InputStream own = owner.getResourceAsStream(folder + name);
    try (InputStream in = own == null ? PageFiles.class.getResourceAsStream(name) : own) {
      return in == null ? Optional.empty() : Optional.of(new PageFile(type, in.readAllBytes()));
    }
  }
}

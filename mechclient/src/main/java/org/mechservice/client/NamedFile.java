package org.mechservice.client;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Reads the file a user names. */
final class NamedFile {
  private NamedFile() {}

  /**
   * Returns the bytes of a file.
   *
   * @throws FileSystemException if it cannot be read; the message names the file, which Java omits
   *     for folders
   */
  static byte[] of(Path file) throws IOException {
    if (Files.isDirectory(file)) {
      throw new FileSystemException(file.toString(), null, "it is a folder; name a file in it");
    }
    return Files.readAllBytes(file);
  }
}

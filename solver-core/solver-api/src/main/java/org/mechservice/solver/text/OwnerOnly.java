package org.mechservice.solver.text;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;

/**
 * Files and folders that their owner alone may read. On systems without such permissions they are
 * made as usual.
 */
public final class OwnerOnly {
  private static final String FILE = "rw-------";
  private static final String FOLDER = "rwx------";

  private OwnerOnly() {}

  /** Returns the attributes of a new file. */
  public static FileAttribute<?>[] file() {
    return attributes(FILE);
  }

  /** Returns the attributes of a new folder. */
  public static FileAttribute<?>[] folder() {
    return attributes(FOLDER);
  }

  private static boolean posix() {
    return FileSystems.getDefault().supportedFileAttributeViews().contains("posix");
  }

  private static FileAttribute<?>[] attributes(String permissions) {
    return posix()
        ? new FileAttribute<?>[] {
          PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString(permissions))
        }
        : new FileAttribute<?>[0];
  }

  /**
   * Takes the rights of others from a file or folder that exists; leaves pipes and devices alone.
   *
   * @throws IOException if it belongs to somebody else
   */
  public static void restrict(Path path) throws IOException {
    boolean folder = Files.isDirectory(path);
    if (posix() && (folder || Files.isRegularFile(path))) {
      Files.setPosixFilePermissions(path, PosixFilePermissions.fromString(folder ? FOLDER : FILE));
    }
  }
}

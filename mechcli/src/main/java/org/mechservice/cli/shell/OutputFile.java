package org.mechservice.cli.shell;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.UUID;
import org.mechservice.solver.catalogue.MessageCode;

/** Writes whole files: a file gets its name when it is complete. */
public final class OutputFile {
  private OutputFile() {}

  /**
   * Writes a file, replacing one of that name.
   *
   * @throws IOException S-042 if it cannot be written
   * @throws UsageException S-046 as {@link #requireUsable}
   */
  public static void write(Path target, byte[] content) throws IOException {
    requireUsable(target);
    Path file = target.toAbsolutePath();
    // Not a temporary file of the JDK's making: those are readable for their owner only.
    Path growing =
        file.resolveSibling("." + file.getFileName() + "-" + UUID.randomUUID() + ".part");
    try {
      Files.write(growing, content);
      Files.move(
          growing, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    } catch (FileSystemException e) {
      throw e;
    } catch (IOException e) {
      throw new IOException(
          MessageCode.FILE_UNUSABLE + " " + target + " cannot be written: " + e.getMessage(), e);
    } finally {
      Files.deleteIfExists(growing);
    }
  }

  /**
   * Checks a name before anything is computed for it.
   *
   * @throws UsageException S-046 if it is that of a folder or a device, whose place no file may
   *     take, or its folder does not exist
   */
  public static void requireUsable(Path target) {
    Path file = target.toAbsolutePath();
    Path folder = file.getParent();
    if (folder == null || Files.isDirectory(file)) {
      throw new UsageException(
          MessageCode.OUTPUT_PLACE + " " + target + " is a folder; name a file");
    } else if (Files.exists(file) && !Files.isRegularFile(file)) {
      throw new UsageException(
          MessageCode.OUTPUT_PLACE + " " + target + " is a device; name a file");
    } else if (!Files.isDirectory(folder)) {
      throw new UsageException(
          MessageCode.OUTPUT_PLACE + " there is no folder " + folder + " for " + target);
    }
  }
}

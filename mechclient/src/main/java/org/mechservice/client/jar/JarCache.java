package org.mechservice.client.jar;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.function.Supplier;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.Sha256;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Stores fetched runtime JARs by their SHA-256, so that each is fetched once. Every JAR is checked
 * against its hash before it is returned: a changed file is fetched again; a download with another
 * hash is rejected and not stored.
 */
public final class JarCache {
  private static final Logger LOG = LoggerFactory.getLogger(JarCache.class);

  private final Path folder;

  /**
   * @param folder where the files are kept; created when first needed
   */
  public JarCache(Path folder) {
    this.folder = folder;
  }

  /** Returns the user's cache: {@code mechservice} under $XDG_CACHE_HOME or ~/.cache. */
  public static JarCache ofUser() {
    String configured = System.getenv().getOrDefault("XDG_CACHE_HOME", "");
    // The XDG specification has relative paths ignored.
    Path caches =
        configured.startsWith("/")
            ? Path.of(configured)
            : Path.of(System.getProperty("user.home"), ".cache");
    return new JarCache(caches.resolve("mechservice"));
  }

  /**
   * Returns a JAR from the cache, or from the server if it is not there.
   *
   * @param sha256 hash of the JAR
   * @param download fetches it
   * @throws JarRefusedException if what was downloaded is not what was announced
   */
  byte[] get(String sha256, Supplier<byte[]> download) {
    if (!Sha256.isHash(sha256)) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(), "\"" + sha256 + "\" is no SHA-256 of the runtime JAR");
    }
    Path file = folder.resolve(sha256 + ".jar");
    byte[] kept = read(file);
    if (Sha256.of(kept).equals(sha256)) {
      return kept;
    }
    byte[] fetched = BuiltJar.verified(download.get(), sha256, "the runtime JAR");
    keep(file, fetched);
    return fetched;
  }

  private static byte[] read(Path file) {
    try {
      return Files.readAllBytes(file);
    } catch (NoSuchFileException e) {
      return new byte[0];
    } catch (IOException e) {
      LOG.warn(
          MessageCode.CACHE_UNUSABLE + " cannot read {}; fetching it again: {}",
          file,
          e.toString());
      return new byte[0];
    }
  }

  private void keep(Path file, byte[] jar) {
    try {
      Files.createDirectories(folder);
      Path growing = Files.createTempFile(folder, "fetched", ".part");
      try {
        Files.write(growing, jar);
        Files.move(growing, file, StandardCopyOption.ATOMIC_MOVE);
      } finally {
        Files.deleteIfExists(growing);
      }
    } catch (IOException e) {
      LOG.warn(
          MessageCode.CACHE_UNUSABLE + " cannot keep {}; it will be fetched again next time: {}",
          file,
          e.toString());
    }
  }
}

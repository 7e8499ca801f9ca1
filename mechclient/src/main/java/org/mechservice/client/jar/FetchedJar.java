package org.mechservice.client.jar;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.jar.Attributes;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.zip.ZipInputStream;
import org.mechservice.client.failure.JarRefusedException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The content of a JAR in memory: the bytes whose hash was checked are the bytes that are used.
 *
 * <p>{@link JarFile} reads files only and {@code JarInputStream} inflates every entry, most of
 * which a run does not need. So this class reads the table of contents itself (PKWARE APPNOTE
 * 4.3.12 and 4.3.16) and inflates an entry on request.
 */
final class FetchedJar {
  private static final String API_VERSION_ATTRIBUTE = "Mech-Api-Version";
  private static final int END_SIGNATURE = 0x06054b50;
  private static final int END_LENGTH = 22;
  private static final int HEADER_SIGNATURE = 0x02014b50;
  private static final int HEADER_LENGTH = 46;

  /** Largest entry when it is inflated; a few kilobytes can become any size. */
  private static final int MOST_ENTRY_BYTES = 32 << 20;

  private final byte[] jar;
  private final Map<String, Integer> places;
  private final Attributes manifest;

  private FetchedJar(byte[] jar) throws IOException {
    this.jar = jar;
    places = places(ByteBuffer.wrap(jar).order(ByteOrder.LITTLE_ENDIAN));
    Optional<byte[]> written = entry(JarFile.MANIFEST_NAME);
    manifest =
        written.isEmpty()
            ? new Attributes()
            : new Manifest(new ByteArrayInputStream(written.get())).getMainAttributes();
  }

  /**
   * Reads a JAR in memory.
   *
   * @param jar the file; not to be modified
   * @param what the JAR's name in messages
   * @throws JarRefusedException if it cannot be read, or was built for another solver API
   */
  static FetchedJar read(byte[] jar, String what) {
    try {
      FetchedJar read = new FetchedJar(jar);
      requireSameApi(read.manifest, what);
      return read;
    } catch (IOException | IndexOutOfBoundsException | BufferUnderflowException e) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(), what + " is no JAR: " + e.getMessage());
    }
  }

  /** Returns where the local header of each entry begins. */
  private static Map<String, Integer> places(ByteBuffer zip) throws IOException {
    int end = zip.limit() - END_LENGTH;
    while (end >= 0 && zip.getInt(end) != END_SIGNATURE) {
      end--;
    }
    if (end < 0) {
      throw new IOException("it has no table of contents");
    }
    Map<String, Integer> places = new HashMap<>();
    int header = zip.getInt(end + 16);
    for (int count = Short.toUnsignedInt(zip.getShort(end + 10)); count > 0; count--) {
      if (zip.getInt(header) != HEADER_SIGNATURE) {
        throw new IOException("its table of contents is damaged");
      }
      int nameLength = Short.toUnsignedInt(zip.getShort(header + 28));
      byte[] name = new byte[nameLength];
      zip.get(header + HEADER_LENGTH, name);
      places.put(new String(name, StandardCharsets.UTF_8), zip.getInt(header + 42));
      header +=
          HEADER_LENGTH
              + nameLength
              + Short.toUnsignedInt(zip.getShort(header + 30))
              + Short.toUnsignedInt(zip.getShort(header + 32));
    }
    return places;
  }

  private static void requireSameApi(Attributes manifest, String what) {
    String built = manifest.getValue(API_VERSION_ATTRIBUTE);
    String own = Integer.toString(Model.API_VERSION);
    if (!own.equals(built)) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(),
          what
              + " was built for solver API version "
              + (built == null ? "none" : built)
              + "; this client has "
              + own
              + ": use the client of the server's version");
    }
  }

  /** Returns a main attribute of the manifest. */
  Optional<String> attribute(String name) {
    return Optional.ofNullable(manifest.getValue(name));
  }

  /** Returns the names of all entries. */
  Set<String> names() {
    return Collections.unmodifiableSet(places.keySet());
  }

  /**
   * Returns the bytes of an entry; empty if there is none of this name.
   *
   * @throws JarRefusedException if the entry is damaged or too large
   */
  Optional<byte[]> entry(String name) {
    Integer place = places.get(name);
    if (place == null) {
      return Optional.empty();
    }
    try (ZipInputStream in =
        new ZipInputStream(new ByteArrayInputStream(jar, place, jar.length - place))) {
      if (in.getNextEntry() == null) {
        throw new JarRefusedException(
            MessageCode.JAR_REFUSED.code(), "entry " + name + " of a fetched JAR is damaged");
      }
      byte[] content = in.readNBytes(MOST_ENTRY_BYTES + 1);
      if (content.length > MOST_ENTRY_BYTES) {
        throw new JarRefusedException(
            MessageCode.JAR_REFUSED.code(),
            "entry " + name + " of a fetched JAR has more than " + MOST_ENTRY_BYTES + " bytes");
      }
      return Optional.of(content);
    } catch (IOException e) {
      throw new JarRefusedException(
          MessageCode.JAR_REFUSED.code(),
          "entry " + name + " of a fetched JAR is damaged: " + e.getMessage());
    }
  }
}

package org.mechservice.mechml;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Objects;

/** Test files beside the tests' classes. */
public final class Resources {
  private Resources() {}

  public static byte[] bytes(String name) throws IOException {
    try (InputStream stream =
        Objects.requireNonNull(Resources.class.getResourceAsStream(name), name)) {
      return stream.readAllBytes();
    }
  }

  public static String text(String name) throws IOException {
    return new String(bytes(name), StandardCharsets.UTF_8);
  }
}

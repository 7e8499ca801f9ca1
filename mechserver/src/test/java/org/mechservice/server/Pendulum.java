package org.mechservice.server;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Objects;
import org.mechservice.idl.ModelFile;

/** The five-bar pendulum: 5 joints, 11 columns, 301 rows to its end at 3 s. */
final class Pendulum {
  static final int COLUMNS = 11;
  static final int ROWS = 301;

  private Pendulum() {}

  static ModelFile file() {
    try (InputStream in =
        Objects.requireNonNull(Pendulum.class.getResourceAsStream("pendulum.xml"))) {
      return new ModelFile("pendulum.xml", in.readAllBytes());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}

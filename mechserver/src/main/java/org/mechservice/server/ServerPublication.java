package org.mechservice.server;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;
import org.mechservice.orb.ServiceKey;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.ServiceUnreachableException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.FileErrors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Publishes the reference of a server in a file and at a naming service, until it is closed. */
final class ServerPublication implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(ServerPublication.class);

  private final Optional<Path> iorFile;
  private final Optional<Runnable> unbind;

  private ServerPublication(Optional<Path> iorFile, Optional<Runnable> unbind) {
    this.iorFile = iorFile;
    this.unbind = unbind;
  }

  /**
   * Publishes the reference of a server.
   *
   * @param iorFile file its reference is written to
   * @param naming naming service it is bound at
   * @throws IllegalArgumentException with code S-162 if the file cannot be written
   * @throws ServiceUnreachableException with code S-020 if the naming service does not take the
   *     name
   */
  static ServerPublication make(ServiceOrb orb, Optional<Path> iorFile, Optional<String> naming) {
    Optional<Runnable> unbind = naming.map(address -> orb.bind(address, ServiceKey.SERVER));
    iorFile.ifPresent(file -> write(file, orb.ior(ServiceKey.SERVER)));
    return new ServerPublication(iorFile, unbind);
  }

  /** Replaces the file in one step: a reader finds the whole reference or none. */
  private static void write(Path file, String ior) {
    Path target = file.toAbsolutePath();
    Path growing = target.resolveSibling(target.getFileName() + ".part");
    try {
      Files.writeString(growing, ior + "\n", StandardCharsets.US_ASCII);
      Files.move(growing, target, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw new IllegalArgumentException(
          MessageCode.REFERENCE_NOT_WRITTEN
              + " the server's reference cannot be written to "
              + file
              + ": "
              + FileErrors.reason(e),
          e);
    }
  }

  @Override
  public void close() {
    try {
      unbind.ifPresent(Runnable::run);
      if (iorFile.isPresent()) {
        Files.deleteIfExists(iorFile.get());
      }
    } catch (IOException | ServiceUnreachableException e) {
      LOG.warn(
          MessageCode.UNCLEAN_CLOSE + " the server's reference stays where it is: {}",
          e.toString());
    }
  }
}

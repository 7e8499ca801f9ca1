package org.mechservice.cli.service;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Option;

/** The address on which a process listens. */
public final class ListenOptions {
  private static final Pattern WITH_PORT = Pattern.compile("(\\[.*]|[^:]*):(\\d{1,9})");
  private static final int HIGHEST_PORT = 65535;

  @Option(
      names = "--listen",
      paramLabel = "ADDR[:PORT]",
      description = "Address to listen on (default: 127.0.0.1).")
  private String listen = "127.0.0.1";

  @Option(names = "--port", paramLabel = "P", description = "Port to listen on; 0: any free one.")
  private Optional<Integer> port = Optional.empty();

  /** Returns the address without its port. */
  String address() {
    Matcher withPort = WITH_PORT.matcher(listen);
    return withPort.matches() ? withPort.group(1) : listen;
  }

  /**
   * Returns the port.
   *
   * @param otherwise the port if none is given
   * @throws UsageException if it is no port, or given twice
   */
  int port(int otherwise) {
    Matcher withPort = WITH_PORT.matcher(listen);
    if (!withPort.matches()) {
      return usable(port.orElse(otherwise));
    } else if (port.isPresent()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --port "
              + port.get()
              + ": --listen "
              + listen
              + " already names a port");
    }
    return usable(Integer.parseInt(withPort.group(2)));
  }

  /**
   * Returns a port.
   *
   * @throws UsageException if it is none
   */
  public static int usable(int port) {
    if (port < 0 || port > HIGHEST_PORT) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " "
              + port
              + " is no port; there are ports from 0 (any free one) to "
              + HIGHEST_PORT);
    }
    return port;
  }
}

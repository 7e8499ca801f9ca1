package org.mechservice.cli.shell;

import java.util.Optional;
import org.mechservice.orb.tls.TlsIdentity;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The service that a command uses. */
public final class ServerOption {
  @Option(
      names = "--server",
      paramLabel = "URL[,URL...]",
      description =
          "Server as host:port or URL, the next where one is gone; this process does the work if"
              + " left out.")
  private Optional<String> address = Optional.empty();

  @Mixin private TlsOption tls = new TlsOption();

  /**
   * Returns the server's address; empty if none is given.
   *
   * @throws UsageException S-041 if it is blank, as from a variable of a script that is not set:
   *     the server meant is not this process
   */
  public String address() {
    if (address.isPresent() && address.get().isBlank()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --server lacks its value; leave it out to run here");
    }
    return address.orElse("");
  }

  public Optional<TlsIdentity> identity() {
    return tls.identity();
  }
}

package org.mechservice.cli;

import java.util.Optional;
import org.mechservice.orb.TlsIdentity;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** Which service to ask. */
final class ServerOption {
  @Option(
      names = "--server",
      paramLabel = "URL[,URL...]",
      description =
          "Server as host:port or URL, the next where one is gone; without it one is started within"
              + " this process.")
  private String address = "";

  @Mixin private TlsOption tls = new TlsOption();

  String address() {
    return address;
  }

  Optional<TlsIdentity> identity() {
    return tls.identity();
  }
}

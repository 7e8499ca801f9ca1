package org.mechservice.cli;

import picocli.CommandLine.Option;

/** Which service to ask. */
final class ServerOption {
  @Option(
      names = "--server",
      paramLabel = "URL",
      description = "Server as host:port or URL; without it one is started within this process.")
  private String address = "";

  String address() {
    return address;
  }
}

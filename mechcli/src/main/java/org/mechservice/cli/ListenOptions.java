package org.mechservice.cli;

import picocli.CommandLine.Option;

/** Where a process listens. */
final class ListenOptions {
  @Option(
      names = "--listen",
      paramLabel = "ADDR",
      description = "Address to listen on (default: ${DEFAULT-VALUE}).")
  private String address = "127.0.0.1";

  String address() {
    return address;
  }
}

package org.mechservice.cli;

import picocli.CommandLine.Option;

/** Whether a process that serves others runs what they have written. */
final class AllowUserCodeOption {
  @Option(
      names = "--allow-user-code",
      description =
          "Compile and run the classes of user forces that clients send; for trusted clients only.")
  private boolean allowed;

  boolean isGiven() {
    return allowed;
  }
}

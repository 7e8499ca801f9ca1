package org.mechservice.cli.sweep;

import java.util.Optional;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Option;

/** The number of runs at the same time. */
final class ThreadsOption {
  @Option(
      names = "--threads",
      paramLabel = "N",
      description =
          "Runs at once (default: as many as there are processors, or places on the hosts).")
  private Optional<Integer> threads = Optional.empty();

  /**
   * Returns the number given.
   *
   * @param places without one
   * @throws UsageException S-041 if it is not above 0
   */
  int or(int places) {
    if (threads.isPresent() && threads.get() < 1) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --threads is "
              + threads.get()
              + "; it must be 1 or more");
    }
    return threads.orElse(places);
  }
}

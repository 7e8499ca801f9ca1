package org.mechservice.cli.optimise;

import java.util.List;
import java.util.Optional;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A parameter or start value of a gradient: {@code k}, or {@code k=1e3:2e4}.
 *
 * @param range its ends, in the unit of its derivatives; empty if none is given
 */
record DifferentiatedBy(String name, Optional<List<Double>> range) {
  /**
   * Reads one.
   *
   * @throws UsageException S-216 if it cannot be understood
   */
  static DifferentiatedBy parse(String text) {
    int equals = text.indexOf('=');
    if (equals < 0) {
      return new DifferentiatedBy(text.strip(), Optional.empty());
    }
    String[] ends = text.substring(equals + 1).split(":", -1);
    try {
      if (ends.length == 2) {
        double from = Double.parseDouble(ends[0].strip());
        double to = Double.parseDouble(ends[1].strip());
        if (from < to && Double.isFinite(to - from)) {
          return new DifferentiatedBy(
              text.substring(0, equals).strip(), Optional.of(List.of(from, to)));
        }
      }
    } catch (NumberFormatException e) {
      throw refused(text);
    }
    throw refused(text);
  }

  private static UsageException refused(String text) {
    return new UsageException(
        MessageCode.GRADIENT_UNUSABLE
            + " --by "
            + text
            + ": write a name, or a name with a range, such as k=1e3:2e4; its end is above its"
            + " begin");
  }
}

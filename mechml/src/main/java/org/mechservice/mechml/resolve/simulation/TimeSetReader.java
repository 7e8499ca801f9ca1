package org.mechservice.mechml.resolve.simulation;

import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;

/** Reads {@code timeSet}. */
final class TimeSetReader {
  /** Largest number of output rows; more would fill a disk at 8 bytes a number. */
  private static final double MOST_ROWS = 1e9;

  /** Largest ratio of the spacing of doubles near these times to the output step. */
  private static final double FINEST = 1e-2;

  private final ValueReader values;
  private final Diagnostics diagnostics;

  TimeSetReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns the time set; empty after a reported error. */
  Optional<TimeSet> read(Element element) {
    OptionalDouble start = values.quantity(element, "tini", Quantity.TIME);
    OptionalDouble end = values.quantity(element, "tend", Quantity.TIME);
    OptionalDouble step = values.quantity(element, "tstep", Quantity.TIME);
    if (start.isEmpty() || end.isEmpty() || step.isEmpty()) {
      return Optional.empty();
    }
    TimeSet time = new TimeSet(start.getAsDouble(), end.getAsDouble(), step.getAsDouble());
    Optional<String> defect = defect(time);
    defect.ifPresent(
        d ->
            diagnostics.error(
                MessageCode.TIME_SET, element.position(), element.label() + ": " + d));
    return defect.isPresent() ? Optional.empty() : Optional.of(time);
  }

  private static Optional<String> defect(TimeSet time) {
    if (time.end() < time.start()) {
      return Optional.of(Phrase.of("tend, %s s, is before tini, %s s", time.end(), time.start()));
    }
    if (time.step() <= 0) {
      return Optional.of(Phrase.of("tstep is %s s; it must be positive", time.step()));
    }
    if ((time.end() - time.start()) / time.step() > MOST_ROWS) {
      return Optional.of(
          Phrase.of("tstep, %s s, would write more than %.0e rows", time.step(), MOST_ROWS));
    }
    double spacing = Math.ulp(Math.max(Math.abs(time.start()), Math.abs(time.end())));
    if (spacing > FINEST * time.step()) {
      return Optional.of(
          Phrase.of(
              "double-precision numbers near these times lie %s s apart, too coarse for tstep, %s"
                  + " s; start the run near 0 and shift the time in expressions instead",
              spacing, time.step()));
    }
    return Optional.empty();
  }

  /**
   * Start, end and output step of a run.
   *
   * @param start s
   * @param end s; not before the start
   * @param step time between two rows, s; positive
   */
  record TimeSet(double start, double end, double step) {}
}

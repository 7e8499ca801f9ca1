package org.mechservice.mechml.resolve;

import java.util.Optional;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Revolute;

/** Reads joints of type R. */
final class RevoluteReader implements JointReader {
  private final AxisReader axes;
  private final StartReader starts;

  RevoluteReader(AxisReader axes, StartReader starts) {
    this.axes = axes;
    this.starts = starts;
  }

  @Override
  public Optional<Joint> read(JointInput input) {
    Optional<AxisPlacement> placement = axes.read(input);
    Optional<StartValues> start = starts.read(input, JointType.R);
    if (placement.isEmpty() || start.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new Revolute(
            input.name(),
            placement.get().attachment(),
            placement.get().axis(),
            start.get().position(0),
            start.get().velocity(0),
            input.origin()));
  }
}

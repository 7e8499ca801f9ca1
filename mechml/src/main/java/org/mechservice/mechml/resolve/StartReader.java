package org.mechservice.mechml.resolve;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.unit.Dimension;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitSymbols;
import org.mechservice.solver.api.JointType;

/**
 * Reads {@code jointVal}. Its {@code unit} is that of the positions; velocities are per second of
 * it. What is not given starts at zero.
 */
final class StartReader {
  private static final Unit PER_SECOND = UnitSymbols.unit("s").orElseThrow().power(-1);

  private final ValueReader values;

  StartReader(ValueReader values) {
    this.values = values;
  }

  /** Returns the joint's start; empty if something was wrong and has been reported. */
  Optional<StartValues> read(JointInput input, JointType type) {
    List<String> positions = new ArrayList<>();
    for (int i = 0; i < type.positionCount(); i++) {
      positions.add(type.positionUnit(i));
    }
    List<String> velocities = new ArrayList<>();
    for (int i = 0; i < type.velocityCount(); i++) {
      velocities.add(type.velocityUnit(i));
    }
    Optional<List<Double>> q = list(input.start(), "posVals", positions);
    Optional<List<Double>> v = list(input.start(), "velVals", velocities);
    return q.isPresent() && v.isPresent()
        ? Optional.of(new StartValues(q.get(), v.get()))
        : Optional.empty();
  }

  private Optional<List<Double>> list(
      Optional<Element> start, String attribute, List<String> siUnits) {
    if (start.isEmpty() || start.get().attribute(attribute).isEmpty()) {
      return Optional.of(Collections.nCopies(siUnits.size(), 0.0));
    }
    List<Unit> units = new ArrayList<>();
    for (String siUnit : siUnits) {
      unit(start.get(), siUnit).ifPresent(units::add);
    }
    return units.size() == siUnits.size()
        ? values.list(start.get(), attribute, units)
        : Optional.empty();
  }

  /** Returns the unit in the file of what has a given unit in SI. */
  private Optional<Unit> unit(Element start, String siUnit) {
    return switch (siUnit) {
      case "m" -> values.unit(start, Dimension.LENGTH);
      case "rad" -> values.unit(start, Dimension.ANGLE);
      case "m/s" -> values.unit(start, Dimension.LENGTH).map(PER_SECOND::times);
      case "rad/s" -> values.unit(start, Dimension.ANGLE).map(PER_SECOND::times);
      default -> Optional.of(Unit.ONE);
    };
  }
}

package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Dimension;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitSymbols;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The units of a joint's coordinate values. The attribute {@code unit} applies to the positions of
 * its dimension; velocities are in that unit per second.
 */
public final class JointCoordinateUnits {
  private static final Unit PER_SECOND = UnitSymbols.unit("s").orElseThrow().power(-1);

  private final ValueReader values;
  private final Diagnostics diagnostics;

  public JointCoordinateUnits(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns the unit of each position; empty after a reported error, if {@code unit} fits none. */
  public Optional<List<Unit>> positions(Element element, JointType type) {
    List<String> si = new ArrayList<>();
    for (int i = 0; i < type.positionCount(); i++) {
      si.add(type.positionUnit(i));
    }
    return units(element, type, si);
  }

  /**
   * Returns the unit of each of three angles and of the positions of an S or F joint behind its
   * Euler parameters; empty after a reported error, if {@code unit} fits none.
   */
  public Optional<List<Unit>> angles(Element element, JointType type) {
    List<String> si = new ArrayList<>(List.of("rad", "rad", "rad"));
    for (int i = 4; i < type.positionCount(); i++) {
      si.add(type.positionUnit(i));
    }
    return units(element, type, si);
  }

  /** Returns the unit of each velocity; empty after a reported error, if {@code unit} fits none. */
  public Optional<List<Unit>> velocities(Element element, JointType type) {
    List<String> si = new ArrayList<>();
    for (int i = 0; i < type.velocityCount(); i++) {
      si.add(type.velocityUnit(i));
    }
    return units(element, type, si);
  }

  private Optional<List<Unit>> units(Element element, JointType type, List<String> si) {
    Optional<Unit> own = Optional.empty();
    if (element.attribute("unit").isPresent()) {
      own = values.parse(element, element.required("unit"));
      if (own.isEmpty() || !fits(element, type, own.get())) {
        return Optional.empty();
      }
    }
    List<Unit> units = new ArrayList<>();
    for (String unit : si) {
      units.add(unit(unit, own));
    }
    return Optional.of(units);
  }

  private Unit unit(String si, Optional<Unit> own) {
    return switch (si) {
      case "m" -> of(Quantity.LENGTH, own);
      case "rad" -> of(Quantity.ANGLE, own);
      case "m/s" -> of(Quantity.LENGTH, own).times(PER_SECOND);
      case "rad/s" -> of(Quantity.ANGLE, own).times(PER_SECOND);
      default -> Unit.ONE;
    };
  }

  private Unit of(Quantity quantity, Optional<Unit> own) {
    return own.filter(quantity::isMeasuredBy).orElse(values.units().of(quantity));
  }

  private boolean fits(Element element, JointType type, Unit own) {
    Set<Dimension> dimensions = new LinkedHashSet<>();
    for (int i = 0; i < type.velocityCount(); i++) {
      dimensions.add(type.velocityUnit(i).startsWith("rad") ? Dimension.ANGLE : Dimension.LENGTH);
    }
    if (dimensions.contains(own.dimension())) {
      return true;
    }
    String needed =
        dimensions.isEmpty()
            ? "the joint has no coordinates"
            : String.join(" and ", dimensions.stream().map(Dimension::toString).toList())
                + (dimensions.size() == 1 ? " is needed" : " are needed");
    diagnostics.error(
        MessageCode.WRONG_DIMENSION,
        element.position(),
        Phrase.of(
            "%s: the unit %s measures %s, but %s",
            element.label(), Quoted.of(element.required("unit")), own.dimension(), needed));
    return false;
  }
}

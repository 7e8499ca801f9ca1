package org.mechservice.mechml.resolve.joint;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.JointCoordinateUnits;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.joint.JointStart;

/**
 * Reads {@code jointVal}. Coordinates without a given value start at zero, Euler parameters at 1,
 * 0, 0, 0.
 */
final class StartReader {
  /** Deviation of the norm of Euler parameters from 1 that causes a warning: nine digits. */
  private static final double ROUNDED = 1e-9;

  /** Deviation of the norm that causes an error. */
  private static final double ROUNDED_BY_HAND = 1e-3;

  private static final List<JointType> WITH_EULER_PARAMETERS = List.of(JointType.S, JointType.F);

  private final ValueReader values;
  private final JointCoordinateUnits units;
  private final Diagnostics diagnostics;

  StartReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.units = new JointCoordinateUnits(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns a joint's start; empty after a reported error. */
  Optional<JointStart> read(Optional<Element> jointVal, JointType type) {
    JointStart atZero = JointStart.atZero(type);
    if (jointVal.isEmpty()) {
      return Optional.of(atZero);
    }
    Element element = jointVal.get();
    Optional<List<Double>> q =
        list(element, "posVals", units.positions(element, type), atZero.positions());
    Optional<List<Double>> v =
        list(element, "velVals", units.velocities(element, type), atZero.velocities());
    if (WITH_EULER_PARAMETERS.contains(type)) {
      q = q.flatMap(positions -> normalized(element, positions));
    }
    return q.isPresent() && v.isPresent()
        ? Optional.of(new JointStart(q.get(), v.get()))
        : Optional.empty();
  }

  private Optional<List<Double>> list(
      Element element, String attribute, Optional<List<Unit>> itemUnits, List<Double> open) {
    return element.attribute(attribute).isEmpty()
        ? Optional.of(open)
        : itemUnits.flatMap(units -> values.list(element, attribute, units));
  }

  private Optional<List<Double>> normalized(Element element, List<Double> q) {
    double norm = 0;
    for (double e : q.subList(0, 4)) {
      norm = StrictMath.hypot(norm, e);
    }
    String found =
        Phrase.of("%s: the Euler parameters have the norm %.12g, not 1", element.label(), norm);
    if (!(Math.abs(norm - 1) <= ROUNDED_BY_HAND)) {
      diagnostics.error(
          MessageCode.NOT_EULER_PARAMETERS,
          element.position(),
          found + "; they are cos(a/2) and the unit axis times sin(a/2), the scalar first");
      return Optional.empty();
    }
    if (Math.abs(norm - 1) > ROUNDED) {
      diagnostics.warning(
          MessageCode.EULER_PARAMETERS_NORMALIZED,
          element.position(),
          found + "; they were divided by it");
    }
    List<Double> normalized = new ArrayList<>(q);
    for (int i = 0; i < 4; i++) {
      normalized.set(i, q.get(i) / norm);
    }
    return Optional.of(normalized);
  }
}

package org.mechservice.mechml.resolve.value;

import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/** Reads {@code vector}: a direction, normalised. */
public final class DirectionReader {
  private final ValueReader values;
  private final Diagnostics diagnostics;

  public DirectionReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns the unit vector; reports a vector of length zero. */
  public Optional<Vector3> read(Element element) {
    return direction(element, "", values.vector(element, "vx", "vy", "vz", Quantity.NUMBER));
  }

  /** Returns the unit vector of a list of three components; reports one of length zero. */
  public Optional<Vector3> read(Element element, String attribute) {
    return direction(element, ": " + attribute, values.triple(element, attribute, Quantity.NUMBER));
  }

  private Optional<Vector3> direction(Element element, String what, Optional<Vector3> vector) {
    if (vector.isPresent() && !hasDirection(vector.get())) {
      diagnostics.error(
          MessageCode.ZERO_VECTOR,
          element.position(),
          Phrase.of(
              "%s%s has length %s and therefore no direction",
              element.label(), what, vector.get().norm()));
      return Optional.empty();
    }
    return vector.map(Vector3::normalized);
  }

  private static boolean hasDirection(Vector3 vector) {
    double norm = vector.norm();
    return norm >= Double.MIN_NORMAL && Double.isFinite(norm);
  }
}

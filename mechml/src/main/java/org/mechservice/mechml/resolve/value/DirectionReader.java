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
    Optional<Vector3> vector = values.vector(element, "vx", "vy", "vz", Quantity.NUMBER);
    if (vector.isPresent() && !hasDirection(vector.get())) {
      diagnostics.error(
          MessageCode.ZERO_VECTOR,
          element.position(),
          Phrase.of(
              "%s has length %s and therefore no direction", element.label(), vector.get().norm()));
      return Optional.empty();
    }
    return vector.map(Vector3::normalized);
  }

  private static boolean hasDirection(Vector3 vector) {
    double norm = vector.norm();
    return norm >= Double.MIN_NORMAL && Double.isFinite(norm);
  }
}

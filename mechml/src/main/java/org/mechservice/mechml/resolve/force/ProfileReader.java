package org.mechservice.mechml.resolve.force;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Table;

/**
 * Reads {@code profile}: heights at stations, joined by a smoothStep from each to the next. The
 * height is constant before the first and after the last station. The slope is continuous, and zero
 * at the stations.
 */
final class ProfileReader {
  private static final int MOST_STATIONS = 500;

  private final ValueReader values;
  private final Diagnostics diagnostics;

  ProfileReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns the height, m, as a function of the arc length along the surface, m. */
  Optional<Expression> read(Element element) {
    int count = AttributeText.itemsOf(element, "stations").size();
    if (count < 2 || count > MOST_STATIONS) {
      error(element, Phrase.of("it has %d stations; there must be 2 to %d", count, MOST_STATIONS));
      return Optional.empty();
    }
    Optional<List<Double>> stations = lengths(element, "stations", count);
    Optional<List<Double>> heights = lengths(element, "heights", count);
    if (stations.isEmpty() || heights.isEmpty() || !isRising(element, stations.get())) {
      return Optional.empty();
    }
    return Optional.of(height(stations.get(), heights.get()));
  }

  private Optional<List<Double>> lengths(Element element, String attribute, int count) {
    Optional<Unit> unit = values.unit(element, attribute, Quantity.LENGTH);
    return unit.flatMap(u -> values.list(element, attribute, Collections.nCopies(count, u)));
  }

  private boolean isRising(Element element, List<Double> stations) {
    for (int i = 1; i < stations.size(); i++) {
      if (!(stations.get(i) > stations.get(i - 1))) {
        error(
            element,
            Phrase.of(
                "station %d, %s m, must be greater than the one before, %s m",
                i + 1, stations.get(i), stations.get(i - 1)));
        return false;
      }
    }
    return true;
  }

  /** The cubics with the slope 0 at both ends are smoothSteps. */
  private static Expression height(List<Double> stations, List<Double> heights) {
    Table profile =
        Table.hermite(
            "profile",
            stations,
            heights,
            Collections.nCopies(stations.size(), 0.0),
            Table.Extrapolation.HOLD);
    return new Expression.TableValue(profile, List.of(new Expression.Argument()));
  }

  private void error(Element element, String message) {
    diagnostics.error(
        MessageCode.SURFACE_PROFILE, element.position(), element.label() + ": " + message);
  }
}

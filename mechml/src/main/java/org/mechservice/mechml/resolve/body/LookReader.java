package org.mechservice.mechml.resolve.body;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.mechservice.mechml.Look;
import org.mechservice.mechml.Solid;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.NameTable;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.Vector3;

/** Reads {@code look}: shapes of a body for the eye alone. */
final class LookReader {
  private static final String COLOUR = "#[0-9a-fA-F]{6}";

  private final ValueReader values;
  private final ShapeReader shapes;
  private final Diagnostics diagnostics;

  LookReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.shapes = new ShapeReader(values, diagnostics, false);
    this.diagnostics = diagnostics;
  }

  /**
   * Returns the look; empty after a reported error.
   *
   * @param points of its body, among which the names of the look's own point and those of its
   *     shapes are
   */
  Optional<Look> read(Element look, NameTable<Vector3> points) {
    List<Solid> solids = new ArrayList<>();
    for (Element shape : look.children()) {
      if (shape.name().equals("capsule")) {
        solids.addAll(shapes.capsule(shape, points));
      } else {
        shapes.read(shape, points).ifPresent(one -> solids.add(one.solid()));
      }
    }
    Optional<Vector3> origin = shapes.point(look, points);
    Optional<Vector3> axis =
        look.attribute("axis").isPresent()
            ? values.triple(look, "axis", Quantity.NUMBER)
            : Optional.of(new Vector3(0, 0, 1));
    OptionalDouble angle = values.quantityOrZero(look, "angle", Quantity.ANGLE);
    OptionalDouble opacity =
        look.attribute("opacity").isPresent()
            ? values.number(look, "opacity")
            : OptionalDouble.of(1);
    if (origin.isEmpty() || axis.isEmpty() || angle.isEmpty() || opacity.isEmpty()) {
      return Optional.empty();
    }
    if (axis.get().norm() == 0) {
      return wrong(look, "axis has no direction");
    }
    if (!(opacity.getAsDouble() > 0 && opacity.getAsDouble() <= 1)) {
      return wrong(look, "opacity is more than 0 and at most 1");
    }
    String colour = look.attribute("colour").orElse("");
    if (!colour.isEmpty() && !colour.matches(COLOUR)) {
      return wrong(look, "colour is #rrggbb in hexadecimal digits, such as #c04020");
    }
    return Optional.of(
        new Look(
            solids,
            origin.get(),
            axis.get().normalized(),
            angle.getAsDouble(),
            colour.isEmpty()
                ? OptionalInt.empty()
                : OptionalInt.of(Integer.parseInt(colour.substring(1), 16)),
            opacity.getAsDouble()));
  }

  private Optional<Look> wrong(Element look, String why) {
    diagnostics.error(
        MessageCode.SHAPE_VALUES, look.position(), Phrase.of("%s: %s", look.label(), why));
    return Optional.empty();
  }
}

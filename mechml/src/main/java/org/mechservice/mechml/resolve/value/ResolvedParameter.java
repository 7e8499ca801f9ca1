package org.mechservice.mechml.resolve.value;

import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.unit.Unit;

/**
 * A parameter of the model.
 *
 * @param element its element in the file
 * @param value in its own unit
 * @param unit its own; {@link Unit#ONE} if it has none
 * @param valueInExpressions in the file's units, angles in rad
 * @param tunable whether it remains an input of the model
 */
public record ResolvedParameter(
    Element element, double value, Unit unit, double valueInExpressions, boolean tunable) {

  public String name() {
    return element.required("name");
  }

  /** Returns its unit as the file writes it, {@code 1} if it has none. */
  public String unitSymbol() {
    return element.attribute("unit").map(String::strip).orElse("1");
  }

  /**
   * Returns whether expressions see it in rad, rad/s or another unit with the first power of rad.
   */
  boolean isOfAngles() {
    return unit.dimension().angle() == 1;
  }
}

package org.mechservice.mechml.resolve.body;

import java.util.Optional;
import java.util.OptionalDouble;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.spatial.InertiaTensor;

/** Reads {@code inertiaTensor} and checks that it is physically possible. */
final class InertiaReader {
  /**
   * Tolerance for input rounded to six digits, relative to the largest moment: the smallest moment
   * of a thin rod may become negative, the largest may exceed the sum of the others.
   */
  private static final double ROUNDING = 1e-6;

  private final ValueReader values;
  private final Diagnostics diagnostics;

  InertiaReader(ValueReader values, Diagnostics diagnostics) {
    this.values = values;
    this.diagnostics = diagnostics;
  }

  /** Returns the tensor; reports negative principal moments as an error. */
  Optional<InertiaTensor> read(Element element) {
    OptionalDouble xx = values.quantity(element, "Ixx", Quantity.INERTIA);
    OptionalDouble yy = values.quantity(element, "Iyy", Quantity.INERTIA);
    OptionalDouble zz = values.quantity(element, "Izz", Quantity.INERTIA);
    OptionalDouble xy = values.quantityOrZero(element, "Ixy", Quantity.INERTIA);
    OptionalDouble xz = values.quantityOrZero(element, "Ixz", Quantity.INERTIA);
    OptionalDouble yz = values.quantityOrZero(element, "Iyz", Quantity.INERTIA);
    boolean diagonal = xx.isPresent() && yy.isPresent() && zz.isPresent();
    if (!diagonal || xy.isEmpty() || xz.isEmpty() || yz.isEmpty()) {
      return Optional.empty();
    }
    InertiaTensor inertia =
        new InertiaTensor(
            xx.getAsDouble(),
            yy.getAsDouble(),
            zz.getAsDouble(),
            xy.getAsDouble(),
            xz.getAsDouble(),
            yz.getAsDouble());
    return isPossible(element, PrincipalMoments.of(inertia))
        ? Optional.of(inertia)
        : Optional.empty();
  }

  private boolean isPossible(Element element, double[] moments) {
    double rounding = ROUNDING * Math.max(Math.abs(moments[0]), Math.abs(moments[2]));
    if (moments[0] < -rounding) {
      diagnostics.error(
          MessageCode.NEGATIVE_INERTIA,
          element.position(),
          shown(element, moments)
              + "; none may be negative. Write Ixy, Ixz, Iyz as elements of the matrix");
      return false;
    }
    if (moments[2] - moments[1] > moments[0] + rounding) {
      diagnostics.warning(
          MessageCode.IMPOSSIBLE_INERTIA,
          element.position(),
          shown(element, moments) + "; no moment of a rigid body exceeds the sum of the other two");
    }
    return true;
  }

  private static String shown(Element element, double[] moments) {
    return Phrase.of(
        "%s: the principal moments, in kg*m^2, are %.6g, %.6g and %.6g",
        element.label(), moments[0], moments[1], moments[2]);
  }
}

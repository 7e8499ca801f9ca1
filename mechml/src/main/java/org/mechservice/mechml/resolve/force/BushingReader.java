package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.FrameReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.AttributeText;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.force.Bushing;

/**
 * Reads {@code bushing}. Its matrices are in the file's units, displacements before rotations, per
 * rad: a list of 6 is a diagonal, a list of 36 holds the rows one after the other.
 */
final class BushingReader {
  private static final int ROWS = 6;
  private static final int DISPLACEMENTS = 3;

  private final ValueReader values;
  private final FormulaReader formulas;
  private final MechanismNames names;
  private final FrameReader frames;
  private final Diagnostics diagnostics;

  /** Quantities of the four 3 × 3 blocks of a matrix. */
  private record Blocks(
      Quantity forceByDisplacement,
      Quantity forceByRotation,
      Quantity momentByDisplacement,
      Quantity momentByRotation) {

    static final Blocks STIFFNESS =
        new Blocks(
            Quantity.STIFFNESS,
            Quantity.FORCE_PER_ANGLE,
            Quantity.FORCE,
            Quantity.TORSIONAL_STIFFNESS);

    static final Blocks DAMPING =
        new Blocks(
            Quantity.DAMPING,
            Quantity.FORCE_PER_ANGULAR_SPEED,
            Quantity.TORQUE_PER_SPEED,
            Quantity.TORSIONAL_DAMPING);

    Quantity at(int row, int column) {
      if (row < DISPLACEMENTS) {
        return column < DISPLACEMENTS ? forceByDisplacement : forceByRotation;
      }
      return column < DISPLACEMENTS ? momentByDisplacement : momentByRotation;
    }
  }

  BushingReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.values = values;
    this.formulas = formulas;
    this.names = names;
    this.frames = new FrameReader(names, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the bushing; empty after a reported error. */
  Optional<Bushing> read(Element element) {
    Optional<BodyFrame> frame1 = frames.read(element.requiredChild("body1"));
    Optional<BodyFrame> frame2 = frames.read(element.requiredChild("body2"));
    Optional<List<Expression>> k = matrix(element, "k", Blocks.STIFFNESS);
    Optional<List<Expression>> c = matrix(element, "c", Blocks.DAMPING);
    Optional<List<Expression>> preload = preload(element);
    boolean numbers = k.isPresent() && c.isPresent() && preload.isPresent();
    if (frame1.isEmpty() || frame2.isEmpty() || !numbers) {
      return Optional.empty();
    }
    boolean linear = element.attribute("law").map("linear"::equals).orElse(false);
    return Optional.of(
        new Bushing(
            element.required("name"),
            frame1.get(),
            frame2.get(),
            k.get(),
            c.get(),
            preload.get(),
            linear ? Bushing.Law.LINEAR : Bushing.Law.ENERGY,
            names.origin(element)));
  }

  private Optional<List<Expression>> matrix(Element element, String attribute, Blocks blocks) {
    List<Expression> matrix = new ArrayList<>(Collections.nCopies(ROWS * ROWS, Expression.ZERO));
    if (element.attribute(attribute).isEmpty()) {
      return Optional.of(matrix);
    }
    List<AttributeText> items = AttributeText.itemsOf(element, attribute);
    if (items.size() != ROWS && items.size() != ROWS * ROWS) {
      diagnostics.error(
          MessageCode.VALUE_COUNT,
          element.position(),
          Phrase.of(
              "%s: %s holds %d value%s; 6 (a diagonal) or 36 (row by row) are needed, separated by"
                  + " \";\"",
              element.label(), attribute, items.size(), items.size() == 1 ? "" : "s"));
      return Optional.empty();
    }
    int stride = items.size() == ROWS ? ROWS + 1 : 1;
    int read = 0;
    for (int i = 0; i < items.size(); i++) {
      int at = stride * i;
      Unit unit = values.units().of(blocks.at(at / ROWS, at % ROWS));
      Optional<Expression> item = formulas.read(items.get(i), unit, FormulaRole.COEFFICIENT);
      if (item.isPresent()) {
        matrix.set(at, item.get());
        read++;
      }
    }
    return read == items.size() ? Optional.of(matrix) : Optional.empty();
  }

  private Optional<List<Expression>> preload(Element element) {
    if (element.attribute("force0").isEmpty()) {
      return Optional.of(Collections.nCopies(ROWS, Expression.ZERO));
    }
    Unit force = values.units().of(Quantity.FORCE);
    Unit torque = values.units().of(Quantity.TORQUE);
    return formulas.list(
        element,
        "force0",
        List.of(force, force, force, torque, torque, torque),
        FormulaRole.COEFFICIENT);
  }
}

package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FrameReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.force.law.ForceRow;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.mechanism.force.LawForce;

/** Reads the elements that are laws with numbers, by their rows. */
final class LawForceReader {
  private final FormulaReader formulas;
  private final MechanismNames names;
  private final FrameReader frames;

  LawForceReader(FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.names = names;
    this.frames = new FrameReader(names, diagnostics);
  }

  /** Returns the force; empty after a reported error. */
  Optional<LawForce> read(Element element, PairLaw law) {
    Optional<BodyFrame> frame1 = frames.read(element.requiredChild("body1"));
    Optional<BodyFrame> frame2 = frames.read(element.requiredChild("body2"));
    List<ForceRow.Attribute> row = law.row().orElseThrow().attributes();
    List<Expression> numbers = new ArrayList<>();
    for (ForceRow.Attribute number : row) {
      number(element, number).ifPresent(numbers::add);
    }
    if (frame1.isEmpty() || frame2.isEmpty() || numbers.size() < row.size()) {
      return Optional.empty();
    }
    return Optional.of(
        new LawForce(
            element.required("name"),
            law,
            frame1.get(),
            frame2.get(),
            numbers,
            names.origin(element)));
  }

  private Optional<Expression> number(Element element, ForceRow.Attribute number) {
    Quantity quantity = Quantity.inSi(number.unit());
    return formulas
        .coefficient(element, number.name(), quantity, number.otherwise().orElse(0.0))
        .filter(
            value ->
                formulas.satisfies(
                    element,
                    number.name(),
                    value,
                    x -> number.condition().holds(x, 0),
                    "must be " + number.condition().text()));
  }
}

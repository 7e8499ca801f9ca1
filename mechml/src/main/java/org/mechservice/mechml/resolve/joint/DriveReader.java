package org.mechservice.mechml.resolve.joint;

import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.JointCoordinateUnits;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.joint.StartRole;

/** Reads the attributes {@code driven} and {@code fixed} of {@code jointVal}. */
public final class DriveReader {
  private final FormulaReader formulas;
  private final JointCoordinateUnits units;
  private final Diagnostics diagnostics;

  public DriveReader(ValueReader values, FormulaReader formulas, Diagnostics diagnostics) {
    this.formulas = formulas;
    this.units = new JointCoordinateUnits(values, diagnostics);
    this.diagnostics = diagnostics;
  }

  /** Returns the role of a joint's start in assembly: fixed, preferred or free. */
  public static StartRole role(JointLink link) {
    Optional<Element> start = link.start();
    if (start.flatMap(s -> s.attribute("fixed")).map("true"::equals).orElse(false)) {
      return StartRole.FIXED;
    }
    return start.flatMap(s -> s.attribute("posVals")).isPresent()
        ? StartRole.PREFERRED
        : StartRole.FREE;
  }

  /** Returns one expression of time per coordinate; empty if the joint is not driven. */
  public List<Expression> motion(JointLink link) {
    if (!link.isDriven()) {
      return List.of();
    }
    Element element = link.start().orElseThrow();
    JointType type = link.type();
    if (type.positionCount() == 0 || type.positionCount() != type.velocityCount()) {
      diagnostics.error(
          MessageCode.DRIVEN_JOINT,
          element.position(),
          Phrase.of(
              "%s: a joint of type %s cannot be driven; replace it by a chain of driven joints with"
                  + " one coordinate each",
              element.label(), type));
      return List.of();
    }
    for (String overruled : List.of("posVals", "velVals")) {
      if (element.attribute(overruled).isPresent()) {
        diagnostics.warning(
            MessageCode.DRIVEN_JOINT,
            element.position(),
            Phrase.of(
                "%s: %s has no effect, because the attribute driven defines the motion",
                element.label(), overruled));
      }
    }
    return units
        .positions(element, type)
        .flatMap(u -> formulas.list(element, "driven", u, FormulaRole.MOTION))
        .orElse(List.of());
  }
}

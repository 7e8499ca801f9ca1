package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FrameReader;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.force.PairForce;

/** Reads {@code tyre}: body1 carries the road, body2 is the wheel. */
final class TyreReader {
  private final FormulaReader formulas;
  private final MechanismNames names;
  private final FrameReader frames;
  private final ContactReader surfaces;
  private final List<FurtherState> states;
  private final Diagnostics diagnostics;

  /**
   * @param states receives the deflections of tyres that have them
   */
  TyreReader(
      ValueReader values,
      FormulaReader formulas,
      MechanismNames names,
      List<FurtherState> states,
      Diagnostics diagnostics) {
    this.formulas = formulas;
    this.names = names;
    this.frames = new FrameReader(names, diagnostics);
    this.surfaces = new ContactReader(values, formulas, names, diagnostics);
    this.states = states;
    this.diagnostics = diagnostics;
  }

  /** Returns the tyre; empty after a reported error. */
  Optional<PairForce> read(Element element) {
    Element road = element.requiredChild("body1");
    Element wheel = element.requiredChild("body2");
    boolean normal = frames.direction(road, "the normal of the road").isPresent();
    boolean axle = frames.direction(wheel, "the axle of the wheel").isPresent();
    Optional<BodyFrame> frame1 = normal ? frames.read(road) : Optional.empty();
    Optional<BodyFrame> frame2 = axle ? frames.read(wheel) : Optional.empty();
    Optional<Expression> height = surfaces.height(element);
    Optional<TyreFormulas.Vertical> vertical = vertical(element);
    Optional<TyreFormulas.Curve> along = curve(element, "longitudinal");
    Optional<TyreFormulas.Curve> across = curve(element, "lateral");
    Optional<Expression> load = formulas.positive(element, "load", Quantity.FORCE);
    Optional<Expression> rest =
        element.attribute("restSpeed").isPresent()
            ? formulas.positive(element, "restSpeed", Quantity.SPEED)
            : Optional.of(Expression.of(0.01));
    Optional<Expression> rolling = formulas.notNegative(element, "rolling", Quantity.NUMBER);
    boolean frame = frame1.isPresent() && frame2.isPresent() && height.isPresent();
    boolean shape = vertical.isPresent() && along.isPresent() && across.isPresent();
    boolean rest2 = load.isPresent() && rest.isPresent() && rolling.isPresent();
    if (!frame || !shape || !rest2) {
      return Optional.empty();
    }
    return Optional.of(
        new TyreFormulas(
                RelativeFrames.of(frame1.get(), frame2.get()),
                vertical.get(),
                along.get(),
                across.get(),
                load.get(),
                rest.get(),
                rolling.get(),
                height.get())
            .force(element.required("name"), states, names.origin(element)));
  }

  private Optional<TyreFormulas.Vertical> vertical(Element element) {
    Optional<Expression> radius = formulas.positive(element, "radius", Quantity.LENGTH);
    Optional<Expression> stiffness = formulas.positive(element, "stiffness", Quantity.STIFFNESS);
    Optional<Expression> damping = formulas.notNegative(element, "damping", Quantity.DAMPING);
    Optional<Expression> smoothing = formulas.notNegative(element, "smoothing", Quantity.LENGTH);
    return radius.isPresent()
            && stiffness.isPresent()
            && damping.isPresent()
            && smoothing.isPresent()
        ? Optional.of(
            new TyreFormulas.Vertical(
                radius.get(), stiffness.get(), damping.get(), smoothing.get()))
        : Optional.empty();
  }

  private Optional<TyreFormulas.Curve> curve(Element element, String attribute) {
    Optional<List<Expression>> once = numbers(element, attribute);
    Optional<List<Expression>> twice =
        element.attribute(attribute + "2").isPresent()
            ? numbers(element, attribute + "2")
            : once.map(TyreReader::doubled);
    Optional<Expression> stiffness =
        formulas.notNegative(element, attribute + "Stiffness", Quantity.STIFFNESS);
    Optional<Expression> damping =
        element.attribute(attribute + "Stiffness").isPresent()
            ? formulas.positive(element, attribute + "Damping", Quantity.DAMPING)
            : formulas.notNegative(element, attribute + "Damping", Quantity.DAMPING);
    if (element.attribute(attribute + "Stiffness").isEmpty()
        && element.attribute(attribute + "Damping").isPresent()) {
      error(element, attribute + "Damping has no meaning without " + attribute + "Stiffness");
      return Optional.empty();
    }
    return once.isPresent() && twice.isPresent() && stiffness.isPresent() && damping.isPresent()
        ? Optional.of(
            new TyreFormulas.Curve(
                attribute, once.get(), twice.get(), stiffness.get(), damping.get()))
        : Optional.empty();
  }

  /** Returns forces twice as large at the same slips. */
  private static List<Expression> doubled(List<Expression> once) {
    List<Expression> twice = new ArrayList<>(once);
    for (int force : new int[] {0, 2, 4}) {
      twice.set(force, ExpressionAlgebra.times(2, once.get(force)));
    }
    return twice;
  }

  /** Returns the five numbers of a curve at one load, checked. */
  private Optional<List<Expression>> numbers(Element element, String attribute) {
    List<Expression> numbers = new ArrayList<>();
    for (int i = 0; i < 5; i++) {
      Quantity quantity = i % 2 == 0 ? Quantity.FORCE : Quantity.NUMBER;
      formulas
          .item(element, attribute, 5, i, quantity)
          .filter(n -> formulas.satisfies(element, attribute, n, x -> x > 0, "must be positive"))
          .ifPresent(numbers::add);
    }
    return numbers.size() == 5 && isCurve(element, attribute, numbers)
        ? Optional.of(numbers)
        : Optional.empty();
  }

  private boolean isCurve(Element element, String attribute, List<Expression> numbers) {
    double[] n = new double[5];
    for (int i = 0; i < 5; i++) {
      if (!(numbers.get(i) instanceof Expression.Constant constant)) {
        return true;
      }
      n[i] = constant.value();
    }
    if (n[0] * n[1] < 2 * n[2]) {
      error(
          element,
          Phrase.of(
              "%s: slope times slip at the maximum is %s N, less than twice the maximum, %s N, so"
                  + " that the curve has no maximum there; enlarge the slope or the slip",
              attribute, n[0] * n[1], n[2]));
      return false;
    }
    if (n[3] <= n[1] || n[4] > n[2]) {
      error(
          element,
          attribute
              + ": sliding begins beyond the slip of the maximum, with at most its force; the list"
              + " is slope; slip and force of the maximum; slip and force of sliding");
      return false;
    }
    return true;
  }

  private void error(Element element, String message) {
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES, element.position(), element.label() + ": " + message);
  }
}

package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.formula.RopeReader;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.PathMotion;
import org.mechservice.solver.expression.Expression.StateValue;
import org.mechservice.solver.expression.ScalarFormulas;
import org.mechservice.solver.force.law.MuscleLaw;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.force.PathForce;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;

/**
 * Reads {@code pathForce} and {@code muscle}. A muscle is a state, its activation, and a tension of
 * it.
 */
final class PathForceReader {
  /** Numbers of a muscle whose element does not give them: those of MuJoCo. */
  private static final Map<String, Double> DEFAULTS =
      new TreeMap<>(
          Map.of(
              "low", 0.75,
              "high", 1.05,
              "lmin", 0.5,
              "lmax", 1.6,
              "vmax", 1.5,
              "fpmax", 1.3,
              "fvmax", 1.2,
              "activationTime", 0.01,
              "deactivationTime", 0.04));

  private final FormulaReader formulas;
  private final RopeReader ropes;
  private final MechanismNames names;
  private final List<FurtherState> states;
  private final Diagnostics diagnostics;

  PathForceReader(
      ValueReader values,
      FormulaReader formulas,
      MechanismNames names,
      List<FurtherState> states,
      Diagnostics diagnostics) {
    this.formulas = formulas;
    this.ropes = new RopeReader(values, formulas, names, diagnostics);
    this.names = names;
    this.states = states;
    this.diagnostics = diagnostics;
  }

  /** Reads {@code pathForce}; empty after a reported error. */
  Optional<PathForce> pathForce(Element element) {
    Optional<RopeReader.Rope> path = ropes.readOrSum(element);
    Optional<Expression> tension =
        formulas.read(element, "expression", Quantity.FORCE, FormulaRole.TENSION);
    return path.flatMap(way -> tension.map(force -> of(element, way, force)));
  }

  private PathForce of(Element element, RopeReader.Rope way, Expression tension) {
    return of(element, way, tension, way.changes());
  }

  private PathForce of(
      Element element, RopeReader.Rope way, Expression tension, List<Expression> watched) {
    return new PathForce(
        element.required("name"),
        way.length(),
        tension,
        watched,
        way.points(),
        names.origin(element));
  }

  /** Reads {@code muscle}; empty after a reported error. */
  Optional<PathForce> muscle(Element element) {
    Optional<RopeReader.Rope> path = ropes.readOrSum(element);
    Optional<Expression> excitation =
        formulas.read(element, "excitation", Quantity.NUMBER, FormulaRole.STATE);
    Optional<Expression> start = formulas.coefficient(element, "activation", Quantity.NUMBER, 0);
    Optional<Expression> blend = formulas.notNegative(element, "blend", Quantity.NUMBER);
    List<Optional<Expression>> read = new ArrayList<>();
    read.add(formulas.notNegative(element, "force", Quantity.FORCE));
    read.add(formulas.coefficient(element, "shortest", Quantity.LENGTH, 0));
    read.add(formulas.coefficient(element, "longest", Quantity.LENGTH, 0));
    for (String name : List.of("low", "high", "lmin", "lmax", "vmax", "fpmax", "fvmax")) {
      read.add(number(element, name, Quantity.NUMBER));
    }
    for (String name : List.of("activationTime", "deactivationTime")) {
      read.add(number(element, name, Quantity.TIME));
    }
    if (path.isEmpty()
        || excitation.isEmpty()
        || start.isEmpty()
        || blend.isEmpty()
        || read.stream().anyMatch(Optional::isEmpty)) {
      return Optional.empty();
    }
    List<Expression> given = read.stream().map(Optional::orElseThrow).toList();
    if (!isPossible(element, start.get(), blend.get(), given)) {
      return Optional.empty();
    }
    return Optional.of(
        muscle(element, path.get(), excitation.get(), start.get(), blend.get(), given));
  }

  private Optional<Expression> number(Element element, String name, Quantity quantity) {
    double otherwise = DEFAULTS.getOrDefault(name, 0.0);
    Optional<Expression> read = formulas.coefficient(element, name, quantity, otherwise);
    return name.startsWith("l")
        ? read
        : read.filter(
            x -> formulas.satisfies(element, name, x, value -> value >= 0, "must not be negative"));
  }

  private boolean isPossible(
      Element element, Expression start, Expression blend, List<Expression> given) {
    if (!(start instanceof Expression.Constant) || !(blend instanceof Expression.Constant)) {
      return refuse(element, "activation and blend are numbers, of no tunable parameter");
    }
    return rises(element, given.get(1), given.get(2), "longest is not above shortest")
        && rises(element, given.get(3), given.get(4), "high is not above low")
        && rises(element, given.get(5), given.get(6), "lmax is not above lmin");
  }

  private boolean rises(Element element, Expression low, Expression high, String message) {
    boolean known = low instanceof Expression.Constant && high instanceof Expression.Constant;
    return !known
        || ((Expression.Constant) low).value() < ((Expression.Constant) high).value()
        || refuse(element, message);
  }

  private boolean refuse(Element element, String message) {
    diagnostics.error(
        MessageCode.FORCE_ATTRIBUTES, element.position(), element.label() + ": " + message);
    return false;
  }

  private PathForce muscle(
      Element element,
      RopeReader.Rope way,
      Expression excitation,
      Expression start,
      Expression blend,
      List<Expression> given) {
    Expressions e = new Expressions();
    List<Expression> leaves = new ArrayList<>();
    List<Scalar> numbers = given.stream().map(one -> scalar(e, one, leaves)).toList();
    Scalar length = scalar(e, PathMotion.LENGTH, leaves);
    Scalar rate = scalar(e, PathMotion.RATE, leaves);
    Scalar activation = scalar(e, new StateValue(states.size()), leaves);
    Scalar wish = scalar(e, excitation, leaves);
    MuscleLaw law =
        new MuscleLaw(
            e,
            numbers.get(0),
            numbers.get(1),
            numbers.get(2),
            numbers.get(3),
            numbers.get(4),
            numbers.get(5),
            numbers.get(6),
            numbers.get(7),
            numbers.get(8),
            numbers.get(9));
    double width = ((Expression.Constant) blend).value();
    Scalar change =
        MuscleLaw.activationRate(wish, activation, numbers.get(10), numbers.get(11), width);
    Scalar stretch = law.stretch(scalar(e, way.length(), leaves));
    ScalarFormulas written = new ScalarFormulas(leaves);
    states.add(
        new FurtherState(
            element.required("name") + ".activation",
            ((Expression.Constant) start).value(),
            written.of(change),
            "1",
            0,
            names.origin(element)));
    List<Expression> watched = new ArrayList<>(way.changes());
    watched.add(Expression.call(MathFunction.MAX, List.of(Expression.ZERO, written.of(stretch))));
    return of(element, way, written.of(law.tension(length, rate, activation)), watched);
  }

  private static Scalar scalar(Expressions e, Expression leaf, List<Expression> leaves) {
    if (leaf instanceof Expression.Constant constant) {
      return e.constant(constant.value());
    }
    leaves.add(leaf);
    return e.input(leaves.size() - 1);
  }
}

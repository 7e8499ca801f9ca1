package org.mechservice.mechml.resolve.formula;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.mechml.diagnosis.NearestName;
import org.mechservice.mechml.diagnosis.Phrase;
import org.mechservice.mechml.diagnosis.Quoted;
import org.mechservice.mechml.expression.ExpressionException;
import org.mechservice.mechml.expression.ParsedExpression;
import org.mechservice.mechml.expression.Scope;
import org.mechservice.mechml.resolve.body.BodyDefinition;
import org.mechservice.mechml.resolve.value.ParameterTable;
import org.mechservice.mechml.resolve.value.ResolvedParameter;
import org.mechservice.mechml.unit.Dimension;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitSystem;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.PointFunction;
import org.mechservice.solver.spatial.Vector3;

/**
 * Resolves the names in a formula: {@code t}, {@code s}, parameters, states, {@code joint.q},
 * {@code joint.v[2]}, {@code body.point.vx}. In formulas lengths are in the file's unit and angles
 * in rad.
 */
final class FormulaNames {
  private static final List<String> POINT_COMPONENTS = List.of("x", "y", "z", "vx", "vy", "vz");

  private final MechanismNames names;
  private final ParameterTable parameters;
  private final UnitSystem units;

  FormulaNames(MechanismNames names, ParameterTable parameters, UnitSystem units) {
    this.names = names;
    this.parameters = parameters;
    this.units = units;
  }

  /**
   * Returns the expression of a name, in the units of formulas.
   *
   * @throws ExpressionException if the name is unknown or not allowed in this role
   */
  Expression leaf(ParsedExpression.Reference name, FormulaRole role) throws ExpressionException {
    Optional<ResolvedParameter> parameter = parameters.find(name);
    if (parameter.isPresent() && name.text().equals("s") && role == FormulaRole.HEIGHT) {
      throw new ExpressionException(
          MessageCode.UNUSABLE_NAME,
          name.offset(),
          "s is the arc length along the surface here, and the name of a parameter, too; rename"
              + " the parameter");
    }
    Optional<Expression.PathMotion> ofPath = pathMotion(name, role);
    if (ofPath.isPresent() && (parameter.isPresent() || names.signal(name.text()).isPresent())) {
      throw new ExpressionException(
          MessageCode.UNUSABLE_NAME,
          name.offset(),
          name.text() + " is that of the path here, and a name of the model, too; rename that");
    }
    if (parameter.isPresent()) {
      return parameter(parameter.get());
    }
    if (name.text().equals("t")) {
      require(role.allowsTime(), name, role);
      return new Expression.Time();
    }
    if (name.text().equals("s") && role == FormulaRole.HEIGHT) {
      return scaled(new Expression.Argument(), units.length());
    }
    if (ofPath.isPresent()) {
      return scaled(ofPath.get(), units.length());
    }
    Optional<Signal> signal = names.signal(String.join(".", name.names()));
    if (signal.isPresent() && name.index().isEmpty()) {
      require(role.allowsStates(), name, role);
      return signal.get().value(name.offset());
    }
    if (name.names().size() == 2 && !name.text().equals("Math.PI")) {
      return coordinate(name, role);
    }
    if (name.names().size() == 3) {
      return point(name, role);
    }
    List<String> known = new ArrayList<>(parameters.names());
    known.addAll(names.jointNames());
    known.addAll(names.signalNames());
    known.add("t");
    return new Expression.Constant(Scope.constant(name, known));
  }

  /** Returns what {@code length} and {@code rate} are in a tension. */
  private static Optional<Expression.PathMotion> pathMotion(
      ParsedExpression.Reference name, FormulaRole role) {
    if (role != FormulaRole.TENSION || name.index().isPresent()) {
      return Optional.empty();
    }
    return switch (name.text()) {
      case "length" -> Optional.of(Expression.PathMotion.LENGTH);
      case "rate" -> Optional.of(Expression.PathMotion.RATE);
      default -> Optional.empty();
    };
  }

  /**
   * Returns the dimension of a name that is no parameter and that {@link #leaf} knows; empty if it
   * may be any, as that of a state.
   */
  Optional<Dimension> dimension(ParsedExpression.Reference name) {
    if (name.text().equals("t")) {
      return Optional.of(Dimension.TIME);
    }
    if (names.signal(String.join(".", name.names())).isPresent()) {
      return Optional.empty();
    }
    Dimension perTime = Dimension.TIME.power(-1);
    String last = name.names().get(name.names().size() - 1);
    if (name.names().size() == 3) {
      return Optional.of(last.startsWith("v") ? Dimension.LENGTH.times(perTime) : Dimension.LENGTH);
    }
    if (name.names().size() == 2) {
      return names
          .joint(name.names().get(0))
          .map(joint -> dimension(joint, name.index().orElse(0), last.equals("v")));
    }
    return Optional.empty();
  }

  /** Returns whether a name that is no parameter is an angle or an angular speed of a joint. */
  boolean isInRadians(ParsedExpression.Reference name) {
    return name.names().size() == 2
        && names.signal(String.join(".", name.names())).isEmpty()
        && names
            .joint(name.names().get(0))
            .filter(
                joint ->
                    unit(joint, name.index().orElse(0), name.names().get(1).equals("v"))
                        .startsWith("rad"))
            .isPresent();
  }

  private static String unit(ResolvedJoint joint, int component, boolean velocity) {
    return velocity ? joint.type().velocityUnit(component) : joint.type().positionUnit(component);
  }

  private static Dimension dimension(ResolvedJoint joint, int component, boolean velocity) {
    String unit = unit(joint, component, velocity);
    Dimension length = unit.startsWith("m") ? Dimension.LENGTH : Dimension.NONE;
    return velocity ? length.times(Dimension.TIME.power(-1)) : length;
  }

  /** Returns the tables and maps by name. */
  Map<String, PointFunction> tables() {
    return names.tables();
  }

  /** Returns the number of arguments of each table and map, by its name. */
  Map<String, Integer> argumentCounts() {
    Map<String, Integer> counts = new HashMap<>();
    names.tables().forEach((name, table) -> counts.put(name, table.argumentCount()));
    return counts;
  }

  private Expression parameter(ResolvedParameter parameter) {
    if (!parameter.tunable()) {
      return new Expression.Constant(parameter.valueInExpressions());
    }
    Unit unit = units.inExpressions(parameter.unit().dimension());
    return scaled(new Expression.ParameterValue(parameters.indexOf(parameter)), unit);
  }

  private Expression coordinate(ParsedExpression.Reference name, FormulaRole role)
      throws ExpressionException {
    ResolvedJoint joint = joint(name);
    String kind = name.names().get(1);
    if (!kind.equals("q") && !kind.equals("v")) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_NAME,
          name.offset(),
          Phrase.of("%s: a joint has q and v", Quoted.of(name.text())));
    }
    boolean position = kind.equals("q");
    require(position ? role.allowsPositions() : role == FormulaRole.STATE, name, role);
    int component = component(name, joint, position);
    if (position) {
      return position(joint, component);
    }
    return scaled(
        new Expression.CoordinateVelocity(joint.coordinate(component)),
        joint.turns(component) ? Unit.ONE : units.length());
  }

  /** Returns a joint's position in the units of formulas. */
  Expression position(ResolvedJoint joint, int component) {
    boolean length = joint.type().positionUnit(component).equals("m");
    return scaled(
        new Expression.CoordinatePosition(joint.coordinate(component)),
        length ? units.length() : Unit.ONE);
  }

  private ResolvedJoint joint(ParsedExpression.Reference name) throws ExpressionException {
    String joint = name.names().get(0);
    Optional<ResolvedJoint> found = names.joint(joint);
    if (found.isPresent()) {
      return found.get();
    }
    String hint =
        names.bodyNames().contains(joint)
            ? "; it is a body: its points are written "
                + Quoted.plain(joint)
                + ".point.x, .y, .z, .vx, .vy, .vz"
            : NearestName.suggestion(joint, names.jointNames());
    throw unknown(name, "there is no joint " + Quoted.of(joint) + hint);
  }

  private static int component(
      ParsedExpression.Reference name, ResolvedJoint joint, boolean position)
      throws ExpressionException {
    int count = position ? joint.type().positionCount() : joint.type().velocityCount();
    if (name.index().isEmpty() && count == 1) {
      return 0;
    }
    if (name.index().isPresent() && name.index().getAsInt() < count) {
      return name.index().getAsInt();
    }
    String joined = String.join(".", name.names());
    String has =
        switch (count) {
          case 0 -> "none: it is a weld";
          case 1 -> joined + " only";
          default -> joined + "[0] to " + joined + "[" + (count - 1) + "]";
        };
    throw new ExpressionException(
        MessageCode.UNKNOWN_COORDINATE,
        name.offset(),
        Phrase.of("%s: a joint of type %s has %s", Quoted.of(name.text()), joint.type(), has));
  }

  private Expression point(ParsedExpression.Reference name, FormulaRole role)
      throws ExpressionException {
    String body = name.names().get(0);
    String point = name.names().get(1);
    int component = POINT_COMPONENTS.indexOf(name.names().get(2));
    BodyDefinition parts =
        names
            .body(body)
            .orElseThrow(
                () ->
                    unknown(
                        name,
                        "there is no body "
                            + Quoted.of(body)
                            + NearestName.suggestion(body, names.bodyNames())));
    if (!parts.points().names().contains(point)) {
      throw unknown(
          name,
          Phrase.of(
              "body %s has no point %s%s",
              Quoted.of(body),
              Quoted.of(point),
              NearestName.suggestion(point, parts.points().names())));
    }
    if (component < 0 || name.index().isPresent()) {
      throw unknown(
          name, Quoted.of(name.text()) + ": a point has " + String.join(", ", POINT_COMPONENTS));
    }
    require(role == FormulaRole.STATE || (component < 3 && role.allowsPositions()), name, role);
    parts.points().use(point);
    Vector3 position = parts.points().value(point).orElse(Vector3.ZERO);
    BodyPoint place = new BodyPoint(names.indexOf(parts), position);
    return scaled(
        component < 3
            ? new Expression.PointPosition(place, component)
            : new Expression.PointVelocity(place, component - 3),
        units.length());
  }

  private static ExpressionException unknown(ParsedExpression.Reference name, String message) {
    return new ExpressionException(MessageCode.EXPRESSION_NAME, name.offset(), message);
  }

  private static void require(boolean allowed, ParsedExpression.Reference name, FormulaRole role)
      throws ExpressionException {
    if (!allowed) {
      throw new ExpressionException(
          MessageCode.EXPRESSION_NAME,
          name.offset(),
          Quoted.of(name.text()) + " is not permitted here: " + role.rule());
    }
  }

  /** Returns a value given in SI in a unit. */
  private static Expression scaled(Expression si, Unit unit) {
    return quotient(product(si, unit.denominator()), unit.numerator());
  }

  /** Returns a value given in a unit in SI. */
  static Expression toSi(Expression value, Unit unit) {
    if (value instanceof Expression.Constant constant) {
      return new Expression.Constant(unit.toSi(constant.value()) + 0.0);
    }
    return quotient(product(value, unit.numerator()), unit.denominator());
  }

  private static Expression product(Expression value, double factor) {
    return factor == 1 ? value : new Expression.Product(value, new Expression.Constant(factor));
  }

  private static Expression quotient(Expression value, double divisor) {
    return divisor == 1 ? value : new Expression.Quotient(value, new Expression.Constant(divisor));
  }
}

package org.mechservice.mechml.resolve.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.mechservice.mechml.diagnosis.Diagnostics;
import org.mechservice.mechml.document.Element;
import org.mechservice.mechml.resolve.formula.FormulaReader;
import org.mechservice.mechml.resolve.formula.FormulaRole;
import org.mechservice.mechml.resolve.formula.MechanismNames;
import org.mechservice.mechml.resolve.value.ValueReader;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.spatial.Vector3;

/**
 * Reads {@code gravity}: a constant acceleration, or one of time, which is a force at the centre of
 * mass of every body.
 */
public final class GravityReader {
  private static final Pattern TIME = Pattern.compile("\\bt\\b");
  private static final List<String> COMPONENTS = List.of("gx", "gy", "gz");

  private final ValueReader values;
  private final FormulaReader formulas;
  private final MechanismNames names;
  private final Diagnostics diagnostics;

  public GravityReader(
      ValueReader values, FormulaReader formulas, MechanismNames names, Diagnostics diagnostics) {
    this.values = values;
    this.formulas = formulas;
    this.names = names;
    this.diagnostics = diagnostics;
  }

  /** Returns the element of a model, if it has one. */
  private static Optional<Element> element(Element model) {
    return model.child("Forces").flatMap(forces -> forces.child("gravity"));
  }

  private static boolean dependsOnTime(Element gravity) {
    return COMPONENTS.stream().anyMatch(g -> TIME.matcher(gravity.required(g)).find());
  }

  /** Returns the constant acceleration, zero for one of time; empty after a reported error. */
  public Optional<Vector3> constant(Element model) {
    return element(model)
        .filter(gravity -> !dependsOnTime(gravity))
        .map(gravity -> values.vector(gravity, "gx", "gy", "gz", Quantity.ACCELERATION))
        .orElse(Optional.of(Vector3.ZERO));
  }

  /**
   * Returns the forces of an acceleration that depends on time; none for a constant one, and after
   * a reported error.
   *
   * @param bodies the moving bodies in the mechanism's order
   * @param closures the closures of loops, whose rods must have no mass
   */
  public List<ForceElement> overTime(Element model, List<Body> bodies, List<LoopClosure> closures) {
    Optional<Element> moving = element(model).filter(GravityReader::dependsOnTime);
    if (moving.isEmpty() || refusesRods(moving.get(), closures)) {
      return List.of();
    }
    Element gravity = moving.get();
    List<Expression> acceleration = new ArrayList<>();
    for (String component : COMPONENTS) {
      formulas
          .read(gravity, component, Quantity.ACCELERATION, FormulaRole.GRAVITY)
          .ifPresent(acceleration::add);
    }
    List<ForceElement> forces = new ArrayList<>();
    for (int i = 0; acceleration.size() == 3 && i < bodies.size(); i++) {
      Body body = bodies.get(i);
      if (body.mass() > 0) {
        List<Expression> load = new ArrayList<>();
        acceleration.forEach(g -> load.add(ExpressionAlgebra.times(body.mass(), g)));
        load.addAll(List.of(Expression.ZERO, Expression.ZERO, Expression.ZERO));
        forces.add(
            new ForceTorque(
                "gravity." + body.name(),
                new BodyPoint(i, body.centerOfMass()),
                ForceTorque.Axes.WORLD,
                load,
                names.origin(gravity)));
      }
    }
    return forces;
  }

  private boolean refusesRods(Element gravity, List<LoopClosure> closures) {
    for (LoopClosure closure : closures) {
      if (closure instanceof DistanceClosure rod && rod.hasRod()) {
        diagnostics.error(
            MessageCode.FORCE_ATTRIBUTES,
            gravity.position(),
            "gravity that depends on t does not act on the rod of DISTConstraint \""
                + rod.name()
                + "\", which has a mass; give that mass to a body, or make gravity constant");
        return true;
      }
    }
    return false;
  }
}

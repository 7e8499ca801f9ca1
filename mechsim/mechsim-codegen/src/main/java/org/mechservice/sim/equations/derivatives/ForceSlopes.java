package org.mechservice.sim.equations.derivatives;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.ParentTransform;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.EulerParameterTerms;
import org.mechservice.solver.step.Twist;
import org.mechservice.solver.step.Wrench;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Terms of applied forces in the derivatives of the residual: −Sᵀ ∂w − ∂τ for each velocity and
 * each position along the tangent. The formulas of the forces are differentiated one direction at a
 * time; the derivatives of the wrenches are swept inwards from their links.
 */
final class ForceSlopes {
  private final Expressions expressions;
  private final Links mechanism;
  private final Coordinates coordinates;
  private final TreeOrder places;
  private final Loads loads;
  private final ParentTransform toParent;
  private final List<List<Twist>> subspaces = new ArrayList<>();

  /** By row and column place. */
  private final @Nullable Scalar[][] byPosition;

  private final @Nullable Scalar[][] byVelocity;

  ForceSlopes(
      Expressions expressions,
      Links mechanism,
      Coordinates coordinates,
      TreeOrder places,
      Loads loads,
      JointColumns columns) {
    this.expressions = expressions;
    this.mechanism = mechanism;
    this.coordinates = coordinates;
    this.places = places;
    this.loads = loads;
    this.toParent = new ParentTransform(coordinates);
    mechanism.links().forEach(link -> subspaces.add(columns.subspace(link)));
    byPosition = new Scalar[places.size()][places.size()];
    byVelocity = new Scalar[places.size()][places.size()];
  }

  /** Differentiates all forces. */
  void derive() {
    for (int place = 0; place < places.size(); place++) {
      sweep(place, alongPosition(place), byPosition);
      sweep(place, alongVelocity(place), byVelocity);
    }
  }

  /** Returns the changes of inputs by a small displacement along the tangent. */
  private Map<Scalar, Scalar> alongPosition(int place) {
    TreeOrder.Place at = places.get(place);
    Link link = mechanism.links().get(at.link());
    Map<Scalar, Scalar> turn = new HashMap<>();
    if (link.isBall()) {
      EulerParameterTerms e = coordinates.eulerParameters(link);
      EulerParameterTerms rate = e.rate(unit(at.component()));
      for (int i = 0; i < 4; i++) {
        turn.put(e.at(i), rate.at(i));
      }
    } else {
      turn.put(expressions.input(link.position()), expressions.one());
    }
    return turn;
  }

  private Map<Scalar, Scalar> alongVelocity(int place) {
    int velocity = mechanism.positionCount() + places.get(place).velocity();
    return Map.of(expressions.input(velocity), expressions.one());
  }

  private ScalarVector unit(int axis) {
    Scalar zero = expressions.zero();
    Scalar one = expressions.one();
    return new ScalarVector(axis == 0 ? one : zero, axis == 1 ? one : zero, axis == 2 ? one : zero);
  }

  /**
   * Outputs what further states add, in the layout of {@link
   * org.mechservice.solver.dynamics.derivative.FurtherDerivatives}.
   *
   * @param rates derivatives of the further states
   * @param at index of the first output
   */
  void putOutFurther(Program program, List<Scalar> rates, int at) {
    int ns = rates.size();
    int nv = places.size();
    int firstState = mechanism.positionCount() + mechanism.velocityCount();
    Scalar[][] byState = new Scalar[nv][ns];
    for (int k = 0; k < ns; k++) {
      Map<Scalar, Scalar> direction = Map.of(expressions.input(firstState + k), expressions.one());
      sweep(k, direction, byState);
      for (int row = 0; row < nv; row++) {
        Scalar element = byState[row][k];
        if (element != null) {
          program.output(at + places.get(row).velocity() * ns + k, element);
        }
      }
      putOutRates(program, rates, direction, at + 3 * nv * ns + k, ns);
    }
    for (int place = 0; ns > 0 && place < nv; place++) {
      int column = places.get(place).velocity();
      putOutRates(program, rates, alongPosition(place), at + nv * ns + column, nv);
      putOutRates(program, rates, alongVelocity(place), at + 2 * nv * ns + column, nv);
    }
  }

  private void putOutRates(
      Program program, List<Scalar> rates, Map<Scalar, Scalar> direction, int at, int step) {
    Differentiation slope = new Differentiation(expressions, direction);
    for (int i = 0; i < rates.size(); i++) {
      Scalar element = slope.of(rates.get(i));
      if (!element.isZero()) {
        program.output(at + i * step, element);
      }
    }
  }

  private void sweep(int column, Map<Scalar, Scalar> direction, @Nullable Scalar[][] into) {
    Differentiation rate = new Differentiation(expressions, direction);
    int count = mechanism.links().size();
    Wrench[] changes = new Wrench[count];
    ScalarVector none = ScalarVector.zero(expressions);
    Arrays.fill(changes, new Wrench(none, none));
    for (int i = count - 1; i >= 0; i--) {
      Link link = mechanism.links().get(i);
      Wrench on = loads.on(i);
      changes[i] = changes[i].plus(new Wrench(on.moment().map(rate::of), on.force().map(rate::of)));
      ScalarVector inJoint = loads.of(i);
      ScalarVector toState =
          (link.isBall() ? coordinates.ballToState(link, inJoint) : inJoint).map(rate::of);
      int[] rows = places.of(i);
      for (int r = 0; r < rows.length; r++) {
        Scalar borne = subspaces.get(i).get(r).dot(changes[i]);
        Scalar sum = borne.plus(toState.at(link.isBall() ? r : 2)).negated();
        if (!sum.isZero()) {
          into[rows[r]][column] = sum;
        }
      }
      if (link.parent() != Links.ROOT) {
        changes[link.parent()] = changes[link.parent()].plus(toParent.wrench(link, changes[i]));
      }
    }
  }

  /**
   * Returns the elements of forces in addition to those of the tree, two places for each. The three
   * velocities of a ball are coupled together, because the rotation of its columns mixes them.
   */
  List<Integer> coupled() {
    List<Integer> coupled = new ArrayList<>();
    for (int i = 0; i < mechanism.links().size(); i++) {
      for (int j = 0; j < i; j++) {
        if (couples(places.of(i), places.of(j))) {
          addAll(places.of(i), places.of(j), coupled);
        }
      }
    }
    return coupled;
  }

  private boolean couples(int[] rows, int[] columns) {
    for (int i : rows) {
      for (int j : columns) {
        boolean any =
            byPosition[i][j] != null
                || byPosition[j][i] != null
                || byVelocity[i][j] != null
                || byVelocity[j][i] != null;
        if (any && !places.isOnWay(j, i)) {
          return true;
        }
      }
    }
    return false;
  }

  private static void addAll(int[] rows, int[] columns, List<Integer> coupled) {
    for (int i : rows) {
      for (int j : columns) {
        coupled.addAll(List.of(i, j));
      }
    }
  }

  /** Returns the terms in ∂F/∂q. */
  Scalar byPosition(int row, int column) {
    return orZero(byPosition[row][column]);
  }

  /** Returns the terms in ∂F/∂v. */
  Scalar byVelocity(int row, int column) {
    return orZero(byVelocity[row][column]);
  }

  private Scalar orZero(@Nullable Scalar value) {
    return value == null ? expressions.zero() : value;
  }
}

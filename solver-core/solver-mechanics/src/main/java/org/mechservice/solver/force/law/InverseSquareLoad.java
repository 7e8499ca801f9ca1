package org.mechservice.solver.force.law;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Attraction of two points by the inverse square of their distance: gravity, or charges. With the
 * way r between the points and R = √(r² + ε²) the force on point 2 is −k r / R³, its energy −k / R.
 * The softening ε is that of H. C. Plummer, Mon. Not. R. Astron. Soc. 71 (1911) 460, for points
 * that pass through each other.
 */
final class InverseSquareLoad implements PairLoad {
  static final ForceRow ROW =
      new ForceRow(
          "inverseSquareForce",
          "between two points",
          "attraction strength·r/(r² + softening²)^(3/2)",
          "potential",
          List.of(
              new ForceRow.Attribute(
                  "strength",
                  "N*m^2",
                  Optional.empty(),
                  Condition.FINITE,
                  "force times the square of the distance; negative pushes apart",
                  0.5),
              new ForceRow.Attribute(
                  "softening",
                  "m",
                  Optional.of(0.0),
                  Condition.NOT_NEGATIVE,
                  "distance below which the force no longer grows",
                  0.1)),
          List.of(new Variable("distance", "m"), new Variable("attraction", "N")),
          new ForceRow.Example(ForceRow.Trial.BLOCK, "slide.q = 0.729154"));

  static final Undirected UNDIRECTED =
      new Undirected(
          "Its two points coincide, so its force has no size and no direction.",
          0,
          "Give it a softening, or keep the points apart.");

  private final ScalarVector way;
  private final Scalar strength;
  private final Scalar square;
  private final Scalar root;

  /**
   * @param coefficients k, N·m², and ε, m
   */
  InverseSquareLoad(Frames x, List<Scalar> coefficients) {
    way = x.displacement();
    strength = coefficients.get(0);
    square = way.dot(way).plus(coefficients.get(1).squared());
    root = square.squareRoot();
  }

  private Scalar perLength() {
    return strength.over(square.times(root));
  }

  @Override
  public Optional<Direction> direction() {
    return Optional.of(new Direction(square, 0));
  }

  @Override
  public ScalarVector force() {
    return way.times(perLength().negated());
  }

  @Override
  public ScalarVector moment() {
    return ScalarVector.zero(expressions());
  }

  private Expressions expressions() {
    return square.expressions();
  }

  @Override
  public Scalar potential() {
    return strength.over(root).negated();
  }

  @Override
  public Scalar power() {
    return expressions().zero();
  }

  @Override
  public List<Scalar> values() {
    Scalar distance = way.dot(way).squareRoot();
    return List.of(distance, distance.times(perLength()));
  }
}

package org.mechservice.solver.step;

import java.util.List;
import org.mechservice.solver.links.Axes;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * A rotation as Euler parameters e0 = cos(φ/2), (e1, e2, e3) = u sin(φ/2).
 *
 * @param e the four numbers in order
 */
public record EulerParameterTerms(List<Scalar> e) {

  public Scalar at(int i) {
    return e.get(i);
  }

  /** Returns a rotation about a constant unit vector, given cosine and sine of half its angle. */
  public static EulerParameterTerms about(Vector3 axis, Scalar cosineOfHalf, Scalar sineOfHalf) {
    return new EulerParameterTerms(
        List.of(
            cosineOfHalf,
            sineOfHalf.times(axis.x()),
            sineOfHalf.times(axis.y()),
            sineOfHalf.times(axis.z())));
  }

  /** Returns a constant rotation, e0 ≥ 0. */
  public static EulerParameterTerms of(Expressions expressions, Rotation rotation) {
    double[] e = numbers(Axes.elements(rotation));
    return new EulerParameterTerms(
        List.of(
            expressions.constant(e[0]),
            expressions.constant(e[1]),
            expressions.constant(e[2]),
            expressions.constant(e[3])));
  }

  /**
   * Computes the largest of the four first, so that no divisor is small: 4 e0² = 1 + trace, 4 ei² =
   * 1 + 2 rii − trace.
   */
  private static double[] numbers(double[][] r) {
    double trace = r[0][0] + r[1][1] + r[2][2];
    double[] fourSquares = {
      1 + trace, 1 + 2 * r[0][0] - trace, 1 + 2 * r[1][1] - trace, 1 + 2 * r[2][2] - trace
    };
    int largest = 0;
    for (int i = 1; i < 4; i++) {
      largest = fourSquares[i] > fourSquares[largest] ? i : largest;
    }
    double[] products = fourProducts(r, largest);
    double twice = Math.sqrt(fourSquares[largest]);
    double[] e = new double[4];
    for (int i = 0; i < 4; i++) {
      e[i] = i == largest ? twice / 2 : products[i] / (2 * twice);
    }
    if (e[0] < 0) {
      for (int i = 0; i < 4; i++) {
        e[i] = -e[i];
      }
    }
    return e;
  }

  /** Returns 4 e(i) e(largest) for the others. */
  private static double[] fourProducts(double[][] r, int largest) {
    double[] products = new double[4];
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      double withZero = r[k][j] - r[j][k];
      if (largest == 0) {
        products[i + 1] = withZero;
      } else if (largest == i + 1) {
        products[0] = withZero;
        products[j + 1] = r[i][j] + r[j][i];
        products[k + 1] = r[i][k] + r[k][i];
      }
    }
    return products;
  }

  /** Returns the parameters of the inverse rotation. */
  public EulerParameterTerms inverse() {
    return new EulerParameterTerms(
        List.of(at(0), at(1).negated(), at(2).negated(), at(3).negated()));
  }

  private Scalar squares() {
    return at(0).squared().plus(at(1).squared()).plus(at(2).squared()).plus(at(3).squared());
  }

  /** Returns e/|e|. */
  public EulerParameterTerms normalised() {
    Scalar norm = squares().squareRoot();
    return new EulerParameterTerms(e.stream().map(component -> component.over(norm)).toList());
  }

  /** Returns R(e/|e|) = 1 + s (e0 [u]× + [u]×²), s = 2/|e|². */
  public ScalarMatrix rotation() {
    Expressions x = at(0).expressions();
    Scalar s = x.constant(2).over(squares());
    return ScalarMatrix.of(
        (i, j) -> i == j ? diagonal(s, (i + 1) % 3 + 1, (i + 2) % 3 + 1) : beside(s, i, j));
  }

  private Scalar diagonal(Scalar s, int j, int k) {
    Scalar sum = at(j).squared().plus(at(k).squared());
    return s.expressions().one().minus(s.times(sum));
  }

  /** s (ei ej − e0 ek) for cyclic i, j, k, + for the others. */
  private Scalar beside(Scalar s, int i, int j) {
    Scalar product = at(i + 1).times(at(j + 1));
    Scalar turn = at(0).times(at(3 - i - j + 1));
    boolean cyclic = (i + 1) % 3 == j;
    return s.times(cyclic ? product.minus(turn) : product.plus(turn));
  }

  /** Returns e' = ½ (0, ω) ∘ e. */
  public EulerParameterTerms rate(ScalarVector omega) {
    Scalar zero = at(0).expressions().zero();
    ScalarVector half = omega.map(component -> component.times(0.5));
    return new EulerParameterTerms(List.of(zero, half.x(), half.y(), half.z())).times(this);
  }

  /** Returns this ∘ other: the other rotation first. */
  public EulerParameterTerms times(EulerParameterTerms other) {
    return new EulerParameterTerms(
        List.of(
            product(other, 0, 0)
                .minus(product(other, 1, 1))
                .minus(product(other, 2, 2))
                .minus(product(other, 3, 3)),
            vectorPart(other, 1, 2, 3),
            vectorPart(other, 2, 3, 1),
            vectorPart(other, 3, 1, 2)));
  }

  /** a0 bi + ai b0 + aj bk − ak bj. */
  private Scalar vectorPart(EulerParameterTerms other, int i, int j, int k) {
    return product(other, 0, i)
        .plus(product(other, i, 0))
        .plus(product(other, j, k))
        .minus(product(other, k, j));
  }

  private Scalar product(EulerParameterTerms other, int i, int j) {
    return at(i).times(other.at(j));
  }
}

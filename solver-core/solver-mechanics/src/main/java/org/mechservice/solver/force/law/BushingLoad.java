package org.mechservice.solver.force.law;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Force and moment of a bushing. Legend: x = [r; φ]; φ′ = B ω with B = B(φ); g = preload − K x − C
 * x′; force g_r; moment Bᵀ g_φ, or g_φ with ω in place of φ′ where the law is linear.
 */
public final class BushingLoad implements PairLoad {
  /** Names of the coefficients in printed methods. */
  static final List<String> SYMBOLS =
      Stream.of(numbered("K", 36), numbered("C", 36), numbered("preload", 6))
          .flatMap(List::stream)
          .toList();

  static final Undirected UNDIRECTED =
      new Undirected(
          "Its frames are turned by half a turn, where a rotation vector changes its sign.",
          0,
          "Turn one of the frames, or use a joint with a spring for large rotations.");

  /** Angle below which γ is taken from its series; the next term is then below 1e-17. */
  private static final double SERIES = 0.05;

  /** Cosine of half the angle at which a rotation counts as half a turn. */
  private static final double HALF_TURN = 1e-3;

  private final Expressions e;
  private final Frames frames;
  private final List<Scalar> stiffness;
  private final List<Scalar> preload;
  private final boolean byEnergy;
  private final ScalarVector phi;
  private final Scalar gamma;
  private final Scalar half;
  private final List<Scalar> x;
  private final List<Scalar> rates;
  private final List<Scalar> g;

  /**
   * @param stiffness K row by row, 36 numbers, N/m, N, N·m/m and N·m
   * @param damping C row by row, likewise by rates
   * @param preload force, then moment, N and N·m
   * @param byEnergy whether the moment follows from its power
   */
  public BushingLoad(
      Frames frames,
      List<Scalar> stiffness,
      List<Scalar> damping,
      List<Scalar> preload,
      boolean byEnergy) {
    this.frames = frames;
    this.stiffness = List.copyOf(stiffness);
    this.preload = List.copyOf(preload);
    this.byEnergy = byEnergy;
    ScalarMatrix r = frames.rotation();
    e = r.at(0, 0).expressions();
    // e0 = cos θ/2: half a turn is refused
    half = e.one().plus(r.at(0, 0)).plus(r.at(1, 1)).plus(r.at(2, 2)).squareRoot().times(0.5);
    ScalarVector vector =
        new ScalarVector(
                r.at(2, 1).minus(r.at(1, 2)),
                r.at(0, 2).minus(r.at(2, 0)),
                r.at(1, 0).minus(r.at(0, 1)))
            .times(e.constant(0.25).over(half));
    Scalar square = vector.dot(vector);
    // Without a rotation there is no division by zero, not even in derivatives of the other branch.
    Scalar sine = choose(square, e.zero(), e.one(), square).squareRoot();
    Scalar turn = e.function(MathFunction.ATAN2, sine, half).times(2);
    boolean parallel = square.isZero();
    phi =
        vector.times(
            parallel ? e.constant(2) : choose(square, e.zero(), e.constant(2), turn.over(sine)));
    gamma =
        parallel
            ? e.constant(1.0 / 12)
            : gamma(choose(square, e.zero(), e.zero(), turn), turn, half.over(sine));
    x = joined(frames.displacement(), phi);
    rates = joined(frames.rate(), byEnergy ? turned(-0.5, frames.omega()) : frames.omega());
    g = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      Scalar sum = preload.get(i);
      for (int k = 0; k < 6; k++) {
        Scalar spring = x.get(k).times(stiffness.get(6 * i + k));
        sum = sum.minus(spring).minus(rates.get(k).times(damping.get(6 * i + k)));
      }
      g.add(sum);
    }
  }

  private static List<String> numbered(String name, int count) {
    return IntStream.range(0, count).mapToObj(i -> name + "_" + i).toList();
  }

  private Scalar choose(Scalar a, Scalar b, Scalar first, Scalar second) {
    return e.function(MathFunction.CHOOSE, a, b, first, second);
  }

  /**
   * Returns γ = (1 − θ/2 cot θ/2) / θ².
   *
   * @param turn θ if it is not zero
   */
  private Scalar gamma(Scalar theta, Scalar turn, Scalar cotangent) {
    Scalar z = theta.squared();
    Scalar series =
        e.constant(1.0 / 12)
            .plus(
                z.times(
                    e.constant(1.0 / 720)
                        .plus(z.times(e.constant(1.0 / 30240).plus(z.times(1.0 / 1209600))))));
    Scalar closed = e.one().minus(turn.times(0.5).times(cotangent)).over(turn.squared());
    return choose(theta, e.constant(SERIES), series, closed);
  }

  /** Returns a + half φ × a + γ φ × (φ × a). */
  private ScalarVector turned(double factor, ScalarVector a) {
    ScalarVector once = phi.cross(a);
    ScalarVector twice = phi.cross(once);
    return a.plus(once.map(component -> component.times(factor))).plus(twice.times(gamma));
  }

  private static List<Scalar> joined(ScalarVector first, ScalarVector second) {
    List<Scalar> all = new ArrayList<>(first.components());
    all.addAll(second.components());
    return all;
  }

  @Override
  public ScalarVector force() {
    return new ScalarVector(g.get(0), g.get(1), g.get(2));
  }

  @Override
  public ScalarVector moment() {
    ScalarVector plain = new ScalarVector(g.get(3), g.get(4), g.get(5));
    return byEnergy ? turned(0.5, plain) : plain;
  }

  /** {@inheritDoc} The rotation vector jumps near half a turn. */
  @Override
  public Optional<Direction> direction() {
    return half.isConstant() ? Optional.empty() : Optional.of(new Direction(half, HALF_TURN));
  }

  @Override
  public Scalar potential() {
    Scalar sum = e.zero();
    for (int i = 0; i < 6; i++) {
      for (int k = 0; k < 6; k++) {
        sum = sum.plus(x.get(i).times(x.get(k)).times(stiffness.get(6 * i + k).times(0.5)));
      }
      sum = sum.minus(x.get(i).times(preload.get(i)));
    }
    return sum;
  }

  /** {@inheritDoc} It is the power of force and moment plus the rate of the potential energy. */
  @Override
  public Scalar power() {
    ScalarVector omega = frames.omega();
    Scalar sum = force().dot(frames.rate()).plus(moment().dot(omega));
    List<Scalar> dx = joined(frames.rate(), turned(-0.5, omega));
    for (int i = 0; i < 6; i++) {
      Scalar resisting = preload.get(i).negated();
      for (int k = 0; k < 6; k++) {
        Scalar both = stiffness.get(6 * i + k).plus(stiffness.get(6 * k + i));
        resisting = resisting.plus(x.get(k).times(both.times(0.5)));
      }
      sum = sum.plus(resisting.times(dx.get(i)));
    }
    return sum;
  }

  @Override
  public List<Scalar> values() {
    List<Scalar> values = new ArrayList<>(x);
    values.addAll(force().components());
    values.addAll(moment().components());
    return values;
  }
}

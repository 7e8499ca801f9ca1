package org.mechservice.solver.step;

import java.util.Arrays;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.IntFunction;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The numbers of a link as scalars: constants where code is written for one mechanism, inputs where
 * it is written for all.
 *
 * @param kind the elementary motion of its joint
 * @param inverse whether Euler parameters turn the parent relative to the link
 * @param axes from the link's computing axes to the axes before {@code turn}
 * @param turn the constant turn that follows to the parent's computing axes, if there is one
 * @param offset from the parent's computing origin to the joint's point, in parent axes, m
 * @param way displacement along z per coordinate: 1 for a slide, the pitch of a screw in m/rad,
 *     otherwise 0
 * @param armature inertia of its own of each velocity, kg·m² or kg
 * @param body its mass
 */
public record LinkNumbers(
    LinkKind kind,
    boolean inverse,
    ScalarMatrix axes,
    Optional<Turn> turn,
    ScalarVector offset,
    Scalar way,
    Scalar armature,
    Body body) {
  /** Number of the first element of {@code axes}; the others follow row by row. */
  public static final int AXES = 0;

  /** Numbers of the cosine and the sine of a constant turn, where it is a step of its own. */
  public static final int COSINE = 0;

  public static final int SINE = 1;

  /** Number of the first component of {@code offset}. */
  public static final int OFFSET = 9;

  static final int WAY = 12;
  static final int MASS = 13;
  static final int CENTER = 14;
  static final int MOMENTS = 17;
  static final int FIRST = 23;
  static final int SECOND = 26;

  /** How many numbers a link has. */
  public static final int COUNT = 32;

  /** Number of an element of a symmetric matrix among xx, yy, zz, xy, xz, yz. */
  private static final int[] SYMMETRIC = {0, 3, 4, 3, 1, 5, 4, 5, 2};

  /**
   * A constant turn about a coordinate axis.
   *
   * @param axis 0, 1, 2 for x, y, z
   * @param cosine of its angle
   * @param sine of its angle
   */
  public record Turn(int axis, Scalar cosine, Scalar sine) {}

  /**
   * The mass of a link.
   *
   * @param mass m, kg
   * @param center c, of mass from the computing origin, m
   * @param first m c, kg·m
   * @param second J about the origin, symmetric, kg·m²
   * @param inertia I about the centre, symmetric, kg·m²
   */
  public record Body(
      Scalar mass,
      ScalarVector center,
      ScalarVector first,
      ScalarMatrix second,
      ScalarMatrix inertia) {}

  /** Returns a link's numbers as constants. */
  public static LinkNumbers of(Expressions expressions, Link link) {
    return of(expressions, link, expressions::constant);
  }

  /**
   * Returns a link's numbers.
   *
   * @param scalar returns a number as a scalar
   */
  public static LinkNumbers of(Expressions expressions, Link link, DoubleFunction<Scalar> scalar) {
    Scalar[] numbers = Arrays.stream(values(link)).mapToObj(scalar).toArray(Scalar[]::new);
    Scalar armature = link.armature() == 0 ? expressions.zero() : scalar.apply(link.armature());
    return of(link.kind(), link.inverse(), expressions, k -> numbers[k])
        .armed(armature)
        .turned(
            link.axes()
                .turn()
                .map(
                    turn ->
                        new Turn(
                            turn.axis(), scalar.apply(turn.cosine()), scalar.apply(turn.sine()))));
  }

  /** Returns the {@link #COUNT} numbers of a link in doubles. */
  public static double[] values(Link link) {
    double[] numbers = new double[COUNT];
    StepBlock.put(numbers, 0, link);
    return numbers;
  }

  /** Returns the numbers of a constant turn about a coordinate axis, a step without mass. */
  static LinkNumbers ofTurn(int axis, Expressions expressions, IntFunction<Scalar> number) {
    Scalar zero = expressions.zero();
    ScalarVector none = ScalarVector.zero(expressions);
    ScalarMatrix nothing = ScalarMatrix.zero(expressions);
    return new LinkNumbers(
        LinkKind.FIXED,
        false,
        ScalarMatrix.of((i, j) -> i == j ? expressions.one() : zero),
        Optional.of(new Turn(axis, number.apply(COSINE), number.apply(SINE))),
        vector(number, OFFSET),
        zero,
        zero,
        new Body(zero, none, none, nothing, nothing));
  }

  private LinkNumbers turned(Optional<Turn> by) {
    return new LinkNumbers(kind, inverse, axes, by, offset, way, armature, body);
  }

  /** Returns the same numbers with an armature. */
  LinkNumbers armed(Scalar by) {
    return new LinkNumbers(kind, inverse, axes, turn, offset, way, by, body);
  }

  /**
   * Returns the numbers of a link without a constant turn and without armature.
   *
   * @param number returns one of the {@link #COUNT} numbers that {@link StepBlock#put} writes
   */
  static LinkNumbers of(
      LinkKind kind, boolean inverse, Expressions expressions, IntFunction<Scalar> number) {
    return new LinkNumbers(
        kind,
        inverse,
        ScalarMatrix.of((i, j) -> number.apply(AXES + 3 * i + j)),
        Optional.empty(),
        vector(number, OFFSET),
        switch (kind) {
          case SLIDE -> expressions.one();
          case SCREW -> number.apply(WAY);
          default -> expressions.zero();
        },
        expressions.zero(),
        new Body(
            number.apply(MASS),
            vector(number, CENTER),
            vector(number, FIRST),
            symmetric(number, SECOND),
            symmetric(number, MOMENTS)));
  }

  private static ScalarMatrix symmetric(IntFunction<Scalar> number, int at) {
    return ScalarMatrix.of((i, j) -> number.apply(at + SYMMETRIC[3 * i + j]));
  }

  private static ScalarVector vector(IntFunction<Scalar> number, int at) {
    return new ScalarVector(number.apply(at), number.apply(at + 1), number.apply(at + 2));
  }
}

package org.mechservice.solver.step;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.links.AxesChange;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
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
 * @param body its mass
 */
public record LinkNumbers(
    LinkKind kind,
    boolean inverse,
    ScalarMatrix axes,
    Optional<Turn> turn,
    ScalarVector offset,
    Scalar way,
    Body body) {
  /** Number of the first element of {@code axes}; the others follow row by row. */
  public static final int AXES = 0;

  /** Number of the first component of {@code offset}. */
  public static final int OFFSET = 9;

  /** Number of {@code way}. */
  public static final int WAY = 12;

  /** Numbers of the cosine and the sine of {@code turn}. */
  public static final int COSINE = 13;

  public static final int SINE = 14;

  /** Number of the mass. */
  public static final int MASS = 15;

  private static final int CENTER = 16;
  private static final int FIRST = 19;
  private static final int SECOND = 22;
  private static final int PRODUCTS = 28;
  private static final int TURNING = 31;

  /** How many numbers a link has. */
  public static final int COUNT = 43;

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
   * @param products Ixy, Ixz, Iyz about the centre, kg·m²
   * @param turning for each axis four factors, kg·m²: of αi, ωj ωk, Wkj and Wjk, with i, j, k
   *     cyclic. They sum up to Iii αi + (Ikk − Ijj) ωj ωk; two of them are zero
   */
  public record Body(
      Scalar mass,
      ScalarVector center,
      ScalarVector first,
      ScalarMatrix second,
      List<Scalar> products,
      List<Scalar> turning) {}

  /** Returns a link's numbers as constants. */
  public static LinkNumbers of(Expressions expressions, Link link) {
    double[] numbers = numbers(link);
    return of(
        link.kind(),
        link.inverse(),
        link.axes().turn().map(AxesChange.Turn::axis),
        expressions,
        k -> expressions.constant(numbers[k]));
  }

  /**
   * Returns the numbers of a link.
   *
   * @param turnAxis the axis of the constant turn, if the link has one
   * @param number returns one of the {@link #COUNT} numbers of {@link #numbers}
   */
  static LinkNumbers of(
      LinkKind kind,
      boolean inverse,
      Optional<Integer> turnAxis,
      Expressions expressions,
      IntFunction<Scalar> number) {
    List<Scalar> products = new ArrayList<>();
    List<Scalar> turning = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      products.add(number.apply(PRODUCTS + i));
    }
    for (int i = 0; i < 12; i++) {
      turning.add(number.apply(TURNING + i));
    }
    return new LinkNumbers(
        kind,
        inverse,
        ScalarMatrix.of((i, j) -> number.apply(AXES + 3 * i + j)),
        turnAxis.map(axis -> new Turn(axis, number.apply(COSINE), number.apply(SINE))),
        vector(number, OFFSET),
        switch (kind) {
          case SLIDE -> expressions.one();
          case SCREW -> number.apply(WAY);
          default -> expressions.zero();
        },
        new Body(
            number.apply(MASS),
            vector(number, CENTER),
            vector(number, FIRST),
            ScalarMatrix.of((i, j) -> number.apply(SECOND + SYMMETRIC[3 * i + j])),
            products,
            turning));
  }

  private static ScalarVector vector(IntFunction<Scalar> number, int at) {
    return new ScalarVector(number.apply(at), number.apply(at + 1), number.apply(at + 2));
  }

  /** Returns the {@link #COUNT} numbers of a link. */
  public static double[] numbers(Link link) {
    double[] numbers = new double[COUNT];
    put(numbers, AXES, link.axes().matrix());
    put(numbers, OFFSET, link.offset());
    numbers[WAY] = link.way();
    numbers[COSINE] = link.axes().turn().map(AxesChange.Turn::cosine).orElse(1.0);
    numbers[SINE] = link.axes().turn().map(AxesChange.Turn::sine).orElse(0.0);
    numbers[MASS] = link.mass();
    put(numbers, CENTER, link.centerOfMass());
    put(numbers, FIRST, link.centerOfMass().times(link.mass()));
    put(numbers, SECOND, link.inertiaAtOrigin());
    InertiaTensor own = link.inertia();
    put(numbers, PRODUCTS, new Vector3(own.xy(), own.xz(), own.yz()));
    putTurning(numbers, new double[] {own.xx(), own.yy(), own.zz()});
    return numbers;
  }

  /**
   * Writes for each axis the factors of Iii αi + (Ikk − Ijj) ωj ωk, or of the same as Σjj Wkj − Σkk
   * Wjk with Σ the second moments of mass, whichever has fewer terms: a slender rod has one second
   * moment, a wheel two equal moments of inertia.
   */
  private static void putTurning(double[] numbers, double[] moments) {
    for (int i = 0; i < 3; i++) {
      double ii = moments[i];
      double jj = moments[(i + 1) % 3];
      double kk = moments[(i + 2) % 3];
      double secondJ = (ii + kk - jj) / 2;
      double secondK = (ii + jj - kk) / 2;
      int at = TURNING + 4 * i;
      if (nonZeros(ii, kk - jj) <= nonZeros(secondJ, secondK)) {
        numbers[at] = ii;
        numbers[at + 1] = kk - jj;
      } else {
        numbers[at + 2] = secondJ;
        numbers[at + 3] = secondK;
      }
    }
  }

  private static int nonZeros(double a, double b) {
    return (a == 0 ? 0 : 1) + (b == 0 ? 0 : 1);
  }

  private static void put(double[] numbers, int at, Rotation r) {
    put(numbers, at, new Vector3(r.xx(), r.xy(), r.xz()));
    put(numbers, at + 3, new Vector3(r.yx(), r.yy(), r.yz()));
    put(numbers, at + 6, new Vector3(r.zx(), r.zy(), r.zz()));
  }

  private static void put(double[] numbers, int at, Vector3 v) {
    numbers[at] = v.x();
    numbers[at + 1] = v.y();
    numbers[at + 2] = v.z();
  }

  private static void put(double[] numbers, int at, InertiaTensor i) {
    put(numbers, at, new Vector3(i.xx(), i.yy(), i.zz()));
    put(numbers, at + 3, new Vector3(i.xy(), i.xz(), i.yz()));
  }
}

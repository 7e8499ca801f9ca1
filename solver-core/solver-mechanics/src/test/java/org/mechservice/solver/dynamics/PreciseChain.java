package org.mechservice.solver.dynamics;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

/**
 * Accelerations of a chain of revolute joints with 50 digits, in a way that shares nothing with the
 * solver: Newton's and Euler's equations of each body in world axes, the mass matrix column by
 * column from them, and elimination. Joint axes must be axes of the bodies, as no others are of
 * unit length with all digits; body frames stand in their joints.
 */
final class PreciseChain {
  private static final MathContext DIGITS = new MathContext(50);
  private static final BigDecimal SMALLEST_TERM = new BigDecimal("1e-55");

  private final Mechanism chain;
  private final int n;
  private final BigDecimal[][][] rotation;
  private final BigDecimal[][] axis;
  private final BigDecimal[][] arm;
  private final BigDecimal[][] center;

  /**
   * @param q joint angles, rad
   */
  PreciseChain(Mechanism chain, double[] q) {
    this.chain = chain;
    n = chain.bodies().size();
    rotation = new BigDecimal[n][][];
    axis = new BigDecimal[n][];
    arm = new BigDecimal[n][];
    center = new BigDecimal[n][];
    BigDecimal[][] parent = {vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)};
    for (int i = 0; i < n; i++) {
      Revolute joint = (Revolute) chain.joints().get(i);
      arm[i] = times(parent, vector(joint.attachment().parentPoint()));
      axis[i] = times(parent, vector(joint.axis()));
      rotation[i] = times(parent, turn(joint.axis(), new BigDecimal(q[i])));
      center[i] = times(rotation[i], vector(chain.bodies().get(i).centerOfMass()));
      parent = rotation[i];
    }
  }

  /**
   * Returns the joint accelerations without joint forces, rounded to doubles, rad/s².
   *
   * @param v joint velocities, rad/s
   */
  double[] accelerations(double[] v) {
    double[] none = new double[n];
    BigDecimal[] right = jointForces(v, none, chain.gravity());
    BigDecimal[][] mass = new BigDecimal[n][];
    for (int i = 0; i < n; i++) {
      right[i] = right[i].negate();
      double[] unit = new double[n];
      unit[i] = 1;
      mass[i] = jointForces(none, unit, Vector3.ZERO);
    }
    eliminate(mass, right);
    return Arrays.stream(right).mapToDouble(BigDecimal::doubleValue).toArray();
  }

  /** Returns the joint forces that a motion takes: out along the chain, and back. */
  private BigDecimal[] jointForces(double[] v, double[] a, Vector3 gravity) {
    BigDecimal[] zero = vector(0, 0, 0);
    BigDecimal[] omega = zero;
    BigDecimal[] alpha = zero;
    BigDecimal[] acceleration = minus(zero, vector(gravity));
    BigDecimal[][] force = new BigDecimal[n][];
    BigDecimal[][] moment = new BigDecimal[n][];
    for (int i = 0; i < n; i++) {
      acceleration = plus(acceleration, ofPoint(omega, alpha, arm[i]));
      BigDecimal[] turning = times(new BigDecimal(v[i]), axis[i]);
      alpha = plus(alpha, plus(times(new BigDecimal(a[i]), axis[i]), cross(omega, turning)));
      omega = plus(omega, turning);
      Body body = chain.bodies().get(i);
      BigDecimal[] ofCenter = plus(acceleration, ofPoint(omega, alpha, center[i]));
      force[i] = times(new BigDecimal(body.mass()), ofCenter);
      BigDecimal[] spin = cross(omega, inertiaTimes(i, omega));
      moment[i] = plus(plus(inertiaTimes(i, alpha), spin), cross(center[i], force[i]));
    }
    BigDecimal[] joint = new BigDecimal[n];
    for (int i = n - 1; i >= 0; i--) {
      joint[i] = dot(axis[i], moment[i]);
      if (i > 0) {
        force[i - 1] = plus(force[i - 1], force[i]);
        moment[i - 1] = plus(moment[i - 1], plus(moment[i], cross(arm[i], force[i])));
      }
    }
    return joint;
  }

  private static BigDecimal[] ofPoint(BigDecimal[] omega, BigDecimal[] alpha, BigDecimal[] r) {
    return plus(cross(alpha, r), cross(omega, cross(omega, r)));
  }

  private BigDecimal[] inertiaTimes(int body, BigDecimal[] world) {
    InertiaTensor tensor = chain.bodies().get(body).inertia();
    BigDecimal[][] rows = {
      vector(tensor.xx(), tensor.xy(), tensor.xz()),
      vector(tensor.xy(), tensor.yy(), tensor.yz()),
      vector(tensor.xz(), tensor.yz(), tensor.zz())
    };
    return times(rotation[body], times(rows, times(transposed(rotation[body]), world)));
  }

  /** Solves a symmetric positive definite system; the solution replaces the right side. */
  private static void eliminate(BigDecimal[][] m, BigDecimal[] right) {
    int n = right.length;
    for (int p = 0; p < n; p++) {
      for (int i = p + 1; i < n; i++) {
        BigDecimal factor = m[i][p].divide(m[p][p], DIGITS);
        for (int k = p; k < n; k++) {
          m[i][k] = m[i][k].subtract(factor.multiply(m[p][k], DIGITS), DIGITS);
        }
        right[i] = right[i].subtract(factor.multiply(right[p], DIGITS), DIGITS);
      }
    }
    for (int i = n - 1; i >= 0; i--) {
      for (int k = i + 1; k < n; k++) {
        right[i] = right[i].subtract(m[i][k].multiply(right[k], DIGITS), DIGITS);
      }
      right[i] = right[i].divide(m[i][i], DIGITS);
    }
  }

  /** Turns about an axis of the coordinate frame. */
  private static BigDecimal[][] turn(Vector3 axis, BigDecimal angle) {
    int i = List.of(axis.x(), axis.y(), axis.z()).indexOf(1.0);
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    BigDecimal sine = series(angle, angle, 1);
    BigDecimal cosine = series(BigDecimal.ONE, angle, 0);
    BigDecimal[][] turn = {vector(0, 0, 0), vector(0, 0, 0), vector(0, 0, 0)};
    turn[i][i] = BigDecimal.ONE;
    turn[j][j] = cosine;
    turn[k][k] = cosine;
    turn[j][k] = sine.negate();
    turn[k][j] = sine;
    return turn;
  }

  /** Sums first − first x² / ((k+1)(k+2)) + …: the sine (k = 1) or cosine (k = 0). */
  private static BigDecimal series(BigDecimal first, BigDecimal x, int k) {
    BigDecimal square = x.multiply(x, DIGITS).negate();
    BigDecimal term = first;
    BigDecimal sum = first;
    for (int i = k; term.abs().compareTo(SMALLEST_TERM) > 0; i += 2) {
      term = term.multiply(square, DIGITS).divide(BigDecimal.valueOf((i + 1L) * (i + 2L)), DIGITS);
      sum = sum.add(term, DIGITS);
    }
    return sum;
  }

  private static BigDecimal[] vector(double x, double y, double z) {
    return new BigDecimal[] {new BigDecimal(x), new BigDecimal(y), new BigDecimal(z)};
  }

  private static BigDecimal[] vector(Vector3 v) {
    return vector(v.x(), v.y(), v.z());
  }

  private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
    BigDecimal sum = BigDecimal.ZERO;
    for (int i = 0; i < 3; i++) {
      sum = sum.add(a[i].multiply(b[i], DIGITS), DIGITS);
    }
    return sum;
  }

  private static BigDecimal[] plus(BigDecimal[] a, BigDecimal[] b) {
    BigDecimal[] sum = new BigDecimal[3];
    Arrays.setAll(sum, i -> a[i].add(b[i], DIGITS));
    return sum;
  }

  private static BigDecimal[] minus(BigDecimal[] a, BigDecimal[] b) {
    return plus(a, times(BigDecimal.ONE.negate(), b));
  }

  private static BigDecimal[] times(BigDecimal factor, BigDecimal[] a) {
    BigDecimal[] product = new BigDecimal[3];
    Arrays.setAll(product, i -> factor.multiply(a[i], DIGITS));
    return product;
  }

  private static BigDecimal[] times(BigDecimal[][] rows, BigDecimal[] a) {
    BigDecimal[] product = new BigDecimal[3];
    Arrays.setAll(product, i -> dot(rows[i], a));
    return product;
  }

  private static BigDecimal[][] times(BigDecimal[][] a, BigDecimal[][] b) {
    BigDecimal[][] columns = transposed(b);
    BigDecimal[][] product = new BigDecimal[3][];
    Arrays.setAll(product, i -> times(columns, a[i]));
    return product;
  }

  private static BigDecimal[][] transposed(BigDecimal[][] a) {
    BigDecimal[][] columns = new BigDecimal[3][3];
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        columns[k][i] = a[i][k];
      }
    }
    return columns;
  }

  private static BigDecimal[] cross(BigDecimal[] a, BigDecimal[] b) {
    BigDecimal[] product = new BigDecimal[3];
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      product[i] = a[j].multiply(b[k], DIGITS).subtract(a[k].multiply(b[j], DIGITS), DIGITS);
    }
    return product;
  }
}

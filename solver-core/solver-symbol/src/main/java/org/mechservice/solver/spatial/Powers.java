package org.mechservice.solver.spatial;

/**
 * Powers that allocate nothing and have the same bits on every machine ({@link StrictMath#pow}
 * allocates in some versions of Java).
 */
public final class Powers {
  /**
   * Whole and half exponents up to here are products; a product of n factors is good to n/2 ulp.
   */
  private static final int LARGEST_PRODUCT = 64;

  private Powers() {}

  /**
   * Returns a to the power of b, with the special cases of {@link StrictMath#pow}. The error is
   * some ulp for whole and half exponents to 64, else about |b ln a| ulp.
   */
  public static double power(double a, double b) {
    if (Math.abs(b) <= LARGEST_PRODUCT) {
      if (b == (int) b) {
        return whole(a, (int) b);
      }
      if (a > 0 && 2 * b == (int) (2 * b)) {
        double root = Math.sqrt(a) * whole(a, (int) Math.abs(b));
        return b > 0 ? root : 1 / root;
      }
    }
    if (a > 0) {
      return positive(a, b);
    }
    return nonPositive(a, b);
  }

  private static double whole(double a, int n) {
    double product = 1;
    double square = a;
    for (int k = Math.abs(n); k > 0; k >>= 1) {
      if ((k & 1) == 1) {
        product *= square;
      }
      square *= square;
    }
    return n >= 0 ? product : 1 / product;
  }

  /** exp(b ln a), the product carried to twice the precision. */
  private static double positive(double a, double b) {
    double log = StrictMath.log(a);
    double high = b * log;
    double low = Math.fma(b, log, -high);
    double power = StrictMath.exp(high);
    return Double.isFinite(power) && Double.isFinite(low) ? power + power * low : power;
  }

  private static double nonPositive(double a, double b) {
    boolean whole = b == Math.rint(b);
    boolean odd = whole && Math.abs(b) < 0x1p53 && b % 2 != 0;
    if (a == 0) {
      double size = b > 0 ? 0 : Double.POSITIVE_INFINITY;
      return odd ? Math.copySign(size, a) : size;
    }
    if (!whole || Double.isNaN(a)) {
      return Double.NaN;
    }
    double size = positive(-a, b);
    return odd ? -size : size;
  }
}

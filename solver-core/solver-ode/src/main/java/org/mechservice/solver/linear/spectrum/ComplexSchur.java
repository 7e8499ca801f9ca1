package org.mechservice.solver.linear.spectrum;

import java.util.Arrays;

/**
 * Complex Schur form H = Z T Zᴴ of a Hessenberg matrix, T upper triangular with the eigenvalues on
 * its diagonal: the QR algorithm with Wilkinson's shifts (Golub and Van Loan, Matrix Computations,
 * 2013, §7.5). Real and imaginary parts stand in arrays of their own.
 */
final class ComplexSchur {
  private static final int ITERATIONS_PER_EIGENVALUE = 60;
  private static final int UNUSUAL_SHIFT_EVERY = 10;
  private static final double ROUNDING = Math.ulp(1.0);

  private final int n;
  final double[] tr;
  final double[] ti;
  final double[] zr;
  final double[] zi;
  private final double[] cr;
  private final double[] ci;
  private final double[] sr;
  private final double[] si;
  private double shiftR;
  private double shiftI;

  /**
   * @param h upper Hessenberg; not modified
   * @param q what Z begins with; not modified
   */
  ComplexSchur(int n, double[] h, double[] q) {
    this.n = n;
    tr = Arrays.copyOf(h, n * n);
    ti = new double[n * n];
    zr = Arrays.copyOf(q, n * n);
    zi = new double[n * n];
    cr = new double[n];
    ci = new double[n];
    sr = new double[n];
    si = new double[n];
  }

  /** Iterates; returns false if an eigenvalue does not settle. */
  boolean iterate() {
    int end = n - 1;
    int count = 0;
    while (end > 0) {
      int start = end;
      while (start > 0 && !isNegligible(start)) {
        start--;
      }
      if (start == end) {
        end--;
        count = 0;
      } else if (++count > ITERATIONS_PER_EIGENVALUE) {
        return false;
      } else {
        chooseShift(end, count);
        step(start, end);
      }
    }
    return true;
  }

  /**
   * Whether the element below the diagonal of row k vanishes against its neighbours; cuts it off.
   */
  private boolean isNegligible(int k) {
    double neighbours = size(tr, ti, k * n + k) + size(tr, ti, (k - 1) * n + k - 1);
    if (neighbours == 0) {
      neighbours = largest();
    }
    if (size(tr, ti, k * n + k - 1) > ROUNDING * neighbours) {
      return false;
    }
    tr[k * n + k - 1] = 0;
    ti[k * n + k - 1] = 0;
    return true;
  }

  private double largest() {
    double largest = 0;
    for (int i = 0; i < n * n; i++) {
      largest = Math.max(largest, Math.abs(tr[i]) + Math.abs(ti[i]));
    }
    return largest;
  }

  private static double size(double[] re, double[] im, int at) {
    return Math.abs(re[at]) + Math.abs(im[at]);
  }

  /** The eigenvalue of the last 2 × 2 block that is nearer to its last element. */
  private void chooseShift(int end, int count) {
    int d = end * n + end;
    int c = d - 1;
    int b = d - n;
    int a = b - 1;
    if (count % UNUSUAL_SHIFT_EVERY == 0) {
      shiftR = tr[d] + size(tr, ti, c);
      shiftI = ti[d];
      return;
    }
    // λ = d − bc / (p ± √(p² + bc)), p = (a − d) / 2, the sign that makes the divisor large
    double pr = 0.5 * (tr[a] - tr[d]);
    double pi = 0.5 * (ti[a] - ti[d]);
    double bcr = tr[b] * tr[c] - ti[b] * ti[c];
    double bci = tr[b] * ti[c] + ti[b] * tr[c];
    double wr = pr * pr - pi * pi + bcr;
    double wi = 2 * pr * pi + bci;
    double rootR = Math.sqrt(0.5 * (StrictMath.hypot(wr, wi) + Math.abs(wr)));
    double rootI = rootR == 0 ? 0 : 0.5 * wi / rootR;
    if (wr < 0) {
      double kept = Math.abs(rootI);
      rootI = Math.copySign(rootR, wi);
      rootR = kept;
    }
    boolean same = pr * rootR + pi * rootI >= 0;
    double divisorR = same ? pr + rootR : pr - rootR;
    double divisorI = same ? pi + rootI : pi - rootI;
    double square = divisorR * divisorR + divisorI * divisorI;
    shiftR = tr[d];
    shiftI = ti[d];
    if (square != 0) {
      shiftR -= (bcr * divisorR + bci * divisorI) / square;
      shiftI -= (bci * divisorR - bcr * divisorI) / square;
    }
  }

  /** T − σ I = Q R on rows start … end, then T = R Q + σ I, and Z = Z Q. */
  private void step(int start, int end) {
    shift(start, end, -1);
    for (int k = start; k < end; k++) {
      rotation(k);
      rotateRows(k);
    }
    for (int k = start; k < end; k++) {
      rotateColumns(tr, ti, k, Math.min(k + 2, end + 1));
      rotateColumns(zr, zi, k, n);
    }
    shift(start, end, 1);
  }

  private void shift(int start, int end, int sign) {
    for (int k = start; k <= end; k++) {
      tr[k * n + k] += sign * shiftR;
      ti[k * n + k] += sign * shiftI;
    }
  }

  /** c = a / r, s = b / r with r² = |a|² + |b|², which take [a; b] to [r; 0]. */
  private void rotation(int k) {
    int a = k * n + k;
    int b = a + n;
    double large = Math.max(size(tr, ti, a), size(tr, ti, b));
    if (large == 0) {
      cr[k] = 1;
      ci[k] = 0;
      sr[k] = 0;
      si[k] = 0;
      return;
    }
    double ar = tr[a] / large;
    double ai = ti[a] / large;
    double br = tr[b] / large;
    double bi = ti[b] / large;
    double r = Math.sqrt(ar * ar + ai * ai + br * br + bi * bi);
    cr[k] = ar / r;
    ci[k] = ai / r;
    sr[k] = br / r;
    si[k] = bi / r;
  }

  /** Rows k and k+1: x = c̄ x + s̄ y, y = −s x + c y. */
  private void rotateRows(int k) {
    for (int j = k; j < n; j++) {
      int x = k * n + j;
      int y = x + n;
      double xr = cr[k] * tr[x] + ci[k] * ti[x] + sr[k] * tr[y] + si[k] * ti[y];
      double xi = cr[k] * ti[x] - ci[k] * tr[x] + sr[k] * ti[y] - si[k] * tr[y];
      double yr = cr[k] * tr[y] - ci[k] * ti[y] - sr[k] * tr[x] + si[k] * ti[x];
      double yi = cr[k] * ti[y] + ci[k] * tr[y] - sr[k] * ti[x] - si[k] * tr[x];
      tr[x] = xr;
      ti[x] = xi;
      tr[y] = yr;
      ti[y] = yi;
    }
  }

  /** Columns k and k+1 of the first rows: x = x c + y s, y = −x s̄ + y c̄. */
  private void rotateColumns(double[] mr, double[] mi, int k, int rows) {
    for (int i = 0; i < rows; i++) {
      int x = i * n + k;
      int y = x + 1;
      double xr = mr[x] * cr[k] - mi[x] * ci[k] + mr[y] * sr[k] - mi[y] * si[k];
      double xi = mr[x] * ci[k] + mi[x] * cr[k] + mr[y] * si[k] + mi[y] * sr[k];
      double yr = mr[y] * cr[k] + mi[y] * ci[k] - mr[x] * sr[k] - mi[x] * si[k];
      double yi = mi[y] * cr[k] - mr[y] * ci[k] - mi[x] * sr[k] + mr[x] * si[k];
      mr[x] = xr;
      mi[x] = xi;
      mr[y] = yr;
      mi[y] = yi;
    }
  }
}

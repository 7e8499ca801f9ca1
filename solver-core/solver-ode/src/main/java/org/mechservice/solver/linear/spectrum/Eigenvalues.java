package org.mechservice.solver.linear.spectrum;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;

/**
 * Eigenvalues and right eigenvectors of a small real matrix: A v = λ v. They come sorted by their
 * modulus, complex ones in conjugate pairs, the positive imaginary part first.
 *
 * <p>Scaling, Hessenberg form, complex Schur form, back substitution; each eigenvalue is exact for
 * a matrix that differs from the scaled A by some units of round-off of its norm. Multiple
 * eigenvalues have independent vectors only if the matrix has them. Allocates; not for a hot loop.
 */
public final class Eigenvalues {
  private static final double ROUNDING = Math.ulp(1.0);

  /** The square of a number of this size is still a normal number. */
  private static final double SQUARABLE = 1.5e-154;

  /** An imaginary part below this many units of round-off of the norm, per row, is rounding. */
  private static final double REAL = 10;

  private final int n;
  private final boolean converged;
  private final double[] real;
  private final double[] imaginary;
  private final double[] vectorsReal;
  private final double[] vectorsImaginary;

  /**
   * Decomposes a matrix.
   *
   * @param n its size
   * @param a n × n row by row, finite; not modified
   */
  public Eigenvalues(int n, double[] a) {
    this.n = n;
    real = new double[n];
    imaginary = new double[n];
    vectorsReal = new double[n * n];
    vectorsImaginary = new double[n * n];
    Hessenberg form = new Hessenberg(n, a);
    double norm = norm(form.h);
    ComplexSchur schur = new ComplexSchur(n, form.h, form.q);
    converged = schur.iterate();
    if (converged) {
      double tiny = realBelow(schur, REAL * n * ROUNDING * norm);
      double smallest = Math.max(ROUNDING * norm, SQUARABLE);
      int to = 0;
      for (int k : upperHalf(schur, tiny)) {
        take(schur, form, k, to, smallest);
        if (schur.ti[k * n + k] > tiny) {
          conjugate(to, to + 1);
          to += 2;
        } else {
          makeReal(to);
          to++;
        }
      }
    }
  }

  /**
   * Returns the size below which imaginary parts are rounding: so large that as many lie above as
   * below its negative.
   */
  private double realBelow(ComplexSchur schur, double least) {
    double tiny = least;
    while (true) {
      int above = 0;
      for (int i = 0; i < n; i++) {
        double im = schur.ti[i * n + i];
        above += im > tiny ? 1 : im < -tiny ? -1 : 0;
      }
      if (above == 0) {
        return tiny;
      }
      tiny *= 4;
    }
  }

  /** Returns the real eigenvalues and those with a positive imaginary part, by modulus. */
  private List<Integer> upperHalf(ComplexSchur schur, double tiny) {
    List<Integer> upper = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      if (schur.ti[i * n + i] >= -tiny) {
        upper.add(i);
      }
    }
    Comparator<Integer> byModulus =
        Comparator.comparingDouble(i -> StrictMath.hypot(schur.tr[i * n + i], schur.ti[i * n + i]));
    upper.sort(byModulus.thenComparing(i -> schur.tr[i * n + i]));
    return upper;
  }

  private double norm(double[] h) {
    double largest = 0;
    for (int i = 0; i < n; i++) {
      double sum = 0;
      for (int j = 0; j < n; j++) {
        sum += Math.abs(h[i * n + j]);
      }
      largest = Math.max(largest, sum);
    }
    return largest;
  }

  /** Solves (T − λ I) x = 0 by back substitution from x_k = 1; v = D Z x, scaled to largest 1. */
  private void take(ComplexSchur schur, Hessenberg form, int k, int to, double smallest) {
    real[to] = schur.tr[k * n + k];
    imaginary[to] = schur.ti[k * n + k];
    double[] xr = new double[n];
    double[] xi = new double[n];
    xr[k] = 1;
    for (int i = k - 1; i >= 0; i--) {
      double sr = 0;
      double si = 0;
      for (int j = i + 1; j <= k; j++) {
        sr -= schur.tr[i * n + j] * xr[j] - schur.ti[i * n + j] * xi[j];
        si -= schur.tr[i * n + j] * xi[j] + schur.ti[i * n + j] * xr[j];
      }
      double dr = schur.tr[i * n + i] - schur.tr[k * n + k];
      double di = schur.ti[i * n + i] - schur.ti[k * n + k];
      if (Math.abs(dr) + Math.abs(di) < smallest) {
        dr = smallest;
        di = 0;
      }
      double square = dr * dr + di * di;
      xr[i] = (sr * dr + si * di) / square;
      xi[i] = (si * dr - sr * di) / square;
      rescale(xr, xi, i, k);
    }
    toVector(schur, form, xr, xi, k, to);
  }

  /** Keeps what may grow without bound at size 1. */
  private static void rescale(double[] xr, double[] xi, int from, int to) {
    double size = Math.max(Math.abs(xr[from]), Math.abs(xi[from]));
    if (size > 1) {
      for (int i = from; i <= to; i++) {
        xr[i] /= size;
        xi[i] /= size;
      }
    }
  }

  private void toVector(
      ComplexSchur schur, Hessenberg form, double[] xr, double[] xi, int k, int to) {
    int largest = 0;
    double size = 0;
    for (int i = 0; i < n; i++) {
      double sr = 0;
      double si = 0;
      for (int j = 0; j <= k; j++) {
        sr += schur.zr[i * n + j] * xr[j] - schur.zi[i * n + j] * xi[j];
        si += schur.zr[i * n + j] * xi[j] + schur.zi[i * n + j] * xr[j];
      }
      vectorsReal[to * n + i] = form.scale[i] * sr;
      vectorsImaginary[to * n + i] = form.scale[i] * si;
      double modulus = StrictMath.hypot(vectorsReal[to * n + i], vectorsImaginary[to * n + i]);
      // a later element must be larger by more than rounding to be the one that is made 1
      if (modulus > size * (1 + 1e-9)) {
        size = modulus;
        largest = i;
      }
    }
    divide(to, vectorsReal[to * n + largest], vectorsImaginary[to * n + largest]);
  }

  private void divide(int to, double dr, double di) {
    double square = dr * dr + di * di;
    for (int i = to * n; i < to * n + n; i++) {
      double r = (vectorsReal[i] * dr + vectorsImaginary[i] * di) / square;
      vectorsImaginary[i] = (vectorsImaginary[i] * dr - vectorsReal[i] * di) / square;
      vectorsReal[i] = r;
    }
  }

  private void conjugate(int of, int to) {
    real[to] = real[of];
    imaginary[to] = -imaginary[of];
    for (int i = 0; i < n; i++) {
      vectorsReal[to * n + i] = vectorsReal[of * n + i];
      vectorsImaginary[to * n + i] = -vectorsImaginary[of * n + i];
    }
  }

  private void makeReal(int k) {
    imaginary[k] = 0;
    Arrays.fill(vectorsImaginary, k * n, k * n + n, 0);
  }

  /** Returns whether all eigenvalues were found; if not, nothing else may be asked. */
  public boolean converged() {
    return converged;
  }

  /** Returns the real part of an eigenvalue. */
  public double real(int index) {
    return real[index];
  }

  /** Returns the imaginary part of an eigenvalue; exactly 0 of a real one. */
  public double imaginary(int index) {
    return imaginary[index];
  }

  /**
   * Writes an eigenvector, its element of largest modulus 1.
   *
   * @param re real parts, n numbers; overwritten
   * @param im imaginary parts; overwritten
   */
  public void vector(int index, double[] re, double[] im) {
    System.arraycopy(vectorsReal, index * n, re, 0, n);
    System.arraycopy(vectorsImaginary, index * n, im, 0, n);
  }
}

package org.mechservice.solver.linear.spectrum;

import java.util.Arrays;

/**
 * A real matrix, scaled by powers of two and turned to upper Hessenberg form: D⁻¹ A D = Q H Qᵀ. The
 * scaling makes rows and columns alike in size, which small eigenvalues beside large ones need
 * (Osborne 1960; Parlett and Reinsch, Numer. Math. 13 (1969) 293); the turning is by Householder
 * reflections.
 */
final class Hessenberg {
  private static final double RADIX = 2;

  /** A scaling must gain this much to be worth another round. */
  private static final double GAIN = 0.95;

  private final int n;

  /** H, n × n row by row. */
  final double[] h;

  /** Q, n × n row by row. */
  final double[] q;

  /** D. */
  final double[] scale;

  private final double[] reflector;

  Hessenberg(int n, double[] a) {
    this.n = n;
    h = Arrays.copyOf(a, n * n);
    q = new double[n * n];
    scale = new double[n];
    reflector = new double[n];
    Arrays.fill(scale, 1);
    for (int i = 0; i < n; i++) {
      q[i * n + i] = 1;
    }
    balance();
    for (int k = 0; k < n - 2; k++) {
      reduce(k);
    }
  }

  private void balance() {
    boolean gained = true;
    while (gained) {
      gained = false;
      for (int i = 0; i < n; i++) {
        gained |= balance(i);
      }
    }
  }

  private boolean balance(int i) {
    double column = 0;
    double row = 0;
    for (int j = 0; j < n; j++) {
      if (j != i) {
        column += Math.abs(h[j * n + i]);
        row += Math.abs(h[i * n + j]);
      }
    }
    if (column == 0 || row == 0) {
      return false;
    }
    double sum = column + row;
    double factor = 1;
    while (column < row / RADIX) {
      factor *= RADIX;
      column *= RADIX * RADIX;
    }
    while (column >= row * RADIX) {
      factor /= RADIX;
      column /= RADIX * RADIX;
    }
    if ((column + row) / factor >= GAIN * sum) {
      return false;
    }
    scale[i] *= factor;
    for (int j = 0; j < n; j++) {
      h[i * n + j] /= factor;
      h[j * n + i] *= factor;
    }
    return true;
  }

  /** Reflects rows and columns k+1 … n−1 so that column k is zero below k+1. */
  private void reduce(int k) {
    double largest = 0;
    for (int i = k + 1; i < n; i++) {
      largest = Math.max(largest, Math.abs(h[i * n + k]));
    }
    if (largest == 0) {
      return;
    }
    double square = 0;
    for (int i = k + 1; i < n; i++) {
      reflector[i] = h[i * n + k] / largest;
      square += reflector[i] * reflector[i];
    }
    double norm = Math.copySign(Math.sqrt(square), reflector[k + 1]);
    reflector[k + 1] += norm;
    double beta = 1 / (norm * reflector[k + 1]);
    for (int j = 0; j < n; j++) {
      reflectColumn(j, k + 1, beta);
    }
    for (int i = 0; i < n; i++) {
      reflectRow(h, i, k + 1, beta);
      reflectRow(q, i, k + 1, beta);
    }
    for (int i = k + 2; i < n; i++) {
      h[i * n + k] = 0;
    }
  }

  private void reflectColumn(int j, int from, double beta) {
    double sum = 0;
    for (int i = from; i < n; i++) {
      sum += reflector[i] * h[i * n + j];
    }
    sum *= beta;
    for (int i = from; i < n; i++) {
      h[i * n + j] -= sum * reflector[i];
    }
  }

  private void reflectRow(double[] m, int i, int from, double beta) {
    double sum = 0;
    for (int j = from; j < n; j++) {
      sum += m[i * n + j] * reflector[j];
    }
    sum *= beta;
    for (int j = from; j < n; j++) {
      m[i * n + j] -= sum * reflector[j];
    }
  }
}

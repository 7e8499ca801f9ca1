package org.mechservice.report.reference;

/**
 * The collocation method of Radau IIA with s stages, order 2s − 1 (Hairer &amp; Wanner II, 1996,
 * §IV.5): nodes are the zeros of P_s(2c − 1) − P_{s−1}(2c − 1), the last is 1.
 */
final class RadauTableau {
  final int stages;

  /** Nodes in (0, 1], length s. */
  final double[] c;

  /** Coefficients, s × s: a_ij = ∫₀^{c_i} l_j, l_j the Lagrange polynomials of the nodes. */
  final double[][] a;

  /** l_j(0), length s: extrapolate stage derivatives to the start of the step. */
  final double[] atStart;

  RadauTableau(int stages) {
    this.stages = stages;
    c = nodes(stages);
    a = new double[stages][stages];
    atStart = new double[stages];
    // Gauss's rule with s points integrates polynomials of degree 2s − 1; l_j has s − 1.
    double[][] gauss = gauss(stages);
    for (int j = 0; j < stages; j++) {
      atStart[j] = lagrange(j, 0);
      for (int i = 0; i < stages; i++) {
        double sum = 0;
        for (int k = 0; k < stages; k++) {
          sum += gauss[1][k] * lagrange(j, c[i] * gauss[0][k]);
        }
        a[i][j] = c[i] * sum;
      }
    }
  }

  /** l_j(x). */
  double lagrange(int j, double x) {
    double product = 1;
    for (int k = 0; k < stages; k++) {
      if (k != j) {
        product *= (x - c[k]) / (c[j] - c[k]);
      }
    }
    return product;
  }

  private static double[] nodes(int s) {
    double[] nodes = new double[s];
    double[] between = gauss(s)[0];
    // P_s and P_{s−1} interlace, so P_s − P_{s−1} has one zero between neighbouring zeros of P_s.
    for (int i = 0; i < s - 1; i++) {
      nodes[i] = bisect(s, between[i], between[i + 1]);
    }
    nodes[s - 1] = 1;
    return nodes;
  }

  private static double bisect(int s, double from, double to) {
    double low = from;
    double high = to;
    double sign = Math.signum(radau(s, low));
    for (int i = 0; i < Double.SIZE; i++) {
      double middle = 0.5 * (low + high);
      if (Math.signum(radau(s, middle)) == sign) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return 0.5 * (low + high);
  }

  private static double radau(int s, double c) {
    return legendre(s, 2 * c - 1) - legendre(s - 1, 2 * c - 1);
  }

  private static double legendre(int degree, double x) {
    double previous = 1;
    double p = degree == 0 ? 1 : x;
    for (int k = 2; k <= degree; k++) {
      double next = ((2 * k - 1) * x * p - (k - 1) * previous) / k;
      previous = p;
      p = next;
    }
    return p;
  }

  /** Nodes and weights of Gauss's rule in (0, 1), increasing. */
  private static double[][] gauss(int n) {
    double[][] rule = new double[2][n];
    for (int i = 0; i < n; i++) {
      double x = -Math.cos(Math.PI * (i + 0.75) / (n + 0.5));
      double slope = 1;
      for (int iteration = 0; iteration < 20; iteration++) {
        slope = n * (legendre(n - 1, x) - x * legendre(n, x)) / (1 - x * x);
        x -= legendre(n, x) / slope;
      }
      slope = n * (legendre(n - 1, x) - x * legendre(n, x)) / (1 - x * x);
      rule[0][i] = 0.5 * (1 + x);
      rule[1][i] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
  }
}

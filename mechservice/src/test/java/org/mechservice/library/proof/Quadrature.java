package org.mechservice.library.proof;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegrator;
import org.apache.commons.math3.analysis.integration.gauss.GaussIntegratorFactory;
import org.apache.commons.math3.util.Pair;

/** Integrals of functions that are smooth between given places, by Gauss of order 32. */
final class Quadrature {
  private static final int NODES = 16;
  private static final double[] NODE = new double[NODES];
  private static final double[] WEIGHT = new double[NODES];

  /** Equal parts of each smooth piece. */
  private static final int PARTS = 6;

  static {
    GaussIntegrator rule = new GaussIntegratorFactory().legendre(NODES);
    for (int i = 0; i < NODES; i++) {
      Pair<Double, Double> of = new Pair<>(rule.getPoint(i), rule.getWeight(i));
      NODE[i] = of.getFirst();
      WEIGHT[i] = of.getSecond();
    }
  }

  private Quadrature() {}

  /** Returns the places within an interval, ascending, with its ends, each piece in parts. */
  static double[] pieces(double[] places, double from, double to) {
    double[] inner =
        Arrays.stream(places).filter(x -> x > from && x < to).sorted().distinct().toArray();
    double[] ends = new double[inner.length + 2];
    ends[0] = from;
    ends[ends.length - 1] = to;
    System.arraycopy(inner, 0, ends, 1, inner.length);
    double[] all = new double[PARTS * (ends.length - 1) + 1];
    for (int i = 0; i < ends.length - 1; i++) {
      for (int k = 0; k < PARTS; k++) {
        all[PARTS * i + k] = ends[i] + (ends[i + 1] - ends[i]) * k / PARTS;
      }
    }
    all[all.length - 1] = to;
    return all;
  }

  /** Returns an integral over an interval in which the function is smooth. */
  static double smooth(DoubleUnaryOperator f, double from, double to) {
    double half = 0.5 * (to - from);
    double sum = 0;
    for (int i = 0; i < NODES; i++) {
      sum += WEIGHT[i] * f.applyAsDouble(from + half * (1 + NODE[i]));
    }
    return half * sum;
  }

  /** Returns an integral over an interval of a function that is smooth between places. */
  static double of(DoubleUnaryOperator f, double[] places, double from, double to) {
    double[] pieces = pieces(places, from, to);
    double sum = 0;
    for (int i = 0; i + 1 < pieces.length; i++) {
      sum += smooth(f, pieces[i], pieces[i + 1]);
    }
    return sum;
  }
}

package org.mechservice.study.design;

import java.util.stream.DoubleStream;
import org.apache.commons.math3.distribution.LogNormalDistribution;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.apache.commons.math3.distribution.RealDistribution;
import org.apache.commons.math3.distribution.TriangularDistribution;

/** The values that a factor may take. */
public sealed interface Spread {
  /**
   * Returns the value at a place of the unit interval.
   *
   * @param u above 0 and below 1; the cumulative probability of the value
   */
  double at(double u);

  /** Returns the values of a grid; empty if none are named. */
  double[] levels();

  /**
   * All values between two.
   *
   * @param count number of evenly spaced values of a grid; 0 if a grid is not meant
   */
  record Range(double from, double to, int count) implements Spread {
    @Override
    public double at(double u) {
      return from * (1 - u) + to * u;
    }

    @Override
    public double[] levels() {
      double[] levels = new double[count];
      for (int i = 0; i < count; i++) {
        levels[i] = i == count - 1 && i > 0 ? to : from + i * (to - from) / Math.max(1, count - 1);
      }
      return levels;
    }
  }

  /** A few values, all as likely. */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  record Choice(double[] values) implements Spread {
    @Override
    public double at(double u) {
      return values[Math.min(values.length - 1, (int) (u * values.length))];
    }

    @Override
    public double[] levels() {
      return values.clone();
    }
  }

  /** A distribution. */
  record Distributed(RealDistribution distribution) implements Spread {
    @Override
    public double at(double u) {
      return distribution.inverseCumulativeProbability(u);
    }

    @Override
    public double[] levels() {
      return DoubleStream.empty().toArray();
    }
  }

  /** Returns a normal distribution. */
  static Spread normal(double mean, double deviation) {
    return new Distributed(new NormalDistribution(null, mean, deviation));
  }

  /**
   * Returns the distribution of values whose logarithms are distributed normally.
   *
   * @param mean mean of the values themselves, above 0
   * @param deviation standard deviation of the values themselves
   */
  static Spread lognormal(double mean, double deviation) {
    double variance = Math.log1p(deviation * deviation / (mean * mean));
    return new Distributed(
        new LogNormalDistribution(null, Math.log(mean) - variance / 2, Math.sqrt(variance)));
  }

  /** Returns a triangular distribution. */
  static Spread triangular(double from, double mode, double to) {
    return new Distributed(new TriangularDistribution(null, from, mode, to));
  }
}

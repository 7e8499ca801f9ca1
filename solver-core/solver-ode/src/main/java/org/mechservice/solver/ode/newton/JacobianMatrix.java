package org.mechservice.solver.ode.newton;

import java.util.Arrays;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.SavedState;
import org.mechservice.solver.ode.step.ErrorNorm;

/**
 * A matrix of derivatives in use, and a second one where the next is formed: what turns out not to
 * be finite, or is stopped half way, does not replace the one in use.
 */
public final class JacobianMatrix {
  /** The second half of these powers of a matrix tell how it grows. */
  private static final int POWERS = 16;

  /** The last powers that are compared with the one before are this many and one more. */
  private static final int COMPARED = 3;

  /** What is left after {@link #POWERS} of an eigenvalue of 0.8 times the largest one. */
  private static final double SAME_LINE = 0.05;

  /**
   * Minus the cosine of the angle between powers that are turned round for the most part: several
   * decays of like rates, as those of a diffusion, which no power tells apart. Two growths are not
   * told from a saddle, through which a swing may pass.
   */
  private static final double SAME_DIRECTION = 0.9;

  private static final double GOLDEN_RATIO = 0.6180339887498949;

  /** The last powers whose largest element tells how fast an oscillation dies out. */
  private static final int TURNS = 6;

  /** Range within which sizes are multiplied: one logarithm tells the growth of all of them. */
  private static final double SMALLEST_PRODUCT = 1e-150;

  private static final double LARGEST_PRODUCT = 1e150;

  private final MatrixLayout layout;
  private double[] values;
  private double[] forming;
  private final double[] rowSums;

  /** Spectral radius, once asked for. */
  private double radius;

  /**
   * Largest distance of one of the last powers from the one before, turned round; in largest
   * elements. Of an oscillation, two in a row may look alike by chance, four do not.
   */
  private double offTurned;

  /** The same distance from the one before as it is. */
  private double offKept;

  /** Largest cosine of the angle between one of the last powers and the one before. */
  private double leastTurned;

  private boolean radiusKnown;

  /** Damping ratio and |λ| of the fastest motion if that is an oscillation. */
  private double damping;

  private double rate;

  /** One element of the last powers, and their sizes. */
  private final double[] turns = new double[TURNS];

  private final double[] sizes = new double[TURNS];
  private final double[] power;
  private final double[] product;

  public JacobianMatrix(MatrixLayout layout) {
    this.layout = layout;
    values = new double[layout.length()];
    forming = new double[layout.length()];
    rowSums = new double[layout.dimension()];
    power = new double[layout.dimension()];
    product = new double[layout.dimension()];
  }

  /** Returns the matrix in use, elements by layout; not to be modified. */
  double[] values() {
    return values;
  }

  /** Returns where to form the next, elements by layout. */
  public double[] forming() {
    return forming;
  }

  /** Returns where to form the next after setting it to zero. */
  double[] formingFromZero() {
    Arrays.fill(forming, 0);
    return forming;
  }

  /** Returns the first row with an element that is not finite in the matrix formed; −1 if none. */
  int rowNotFinite() {
    for (int j = 0; j < layout.dimension(); j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        if (!Double.isFinite(forming[layout.index(i, j)])) {
          return i;
        }
      }
    }
    return -1;
  }

  /** Subtracts a multiple of another matrix, of the same layout, from the one just formed. */
  void subtractInForming(double factor, JacobianMatrix other) {
    for (int i = 0; i < forming.length; i++) {
      forming[i] -= factor * other.values[i];
    }
  }

  /** Takes the matrix that was formed into use. */
  public void replace() {
    double[] freed = values;
    values = forming;
    forming = freed;
    radiusKnown = false;
  }

  /** Adds the product of the matrix in use and x to a vector. */
  void addProduct(double[] x, double[] sum) {
    layout.addProduct(values, x, sum);
  }

  /** Adds the absolute values of the terms of that product. */
  void addMagnitudes(double[] x, double[] sum) {
    addMagnitudes(values, x, sum);
  }

  /** Adds the same of the matrix just formed. */
  void addMagnitudesOfForming(double[] x, double[] sum) {
    addMagnitudes(forming, x, sum);
  }

  private void addMagnitudes(double[] values, double[] x, double[] sum) {
    for (int j = 0; j < x.length; j++) {
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        sum[i] += Math.abs(values[layout.index(i, j)] * x[j]);
      }
    }
  }

  /**
   * Returns the norm of the matrix in use that belongs to the maximum norm of weighted vectors: the
   * largest row sum of w_i |J_ij| / w_j.
   */
  double norm(ErrorNorm weights) {
    Arrays.fill(rowSums, 0);
    for (int j = 0; j < rowSums.length; j++) {
      double unit = weights.weight(j) == 0 ? 0 : 1 / weights.weight(j);
      for (int i = layout.firstRow(j); i <= layout.lastRow(j); i = layout.nextRow(i, j)) {
        rowSums[i] += Math.abs(values[layout.index(i, j)]) * unit;
      }
    }
    return weights.of(rowSums);
  }

  /**
   * Returns an estimate of the spectral radius of the matrix in use: by how much its powers grow,
   * which does not depend on the units of the components.
   *
   * <p>0 for a nilpotent matrix; not finite if the estimate overflows.
   */
  public double spectralRadius() {
    if (!radiusKnown) {
      radius = powerGrowth();
      radiusKnown = true;
    }
    return radius;
  }

  /**
   * Returns whether the fastest motion is a decay or a growth: the largest eigenvalue is real and
   * alone in its size, or among others like it. The powers of the matrix then change hardly
   * anything but the length and the sense of a vector.
   */
  public boolean fastestIsExponential() {
    return spectralRadius() > 0 && (powersKeepLine() || leastTurned <= -SAME_DIRECTION);
  }

  private boolean powersKeepLine() {
    return Math.min(offTurned, offKept) < SAME_LINE;
  }

  /**
   * Returns the damping ratio −Re λ / |λ| of the fastest motion if that is an oscillation: the
   * largest eigenvalue λ is one of a pair and alone in its size. 0 if it grows, or is no
   * oscillation.
   */
  public double dampingOfFastest() {
    return spectralRadius() > 0 ? damping : 0;
  }

  /** Returns |λ| of that oscillation; 0 if there is none. */
  public double rateOfFastest() {
    return spectralRadius() > 0 ? rate : 0;
  }

  /**
   * Finds rate and damping by the last powers: with a pair λ, λ̄ alone in size, every element of
   * them obeys x_i = 2 Re(λ) x_{i−1} − |λ|² x_{i−2}, here with λ in units of the growth g. Both
   * coefficients follow by least squares.
   */
  private void findOscillation(double logGrowth, double growth) {
    double scaled = 0;
    for (int i = 0; i < TURNS; i++) {
      scaled += StrictMath.log(sizes[i]) - logGrowth;
      turns[i] *= StrictMath.exp(scaled);
    }
    double aa = 0;
    double ab = 0;
    double bb = 0;
    double ra = 0;
    double rb = 0;
    for (int i = 2; i < TURNS; i++) {
      double a = turns[i - 1];
      double b = -turns[i - 2];
      aa += a * a;
      ab += a * b;
      bb += b * b;
      ra += a * turns[i];
      rb += b * turns[i];
    }
    double determinant = aa * bb - ab * ab;
    double twiceReal = (ra * bb - rb * ab) / determinant;
    double square = (rb * aa - ra * ab) / determinant;
    boolean pair = twiceReal < 0 && twiceReal * twiceReal < 4 * square;
    if (pair) {
      rate = Math.sqrt(square) * growth;
      damping = -twiceReal / (2 * Math.sqrt(square));
    }
  }

  private double powerGrowth() {
    for (int l = 0; l < power.length; l++) {
      // Fractions of multiples of the golden ratio: no matrix met in practice annuls them.
      double multiple = (l + 1) * GOLDEN_RATIO;
      power[l] = 0.5 + (multiple - Math.floor(multiple));
    }
    double growth = 0;
    double common = 1;
    rate = 0;
    damping = 0;
    int followed = 0;
    double[] before = power;
    double[] next = product;
    for (int i = 1; i <= POWERS; i++) {
      Arrays.fill(next, 0);
      addProduct(before, next);
      double size = largest(next);
      if (size == 0) {
        return 0;
      }
      for (int l = 0; l < next.length; l++) {
        next[l] /= size;
      }
      if (i == POWERS - COMPARED) {
        offTurned = 0;
        offKept = 0;
        leastTurned = -1;
      }
      if (i >= POWERS - COMPARED) {
        compareLastPowers(before, next);
      }
      if (i > POWERS / 2) {
        double larger = common * size;
        boolean inRange = larger > SMALLEST_PRODUCT && larger < LARGEST_PRODUCT;
        growth += inRange ? 0 : StrictMath.log(common) + StrictMath.log(size);
        common = inRange ? larger : 1;
      }
      int turn = i - 1 - (POWERS - TURNS);
      followed = turn == 0 ? placeOfLargest(next) : followed;
      if (turn >= 0) {
        turns[turn] = next[followed];
        sizes[turn] = size;
      }
      double[] freed = before;
      before = next;
      next = freed;
    }
    growth = (growth + StrictMath.log(common)) / (POWERS / 2);
    double radius = StrictMath.exp(growth);
    if (!powersKeepLine()) {
      findOscillation(growth, radius);
    }
    return radius;
  }

  /** Returns the largest magnitude, NaN above all: such have the order of their bits. */
  private static double largest(double[] x) {
    long largest = 0;
    for (double element : x) {
      largest = Math.max(largest, Double.doubleToRawLongBits(element) & Long.MAX_VALUE);
    }
    return Double.longBitsToDouble(largest);
  }

  private void compareLastPowers(double[] before, double[] last) {
    double squareBefore = 0;
    double square = 0;
    double common = 0;
    for (int l = 0; l < last.length; l++) {
      offTurned = Math.max(offTurned, Math.abs(last[l] + before[l]));
      offKept = Math.max(offKept, Math.abs(last[l] - before[l]));
      squareBefore += before[l] * before[l];
      square += last[l] * last[l];
      common += last[l] * before[l];
    }
    leastTurned = Math.max(leastTurned, common / Math.sqrt(squareBefore * square));
  }

  private static int placeOfLargest(double[] x) {
    int largest = 0;
    for (int l = 1; l < x.length; l++) {
      largest = Math.abs(x[l]) > Math.abs(x[largest]) ? l : largest;
    }
    return largest;
  }

  /** Returns whether a column of the matrix in use is zero. */
  boolean isZero(int column) {
    for (int i = layout.firstRow(column);
        i <= layout.lastRow(column);
        i = layout.nextRow(i, column)) {
      if (values[layout.index(i, column)] != 0) {
        return false;
      }
    }
    return true;
  }

  /** Returns the row of the largest element in a column of the matrix in use. */
  int rowOfLargest(int column) {
    int row = layout.firstRow(column);
    for (int i = row; i <= layout.lastRow(column); i = layout.nextRow(i, column)) {
      double element = Math.abs(values[layout.index(i, column)]);
      row = element > Math.abs(values[layout.index(row, column)]) ? i : row;
    }
    return row;
  }

  /** Carries the matrix in use over. */
  void transfer(SavedState state) {
    state.numbers(values);
    radiusKnown = false;
  }
}

package org.mechservice.report.measure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.math3.exception.MathArithmeticException;
import org.apache.commons.math3.exception.MaxCountExceededException;
import org.apache.commons.math3.linear.Array2DRowRealMatrix;
import org.apache.commons.math3.linear.EigenDecomposition;
import org.mechservice.report.method.ModelProblem;
import org.mechservice.report.solution.Reference;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.run.Stiffness;

/**
 * Eigenvalues of the linearised equations along a run: ∂f/∂y by central differences in the
 * independent coordinates, decomposed by Commons Math.
 *
 * @param samples one per time looked at
 * @param interval length of the run, s
 */
public record Spectrum(List<Sample> samples, double interval) {
  /** Relative size of a difference: balances rounding against curvature. */
  private static final double STEP = 1e-6;

  /** Operations of eigenvalues with vectors, by n³ (Golub and Van Loan 2013, §7.5.6). */
  private static final double EIGEN_OPERATIONS = 25;

  /** A low estimate for loops over arrays of arrays. */
  private static final double OPERATIONS_PER_SECOND = 5e8;

  public Spectrum {
    samples = List.copyOf(samples);
  }

  /**
   * The spectrum at one time.
   *
   * @param time s
   * @param modes real eigenvalues and those with positive imaginary part, the fastest first
   */
  public record Sample(double time, List<Mode> modes) {
    public Sample {
      modes = List.copyOf(modes);
    }
  }

  /**
   * One eigenvalue.
   *
   * @param real part, 1/s
   * @param imaginary part, rad/s, not negative
   * @param joint the joint that moves most in it
   */
  public record Mode(double real, double imaginary, String joint) {
    /** Returns the modulus, 1/s. */
    public double modulus() {
      return Math.hypot(real, imaginary);
    }

    /** Returns the damping ratio: 1 decays without swinging, 0 swings for ever, −1 grows. */
    public double damping() {
      return modulus() == 0 ? 0 : (0 - real) / modulus();
    }
  }

  /**
   * Looks at the spectrum at several times of a reference.
   *
   * @param problem the scene's equations; its state is used
   * @param most number of times at most
   */
  public static Spectrum along(Reference reference, ModelProblem problem, int most) {
    List<Sample> samples = new ArrayList<>();
    int last = reference.times().length - 1;
    int count = Math.min(most, last + 1);
    for (int i = 0; i < count; i++) {
      int at = count == 1 ? 0 : (int) Math.rint((double) i * last / (count - 1));
      double t = reference.times()[at];
      double[] y = reference.states()[at].clone();
      if (problem.stepEnded(t, y)) {
        at(problem, t, y).ifPresent(samples::add);
      }
    }
    return new Spectrum(samples, reference.end() - reference.times()[0]);
  }

  /**
   * Returns what one sample will take, s: two evaluations for each independent state, the time of
   * which is measured, and the eigenvalues of a dense matrix.
   *
   * @param problem the scene's equations; its state is used
   */
  public static double forecast(Reference reference, ModelProblem problem) {
    double t = reference.times()[0];
    double[] y = reference.states()[0].clone();
    double n = problem.stepEnded(t, y) ? free(problem).length : 0;
    double[] yDot = new double[y.length];
    problem.derivative(t, y, yDot);
    long started = System.nanoTime();
    problem.derivative(t, y, yDot);
    double evaluation = (System.nanoTime() - started) * 1e-9;
    return 2 * n * evaluation + EIGEN_OPERATIONS * n * n * n / OPERATIONS_PER_SECOND;
  }

  /**
   * Looks at the spectrum in one state.
   *
   * @return empty if the equations have no derivative there
   */
  public static Optional<Sample> at(ModelProblem problem, double t, double[] y) {
    int[] free = free(problem);
    if (free.length == 0) {
      return Optional.of(new Sample(t, List.of()));
    }
    double[][] jacobian = jacobian(problem, t, y, free);
    double scale = largestElement(jacobian);
    if (!Double.isFinite(scale)) {
      return Optional.empty();
    }
    EigenDecomposition eigen;
    try {
      eigen = new EigenDecomposition(scaled(jacobian, scale));
    } catch (MaxCountExceededException | MathArithmeticException e) {
      return Optional.empty();
    }
    List<Mode> modes = new ArrayList<>();
    List<String> joints = jointOfState(problem);
    for (int i = 0; i < free.length; i++) {
      double imaginary = eigen.getImagEigenvalue(i);
      if (imaginary >= 0) {
        // A complex pair of eigenvectors stands in two columns: real part, imaginary part.
        double[] re = eigen.getEigenvector(i).toArray();
        double[] im =
            imaginary > 0 ? eigen.getEigenvector(i + 1).toArray() : new double[free.length];
        String joint = joints.get(free[largest(re, im, free, problem)]);
        modes.add(new Mode(scale * eigen.getRealEigenvalue(i), scale * imaginary, joint));
      }
    }
    modes.sort((a, b) -> Double.compare(b.modulus(), a.modulus()));
    return Optional.of(new Sample(t, modes));
  }

  /** Returns the largest |a_ij|; NaN or infinite if an element is. */
  private static double largestElement(double[][] matrix) {
    double largest = 0;
    for (double[] row : matrix) {
      for (double element : row) {
        largest = Math.max(largest, Math.abs(element));
      }
    }
    return largest;
  }

  /** The decomposition compares with absolute bounds: elements of 1 at most fit them. */
  private static Array2DRowRealMatrix scaled(double[][] matrix, double scale) {
    double factor = scale > 0 ? scale : 1;
    for (double[] row : matrix) {
      for (int i = 0; i < row.length; i++) {
        row[i] /= factor;
      }
    }
    return new Array2DRowRealMatrix(matrix, false);
  }

  private static int[] free(ModelProblem problem) {
    return java.util.stream.IntStream.range(0, problem.dimension())
        .filter(problem::independent)
        .toArray();
  }

  private static double[][] jacobian(ModelProblem problem, double t, double[] y, int[] free) {
    int n = free.length;
    double[][] jacobian = new double[n][n];
    double[] above = new double[y.length];
    double[] below = new double[y.length];
    double[] moved = y.clone();
    for (int column = 0; column < n; column++) {
      double kept = y[free[column]];
      double step = STEP * (1 + Math.abs(kept));
      moved[free[column]] = kept + step;
      boolean defined = problem.derivative(t, moved, above);
      moved[free[column]] = kept - step;
      defined &= problem.derivative(t, moved, below);
      moved[free[column]] = kept;
      for (int row = 0; row < n; row++) {
        double slope = (above[free[row]] - below[free[row]]) / (2 * step);
        jacobian[row][column] = defined ? slope : Double.NaN;
      }
    }
    return jacobian;
  }

  /** The velocity that takes part most: of a fast mode, positions hardly move. */
  private static int largest(double[] re, double[] im, int[] free, ModelProblem problem) {
    int velocities = problem.model().description().positionCount();
    int largest = 0;
    double size = -1;
    for (int i = 0; i < re.length; i++) {
      double part = Math.hypot(re[i], im[i]);
      if (free[i] >= velocities && part > size) {
        size = part;
        largest = i;
      }
    }
    return largest;
  }

  private static List<String> jointOfState(ModelProblem problem) {
    List<String> names = new ArrayList<>();
    List<JointVariables> joints = problem.model().description().joints();
    for (JointVariables joint : joints) {
      for (int i = 0; i < joint.type().positionCount(); i++) {
        names.add(joint.name());
      }
    }
    for (JointVariables joint : joints) {
      for (int i = 0; i < joint.type().velocityCount(); i++) {
        names.add(joint.name());
      }
    }
    return names;
  }

  /** Returns the fastest mode met of those that decide on the verdict. */
  public Optional<Mode> fastest() {
    boolean damped = verdict() == Stiffness.Verdict.STIFF;
    boolean any = verdict() == Stiffness.Verdict.NOT_STIFF;
    return samples.stream()
        .flatMap(sample -> deciding(sample.modes()).stream())
        .filter(mode -> any || Stiffness.isDamped(mode.real(), mode.imaginary()) == damped)
        .max((a, b) -> Double.compare(a.modulus(), b.modulus()));
  }

  private static Optional<Mode> deciding(List<Mode> modes) {
    return modes.isEmpty()
        ? Optional.empty()
        : Optional.of(modes.get(Stiffness.deciding(reals(modes), imaginaries(modes))));
  }

  private static double[] reals(List<Mode> modes) {
    return modes.stream().mapToDouble(Mode::real).toArray();
  }

  private static double[] imaginaries(List<Mode> modes) {
    return modes.stream().mapToDouble(Mode::imaginary).toArray();
  }

  /** Returns the smallest modulus that the interval is long enough to show, 1/s. */
  public double slowest() {
    return samples.stream()
        .flatMap(sample -> sample.modes().stream())
        .mapToDouble(Mode::modulus)
        .filter(modulus -> modulus * interval > 1)
        .min()
        .orElse(1 / interval);
  }

  /** Returns the measure of stiffness, with which the report of a run is judged, too. */
  public Stiffness stiffness() {
    Stiffness stiffness = new Stiffness();
    for (Sample sample : samples) {
      stiffness.add(reals(sample.modes()), imaginaries(sample.modes()));
    }
    return stiffness;
  }

  /** Returns the verdict on the interval. */
  public Stiffness.Verdict verdict() {
    return stiffness().verdict(interval);
  }
}

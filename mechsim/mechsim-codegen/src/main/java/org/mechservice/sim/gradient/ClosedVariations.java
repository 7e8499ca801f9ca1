package org.mechservice.sim.gradient;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.sim.equations.loop.LoopCode;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * The equations of a mechanism with loops: M a + b + Jᵀλ = 0 and J a + γ = 0, solved for a and λ.
 * With K = [M Jᵀ; J 0], which is symmetric, and R the left-hand sides at given a and λ, the
 * derivative of [a; λ] along any direction is −K⁻¹ R', and the adjoint of a weighted by w is −Rᵀ'
 * K⁻¹ [w; 0]: a direction costs the derivative of R and one solution with the factors that gave a.
 *
 * <p>Of equations that depend on others only independent ones are taken, chosen once at the start.
 */
final class ClosedVariations extends VariationalEquations {
  /** Result where the equations cannot be solved for the accelerations. */
  private static final int SINGULAR = -1000;

  /** Relative size below which a row that others are subtracted from counts as dependent. */
  private static final double DEPENDENT = 1e-8;

  private static final int PROJECTIONS = 8;
  private static final double[] NONE = {};

  private final int nq;
  private final int nv;
  private final int all;
  private final int[] rows;
  private final int m;
  private final ProgramCode terms;
  private final double[] term;
  private final DifferentiableFunction residual;
  private final DifferentiableFunction rates;
  private final DenseLu factors;
  private final double[] matrix;
  private final double[] right;

  /** y, a and λ, as R takes them. */
  private final double[] given;

  private final double[] weights;
  private final double[] slopes;
  private final double[] slopesOfRates;
  private final double[] seedOfResidual;
  private final double[] outOfResidual;
  private final double[] outOfRates;
  private final double[] moved;
  private final DenseLu normal;
  private final double[] normalMatrix;
  private double[] seeds = NONE;
  private double[] outs = NONE;
  private int directions;
  private final int parameterCount;

  /**
   * @param start assembled state at {@code time}, where the independent equations are chosen
   */
  ClosedVariations(
      Mechanism mechanism, int[] chosen, double[] parameters, double time, double[] start) {
    super(mechanism.stateCount());
    Links links = Links.of(mechanism);
    nq = mechanism.positionCount();
    nv = mechanism.velocityCount();
    all = new LoopEquations(new TreeGeometry(mechanism)).count();
    Program termsProgram = LoopCode.equations(links, all);
    terms = ProgramCode.of(termsProgram, states(), parameters);
    term = new double[LoopTerms.count(all, nv)];
    terms.run(time, start, NONE, term);
    rows = independent();
    m = rows.length;
    given = new double[states() + nv + m];
    residual =
        new DifferentiableFunction(
            residual(termsProgram), given.length, nv + m, chosen, parameters);
    rates =
        new DifferentiableFunction(LoopCode.rates(links), states(), states(), chosen, parameters);
    factors = new DenseLu(nv + m);
    matrix = new double[(nv + m) * (nv + m)];
    right = new double[nv + m];
    weights = new double[nv + m];
    parameterCount = chosen.length;
    slopes = new double[given.length + 1 + parameterCount];
    slopesOfRates = new double[states() + 1 + parameterCount];
    seedOfResidual = new double[given.length + 1 + parameterCount];
    outOfResidual = new double[2 * (nv + m)];
    outOfRates = new double[2 * states()];
    moved = new double[states()];
    normal = new DenseLu(m);
    normalMatrix = new double[m * m];
  }

  /** Returns the left-hand sides at given a and λ, as a function of y, a and λ. */
  private Program residual(Program program) {
    Map<Integer, Scalar> outputs = new TreeMap<>();
    for (Program.Section section : program.sections()) {
      section.outputs().forEach(output -> outputs.put(output.index(), output.value()));
    }
    Scalar zero = program.expressions().zero();
    Program sums =
        program.in(program.sections().stream().map(Program.Section::withoutOutputs).toList());
    sums.section("M a + b + J' lambda, J a + gamma at given a and lambda.", "residual");
    for (int i = 0; i < nv; i++) {
      Scalar sum = outputs.getOrDefault(LoopTerms.biasAt(all, nv) + i, zero);
      for (int j = 0; j < nv; j++) {
        int at = LoopTerms.massAt(all, nv) + Math.max(i, j) * nv + Math.min(i, j);
        sum = sum.plus(outputs.getOrDefault(at, zero).times(acceleration(program, j)));
      }
      for (int r = 0; r < m; r++) {
        Scalar lambda = program.expressions().input(states() + nv + r);
        sum = sum.plus(outputs.getOrDefault(jacobianAt(r, i), zero).times(lambda));
      }
      sums.output(i, sum);
    }
    for (int r = 0; r < m; r++) {
      Scalar sum = outputs.getOrDefault(LoopTerms.offsetAt(all, nv) + rows[r], zero);
      for (int j = 0; j < nv; j++) {
        sum =
            sum.plus(outputs.getOrDefault(jacobianAt(r, j), zero).times(acceleration(program, j)));
      }
      sums.output(nv + r, sum);
    }
    return sums;
  }

  private Scalar acceleration(Program program, int velocity) {
    return program.expressions().input(states() + velocity);
  }

  private int jacobianAt(int row, int velocity) {
    return LoopTerms.jacobianAt(all) + rows[row] * nv + velocity;
  }

  /** Chooses independent rows of J by elimination with complete pivoting. */
  private int[] independent() {
    double[][] left = new double[all][nv];
    for (int r = 0; r < all; r++) {
      double largest = 0;
      for (int j = 0; j < nv; j++) {
        left[r][j] = term[LoopTerms.jacobianAt(all) + r * nv + j];
        largest = Math.max(largest, Math.abs(left[r][j]));
      }
      for (int j = 0; j < nv && largest > 0; j++) {
        left[r][j] /= largest;
      }
    }
    List<Integer> chosen = new ArrayList<>();
    while (chosen.size() < Math.min(all, nv)) {
      int row = -1;
      int column = -1;
      double largest = DEPENDENT;
      for (int r = 0; r < all; r++) {
        for (int j = 0; j < nv && !chosen.contains(r); j++) {
          if (Math.abs(left[r][j]) > largest) {
            largest = Math.abs(left[r][j]);
            row = r;
            column = j;
          }
        }
      }
      if (row < 0) {
        break;
      }
      chosen.add(row);
      for (int r = 0; r < all; r++) {
        double factor = chosen.contains(r) ? 0 : left[r][column] / left[row][column];
        for (int j = 0; j < nv && factor != 0; j++) {
          left[r][j] -= factor * left[row][j];
        }
      }
    }
    return chosen.stream().mapToInt(Integer::intValue).sorted().toArray();
  }

  /** Solves for a and λ into {@code given}, and keeps the factors of K. */
  private int solve(double t, double[] y) {
    int result = terms.run(t, y, NONE, term);
    if (result != ProgramCode.REGULAR) {
      return result;
    }
    int size = nv + m;
    Arrays.fill(matrix, 0);
    for (int i = 0; i < nv; i++) {
      for (int j = 0; j <= i; j++) {
        double element = term[LoopTerms.massAt(all, nv) + i * nv + j];
        matrix[i * size + j] = element;
        matrix[j * size + i] = element;
      }
      right[i] = -term[LoopTerms.biasAt(all, nv) + i];
    }
    for (int r = 0; r < m; r++) {
      for (int j = 0; j < nv; j++) {
        double element = term[jacobianAt(r, j)];
        matrix[(nv + r) * size + j] = element;
        matrix[j * size + nv + r] = element;
      }
      right[nv + r] = -term[LoopTerms.offsetAt(all, nv) + rows[r]];
    }
    if (factors.factor(matrix) != LinearSolver.NONSINGULAR) {
      return SINGULAR;
    }
    factors.solve(right);
    System.arraycopy(y, 0, given, 0, states());
    System.arraycopy(right, 0, given, states(), size);
    return ProgramCode.REGULAR;
  }

  @Override
  public int derivative(double t, double[] y, double[] yDot) {
    int result = solve(t, y);
    if (result == ProgramCode.REGULAR) {
      rates.value(t, y, yDot);
      System.arraycopy(given, states(), yDot, nq, nv);
    }
    return result;
  }

  @Override
  public void directions(int[] unit) {
    residual.directions(unit);
    rates.directions(unit);
    directions = unit.length;
    seeds = new double[unit.length * given.length];
    outs = new double[(unit.length + 1) * (nv + m)];
  }

  @Override
  public int tangents(double t, double[] y, double[] along, double[] out) {
    int result = solve(t, y);
    if (result != ProgramCode.REGULAR) {
      return result;
    }
    for (int k = 0; k < directions; k++) {
      System.arraycopy(along, k * states(), seeds, k * given.length, states());
    }
    residual.tangents(t, given, seeds, outs);
    rates.tangents(t, y, along, out);
    System.arraycopy(given, states(), out, nq, nv);
    for (int k = 0; k < directions; k++) {
      putAcceleration(outs, (k + 1) * (nv + m), out, (k + 1) * states());
    }
    return result;
  }

  /** Writes −K⁻¹ R' as the rate of the velocities. */
  private void putAcceleration(double[] rate, int from, double[] out, int to) {
    for (int i = 0; i < nv + m; i++) {
      right[i] = -rate[from + i];
    }
    factors.solve(right);
    System.arraycopy(right, 0, out, to + nq, nv);
  }

  @Override
  public int tangent(double t, double[] y, double[] seed, double[] out) {
    int result = solve(t, y);
    if (result != ProgramCode.REGULAR) {
      return result;
    }
    System.arraycopy(seed, 0, seedOfResidual, 0, states());
    System.arraycopy(seed, states(), seedOfResidual, given.length, 1 + parameterCount);
    residual.tangent(t, given, seedOfResidual, outOfResidual);
    rates.tangent(t, y, seed, outOfRates);
    System.arraycopy(outOfRates, 0, out, 0, 2 * states());
    System.arraycopy(given, states(), out, nq, nv);
    putAcceleration(outOfResidual, nv + m, out, states());
    return result;
  }

  @Override
  public int adjoint(double t, double[] y, double[] of, double[] out) {
    int result = solve(t, y);
    if (result != ProgramCode.REGULAR) {
      return result;
    }
    Arrays.fill(weights, 0);
    System.arraycopy(of, nq, weights, 0, nv);
    factors.solve(weights);
    residual.adjoint(t, given, weights, slopes);
    rates.adjoint(t, y, of, slopesOfRates);
    for (int i = 0; i < states(); i++) {
      out[i] = slopesOfRates[i] - slopes[i];
    }
    for (int i = 0; i <= parameterCount; i++) {
      out[states() + i] = slopesOfRates[states() + i] - slopes[given.length + i];
    }
    return result;
  }

  @Override
  public boolean project(double t, double[] y) {
    for (int pass = 0; pass < PROJECTIONS; pass++) {
      terms.run(t, y, NONE, term);
      double before = 0;
      for (int r = 0; r < m; r++) {
        before = Math.max(before, Math.abs(term[rows[r]]));
      }
      if (before < 1e-14) {
        break;
      }
      if (!leastMove(0, moved)) {
        return false;
      }
      // q' of a velocity is the change of q along it
      System.arraycopy(y, 0, given, 0, states());
      System.arraycopy(moved, nq, given, nq, nv);
      rates.value(t, given, outOfRates);
      double largest = 0;
      for (int i = 0; i < nq; i++) {
        y[i] += outOfRates[i];
        largest = Math.max(largest, Math.abs(outOfRates[i]));
      }
      if (largest < 1e-14) {
        break;
      }
    }
    terms.run(t, y, NONE, term);
    if (!leastMove(all, moved)) {
      return false;
    }
    for (int i = 0; i < nv; i++) {
      y[nq + i] += moved[nq + i];
    }
    return Double.isFinite(y[nq]);
  }

  /** Solves J d = −(terms from {@code at} on) for the least d, which goes to the velocities. */
  private boolean leastMove(int at, double[] into) {
    double[] lambda = new double[m];
    for (int r = 0; r < m; r++) {
      for (int s = 0; s < m; s++) {
        double sum = 0;
        for (int j = 0; j < nv; j++) {
          sum += term[jacobianAt(r, j)] * term[jacobianAt(s, j)];
        }
        normalMatrix[r * m + s] = sum;
      }
      lambda[r] = -term[at + rows[r]];
    }
    if (normal.factor(normalMatrix) != LinearSolver.NONSINGULAR) {
      return false;
    }
    normal.solve(lambda);
    for (int j = 0; j < nv; j++) {
      double sum = 0;
      for (int r = 0; r < m; r++) {
        sum += term[jacobianAt(r, j)] * lambda[r];
      }
      into[nq + j] = sum;
    }
    return true;
  }

  @Override
  Iterable<Program> programs() {
    // Φ itself, with its nearest turns, is in neither
    return List.of(residual.program(), rates.program());
  }
}

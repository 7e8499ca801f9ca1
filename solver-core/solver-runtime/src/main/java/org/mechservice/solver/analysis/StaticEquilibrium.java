package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.assembly.Assembly;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.linear.Cholesky;
import org.mechservice.solver.linear.DenseLu;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.Vector3;

/**
 * The equilibrium of a mechanism: Rᵀ (b − τ) = 0 at v = 0 for positions that close the loops, with
 * constant prescribed motions.
 *
 * <p>A trust-region Newton method (Conn, Gould and Toint 2000, ch. 6) solves (K + λD) z = −Rᵀ (b −
 * τ), with λ = 0 or such that z has the trust radius and K + λD is positive definite, so that steps
 * lead downhill and away from an unstable equilibrium. D is diagonal, scaled by K and the residual
 * forces, so that relevant λ are about one and all degrees of freedom are treated equally. A step
 * is accepted if the forces along it have done work; the trust radius grows if the work agrees with
 * the prediction of K and shrinks otherwise. The work is that of the mean of the forces at both
 * ends of the step, so that non-conservative forces are included.
 */
final class StaticEquilibrium {
  /**
   * Initial and largest trust radius: largest move of a coordinate, rad or lengths of the
   * mechanism. Longer steps might lead to an equilibrium that is not the nearest downhill.
   */
  private static final double FIRST_TRUST = 0.1;

  private static final double MOST_TRUST = 0.3;

  /** Smallest trust radius; the search then fails. */
  private static final double LEAST_TRUST = 1e-12;

  /**
   * Fractions of the predicted work below which a step is rejected, or the trust radius shrinks or
   * grows.
   */
  private static final double TAKEN = 1e-3;

  private static final double TRUSTED_LESS = 0.25;
  private static final double TRUSTED_MORE = 0.7;

  /** Smallest length of a step at the trust radius, as a fraction of it. */
  private static final double LONG_ENOUGH = 0.8;

  /** Factor of the search for λ, and its largest number of trials. */
  private static final double GROWTH = 10;

  private static final int TRIES = 60;

  /** Smallest element of D, as a fraction of its largest. */
  private static final double LEAST_SCALE = 1e-9;

  /** Growth rate, as a fraction of the largest eigenvalue, above which a mode is unstable. */
  private static final double GROWS = 1e-6;

  private final Mechanism mechanism;
  private final UserForceSource userForces;
  private final CoordinateNames names;
  private final double tolerance;
  private final int most;
  private final List<Note> notes = new ArrayList<>();
  private EquationsOfMotion equations;
  private double[] y = new double[0];
  private Optional<Defect> defect = Optional.empty();
  private long iterations;

  /** Residual forces Rᵀ (b − τ), and their directions. */
  private double[] left = new double[0];

  private int worst;
  private double worstPart;

  /**
   * @param tolerance largest residual force relative to the largest force
   * @param most largest number of corrections
   */
  StaticEquilibrium(Mechanism mechanism, UserForceSource userForces, double tolerance, int most) {
    this.mechanism = mechanism;
    this.userForces = userForces;
    this.tolerance = tolerance;
    this.most = most;
    names = new CoordinateNames(mechanism);
    equations = new EquationsOfMotion(mechanism, userForces);
  }

  /** Returns the state found, at rest. */
  double[] state() {
    return y.clone();
  }

  /** Returns why none was found. */
  Defect defect() {
    return defect.orElseThrow();
  }

  /** Returns notes on the equilibria found. */
  List<Note> notes() {
    return List.copyOf(notes);
  }

  /** Returns the total number of corrections. */
  long iterations() {
    return iterations;
  }

  /** Returns the equations with constant motions, placed at the state found. */
  EquationsOfMotion equations() {
    return equations;
  }

  /**
   * Finds the equilibrium nearest downhill from the start.
   *
   * @param t time at which prescribed motions are held, s
   * @return whether one was found; if not, {@link #defect} says why
   */
  boolean find(double t) {
    Mechanism held = HeldMotions.at(mechanism, t);
    equations = new EquationsOfMotion(held, userForces);
    y = new double[mechanism.stateCount()];
    held.initialState(y);
    Arrays.fill(y, equations.nq, equations.nq + equations.nv, 0);
    for (LoopFinding finding : new Assembly(equations.tree).assemble(t, y)) {
      if (!finding.kind().isWarning()) {
        defect =
            Optional.of(new Defect(finding.kind().code(), finding.part(), finding.message(), ""));
        return false;
      }
      notes.add(finding.note());
    }
    Arrays.fill(y, equations.nq, equations.nq + equations.nv, 0);
    equations.closePositions(t, y);
    try {
      return descend(t);
    } catch (Linearisation.NotLinearised e) {
      defect = Optional.of(e.defect());
      return false;
    }
  }

  private boolean descend(double t) throws Linearisation.NotLinearised {
    double[] rest = new double[equations.nv];
    Linearisation linear = new Linearisation(equations, t, y, rest);
    double trust = FIRST_TRUST;
    for (int i = 0; i <= most && trust > LEAST_TRUST; i++) {
      if (unbalanced(linear) <= tolerance) {
        notes.addAll(judged(equations, t, linear));
        return true;
      }
      if (i == most) {
        break;
      }
      double[] z = new double[linear.freedom()];
      solve(linear, trust, z);
      double length = longest(linear, z);
      double part = move(t, linear, z);
      iterations++;
      if (part > TAKEN) {
        linear = new Linearisation(equations, t, y, rest);
      } else if (Double.isNaN(part) && trust < FIRST_TRUST * TRUSTED_LESS * TRUSTED_LESS) {
        return notClosed();
      }
      if (!(part >= TRUSTED_LESS)) {
        trust = TRUSTED_LESS * Math.min(trust, length);
      } else if (part >= TRUSTED_MORE) {
        trust = Math.min(MOST_TRUST, Math.max(trust, 2 * length));
      }
    }
    equations.place(t, y);
    return notFound();
  }

  /** Returns the largest residual force relative to the largest force. */
  private double unbalanced(Linearisation linear) {
    left = new double[linear.freedom()];
    linear.project(equations.residual, left);
    double play = inPlay();
    worst = -1;
    worstPart = 0;
    for (int j = 0; j < left.length; j++) {
      double part = Math.abs(left[j]) * equations.unit[linear.independent()[j]] / play;
      if (!(part <= worstPart)) {
        worstPart = part;
        worst = j;
      }
    }
    worst = worst < 0 ? -1 : linear.independent()[worst];
    return worstPart;
  }

  /** Returns an upper bound of the moment of weight and applied forces, N·m. */
  private double inPlay() {
    double length = equations.loops.length();
    Vector3 g = mechanism.gravity();
    double sum = Double.MIN_NORMAL;
    for (int link = 0; link < equations.tree.linkCount; link++) {
      sum += equations.tree.mass[link] * g.norm() * length;
    }
    for (int i = 0; i < equations.wrench.length; i++) {
      sum += Math.abs(equations.wrench[i]) * (i % 6 < 3 ? 1 : length);
    }
    for (int j = 0; j < equations.nv; j++) {
      sum += Math.abs(equations.tau[j]) * equations.unit[j];
    }
    return sum;
  }

  private double longest(Linearisation linear, double[] z) {
    double[] xi = new double[equations.nv];
    linear.expand(z, xi);
    double longest = 0;
    for (int i = 0; i < xi.length; i++) {
      longest = Math.max(longest, Math.abs(xi[i]) / equations.unit[i]);
    }
    return longest;
  }

  /** Solves for a step within the trust radius. */
  private void solve(Linearisation linear, double trust, double[] z) {
    double[] scale = scale(linear);
    if (solve(linear, scale, 0, z) && longest(linear, z) <= trust) {
      return;
    }
    double below = 0;
    double above = 0;
    double shift = 1;
    for (int tries = 0; tries < TRIES; tries++) {
      boolean downhill = solve(linear, scale, shift, z);
      double length = downhill ? longest(linear, z) : Double.POSITIVE_INFINITY;
      if (length <= trust) {
        if (length >= LONG_ENOUGH * trust || shift <= below * (1 + 1e-12)) {
          return;
        }
        above = shift;
        shift = below > 0 ? Math.sqrt(below * above) : shift / GROWTH;
      } else {
        below = shift;
        shift = above > 0 ? Math.sqrt(below * above) : shift * GROWTH;
      }
    }
    solve(linear, scale, above, z);
  }

  /**
   * Returns D: the scale of K and of the residual forces for each degree of freedom, N·m or N/m.
   */
  private double[] scale(Linearisation linear) {
    int f = linear.freedom();
    double[] scale = new double[f];
    double most = Double.MIN_NORMAL;
    for (int j = 0; j < f; j++) {
      double unit = equations.unit[linear.independent()[j]];
      scale[j] = Math.abs(linear.stiffness[j * f + j]) + Math.abs(left[j]) / unit;
      most = Math.max(most, scale[j] * unit * unit);
    }
    for (int j = 0; j < f; j++) {
      double unit = equations.unit[linear.independent()[j]];
      scale[j] = Math.max(scale[j], LEAST_SCALE * most / (unit * unit));
    }
    return scale;
  }

  /** Solves (K + λD) z = −r; returns whether the symmetric part of K + λD is positive definite. */
  private boolean solve(Linearisation linear, double[] scale, double shift, double[] z) {
    int f = linear.freedom();
    double[] symmetric = new double[f * f];
    double[] matrix = linear.stiffness.clone();
    for (int i = 0; i < f; i++) {
      matrix[i * f + i] += shift * scale[i];
      for (int j = 0; j <= i; j++) {
        symmetric[i * f + j] = 0.5 * (matrix[i * f + j] + matrix[j * f + i]);
      }
    }
    if (new Cholesky(f).factor(symmetric) != Cholesky.POSITIVE_DEFINITE) {
      return false;
    }
    DenseLu lu = new DenseLu(f);
    if (lu.factor(matrix) != LinearSolver.NONSINGULAR) {
      return false;
    }
    for (int j = 0; j < f; j++) {
      z[j] = -left[j];
    }
    lu.solve(z);
    return true;
  }

  /**
   * Moves along z if that is downhill.
   *
   * @return the work of the forces divided by the prediction of K; NaN if the loops cannot be
   *     closed there or a force has no value
   */
  private double move(double t, Linearisation linear, double[] z) {
    double[] xi = new double[equations.nv];
    double[] ahead = new double[z.length];
    double[] tried = y.clone();
    linear.expand(z, xi);
    equations.coordinates.move(tried, 0, xi, 0, 1);
    boolean fits = equations.closePositions(t, tried);
    equations.place(t, tried);
    if (!fits || !equations.applyForces(t)) {
      return Double.NaN;
    }
    equations.formResidual(new double[equations.nv], 0);
    linear.project(equations.residual, ahead);
    double foretold = dot(left, z);
    for (int i = 0; i < z.length; i++) {
      for (int j = 0; j < z.length; j++) {
        foretold += 0.5 * z[i] * linear.stiffness[i * z.length + j] * z[j];
      }
    }
    double part = 0.5 * (dot(left, z) + dot(ahead, z)) / foretold;
    if (part > TAKEN) {
      y = tried;
    }
    return part;
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < a.length; i++) {
      sum += a[i] * b[i];
    }
    return sum;
  }

  private boolean notClosed() {
    defect =
        Optional.of(
            new Defect(
                MessageCode.NO_EQUILIBRIUM,
                worst < 0 ? "" : names.part(worst),
                "No equilibrium was found: the loops cannot be closed between the start and the"
                    + " equilibrium.",
                "Start nearer to the equilibrium; the mechanism locks before it."));
    return false;
  }

  private boolean notFound() {
    defect =
        Optional.of(
            new Defect(
                MessageCode.NO_EQUILIBRIUM,
                worst < 0 ? "" : names.part(worst),
                String.format(
                    Locale.ROOT,
                    "No equilibrium was found in %d correction%s: the largest force left over is"
                        + " %.3g times those in play.",
                    iterations,
                    iterations == 1 ? "" : "s",
                    worstPart),
                "Add a restoring force to free motions, start nearer to the equilibrium, or allow"
                    + " more corrections with maxIterations."));
    return false;
  }

  /** Returns notes if an equilibrium is unstable or not isolated. */
  static List<Note> judged(EquationsOfMotion equations, double t, Linearisation linear) {
    List<Note> notes = new ArrayList<>();
    if (ProvenStability.of(linear, Modes.ZERO)) {
      return notes;
    }
    CoordinateNames names = new CoordinateNames(equations.tree.mechanism());
    double[] system = linear.freedom() == 0 ? new double[0] : linear.system();
    if (system.length == 0) {
      return notes;
    }
    Modes modes = new Modes(linear, linear.changing(system));
    double largest = 0;
    for (int k = 0; k < modes.count(); k++) {
      largest = Math.max(largest, Math.hypot(modes.growth(k), modes.angularFrequency(k)));
    }
    int growing = -1;
    int neutral = -1;
    for (int k = 0; k < modes.count(); k++) {
      boolean grows = modes.growth(k) > GROWS * largest;
      growing = grows && (growing < 0 || modes.growth(k) > modes.growth(growing)) ? k : growing;
      neutral = modes.frequency(k) == 0 ? k : neutral;
    }
    if (growing >= 0) {
      String text =
          String.format(
              Locale.ROOT,
              "The equilibrium is unstable: a small disturbance grows with %.3g/s, most of all in"
                  + " %s.",
              modes.growth(growing),
              names.part(mostMoved(equations, linear, modes, growing)));
      notes.add(new Note(MessageCode.UNSTABLE_EQUILIBRIUM, t, true, text));
    }
    if (neutral >= 0) {
      String text =
          "The equilibrium is not the only one: nothing brings "
              + names.part(mostMoved(equations, linear, modes, neutral))
              + " back.";
      notes.add(new Note(MessageCode.EQUILIBRIUM_NOT_UNIQUE, t, true, text));
    }
    return notes;
  }

  private static int mostMoved(
      EquationsOfMotion equations, Linearisation linear, Modes modes, int k) {
    double[] re = new double[equations.nv + linear.changingCount()];
    double[] im = new double[re.length];
    modes.shape(k, equations.unit, re, im);
    int most = 0;
    for (int i = 1; i < equations.nv; i++) {
      if (Math.abs(re[i]) / equations.unit[i] > Math.abs(re[most]) / equations.unit[most]) {
        most = i;
      }
    }
    return most;
  }
}

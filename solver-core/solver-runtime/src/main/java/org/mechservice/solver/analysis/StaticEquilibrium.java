package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
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
 * Where a mechanism comes to rest: Rᵀ (b − τ) = 0 at v = 0 on the positions that close the loops,
 * prescribed motions held.
 *
 * <p>Steps (M/Δ + K) z = −Rᵀ (b − τ), implicit ones of the motion M ż = −Rᵀ (b − τ), which a
 * mechanism in thick oil would follow from its start. Δ grows as the forces left over fall, until
 * the steps are Newton's; it shrinks as long as M/Δ + K is not positive definite, so that they lead
 * away from an unstable equilibrium. A step that goes too far along its direction is halved.
 */
final class StaticEquilibrium {
  /** No coordinate moves further in one step, rad or lengths of the mechanism. */
  private static final double LONGEST_STEP = 0.3;

  /** First step, rad or lengths. */
  private static final double FIRST_STEP = 0.1;

  /** Growth of Δ at most, by which Newton's steps are reached in some ten. */
  private static final double FASTEST_GROWTH = 10;

  /** A step is halved as long as the force along it has turned to this part of what it was. */
  private static final double TURNED = 0.9;

  /** No step is made shorter than this part of what it was. */
  private static final double SHORTEST = 1e-3;

  /** A mode grows if its exponent is beyond this part of the largest eigenvalue. */
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

  /** Forces left over, Rᵀ (b − τ), and the directions they are along. */
  private double[] left = new double[0];

  private int worst;
  private double worstPart;

  /**
   * @param tolerance largest force left over relative to the largest in play
   * @param most corrections allowed
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

  /** Returns what there is to say of the equilibria found. */
  List<Note> notes() {
    return List.copyOf(notes);
  }

  /** Returns how many corrections were made in all. */
  long iterations() {
    return iterations;
  }

  /** Returns the equations, whose motions are held; placed at the state found. */
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
    y = new double[equations.nq + equations.nv];
    held.initialState(y);
    Arrays.fill(y, equations.nq, y.length, 0);
    for (LoopFinding finding : new Assembly(equations.tree).assemble(t, y)) {
      if (!finding.kind().isWarning()) {
        defect =
            Optional.of(new Defect(finding.kind().code(), finding.part(), finding.message(), ""));
        return false;
      }
      notes.add(finding.note());
    }
    Arrays.fill(y, equations.nq, y.length, 0);
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
    double step = 0;
    double before = Double.POSITIVE_INFINITY;
    for (int i = 0; i <= most; i++) {
      Linearisation linear = new Linearisation(equations, t, y, rest);
      double unbalanced = unbalanced(linear);
      if (unbalanced <= tolerance) {
        judge(t, linear);
        return true;
      }
      step = i == 0 ? firstStep(linear) : step * Math.min(FASTEST_GROWTH, before / unbalanced);
      before = unbalanced;
      double[] z = new double[linear.freedom()];
      step = solve(linear, step, z);
      if (!move(t, linear, z)) {
        return notClosed();
      }
      iterations++;
    }
    return notFound();
  }

  /** Returns the largest force left over, relative to those in play. */
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

  /** Returns the moment that weight and applied forces could have at most, N·m. */
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

  /** Returns the Δ of a first step of convenient length: z ≈ −Δ M⁻¹ r. */
  private double firstStep(Linearisation linear) {
    DenseLu lu = new DenseLu(linear.freedom());
    if (lu.factor(linear.mass) != LinearSolver.NONSINGULAR) {
      return 1;
    }
    double[] z = left.clone();
    lu.solve(z);
    double longest = longest(linear, z);
    return longest > 0 ? FIRST_STEP / longest : 1;
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

  /** Solves for a step with the largest Δ up to {@code step} that leads downhill; returns it. */
  private double solve(Linearisation linear, double step, double[] z) {
    int f = linear.freedom();
    Cholesky factors = new Cholesky(f);
    double[] symmetric = new double[f * f];
    double[] matrix = new double[f * f];
    double taken = step;
    for (int tries = 0; tries < 40; tries++) {
      for (int i = 0; i < f; i++) {
        for (int j = 0; j < f; j++) {
          int ij = i * f + j;
          matrix[ij] = linear.mass[ij] / taken + linear.stiffness[ij];
          symmetric[ij] =
              linear.mass[ij] / taken + 0.5 * (linear.stiffness[ij] + linear.stiffness[j * f + i]);
        }
      }
      if (factors.factor(symmetric) == Cholesky.POSITIVE_DEFINITE) {
        break;
      }
      taken /= 4;
    }
    DenseLu lu = new DenseLu(f);
    boolean solved = lu.factor(matrix) == LinearSolver.NONSINGULAR;
    for (int j = 0; j < f; j++) {
      z[j] = -left[j];
    }
    if (solved) {
      lu.solve(z);
    }
    double longest = longest(linear, z);
    if (longest > LONGEST_STEP) {
      for (int j = 0; j < f; j++) {
        z[j] *= LONGEST_STEP / longest;
      }
    }
    return taken;
  }

  /** Moves along z, half as far as long as the force along it has turned round. */
  private boolean move(double t, Linearisation linear, double[] z) {
    double[] xi = new double[equations.nv];
    double[] rest = new double[equations.nv];
    double[] ahead = new double[z.length];
    linear.expand(z, xi);
    double downhill = Math.abs(dot(left, z));
    double[] from = y;
    boolean closed = false;
    for (double factor = 1; factor > SHORTEST; factor /= 2) {
      double[] tried = from.clone();
      equations.coordinates.move(tried, 0, xi, 0, factor);
      boolean fits = equations.closePositions(t, tried);
      equations.place(t, tried);
      if (fits && equations.applyForces(t)) {
        closed = true;
        y = tried;
        equations.formResidual(rest, 0);
        linear.project(equations.residual, ahead);
        if (dot(ahead, z) <= TURNED * downhill) {
          return true;
        }
      }
    }
    return closed;
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
                "No equilibrium was found: on the way to it the loops cannot be closed.",
                "Start nearer to the equilibrium; the mechanism locks on the way."));
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
                    "No equilibrium was found in %d corrections: the largest force left over is"
                        + " %.3g of those in play.",
                    iterations,
                    worstPart),
                "Hold what nothing holds, start nearer to the equilibrium, or allow more"
                    + " corrections with maxIterations."));
    return false;
  }

  /** Says whether the equilibrium is unstable, or not the only one near. */
  private void judge(double t, Linearisation linear) {
    double[] system = linear.freedom() == 0 ? new double[0] : linear.system();
    if (system.length == 0) {
      return;
    }
    Modes modes = new Modes(linear, system);
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
              names.part(mostMoved(modes, growing)));
      notes.add(new Note(MessageCode.UNSTABLE_EQUILIBRIUM, t, true, text));
    }
    if (neutral >= 0) {
      String text =
          "The equilibrium is not the only one: nothing brings "
              + names.part(mostMoved(modes, neutral))
              + " back.";
      notes.add(new Note(MessageCode.EQUILIBRIUM_NOT_UNIQUE, t, true, text));
    }
  }

  private int mostMoved(Modes modes, int k) {
    double[] re = new double[equations.nv];
    double[] im = new double[equations.nv];
    modes.shape(k, equations.unit, re, im);
    int most = 0;
    for (int i = 1; i < re.length; i++) {
      if (Math.abs(re[i]) / equations.unit[i] > Math.abs(re[most]) / equations.unit[most]) {
        most = i;
      }
    }
    return most;
  }
}

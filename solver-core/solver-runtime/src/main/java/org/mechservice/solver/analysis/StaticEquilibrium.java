package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.analysis.RestingStiffness.Metric;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.analysis.equation.RestingLinks;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.assembly.Assembly;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.force.user.UserForceSource;
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
 *
 * <p>A body above a floor that it does not touch has no stiffness, and the forces alone do not say
 * how it comes there. If the descent fails and there are one-sided forces, another one begins at
 * the start with the mass matrix as D: λ is then that of pseudo-transient continuation (Kelley and
 * Keyes, SIAM J. Numer. Anal. 35 (1998) 508), and what nothing holds falls as it would from rest, a
 * crate without turning.
 *
 * <p>Large mechanisms have K kept by their {@linkplain RestingLinks links}, with D by the rotations
 * of links in space: rotations of joints add up along a chain, whose steps they would shorten the
 * more the longer it is. If its forces have no potential, K is a dense matrix.
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

  /** Largest number of corrections of a fall, in those of a descent. */
  private static final int FALLING = 10;

  /**
   * Number of parts of a step of a fall at which forces are evaluated, so that no body passes
   * through another one that is thicker than a part of the longest step.
   */
  private static final int PARTS_OF_A_FALL = 8;

  private final Mechanism mechanism;
  private final UserForceSource userForces;
  private final CoordinateNames names;
  private final double tolerance;
  private final int most;
  private final int large;
  private final List<Note> notes = new ArrayList<>();
  private EquationsOfMotion equations;
  private double[] y = new double[0];
  private Optional<Defect> defect = Optional.empty();
  private long iterations;
  private Metric metric = Metric.FORCES;

  /** Stiffness by links, unless matrices are dense. */
  private Optional<RestingLinks> links = Optional.empty();

  /** b − τ at the present state. */
  private double[] residual = new double[0];

  private int worst;
  private double worstPart;

  /**
   * @param tolerance largest residual force relative to the largest force
   * @param most largest number of corrections
   */
  StaticEquilibrium(Mechanism mechanism, UserForceSource userForces, double tolerance, int most) {
    this(mechanism, userForces, tolerance, most, LoopEquations.LARGE);
  }

  /**
   * @param large number of velocities from which the stiffness is kept by links
   */
  StaticEquilibrium(
      Mechanism mechanism, UserForceSource userForces, double tolerance, int most, int large) {
    this.large = large;
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
      double[] start = y.clone();
      if (descend(t, Metric.FORCES, most)) {
        return true;
      }
      if (!OneSidedForces.in(held)) {
        return false;
      }
      y = start;
      if (descend(t, Metric.MASS, FALLING * most)) {
        defect = Optional.empty();
        return true;
      }
      return false;
    } catch (Linearisation.NotLinearised e) {
      defect = Optional.of(e.defect());
      return false;
    }
  }

  /**
   * Descends from the present state.
   *
   * @param most largest number of corrections
   */
  private boolean descend(double t, Metric metric, int most) throws Linearisation.NotLinearised {
    this.metric = metric;
    links =
        equations.nv >= large && RestingLinks.fits(equations)
            ? Optional.of(new RestingLinks(equations))
            : Optional.empty();
    RestingStiffness here = stiffness(t);
    double[] xi = new double[equations.nv];
    double trust = FIRST_TRUST;
    for (int i = 0; i <= most && trust > LEAST_TRUST; i++) {
      if (unbalanced(here) <= tolerance) {
        notes.addAll(here.judged(t));
        return true;
      }
      if (i == most) {
        break;
      }
      solve(here, trust, xi);
      double length = longest(xi);
      double part = move(t, here, xi);
      iterations++;
      if (part > TAKEN) {
        here = stiffness(t);
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

  /** Returns the stiffness at the present state: by links if the mechanism is large. */
  private RestingStiffness stiffness(double t) throws Linearisation.NotLinearised {
    RestingStiffness found;
    if (links.isPresent()) {
      links.get().evaluate(t, y);
      if (links.get().isStiffnessSymmetric()) {
        found = RestingStiffness.byLinks(equations, links.get(), metric);
        residual = equations.residual.clone();
        return found;
      }
      links = Optional.empty();
    }
    found =
        RestingStiffness.dense(
            equations, new Linearisation(equations, t, y, new double[equations.nv]), metric);
    residual = equations.residual.clone();
    return found;
  }

  /** Returns the largest residual force relative to the largest force. */
  private double unbalanced(RestingStiffness here) {
    double play = inPlay();
    worst = -1;
    worstPart = 0;
    for (int j = 0; j < here.count(); j++) {
      double part = Math.abs(here.left(j)) * equations.unit[here.velocity(j)] / play;
      if (!(part <= worstPart)) {
        worstPart = part;
        worst = here.velocity(j);
      }
    }
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

  private double longest(double[] xi) {
    double longest = 0;
    for (int i = 0; i < xi.length; i++) {
      longest = Math.max(longest, Math.abs(xi[i]) / equations.unit[i]);
    }
    return longest;
  }

  /** Solves for a step within the trust radius. */
  private void solve(RestingStiffness here, double trust, double[] xi) {
    if (here.solve(0, xi) && longest(xi) <= trust) {
      return;
    }
    double below = 0;
    double above = 0;
    double shift = 1;
    for (int tries = 0; tries < TRIES; tries++) {
      double length = here.solve(shift, xi) ? longest(xi) : Double.POSITIVE_INFINITY;
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
    here.solve(above, xi);
  }

  /**
   * Moves along ξ if that is downhill.
   *
   * @return the work of the forces divided by the prediction of K; NaN if the loops cannot be
   *     closed there or a force has no value
   */
  private double move(double t, RestingStiffness here, double[] xi) {
    double before = dot(residual, xi);
    int parts = metric == Metric.MASS ? PARTS_OF_A_FALL : 1;
    double work = 0.5 * before;
    double[] tried = y;
    for (int i = 1; i <= parts; i++) {
      tried = y.clone();
      equations.coordinates.move(tried, 0, xi, 0, (double) i / parts);
      boolean fits = equations.closePositions(t, tried);
      equations.place(t, tried);
      if (!fits || !equations.applyForces(t)) {
        return Double.NaN;
      }
      equations.formResidual(new double[equations.nv], 0);
      work += (i < parts ? 1 : 0.5) * dot(equations.residual, xi);
    }
    double part = work / parts / (before + 0.5 * here.curvature());
    if (part > TAKEN) {
      y = tried;
    }
    return part;
  }

  private static double dot(double[] a, double[] b) {
    double sum = 0;
    for (int i = 0; i < b.length; i++) {
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
                        + " %.3g times those in play.%s",
                    iterations,
                    iterations == 1 ? "" : "s",
                    worstPart,
                    OneSidedForces.in(mechanism)
                        ? " Contacts hold along their normals alone: their friction is zero at"
                            + " rest, so that a body on a slope slides."
                        : ""),
                "Add a restoring force to free motions, start nearer to the equilibrium, or allow"
                    + " more corrections with maxIterations."));
    return false;
  }
}

package org.mechservice.solver.closure;

import java.util.Arrays;
import java.util.Optional;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.RowSupport;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.recursion.TreeElimination;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.RelativeMotion;
import org.mechservice.solver.linear.SparseSymmetric;

/**
 * Factors of M x + Jᵀ λ = f, J x + c = 0 by recursion over articulated bodies, without M. The
 * recursion carries the loop equations inwards and eliminates each at its {@link LoopFronts home};
 * from there inwards the equation is part of the articulated inertia (Popov and Vereshchagin 1978;
 * Sathya and Carpentier 2024, constrained articulated-body algorithm with early elimination).
 * Equations that are at home on the root form a sparse matrix, factored in an order of least
 * degree.
 *
 * <p>Inertias, wrenches and motions of links are those of printed steps ({@link TreeElimination});
 * what an equation adds is here.
 *
 * <p>The cost per link grows with the square of the number of equations open in it; a dense
 * factorisation costs the cube of the mechanism's size. With K the wrenches of the multipliers as a
 * link feels them, U = Iᴬ S, D = Sᵀ U, κ = Kᵀ S + g, where g are the forces of multipliers on the
 * joint itself; D has the armature of the joint, too:
 *
 * <pre>
 * Iᴬ −= U Uᵀ / D,  K −= U κᵀ / D,  Λ += κ κᵀ / D   for each freedom of a joint
 * Iᴬ += K_e K_eᵀ / Λ_ee,  K −= K_e Λ_e / Λ_ee        for each equation e at home
 * </pre>
 *
 * <p>Rods with mass couple two bodies without restricting them: Bᵀ W B x of their ends'
 * accelerations B x is the load of six more multipliers μ with the compliance W⁻¹, B x = W⁻¹ μ.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class ArticulatedLoops {
  private static final double[] NONE = {};

  private final TreeMotion motion;
  private final LoopEquations loops;
  private final MassiveRods rods;
  private final TreeElimination links;
  private final LoopFronts fronts;

  /** Rows of the equations of loops; those of rods follow them. */
  private final int[] rows;

  private final SparseSymmetric multipliers;

  /** Which equations are between two bodies, and the wrenches of one of them. */
  private final boolean[] between;

  private final double[] onA = new double[6];
  private final double[] onB = new double[6];

  /**
   * For each equation the links of the tree on which it exerts a wrench, the two in their order if
   * it is between two bodies, and the entries of the links that carry these, or −1.
   */
  private final int[][] loaded;

  private final int[][] loadedEntry;

  /** K, 6 per entry of a front. */
  private final double[] wrench;

  /** κ of each velocity, for the entries of its link's front that are open in it. */
  private final int[] couplingAt;

  private final double[] coupling;

  /** g of each velocity, likewise. */
  private final double[] direct;

  /** Wrenches and forces of one multiplier; zero between calls. */
  private final double[] ofMultiplier;

  private final double[] ofVelocity;

  /** c + the known part of J x, then multipliers, by place. */
  private final double[] row;

  private final double[] along = new double[3];

  /** What equations without a further link to be carried to add to. */
  private final double[] ended = new double[6];

  private final int[] places;

  /** Links whose joints are eliminated. */
  private final boolean[] free;

  /**
   * @param rows rows of the equations that are used; independent of each other
   * @param rods of the same tree, light beside the links
   */
  public ArticulatedLoops(TreeMotion motion, LoopEquations loops, int[] rows, MassiveRods rods) {
    this(motion, loops, rows, rods, false);
  }

  /** Returns factors that can add inertia to joints, which takes more time. */
  public static ArticulatedLoops withAdded(
      TreeMotion motion, LoopEquations loops, int[] rows, MassiveRods rods) {
    return new ArticulatedLoops(motion, loops, rows, rods, true);
  }

  private ArticulatedLoops(
      TreeMotion motion, LoopEquations loops, int[] rows, MassiveRods rods, boolean arms) {
    TreeGeometry tree = motion.tree();
    this.motion = motion;
    this.loops = loops;
    this.rods = rods;
    this.rows = rows.clone();
    links = new TreeElimination(motion, arms);
    int[] linkOfVelocity = new int[tree.stateVelocityCount];
    for (int link = 0; link < links.count(); link++) {
      if (!links.isDriven(link)) {
        int first = links.velocity(link);
        Arrays.fill(linkOfVelocity, first, first + links.freedoms(link), link);
      }
    }
    RowSupport[] support = new RowSupport[rows.length + rods.equationCount()];
    loaded = new int[support.length][];
    between = new boolean[support.length];
    for (int i = 0; i < support.length; i++) {
      RowSupport ofTree = i < rows.length ? loops.support(rows[i]) : support(i - rows.length);
      boolean isLoop = i < rows.length;
      Optional<RelativeMotion> pair = isLoop ? loops.pair(rows[i]) : Optional.empty();
      between[i] = pair.isPresent();
      loaded[i] = pair.map(r -> new int[] {r.linkA(), r.linkB()}).orElse(ofTree.loaded());
      support[i] =
          ofTree.of(
              way ->
                  isLoop && tree.kind[way] == LinkKind.FIXED
                      ? TreeGeometry.ROOT
                      : links.carrier(way),
              links::carrier);
    }
    fronts = new LoopFronts(links.parents(), linkOfVelocity, support);
    loadedEntry = new int[support.length][];
    for (int i = 0; i < support.length; i++) {
      int equation = i;
      loadedEntry[i] =
          Arrays.stream(loaded[i])
              .map(link -> link == TreeGeometry.ROOT ? TreeGeometry.ROOT : links.carrier(link))
              .map(link -> fronts.loadedEntry(equation, link))
              .toArray();
    }
    multipliers = fronts.matrix;
    wrench = new double[6 * fronts.place.length];
    couplingAt = new int[tree.stateVelocityCount + 1];
    int at = 0;
    for (int k = 0; k < tree.stateVelocityCount; k++) {
      int link = linkOfVelocity[k];
      couplingAt[k] = at;
      at += fronts.start[link + 1] - fronts.open[link];
    }
    couplingAt[tree.stateVelocityCount] = at;
    coupling = new double[at];
    direct = new double[at];
    ofMultiplier = new double[6 * tree.linkCount];
    ofVelocity = new double[tree.velocityCount];
    row = new double[support.length];
    places = fronts.place;
    free = new boolean[links.count()];
  }

  private RowSupport support(int ofRods) {
    int[] ends = rods.ends(ofRods);
    return RowSupport.between(ends[0], ends[1]);
  }

  /** Returns whether these factors were made for a set of equations. */
  public boolean areOf(int[] others) {
    return Arrays.equals(rows, others);
  }

  /**
   * Factors at the state at which the loops were last placed.
   *
   * @return {@link ExplicitModel#REGULAR}; or the index of a velocity without inertia; or −2 − the
   *     row of an equation that is redundant at this state
   */
  public int factor() {
    return factor(NONE, new boolean[0], NONE, NONE);
  }

  /**
   * Factors as {@link #factor()}, with inertias added to joints that the links do not resist. The
   * caller removes them from the solution by iteration. For factors made by {@link #withAdded}.
   *
   * @param added inertia of each velocity of the state; those of joints without a pivot become
   *     {@code least}
   * @param least inertia to be added, one number per velocity of the state; not modified
   * @return as {@link #factor()}
   */
  public int factor(double[] added, double[] least) {
    return factor(NONE, new boolean[0], added, least);
  }

  /**
   * Factors M x + Jᵀ λ = f, J x + c = C λ with a compliance C, which permits redundant equations.
   *
   * @param compliance one number per row of the loops; not modified
   * @param held velocities of the state at which x is zero, all of a joint or none; empty if there
   *     are none
   * @return as {@link #factor()}
   */
  public int factor(double[] compliance, boolean[] held) {
    return factor(compliance, held, NONE, NONE);
  }

  private int factor(double[] compliance, boolean[] held, double[] added, double[] least) {
    links.start();
    multipliers.clear();
    load();
    for (int i = 0; i < rows.length && compliance.length > 0; i++) {
      multipliers.addDiagonal(multipliers.placeOf(i), compliance[rows[i]]);
    }
    for (int i = rows.length; i < row.length; i++) {
      multipliers.addDiagonal(multipliers.placeOf(i), rods.compliance(i - rows.length));
    }
    for (int link = links.count() - 1; link >= 0; link--) {
      free[link] =
          !links.isDriven(link)
              && !(links.velocity(link) < held.length && held[links.velocity(link)]);
      int singular = eliminateAtHome(link);
      if (singular == ExplicitModel.REGULAR) {
        singular = free[link] ? eliminateJoint(link, added, least) : carry(link);
      }
      if (singular != ExplicitModel.REGULAR) {
        links.giveUp();
        return singular;
      }
    }
    for (int at = 0; at < multipliers.size(); at++) {
      if (fronts.isAtHomeOnRoot(at) && !multipliers.eliminate(at)) {
        return redundant(at);
      }
    }
    return ExplicitModel.REGULAR;
  }

  /** Returns −2 − the row of the equation at a place; those of rods have no row. */
  private int redundant(int place) {
    int equation = multipliers.rowAt(place);
    return -2 - (equation < rows.length ? rows[equation] : 0);
  }

  /** Sets K and g of the multipliers in the links on which they act. */
  private void load() {
    Arrays.fill(wrench, 0);
    Arrays.fill(direct, 0);
    for (int i = 0; i < row.length; i++) {
      if (between[i]) {
        loops.wrenches(rows[i], onA, onB);
        add(i, 0, onA, 0);
        add(i, 1, onB, 0);
      } else {
        loadOthers(i);
      }
    }
  }

  private void loadOthers(int i) {
    if (i < rows.length) {
      loops.addForces(rows[i], 1, ofMultiplier, ofVelocity);
    } else {
      rods.addLoads(motion, i - rows.length, ofMultiplier);
    }
    for (int l = 0; l < loaded[i].length; l++) {
      int from = 6 * loaded[i][l];
      add(i, l, ofMultiplier, from);
      Arrays.fill(ofMultiplier, from, from + 6, 0);
    }
    for (int l = 0; l < fronts.pushed[i].length; l++) {
      int k = fronts.pushed[i][l];
      direct[couplingAt[k] + fronts.pushedEntry[i][l]] = ofVelocity[k];
    }
    for (int k : fronts.velocities[i]) {
      ofVelocity[k] = 0;
    }
  }

  /** Adds the wrench of an equation on the l-th of the links that it loads. */
  private void add(int equation, int l, double[] onLink, int from) {
    int entry = loadedEntry[equation][l];
    if (entry >= 0) {
      links.addInFrame(loaded[equation][l], onLink, from, wrench, 6 * entry);
    }
  }

  private int eliminateAtHome(int link) {
    for (int e = fronts.start[link]; e < fronts.open[link]; e++) {
      int at = places[e];
      if (!multipliers.eliminate(at)) {
        return redundant(at);
      }
      int later = multipliers.start(at);
      int end = multipliers.start(at + 1);
      for (int other = e + 1; other < fronts.start[link + 1] && later < end; other++) {
        while (later < end && multipliers.later(later) < places[other]) {
          later++;
        }
        if (later < end && multipliers.later(later) == places[other]) {
          addScaled(wrench, 6 * other, wrench, 6 * e, -multipliers.lower(later));
        }
      }
      links.addInertia(link, wrench, 6 * e, 1 / multipliers.pivot(at));
    }
    return ExplicitModel.REGULAR;
  }

  /** Eliminates a link's joint, and carries what is left to the parent. */
  private int eliminateJoint(int link, double[] added, double[] least) {
    int first = links.velocity(link);
    int freedoms = links.freedoms(link);
    int singular = links.eliminate(link);
    if (singular != ExplicitModel.REGULAR && added.length > 0) {
      links.arm(link, least[first]);
      System.arraycopy(least, first, added, first, freedoms);
      singular = links.eliminate(link);
    }
    if (singular != ExplicitModel.REGULAR) {
      return singular;
    }
    int count = fronts.start[link + 1] - fronts.open[link];
    for (int i = 0; i < count; i++) {
      int e = fronts.open[link] + i;
      for (int k = 0; k < freedoms; k++) {
        along[k] = direct[couplingAt[first + k] + i];
      }
      int parent = fronts.inParent[e];
      links.couple(
          link, wrench, 6 * e, along, parent < 0 ? ended : wrench, Math.max(0, 6 * parent));
      for (int k = 0; k < freedoms; k++) {
        coupling[couplingAt[first + k] + i] = along[k];
      }
    }
    for (int k = 0; k < freedoms; k++) {
      double perPivot = 1 / links.pivot(link, k);
      int at = couplingAt[first + k];
      multipliers.addSquare(places, fronts.open[link], coupling, at, count, perPivot);
    }
    return ExplicitModel.REGULAR;
  }

  /** Carries all to the parent with the joint as it is. */
  private int carry(int link) {
    links.carry(link);
    for (int e = fronts.open[link]; e < fronts.start[link + 1]; e++) {
      int parent = fronts.inParent[e];
      links.transfer(link, wrench, 6 * e, parent < 0 ? ended : wrench, Math.max(0, 6 * parent));
    }
    return ExplicitModel.REGULAR;
  }

  /**
   * Returns an upper estimate of the largest diagonal element of M at the placed state: the largest
   * inertia that one joint moves while all others are at rest.
   *
   * @param units of the velocities of the state, by which displacements are lengths
   */
  public double largestInertia(double[] units) {
    return links.largestInertia(units);
  }

  /**
   * Solves with the last factors.
   *
   * @param force f, one number per velocity of the state; not modified
   * @param offset c, one number per row of the loops; not modified
   * @param x from {@code at}, one number per velocity of the state; overwritten
   * @param lambda one number per row of the loops, zero for unused rows; overwritten
   */
  public void solve(double[] force, double[] offset, double[] x, int at, double[] lambda) {
    links.startPush();
    for (int i = 0; i < row.length; i++) {
      row[multipliers.placeOf(i)] = i < rows.length ? offset[rows[i]] : 0;
    }
    for (int link = links.count() - 1; link >= 0; link--) {
      pushInwards(link, force);
    }
    for (int place = 0; place < row.length; place++) {
      if (fronts.isAtHomeOnRoot(place)) {
        passOn(place);
      }
    }
    for (int place = row.length - 1; place >= 0; place--) {
      if (fronts.isAtHomeOnRoot(place)) {
        row[place] = -row[place] / multipliers.pivot(place) - ofLater(place);
      }
    }
    for (int link = 0; link < links.count(); link++) {
      moveOutwards(link, x, at);
    }
    Arrays.fill(lambda, 0);
    for (int place = 0; place < row.length; place++) {
      int equation = multipliers.rowAt(place);
      if (equation < rows.length) {
        lambda[rows[equation]] = -row[place];
      }
    }
  }

  /** Subtracts the contribution of an eliminated equation from the later ones. */
  private void passOn(int place) {
    for (int e = multipliers.start(place); e < multipliers.start(place + 1); e++) {
      row[multipliers.later(e)] -= multipliers.lower(e) * row[place];
    }
  }

  private double ofLater(int place) {
    double sum = 0;
    for (int e = multipliers.start(place); e < multipliers.start(place + 1); e++) {
      sum += multipliers.lower(e) * row[multipliers.later(e)];
    }
    return sum;
  }

  private void pushInwards(int link, double[] force) {
    for (int e = fronts.start[link]; e < fronts.open[link]; e++) {
      int place = places[e];
      passOn(place);
      links.addWrench(link, wrench, 6 * e, row[place] / multipliers.pivot(place));
    }
    if (!free[link]) {
      links.pass(link);
      return;
    }
    links.push(link, force);
    int first = links.velocity(link);
    for (int k = 0; k < links.freedoms(link); k++) {
      double rate = links.rate(link, k);
      int at = couplingAt[first + k] - fronts.open[link];
      for (int e = fronts.open[link]; e < fronts.start[link + 1]; e++) {
        row[places[e]] += coupling[at + e] * rate;
      }
    }
  }

  private void moveOutwards(int link, double[] x, int at) {
    if (free[link]) {
      moveJoint(link, x, at);
    } else {
      links.move(link);
      if (!links.isDriven(link)) {
        int first = at + links.velocity(link);
        Arrays.fill(x, first, first + links.freedoms(link), 0);
      }
    }
    for (int e = fronts.open[link] - 1; e >= fronts.start[link]; e--) {
      int place = places[e];
      double known = row[place] + links.felt(link, wrench, 6 * e);
      row[place] = -known / multipliers.pivot(place) - ofLater(place);
    }
  }

  private void moveJoint(int link, double[] x, int at) {
    int first = links.velocity(link);
    for (int k = 0; k < links.freedoms(link); k++) {
      int from = couplingAt[first + k] - fronts.open[link];
      double sum = 0;
      for (int e = fronts.open[link]; e < fronts.start[link + 1]; e++) {
        sum += coupling[from + e] * row[places[e]];
      }
      if (sum != 0) {
        links.addRate(link, k, sum / links.pivot(link, k));
      }
    }
    links.move(link, x, at);
  }

  private static void addScaled(double[] sum, int is, double[] x, int ix, double factor) {
    for (int i = 0; i < 6; i++) {
      sum[is + i] += factor * x[ix + i];
    }
  }
}

package org.mechservice.solver.closure;

import static org.mechservice.solver.spatial.Blocks.addCross;
import static org.mechservice.solver.spatial.Blocks.applyTransposed;

import java.util.Arrays;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.closure.equations.RowSupport;
import org.mechservice.solver.dynamics.recursion.ArticulatedInertias;
import org.mechservice.solver.dynamics.recursion.LinkInertias;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.dynamics.recursion.RigidComposites;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.SparseSymmetric;

/**
 * Factors of M x + Jᵀ λ = f, J x + c = 0 by recursion over articulated bodies, without M. The
 * recursion carries the loop equations inwards and eliminates each at its {@link LoopFronts home};
 * from there inwards the equation is part of the articulated inertia (Popov and Vereshchagin 1978;
 * Sathya and Carpentier 2024, constrained articulated-body algorithm with early elimination).
 * Equations that are at home on the root form a sparse matrix, factored in an order of least
 * degree.
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

  private final TreeGeometry tree;
  private final TreeMotion motion;
  private final LoopEquations loops;
  private final MassiveRods rods;
  private final LoopFronts fronts;

  /** Rows of the equations of loops; those of rods follow them. */
  private final int[] rows;

  private final SparseSymmetric multipliers;
  private final ArticulatedInertias inertia;
  private final RigidComposites rigid;
  private final PivotCheck check = new PivotCheck();

  /** U, 6 per extended velocity; D, and u of the last solution, one each. */
  private final double[] projected;

  private final double[] pivot;
  private final double[] push;

  /** K, 6 per entry of a front; an eliminated entry keeps its value at the elimination. */
  private final double[] wrench;

  /** κ of each velocity, for the entries of its link's front that are open in it. */
  private final int[] couplingAt;

  private final double[] coupling;

  /** g of each velocity, likewise. */
  private final double[] direct;

  /** Wrenches and forces of one multiplier; zero between calls. */
  private final double[] ofMultiplier;

  private final double[] ofVelocity;

  /** p, then accelerations, 6 per link; c + the known part of J x, then multipliers, by place. */
  private final double[] spatial;

  private final double[] row;
  private final double[] carried = new double[6];
  private final int[] places;
  private boolean[] heldAt = {};

  /** Inertias added to joints, and those to be added where a pivot lacks; empty for none. */
  private double[] addedAt = NONE;

  private double[] leastAt = NONE;

  /**
   * @param rows rows of the equations that are used; independent of each other
   * @param rods of the same tree, light beside the links
   */
  public ArticulatedLoops(TreeMotion motion, LoopEquations loops, int[] rows, MassiveRods rods) {
    tree = motion.tree();
    this.motion = motion;
    this.loops = loops;
    this.rods = rods;
    this.rows = rows.clone();
    RowSupport[] support = new RowSupport[rows.length + rods.equationCount()];
    for (int i = 0; i < support.length; i++) {
      support[i] = i < rows.length ? loops.support(rows[i]) : support(i - rows.length);
    }
    fronts = new LoopFronts(tree, support);
    multipliers = fronts.matrix;
    LinkInertias inertias = new LinkInertias(tree);
    inertia = new ArticulatedInertias(motion, inertias);
    rigid = new RigidComposites(tree, inertias);
    projected = new double[6 * tree.velocityCount];
    pivot = new double[tree.velocityCount];
    push = new double[tree.velocityCount];
    wrench = new double[6 * fronts.place.length];
    couplingAt = new int[tree.velocityCount + 1];
    int at = 0;
    for (int k = 0; k < tree.velocityCount; k++) {
      int link = tree.linkOfVelocity[k];
      couplingAt[k] = at;
      at += fronts.start[link + 1] - fronts.open[link];
    }
    couplingAt[tree.velocityCount] = at;
    coupling = new double[at];
    direct = new double[at];
    ofMultiplier = new double[6 * tree.linkCount];
    ofVelocity = new double[tree.velocityCount];
    spatial = new double[6 * tree.linkCount];
    row = new double[support.length];
    places = fronts.place;
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
    return factor(NONE, new boolean[0]);
  }

  /**
   * Factors as {@link #factor()}, with inertias added to joints that the links do not resist. The
   * caller removes them from the solution by iteration.
   *
   * @param added inertia of each velocity of the state; zeros become {@code least} where the tree
   *     has no pivot
   * @param least inertia to be added, one number per velocity of the state; not modified
   * @return as {@link #factor()}
   */
  public int factor(double[] added, double[] least) {
    addedAt = added;
    leastAt = least;
    int factored = factor(NONE, new boolean[0]);
    addedAt = NONE;
    leastAt = NONE;
    return factored;
  }

  /**
   * Factors M x + Jᵀ λ = f, J x + c = C λ with a compliance C, which permits redundant equations.
   *
   * @param compliance one number per row of the loops, or empty for none; not modified
   * @param held velocities of the state at which x is zero; empty if there are none
   * @return as {@link #factor()}
   */
  public int factor(double[] compliance, boolean[] held) {
    check.start();
    rigid.start();
    multipliers.clear();
    load();
    heldAt = held;
    for (int i = 0; i < rows.length && compliance.length > 0; i++) {
      multipliers.addDiagonal(multipliers.placeOf(i), compliance[rows[i]]);
    }
    for (int i = rows.length; i < row.length; i++) {
      multipliers.addDiagonal(multipliers.placeOf(i), rods.compliance(i - rows.length));
    }
    for (int link = 0; link < tree.linkCount; link++) {
      inertia.startAtRest(link);
    }
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int singular = eliminateAtHome(link);
      if (singular == ExplicitModel.REGULAR) {
        singular = eliminateJoint(link);
      }
      if (singular != ExplicitModel.REGULAR) {
        return singular;
      }
      carryInwards(link);
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
      if (i < rows.length) {
        loops.addForces(rows[i], 1, ofMultiplier, ofVelocity);
      } else {
        rods.addLoads(motion, i - rows.length, ofMultiplier);
      }
      for (int l = 0; l < fronts.loaded[i].length; l++) {
        int from = 6 * fronts.loaded[i][l];
        if (fronts.loadedEntry[i][l] >= 0) {
          System.arraycopy(ofMultiplier, from, wrench, 6 * fronts.loadedEntry[i][l], 6);
        }
        Arrays.fill(ofMultiplier, from, from + 6, 0);
      }
      for (int l = 0; l < fronts.pushed[i].length; l++) {
        int k = fronts.pushed[i][l];
        int link = tree.linkOfVelocity[k];
        direct[couplingAt[k] + fronts.pushedEntry[i][l] - fronts.open[link]] = ofVelocity[k];
      }
      for (int k : fronts.velocities[i]) {
        ofVelocity[k] = 0;
      }
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
      inertia.eliminate(link, wrench, 6 * e, -1 / multipliers.pivot(at));
    }
    return ExplicitModel.REGULAR;
  }

  /** Eliminates the freedoms of a link's joint, one after the other. */
  private int eliminateJoint(int link) {
    if (tree.driven[link]) {
      return ExplicitModel.REGULAR;
    }
    int first = tree.velocityAt[link];
    int count = fronts.start[link + 1] - fronts.open[link];
    for (int k = first; k < first + tree.kind[link].velocityCount(); k++) {
      if (isHeld(k)) {
        continue;
      }
      project(link, k);
      pivot[k] = dot(motion.subspace, 6 * k, projected, 6 * k) + tree.armature[k];
      if (addedAt.length > 0) {
        pivot[k] += addedAt[k];
      }
      if (!check.regular(k, pivot[k], rigid.scale(link))) {
        if (addedAt.length == 0 || addedAt[k] > 0) {
          return k;
        }
        addedAt[k] = leastAt[k];
        pivot[k] += leastAt[k];
      }
      double perPivot = 1 / pivot[k];
      for (int i = 0; i < count; i++) {
        int e = fronts.open[link] + i;
        double moved = dot(motion.subspace, 6 * k, wrench, 6 * e) + direct[couplingAt[k] + i];
        coupling[couplingAt[k] + i] = moved;
        addScaled(wrench, 6 * e, projected, 6 * k, -moved * perPivot);
      }
      multipliers.addSquare(places, fronts.open[link], coupling, couplingAt[k], count, perPivot);
      inertia.eliminate(link, projected, 6 * k, perPivot);
    }
    return ExplicitModel.REGULAR;
  }

  /** U = Iᴬ S. */
  private void project(int link, int k) {
    double[] s = motion.subspace;
    switch (tree.kind[link]) {
      case TURN, BALL -> inertia.applyToTurning(link, s, 6 * k, projected, 6 * k);
      case SLIDE -> inertia.applyToSliding(link, s, 6 * k + 3, projected, 6 * k);
      case SCREW -> inertia.applyTo(link, s, 6 * k, projected, 6 * k);
      case FIXED -> throw new IllegalArgumentException("link " + link + " has no freedom");
    }
  }

  private boolean isHeld(int velocity) {
    return velocity < heldAt.length && heldAt[velocity];
  }

  /**
   * Returns an upper estimate of the largest diagonal element of M at the placed state: the largest
   * inertia that one joint moves while all others are at rest.
   *
   * @param units of the velocities of the state, by which displacements are lengths
   */
  public double largestInertia(double[] units) {
    rigid.start();
    double largest = 0;
    for (int link = tree.linkCount - 1; link >= 0; link--) {
      int first = tree.velocityAt[link];
      for (int k = first; k < first + tree.kind[link].velocityCount(); k++) {
        double unit = tree.driven[link] ? 0 : units[k];
        largest = Math.max(largest, (rigid.scale(link) + tree.armature[k]) * unit * unit);
      }
      if (tree.parent[link] != TreeGeometry.ROOT) {
        rigid.addToParent(motion, link);
      }
    }
    return largest;
  }

  private void carryInwards(int link) {
    if (tree.parent[link] == TreeGeometry.ROOT) {
      return;
    }
    inertia.addToParent(link);
    rigid.addToParent(motion, link);
    for (int e = fronts.open[link]; e < fronts.start[link + 1]; e++) {
      System.arraycopy(wrench, 6 * e, carried, 0, 6);
      motion.wrenches.toParent(link, carried, 0);
      addScaled(wrench, 6 * fronts.inParent[e], carried, 0, 1);
    }
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
    Arrays.fill(spatial, 0);
    for (int i = 0; i < row.length; i++) {
      row[multipliers.placeOf(i)] = i < rows.length ? offset[rows[i]] : 0;
    }
    for (int link = tree.linkCount - 1; link >= 0; link--) {
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
    for (int link = 0; link < tree.linkCount; link++) {
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
      addScaled(spatial, 6 * link, wrench, 6 * e, row[place] / multipliers.pivot(place));
    }
    if (!tree.driven[link]) {
      int first = tree.velocityAt[link];
      for (int k = first; k < first + tree.kind[link].velocityCount(); k++) {
        if (isHeld(k)) {
          continue;
        }
        push[k] = force[k] - dot(motion.subspace, 6 * k, spatial, 6 * link);
        double part = push[k] / pivot[k];
        for (int e = fronts.open[link]; e < fronts.start[link + 1]; e++) {
          row[places[e]] += coupling[couplingAt[k] + e - fronts.open[link]] * part;
        }
        addScaled(spatial, 6 * link, projected, 6 * k, part);
      }
    }
    if (tree.parent[link] != TreeGeometry.ROOT) {
      System.arraycopy(spatial, 6 * link, carried, 0, 6);
      motion.wrenches.toParent(link, carried, 0);
      addScaled(spatial, 6 * tree.parent[link], carried, 0, 1);
    }
  }

  private void moveOutwards(int link, double[] x, int at) {
    carryAcceleration(link);
    if (!tree.driven[link]) {
      moveJoint(link, x, at);
    }
    for (int e = fronts.open[link] - 1; e >= fronts.start[link]; e--) {
      int place = places[e];
      double known = row[place] + dot(wrench, 6 * e, spatial, 6 * link);
      row[place] = -known / multipliers.pivot(place) - ofLater(place);
    }
  }

  private void moveJoint(int link, double[] x, int at) {
    int first = tree.velocityAt[link];
    for (int k = first + tree.kind[link].velocityCount() - 1; k >= first; k--) {
      if (isHeld(k)) {
        x[at + k] = 0;
        continue;
      }
      double sum = push[k] - dot(projected, 6 * k, spatial, 6 * link);
      for (int e = fronts.open[link]; e < fronts.start[link + 1]; e++) {
        sum += coupling[couplingAt[k] + e - fronts.open[link]] * row[places[e]];
      }
      x[at + k] = sum / pivot[k];
      addScaled(spatial, 6 * link, motion.subspace, 6 * k, x[at + k]);
    }
  }

  private void carryAcceleration(int link) {
    int to = 6 * link;
    int parent = tree.parent[link];
    if (parent == TreeGeometry.ROOT) {
      Arrays.fill(spatial, to, to + 6, 0);
      return;
    }
    applyTransposed(motion.rotation, 9 * link, spatial, 6 * parent, spatial, to);
    System.arraycopy(spatial, 6 * parent + 3, carried, 0, 3);
    addCross(spatial, 6 * parent, motion.position, 3 * link, carried, 0);
    applyTransposed(motion.rotation, 9 * link, carried, 0, spatial, to + 3);
  }

  private static void addScaled(double[] sum, int is, double[] x, int ix, double factor) {
    for (int i = 0; i < 6; i++) {
      sum[is + i] += factor * x[ix + i];
    }
  }

  private static double dot(double[] a, int ia, double[] b, int ib) {
    double sum = 0;
    for (int i = 0; i < 6; i++) {
      sum += a[ia + i] * b[ib + i];
    }
    return sum;
  }
}

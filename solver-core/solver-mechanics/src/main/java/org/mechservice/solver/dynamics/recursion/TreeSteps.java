package org.mechservice.solver.dynamics.recursion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.tree.PivotCheck;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.links.Axes;
import org.mechservice.solver.links.BodyPlacement;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.SinCos;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.step.LinkNumbers;
import org.mechservice.solver.step.StepBlock;
import org.mechservice.solver.step.StepKernel;
import org.mechservice.solver.step.StepKind;
import org.mechservice.solver.step.printed.PrintedSteps;

/**
 * The recursions over an open tree, of any size, by printed steps: one method per kind of joint and
 * sweep ({@code solver.step}), with the numbers of each link in its block of one array. Generated
 * code is derived from the same steps.
 *
 * <p>Accelerations are those of the articulated-body algorithm (DTR, Featherstone 2008, ch. 7),
 * forces those of the recursive Newton-Euler algorithm (§5.3). Driven joints are not eliminated;
 * their driving forces are computed (§9.2). Rods with mass, which couple two bodies, are not known.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class TreeSteps {
  private final TreeMotion motion;
  private final TreeGeometry tree;

  /** The steps from the root outwards. */
  private final Step[] steps;

  /** The block of the root, then those of the steps. */
  private final double[] w;

  private final BodyLoads bodies;
  private final PivotBounds bounds;
  private final PivotCheck check = new PivotCheck();
  private final RigidComposites rigid;

  /** Whether {@code rigid} has been composed in this evaluation. */
  private boolean composed;

  private final double[] driving;
  private final double[] sinCos = new double[2];

  /**
   * One step.
   *
   * @param kernel its methods
   * @param at where its block begins
   * @param parent where its parent's begins
   * @param onRoot whether its link is on the root
   * @param index of its link; −1 for a constant turn
   * @param driven whether its joint is driven
   * @param kind of its joint
   * @param inverse whether Euler parameters turn the parent
   * @param way displacement per coordinate
   * @param position its first among the extended positions
   * @param velocity its first among the extended velocities
   */
  private record Step(
      StepKernel kernel,
      int at,
      int parent,
      boolean onRoot,
      int index,
      boolean driven,
      LinkKind kind,
      boolean inverse,
      double way,
      int position,
      int velocity) {
    boolean isTurn() {
      return index < 0;
    }

    boolean isBall() {
      return kind == LinkKind.BALL;
    }

    int result() {
      return at + (isBall() ? StepBlock.BALL_RESULT : StepBlock.RESULT);
    }

    int known() {
      return at + (isBall() ? StepBlock.BALL_KNOWN : StepBlock.KNOWN);
    }
  }

  /**
   * Prepares the steps of a tree.
   *
   * @param motion has the coordinates, set by the caller before each evaluation; its links need not
   *     be swept
   */
  public TreeSteps(TreeMotion motion) {
    this.motion = motion;
    tree = motion.tree();
    Links links = Links.of(tree);
    List<Link> all = links.links();
    List<Step> laid = new ArrayList<>();
    int[] blocks = new int[all.size()];
    w = new double[lay(tree, all, laid, blocks)];
    steps = laid.toArray(Step[]::new);
    int next = 0;
    for (Step step : steps) {
      Link link = all.get(next);
      if (step.isTurn()) {
        StepBlock.putTurn(w, step.at, link);
        continue;
      }
      next++;
      StepBlock.put(w, step.at, link);
      w[step.at + StepBlock.ARMATURE] = link.armature();
      if (link.axes().turn().isPresent()) {
        // the turn has taken the offset
        Arrays.fill(w, step.at + LinkNumbers.OFFSET, step.at + LinkNumbers.OFFSET + 3, 0);
      }
    }
    putGravity(links.gravity());
    bodies = new BodyLoads(tree, links, blocks);
    bounds = new PivotBounds(all);
    rigid = new RigidComposites(tree, new LinkInertias(tree));
    driving = new double[tree.velocityCount - tree.stateVelocityCount];
  }

  /** Lays out the steps and notes the blocks of the links; returns the length of all blocks. */
  private static int lay(TreeGeometry tree, List<Link> links, List<Step> steps, int[] blocks) {
    EnumMap<StepKind, StepKernel> kernels = new EnumMap<>(StepKind.class);
    int elementary = -1;
    int at = StepBlock.SIZE;
    for (int i = 0; i < blocks.length; i++) {
      Link link = links.get(i);
      do {
        elementary++;
      } while (tree.kind[elementary] == LinkKind.FIXED);
      boolean onRoot = link.parent() == Links.ROOT;
      int parent = onRoot ? 0 : blocks[link.parent()];
      if (link.axes().turn().isPresent()) {
        StepKind kind = StepKind.ofTurn(link.axes().turn().get().axis());
        StepKernel kernel = kernels.computeIfAbsent(kind, PrintedSteps::of);
        steps.add(
            new Step(kernel, at, parent, onRoot, -1, false, LinkKind.FIXED, false, 0, -1, -1));
        parent = at;
        at += kind.size();
      }
      StepKind kind = StepKind.of(link);
      steps.add(
          new Step(
              kernels.computeIfAbsent(kind, PrintedSteps::of),
              at,
              parent,
              onRoot,
              i,
              link.isDriven(),
              link.kind(),
              link.inverse(),
              link.way(),
              tree.positionAt[elementary],
              tree.velocityAt[elementary]));
      blocks[i] = at;
      at += kind.size();
    }
    return at;
  }

  /** An acceleration of the root opposite to gravity represents gravity on every body. */
  private void putGravity(Vector3 gravity) {
    w[StepBlock.MOTION + 6] = 0 - gravity.x();
    w[StepBlock.MOTION + 7] = 0 - gravity.y();
    w[StepBlock.MOTION + 8] = 0 - gravity.z();
  }

  /** Returns the check of the pivots of the last accelerations. */
  public PivotCheck check() {
    return check;
  }

  /**
   * Returns the driving forces of the last accelerations, in addition to joint forces applied
   * there, in the order of the extended velocities, N·m or N; must not be modified.
   */
  public double[] drivingForces() {
    return driving;
  }

  /**
   * Solves M(q) a + b(q, v) = τ + Jᵀ w.
   *
   * @param wrench external wrenches [moment; force] in link axes at the reference points, 6 per
   *     link, N·m, N; empty for none; not modified
   * @param tau joint forces, one per extended velocity, N·m or N; not modified
   * @param a joint accelerations in state order from {@code aAt}, rad/s² or m/s²; overwritten
   * @param aAt where the accelerations begin
   * @return {@link ExplicitModel#REGULAR}, or the index of a velocity without inertia
   */
  public int accelerations(double[] wrench, double[] tau, double[] a, int aAt) {
    bodies.load(wrench, w);
    for (Step step : steps) {
      if (!step.isTurn()) {
        place(step, tau);
        if (!step.driven) {
          Arrays.fill(w, step.known(), step.known() + step.kind.velocityCount(), 0);
        }
      }
      step.kernel.motion(w, step.at, step.parent);
    }
    check.start();
    composed = false;
    for (int i = steps.length - 1; i >= 0; i--) {
      int singular = inwards(steps[i]);
      if (singular != ExplicitModel.REGULAR) {
        clear();
        return singular;
      }
    }
    for (Step step : steps) {
      outwards(step, a, aAt);
    }
    return ExplicitModel.REGULAR;
  }

  private int inwards(Step step) {
    if (step.isTurn() || step.driven) {
      if (!step.onRoot) {
        step.kernel.pass(w, step.at, step.parent);
      }
      return ExplicitModel.REGULAR;
    }
    if (step.onRoot) {
      step.kernel.inertiaOnRoot(w, step.at, step.parent);
    } else {
      step.kernel.inertia(w, step.at, step.parent);
    }
    double clear = bounds.clear(step.index);
    int count = step.kind.velocityCount();
    for (int k = 0; k < count; k++) {
      double pivot = w[step.at + StepBlock.freedom(k)];
      int velocity = step.velocity + k;
      if (!(pivot > clear) && !check.regular(velocity, pivot, scale(velocity))) {
        return velocity;
      }
    }
    return ExplicitModel.REGULAR;
  }

  /** Returns what the pivot of a velocity would be with all joints beyond locked. */
  private double scale(int velocity) {
    if (!composed) {
      motion.sweepRelative();
      rigid.compose(motion);
      composed = true;
    }
    return rigid.scale(tree.linkOfVelocity[velocity]);
  }

  /** Forgets the inertias of a sweep that has not come to its end. */
  private void clear() {
    for (Step step : steps) {
      int at = step.at + StepBlock.INERTIA;
      Arrays.fill(w, at, at + StepBlock.INERTIA_COUNT, 0);
    }
  }

  private void outwards(Step step, double[] a, int aAt) {
    if (step.isTurn()) {
      step.kernel.carry(w, step.at, step.parent);
    } else if (step.driven) {
      step.kernel.carry(w, step.at, step.parent);
      step.kernel.driving(w, step.at, step.parent);
      get(step, driving, 0 - tree.stateVelocityCount);
    } else {
      step.kernel.acceleration(w, step.at, step.parent);
      get(step, a, aAt);
    }
  }

  /** Reads the results of a joint's velocities into an array of extended velocities. */
  private void get(Step step, double[] out, int outAt) {
    int at = outAt + step.velocity;
    out[at] = w[step.result()];
    if (step.isBall()) {
      out[at + 1] = w[step.result() + 1];
      out[at + 2] = w[step.result() + 2];
    }
  }

  /**
   * Writes M(q) a + b(q, v) − τ − Jᵀ w.
   *
   * @param wrench as for {@link #accelerations}
   * @param tau as for {@link #accelerations}
   * @param a accelerations of the state from {@code aAt}; not modified
   * @param out one number per extended velocity, N·m or N; overwritten; entries of driven
   *     velocities are the driving forces
   */
  public void forces(double[] wrench, double[] tau, double[] a, int aAt, double[] out) {
    bodies.load(wrench, w);
    for (Step step : steps) {
      if (!step.isTurn()) {
        place(step, tau);
        if (!step.driven) {
          int count = step.kind.velocityCount();
          System.arraycopy(a, aAt + step.velocity, w, step.known(), count);
        }
      }
      step.kernel.motion(w, step.at, step.parent);
    }
    for (int i = steps.length - 1; i >= 0; i--) {
      Step step = steps[i];
      if (step.onRoot) {
        step.kernel.forceOnRoot(w, step.at, step.parent);
      } else {
        step.kernel.force(w, step.at, step.parent);
      }
      if (!step.isTurn()) {
        get(step, out, 0);
      }
    }
  }

  /** Writes a joint's coordinates and applied forces, and the accelerations of a driven one. */
  private void place(Step step, double[] tau) {
    if (step.isBall()) {
      placeBall(step, tau);
      return;
    }
    int at = step.at;
    double q = motion.q[step.position];
    w[at + StepBlock.POSITION] = q;
    w[at + StepBlock.VELOCITY] = motion.v[step.velocity];
    w[at + StepBlock.TAU] = tau[step.velocity];
    if (step.driven) {
      w[at + StepBlock.KNOWN] = motion.a[step.velocity];
    }
    if (step.kind != LinkKind.SLIDE) {
      SinCos.sinCos(q, sinCos, 0);
      w[at + StepBlock.SINE] = sinCos[0];
      w[at + StepBlock.COSINE] = sinCos[1];
    }
    if (step.way != 0) {
      bounds.reached(step.index, step.way * q);
    }
  }

  private void placeBall(Step step, double[] tau) {
    int r = step.at + StepBlock.ROTATION;
    EulerParameters.rotation(motion.q, step.position, w, r);
    if (step.inverse) {
      exchange(r + 1, r + 3);
      exchange(r + 2, r + 6);
      exchange(r + 5, r + 7);
    }
    for (int k = 0; k < 3; k++) {
      int velocity = step.velocity + k;
      w[step.at + StepBlock.BALL_VELOCITY + k] = motion.v[velocity];
      if (step.driven) {
        w[step.at + StepBlock.BALL_KNOWN + k] = motion.a[velocity];
      }
      // moments along the velocities of the state, turned to link axes
      w[step.at + StepBlock.BALL_TAU + k] =
          step.inverse
              ? 0 - tau[velocity]
              : w[r + k] * tau[step.velocity]
                  + w[r + 3 + k] * tau[step.velocity + 1]
                  + w[r + 6 + k] * tau[step.velocity + 2];
    }
  }

  private void exchange(int i, int j) {
    double wi = w[i];
    w[i] = w[j];
    w[j] = wi;
  }

  /** The wrenches on bodies in the frames of the links that carry them. */
  private static final class BodyLoads {
    private final int[] treeLink;
    private final int[] carrier;
    private final double[][] rotation;
    private final double[][] point;
    private final int[] blocks;

    BodyLoads(TreeGeometry tree, Links links, int[] blocks) {
      this.blocks = blocks;
      List<BodyPlacement> places = links.bodies();
      treeLink = tree.linkOfBody;
      carrier = new int[places.size()];
      rotation = new double[places.size()][9];
      point = new double[places.size()][3];
      for (int body = 0; body < carrier.length; body++) {
        BodyPlacement place = places.get(body);
        carrier[body] = place.link();
        double[][] rows = Axes.elements(place.toFrame());
        for (int k = 0; k < 9; k++) {
          rotation[body][k] = rows[k / 3][k % 3];
        }
        int at = 3 * treeLink[body];
        boolean moves = tree.kind[treeLink[body]] != LinkKind.FIXED;
        Vector3 own =
            new Vector3(tree.bodyOrigin[at], tree.bodyOrigin[at + 1], tree.bodyOrigin[at + 2]);
        // the reference point of a body that moves is the computing origin
        Vector3 reference = moves ? Vector3.ZERO : place.origin().minus(place.toFrame().apply(own));
        point[body] = new double[] {reference.x(), reference.y(), reference.z()};
      }
    }

    /** Writes the applied wrenches of all links; without any, they stay as they were: zero. */
    void load(double[] wrench, double[] w) {
      if (wrench.length == 0) {
        return;
      }
      for (int block : blocks) {
        Arrays.fill(w, block + StepBlock.LOAD, block + StepBlock.LOAD + 6, 0);
      }
      for (int body = 0; body < carrier.length; body++) {
        if (carrier[body] != Links.ROOT) {
          add(wrench, 6 * treeLink[body], rotation[body], point[body], w, blocks[carrier[body]]);
        }
      }
    }

    private static void add(
        double[] wrench, int from, double[] r, double[] p, double[] w, int block) {
      int at = block + StepBlock.LOAD;
      double fx = turned(r, 0, wrench, from + 3);
      double fy = turned(r, 3, wrench, from + 3);
      double fz = turned(r, 6, wrench, from + 3);
      w[at] += turned(r, 0, wrench, from) + p[1] * fz - p[2] * fy;
      w[at + 1] += turned(r, 3, wrench, from) + p[2] * fx - p[0] * fz;
      w[at + 2] += turned(r, 6, wrench, from) + p[0] * fy - p[1] * fx;
      w[at + 3] += fx;
      w[at + 4] += fy;
      w[at + 5] += fz;
    }

    private static double turned(double[] r, int row, double[] v, int at) {
      return r[row] * v[at] + r[row + 1] * v[at + 1] + r[row + 2] * v[at + 2];
    }
  }
}

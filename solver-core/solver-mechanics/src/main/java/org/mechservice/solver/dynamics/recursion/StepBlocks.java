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
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.SinCos;
import org.mechservice.solver.step.LinkNumbers;
import org.mechservice.solver.step.StepBlock;
import org.mechservice.solver.step.StepKernel;
import org.mechservice.solver.step.StepKind;
import org.mechservice.solver.step.printed.PrintedSteps;

/**
 * The steps of an open tree from the root outwards, each with its printed methods and the block of
 * its numbers in one array ({@link StepBlock}). A link is one step, and a second one before it if a
 * constant turn precedes its joint. Workspace of one thread; nothing allocates after construction.
 */
final class StepBlocks {
  final TreeMotion motion;
  final TreeGeometry tree;
  final Links links;

  /** From the root outwards. */
  final Step[] steps;

  /** Where the block of each link begins. */
  final int[] blocks;

  /** The block of the root, those of the steps, and more. */
  final double[] w;

  private final PivotBounds bounds;
  private final PivotCheck check = new PivotCheck();
  private final RigidComposites rigid;

  /** Whether {@code rigid} has been composed since {@link #startChecks}. */
  private boolean composed;

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
  record Step(
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
    /** Returns whether it is a constant turn. */
    boolean isTurn() {
      return index < 0;
    }

    boolean isBall() {
      return kind == LinkKind.BALL;
    }

    /** Returns where its accelerations or forces are. */
    int result() {
      return at + (isBall() ? StepBlock.BALL_RESULT : StepBlock.RESULT);
    }

    /** Returns where its known accelerations are. */
    int known() {
      return at + (isBall() ? StepBlock.BALL_KNOWN : StepBlock.KNOWN);
    }
  }

  /**
   * Lays out a tree.
   *
   * @param motion has the coordinates, set by the caller before each evaluation
   * @param armed whether the joints take an armature even where the mechanism has none
   * @param more how many numbers follow the blocks
   */
  StepBlocks(TreeMotion motion, boolean armed, int more) {
    this.motion = motion;
    tree = motion.tree();
    links = Links.of(tree);
    List<Link> all = links.links();
    List<Step> laid = new ArrayList<>();
    blocks = new int[all.size()];
    w = new double[lay(laid, armed) + more];
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
    bounds = new PivotBounds(all);
    rigid = new RigidComposites(tree, new LinkInertias(tree));
  }

  /** Lays out the steps and notes the blocks of the links; returns the length of all blocks. */
  private int lay(List<Step> laid, boolean armed) {
    EnumMap<StepKind, StepKernel> kernels = new EnumMap<>(StepKind.class);
    int elementary = -1;
    int at = StepBlock.SIZE;
    for (int i = 0; i < blocks.length; i++) {
      Link link = links.links().get(i);
      do {
        elementary++;
      } while (tree.kind[elementary] == LinkKind.FIXED);
      boolean onRoot = link.parent() == Links.ROOT;
      int parent = onRoot ? 0 : blocks[link.parent()];
      if (link.axes().turn().isPresent()) {
        StepKind kind = StepKind.ofTurn(link.axes().turn().get().axis());
        StepKernel kernel = kernels.computeIfAbsent(kind, PrintedSteps::of);
        laid.add(new Step(kernel, at, parent, onRoot, -1, false, LinkKind.FIXED, false, 0, -1, -1));
        parent = at;
        at += kind.size();
      }
      StepKind kind = StepKind.of(link, armed);
      laid.add(
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

  /** Begins to check the pivots of an elimination at the coordinates of the motion. */
  void startChecks() {
    check.start();
    composed = false;
  }

  /** Returns the check of the pivots since {@link #startChecks}. */
  PivotCheck check() {
    return check;
  }

  /**
   * Checks the pivots of a joint that has been eliminated.
   *
   * @return {@link ExplicitModel#REGULAR}, or a velocity without inertia
   */
  int singular(Step step) {
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
  double scale(int velocity) {
    if (!composed) {
      motion.sweepRelative();
      rigid.compose(motion);
      composed = true;
    }
    return rigid.scale(tree.linkOfVelocity[velocity]);
  }

  /** Forgets the inertias of a sweep that has not come to its end. */
  void clear() {
    for (Step step : steps) {
      clear(step);
    }
  }

  /** Forgets the inertia beyond a step. */
  void clear(Step step) {
    int at = step.at + StepBlock.INERTIA;
    Arrays.fill(w, at, at + StepBlock.INERTIA_COUNT, 0);
  }

  /** Reads the results of a joint's velocities into an array of extended velocities. */
  void get(Step step, double[] out, int outAt) {
    int at = outAt + step.velocity;
    out[at] = w[step.result()];
    if (step.isBall()) {
      out[at + 1] = w[step.result() + 1];
      out[at + 2] = w[step.result() + 2];
    }
  }

  /** Writes a joint's coordinates and applied forces, and the accelerations of a driven one. */
  void place(Step step, double[] tau) {
    if (step.isBall()) {
      placeBall(step, tau);
      return;
    }
    int at = step.at;
    position(step);
    w[at + StepBlock.VELOCITY] = motion.v[step.velocity];
    w[at + StepBlock.TAU] = tau[step.velocity];
    if (step.driven) {
      w[at + StepBlock.KNOWN] = motion.a[step.velocity];
    }
  }

  /** Writes a joint's positions alone. */
  void position(Step step) {
    int at = step.at;
    if (step.isBall()) {
      rotate(step);
      return;
    }
    double q = motion.q[step.position];
    w[at + StepBlock.POSITION] = q;
    if (step.kind != LinkKind.SLIDE) {
      SinCos.sinCos(q, sinCos, 0);
      w[at + StepBlock.SINE] = sinCos[0];
      w[at + StepBlock.COSINE] = sinCos[1];
    }
    if (step.way != 0) {
      bounds.reached(step.index, step.way * q);
    }
  }

  private void rotate(Step step) {
    int r = step.at + StepBlock.ROTATION;
    EulerParameters.rotation(motion.q, step.position, w, r);
    if (step.inverse) {
      exchange(r + 1, r + 3);
      exchange(r + 2, r + 6);
      exchange(r + 5, r + 7);
    }
  }

  private void placeBall(Step step, double[] tau) {
    rotate(step);
    for (int k = 0; k < 3; k++) {
      int velocity = step.velocity + k;
      w[step.at + StepBlock.BALL_VELOCITY + k] = motion.v[velocity];
      if (step.driven) {
        w[step.at + StepBlock.BALL_KNOWN + k] = motion.a[velocity];
      }
    }
    force(step, tau, 0, step.at + StepBlock.BALL_TAU);
  }

  /**
   * Writes the forces on a joint along its degrees of freedom.
   *
   * @param tau one number per velocity, of this joint's from its velocity's index less {@code less}
   * @param to where they are written
   */
  void force(Step step, double[] tau, int less, int to) {
    int from = step.velocity - less;
    if (!step.isBall()) {
      w[to] = tau[from];
      return;
    }
    // moments along the velocities of the state, turned to link axes
    int r = step.at + StepBlock.ROTATION;
    for (int k = 0; k < 3; k++) {
      w[to + k] =
          step.inverse
              ? 0 - tau[from + k]
              : w[r + k] * tau[from] + w[r + 3 + k] * tau[from + 1] + w[r + 6 + k] * tau[from + 2];
    }
  }

  private void exchange(int i, int j) {
    double wi = w[i];
    w[i] = w[j];
    w[j] = wi;
  }
}

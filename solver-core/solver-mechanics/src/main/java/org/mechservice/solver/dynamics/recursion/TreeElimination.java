package org.mechservice.solver.dynamics.recursion;

import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.recursion.StepBlocks.Step;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.CarriedWrench;
import org.mechservice.solver.step.StepBlock;

/**
 * The elimination of a tree's joints from its articulated inertias, link by link, by printed steps
 * ({@code solver.step}): for recursions that carry wrenches of multipliers inwards beside the
 * inertias. The caller eliminates all links, those outermost first; then it solves for as many
 * forces as it likes, each time pushing all links inwards and moving all links outwards.
 *
 * <p>Links are those that move ({@link Links}): bodies welded to one belong to it. Wrenches are
 * [moment; force], and motions [angular; linear], in the computing frame of a link at its origin.
 *
 * <p>Workspace of one thread; nothing allocates after construction.
 */
public final class TreeElimination {
  private static final int NO_TURN = -1;

  private final StepBlocks blocks;
  private final TreeGeometry tree;
  private final double[] w;
  private final BodyLoads bodies;

  /**
   * For each link its joint's step, and the index of that of the constant turn before it, or −1.
   */
  private final Step[] joints;

  private final int[] turns;

  /** For each link of the tree, the link that carries it, and a body on it or −1. */
  private final int[] carrier;

  private final int[] bodyOf;
  private final int[] parent;

  /** Where the wrench that is being carried is. */
  private final int carried;

  /** Own inertias of the joints, one per link. */
  private final double[] armature;

  /** Whether joints may be given inertia. */
  private final boolean arms;

  /**
   * Inertia of a link and of its parent before the last elimination, if joints may be given some.
   */
  private final double[] before;

  /**
   * @param motion has the coordinates, set by the caller before {@link #start}
   * @param arms whether joints may be given inertia ({@link #arm}), which takes more time
   */
  public TreeElimination(TreeMotion motion, boolean arms) {
    this.arms = arms;
    tree = motion.tree();
    blocks = new StepBlocks(motion, arms, CarriedWrench.SIZE);
    w = blocks.w;
    carried = w.length - CarriedWrench.SIZE;
    List<Link> links = blocks.links.links();
    bodies = new BodyLoads(tree, blocks.links, blocks.blocks);
    joints = new Step[links.size()];
    turns = new int[links.size()];
    parent = links.stream().mapToInt(Link::parent).toArray();
    armature = links.stream().mapToDouble(Link::armature).toArray();
    before = new double[arms ? 2 * StepBlock.INERTIA_COUNT : 0];
    Arrays.fill(turns, NO_TURN);
    int next = 0;
    for (int i = 0; i < blocks.steps.length; i++) {
      if (blocks.steps[i].isTurn()) {
        turns[next] = i;
      } else {
        joints[next++] = blocks.steps[i];
      }
    }
    carrier = new int[tree.linkCount];
    int moving = 0;
    for (int link = 0; link < carrier.length; link++) {
      int inner = tree.parent[link];
      carrier[link] =
          tree.kind[link] != LinkKind.FIXED
              ? moving++
              : inner == TreeGeometry.ROOT ? Links.ROOT : carrier[inner];
    }
    bodyOf = new int[tree.linkCount];
    Arrays.fill(bodyOf, -1);
    for (int body = 0; body < tree.linkOfBody.length; body++) {
      bodyOf[tree.linkOfBody[body]] = body;
    }
  }

  /** Returns the number of links. */
  public int count() {
    return joints.length;
  }

  /** Returns the parent of each link, which has a lower index, or {@link Links#ROOT}. */
  public int[] parents() {
    return parent.clone();
  }

  /** Returns the link that carries a link of the tree, or {@link Links#ROOT}. */
  public int carrier(int ofTree) {
    return carrier[ofTree];
  }

  /** Returns the first velocity of a link's joint among the extended ones. */
  public int velocity(int link) {
    return joints[link].velocity();
  }

  /** Returns the number of velocities of a link's joint. */
  public int freedoms(int link) {
    return joints[link].kind().velocityCount();
  }

  /** Returns whether the joint of a link is driven. */
  public boolean isDriven(int link) {
    return joints[link].driven();
  }

  /** Begins an elimination at the coordinates of the motion. */
  public void start() {
    for (Step step : blocks.steps) {
      if (!step.isTurn()) {
        blocks.position(step);
        w[step.at() + StepBlock.ARMATURE] = armature[step.index()];
      }
      clearWrench(step);
    }
    blocks.startChecks();
  }

  private void clearWrench(Step step) {
    int at = step.at() + StepBlock.WRENCH;
    Arrays.fill(w, at, at + 6, 0);
  }

  /** Gives up an elimination that has not come to its end. */
  public void giveUp() {
    blocks.clear();
  }

  /**
   * Adds a wrench on a link of the tree to one in the frame of its carrier.
   *
   * @param ofTree a link with a body
   * @param wrench in that link's axes at its reference point, from {@code from}
   */
  public void addInFrame(int ofTree, double[] wrench, int from, double[] sum, int at) {
    bodies.add(bodyOf[ofTree], wrench, from, sum, at);
  }

  /** Adds factor · k kᵀ to the articulated inertia of a link. */
  public void addInertia(int link, double[] k, int from, double factor) {
    int at = joints[link].at() + StepBlock.INERTIA;
    double x = k[from];
    double y = k[from + 1];
    double z = k[from + 2];
    double fx = factor * k[from + 3];
    double fy = factor * k[from + 4];
    double fz = factor * k[from + 5];
    w[at] += factor * x * x;
    w[at + 1] += factor * y * y;
    w[at + 2] += factor * z * z;
    w[at + 3] += factor * x * y;
    w[at + 4] += factor * x * z;
    w[at + 5] += factor * y * z;
    w[at + 6] += x * fx;
    w[at + 7] += x * fy;
    w[at + 8] += x * fz;
    w[at + 9] += y * fx;
    w[at + 10] += y * fy;
    w[at + 11] += y * fz;
    w[at + 12] += z * fx;
    w[at + 13] += z * fy;
    w[at + 14] += z * fz;
    w[at + 15] += k[from + 3] * fx;
    w[at + 16] += k[from + 4] * fy;
    w[at + 17] += k[from + 5] * fz;
    w[at + 18] += k[from + 3] * fy;
    w[at + 19] += k[from + 3] * fz;
    w[at + 20] += k[from + 4] * fz;
  }

  /**
   * Eliminates the joint of a link and adds what is left of its inertia to the parent's.
   *
   * @return {@link ExplicitModel#REGULAR}, or a velocity of the joint that moves no inertia
   */
  public int eliminate(int link) {
    Step joint = joints[link];
    if (arms) {
      keep(joint.at(), 0);
      keep(joint.parent(), StepBlock.INERTIA_COUNT);
    }
    if (joint.onRoot()) {
      joint.kernel().inertiaOnRoot(w, joint.at(), joint.parent());
      return blocks.singular(joint);
    }
    joint.kernel().inertia(w, joint.at(), joint.parent());
    int singular = blocks.singular(joint);
    if (singular == ExplicitModel.REGULAR) {
      passTurn(link);
    }
    return singular;
  }

  private void keep(int block, int at) {
    System.arraycopy(w, block + StepBlock.INERTIA, before, at, StepBlock.INERTIA_COUNT);
  }

  /** Takes a failed elimination of a link back and gives its joint inertia of its own. */
  public void arm(int link, double inertia) {
    Step joint = joints[link];
    int count = StepBlock.INERTIA_COUNT;
    System.arraycopy(before, 0, w, joint.at() + StepBlock.INERTIA, count);
    System.arraycopy(before, count, w, joint.parent() + StepBlock.INERTIA, count);
    w[joint.at() + StepBlock.ARMATURE] += inertia;
  }

  /** Adds the inertia of a link to the parent's with its joint as it is. */
  public void carry(int link) {
    Step joint = joints[link];
    if (!joint.onRoot()) {
      joint.kernel().pass(w, joint.at(), joint.parent());
    }
    blocks.clear(joint);
    passTurn(link);
  }

  private void passTurn(int link) {
    if (turns[link] != NO_TURN) {
      Step turn = blocks.steps[turns[link]];
      if (!turn.onRoot()) {
        turn.kernel().pass(w, turn.at(), turn.parent());
      }
    }
  }

  /** Returns D of a degree of freedom of an eliminated joint. */
  public double pivot(int link, int freedom) {
    return w[joints[link].at() + StepBlock.freedom(freedom)];
  }

  /**
   * Carries the wrench of a multiplier over an eliminated joint.
   *
   * @param k the wrench on the link, from {@code from}; not modified
   * @param along the multiplier's force on the joint itself by each velocity; overwritten with its
   *     whole component along each degree of freedom
   * @param sum wrench on the parent, from {@code at}; added to, unless the parent is the root
   */
  public void couple(int link, double[] k, int from, double[] along, double[] sum, int at) {
    Step joint = joints[link];
    System.arraycopy(k, from, w, carried + CarriedWrench.BEFORE, 6);
    int n = joint.kind().velocityCount();
    blocks.force(joint, along, joint.velocity(), carried + CarriedWrench.ALONG);
    if (joint.onRoot()) {
      joint.kernel().coupleOnRoot(w, joint.at(), carried);
    } else {
      joint.kernel().couple(w, joint.at(), carried);
      addCarried(link, sum, at);
    }
    System.arraycopy(w, carried + CarriedWrench.ALONG, along, 0, n);
  }

  /** Carries the wrench of a multiplier over a joint as it is; arguments as of {@link #couple}. */
  public void transfer(int link, double[] k, int from, double[] sum, int at) {
    Step joint = joints[link];
    if (!joint.onRoot()) {
      System.arraycopy(k, from, w, carried + CarriedWrench.BEFORE, 6);
      joint.kernel().transfer(w, joint.at(), carried);
      addCarried(link, sum, at);
    }
  }

  private void addCarried(int link, double[] sum, int at) {
    if (turns[link] != NO_TURN) {
      Step turn = blocks.steps[turns[link]];
      int before = carried + CarriedWrench.BEFORE;
      System.arraycopy(w, carried + CarriedWrench.AFTER, w, before, 6);
      turn.kernel().transfer(w, turn.at(), carried);
    }
    for (int i = 0; i < 6; i++) {
      sum[at + i] += w[carried + CarriedWrench.AFTER + i];
    }
  }

  /** Begins to push the links inwards, without any wrench on them. */
  public void startPush() {
    for (Step step : blocks.steps) {
      clearWrench(step);
    }
  }

  /** Adds factor · k to the wrench on a link. */
  public void addWrench(int link, double[] k, int from, double factor) {
    int at = joints[link].at() + StepBlock.WRENCH;
    for (int i = 0; i < 6; i++) {
      w[at + i] += factor * k[from + i];
    }
  }

  /**
   * Pushes an eliminated joint, and adds what is left of the wrench on its link to the parent's.
   *
   * @param force one number per velocity of the state; not modified
   */
  public void push(int link, double[] force) {
    Step joint = joints[link];
    int tau = joint.isBall() ? StepBlock.BALL_TAU : StepBlock.TAU;
    blocks.force(joint, force, 0, joint.at() + tau);
    if (joint.onRoot()) {
      joint.kernel().pushOnRoot(w, joint.at(), joint.parent());
    } else {
      joint.kernel().push(w, joint.at(), joint.parent());
      passWrench(link);
    }
  }

  /** Adds the wrench on a link to the parent's with its joint as it is. */
  public void pass(int link) {
    Step joint = joints[link];
    if (!joint.onRoot()) {
      joint.kernel().force(w, joint.at(), joint.parent());
      passWrench(link);
    }
  }

  private void passWrench(int link) {
    if (turns[link] != NO_TURN) {
      Step turn = blocks.steps[turns[link]];
      turn.kernel().force(w, turn.at(), turn.parent());
    }
  }

  /**
   * Returns u / D of a degree of freedom as pushed: its acceleration while the parent is at rest.
   */
  public double rate(int link, int freedom) {
    return w[joints[link].at() + StepBlock.freedom(freedom) + 1];
  }

  /** Adds to the u / D of a degree of freedom. */
  public void addRate(int link, int freedom, double more) {
    w[joints[link].at() + StepBlock.freedom(freedom) + 1] += more;
  }

  /**
   * Moves a link outwards with the parent and its eliminated joint.
   *
   * @param x accelerations of the state, from {@code at}; those of the joint are overwritten
   */
  public void move(int link, double[] x, int at) {
    Step joint = joints[link];
    carryMotion(link);
    joint.kernel().acceleration(w, joint.at(), joint.parent());
    blocks.get(joint, x, at);
  }

  /** Moves a link outwards with the parent, its joint as it is. */
  public void move(int link) {
    Step joint = joints[link];
    carryMotion(link);
    joint.kernel().carry(w, joint.at(), joint.parent());
  }

  private void carryMotion(int link) {
    if (turns[link] != NO_TURN) {
      Step turn = blocks.steps[turns[link]];
      turn.kernel().carry(w, turn.at(), turn.parent());
    }
  }

  /** Returns the product of a wrench with the motion of a link, as last moved. */
  public double felt(int link, double[] k, int from) {
    int at = joints[link].at() + StepBlock.ADDED;
    double sum = 0;
    for (int i = 0; i < 6; i++) {
      sum += k[from + i] * w[at + i];
    }
    return sum;
  }

  /**
   * Returns an upper estimate of the largest diagonal element of M at the coordinates of the
   * motion: the largest inertia that one joint moves while all others are at rest.
   *
   * @param units of the velocities of the state, by which displacements are lengths
   */
  public double largestInertia(double[] units) {
    blocks.startChecks();
    double largest = 0;
    for (int k = 0; k < units.length; k++) {
      double inertia = blocks.scale(k) + tree.armature[k];
      largest = Math.max(largest, inertia * units[k] * units[k]);
    }
    return largest;
  }
}

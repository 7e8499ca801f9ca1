package org.mechservice.solver.mechanism;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.StateVariable;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.spatial.Vector3;

/**
 * A mechanism: rigid bodies connected by joints to a root at rest, with closures of loops and
 * applied forces.
 *
 * <p>Bodies and joints stand in the order of the model file. Each body is the child of exactly one
 * joint of the tree. The state y = [q; v; s] takes these joints in that order, leaving out the
 * driven ones, and then the further states; {@link #outward()} gives the joints from the root to
 * the leaves.
 */
public final class Mechanism {
  /** Most times at which the equations change their form that are known of an interval. */
  public static final int MOST_TIME_JUMPS = 1_000_000;

  /** Body index of the root. */
  public static final int ROOT = -1;

  private static final int NOT_DRIVEN = -1;

  private final String name;
  private final Root root;
  private final Vector3 gravity;
  private final List<Body> bodies;
  private final List<Joint> joints;
  private final List<PrescribedMotion> motions;
  private final List<StartRole> startRoles;
  private final List<LoopClosure> closures;
  private final List<ForceElement> forces;
  private final List<Parameter> parameters;
  private final List<Event> events;
  private final List<FurtherState> furtherStates;
  private final List<Sampling> samplings;
  private final List<Armature> armatures;
  private final int[] outward;
  private final int[] jointOfBody;
  private final int[] motionOfJoint;
  private final int[] positionOffset;
  private final int[] velocityOffset;

  /**
   * Joins bodies to a tree without driven joints, loops and forces but gravity.
   *
   * @param name the model's name
   * @param root the body at rest
   * @param gravity acceleration of free fall in world axes, m/s²
   * @param bodies the moving bodies in file order
   * @param joints one joint per body in file order, each leading from the parent outwards
   * @throws IllegalArgumentException if a body index is out of range, a body is the child of no
   *     joint or of two, or the joints do not lead from the root to every body
   */
  public Mechanism(String name, Root root, Vector3 gravity, List<Body> bodies, List<Joint> joints) {
    this(
        name,
        root,
        gravity,
        bodies,
        joints,
        List.of(),
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        List.of(),
        List.of(),
        List.of());
  }

  /**
   * Joins bodies to a tree, closes its loops and applies forces.
   *
   * @param name the model's name
   * @param root the body at rest
   * @param gravity acceleration of free fall in world axes, m/s²
   * @param bodies the moving bodies in file order
   * @param joints one joint of the tree per body in file order, each leading from the parent
   *     outwards
   * @param motions prescribed motions of joints of the tree, at most one per joint
   * @param startRoles how far assembly may move each joint of the tree
   * @param closures cut joints and other constraints
   * @param forces all applied forces except gravity
   * @param parameters numbers that expressions refer to
   * @throws IllegalArgumentException if a body index is out of range, a body is the child of no
   *     joint or of two, or the joints do not lead from the root to every body; if a motion does
   *     not fit its joint, or there is not one start role per joint
   */
  public Mechanism(
      String name,
      Root root,
      Vector3 gravity,
      List<Body> bodies,
      List<Joint> joints,
      List<PrescribedMotion> motions,
      List<StartRole> startRoles,
      List<LoopClosure> closures,
      List<ForceElement> forces,
      List<Parameter> parameters) {
    this.name = name;
    this.root = root;
    this.gravity = gravity;
    this.bodies = List.copyOf(bodies);
    this.joints = List.copyOf(joints);
    this.motions = List.copyOf(motions);
    this.startRoles = List.copyOf(startRoles);
    this.closures = List.copyOf(closures);
    this.forces = List.copyOf(forces);
    this.parameters = List.copyOf(parameters);
    this.events = List.of();
    this.furtherStates = List.of();
    this.samplings = List.of();
    this.armatures = List.of();
    this.jointOfBody = jointOfBody(this.bodies, this.joints);
    this.outward = outward(this.bodies, this.joints, jointOfBody);
    this.motionOfJoint = motionOfJoint(this.joints, this.motions);
    this.positionOffset = new int[joints.size() + 1];
    this.velocityOffset = new int[joints.size() + 1];
    requireRoles();
    for (int i = 0; i < joints.size(); i++) {
      JointType type = this.joints.get(i).type();
      boolean free = motionOfJoint[i] == NOT_DRIVEN;
      positionOffset[i + 1] = positionOffset[i] + (free ? type.positionCount() : 0);
      velocityOffset[i + 1] = velocityOffset[i] + (free ? type.velocityCount() : 0);
    }
  }

  /** Copies a mechanism with other parameters, events, further states, samplings and armatures. */
  private Mechanism(
      Mechanism like,
      List<Parameter> parameters,
      List<Event> events,
      List<FurtherState> furtherStates,
      List<Sampling> samplings,
      List<Armature> armatures) {
    this.name = like.name;
    this.root = like.root;
    this.gravity = like.gravity;
    this.bodies = like.bodies;
    this.joints = like.joints;
    this.motions = like.motions;
    this.startRoles = like.startRoles;
    this.closures = like.closures;
    this.forces = like.forces;
    this.parameters = List.copyOf(parameters);
    this.events = List.copyOf(events);
    this.furtherStates = List.copyOf(furtherStates);
    this.samplings = List.copyOf(samplings);
    this.armatures = List.copyOf(armatures);
    this.jointOfBody = like.jointOfBody;
    this.outward = like.outward;
    this.motionOfJoint = like.motionOfJoint;
    this.positionOffset = like.positionOffset;
    this.velocityOffset = like.velocityOffset;
  }

  private void requireRoles() {
    if (startRoles.size() != joints.size()) {
      throw new IllegalArgumentException(
          "there are " + startRoles.size() + " start roles for " + joints.size() + " joints");
    }
  }

  private static int[] motionOfJoint(List<Joint> joints, List<PrescribedMotion> motions) {
    int[] motionOf = new int[joints.size()];
    Arrays.fill(motionOf, NOT_DRIVEN);
    for (int m = 0; m < motions.size(); m++) {
      PrescribedMotion motion = motions.get(m);
      if (motion.joint() < 0 || motion.joint() >= joints.size()) {
        throw new IllegalArgumentException("a motion names joint " + motion.joint());
      }
      Joint joint = joints.get(motion.joint());
      int coordinates = joint.type().positionCount();
      if (motion.coordinates().size() != coordinates) {
        throw new IllegalArgumentException(
            "joint "
                + joint.name()
                + " has "
                + coordinates
                + " coordinates but "
                + motion.coordinates().size()
                + " motions");
      }
      if (motionOf[motion.joint()] != NOT_DRIVEN) {
        throw new IllegalArgumentException("joint " + joint.name() + " is driven twice");
      }
      motionOf[motion.joint()] = m;
    }
    return motionOf;
  }

  private static int[] jointOfBody(List<Body> bodies, List<Joint> joints) {
    int[] jointOf = new int[bodies.size()];
    Arrays.fill(jointOf, -1);
    for (int j = 0; j < joints.size(); j++) {
      Attachment attachment = joints.get(j).attachment();
      int child = attachment.child();
      if (child < 0 || child >= bodies.size() || attachment.parent() >= bodies.size()) {
        throw new IllegalArgumentException(
            "joint " + joints.get(j).name() + " names a body that is not there");
      }
      if (jointOf[child] != -1) {
        throw new IllegalArgumentException(
            "body " + bodies.get(child).name() + " is the child of two joints");
      }
      jointOf[child] = j;
    }
    return jointOf;
  }

  private static int[] outward(List<Body> bodies, List<Joint> joints, int[] jointOfBody) {
    List<Integer> order = new ArrayList<>();
    boolean[] reached = new boolean[bodies.size()];
    int[] onPathOf = new int[bodies.size()];
    Arrays.fill(onPathOf, ROOT);
    for (int body = 0; body < bodies.size(); body++) {
      List<Integer> path = new ArrayList<>();
      for (int b = body; b != ROOT && !reached[b]; ) {
        int joint = jointOfBody[b];
        if (joint == -1 || onPathOf[b] == body) {
          throw new IllegalArgumentException(
              "body " + bodies.get(b).name() + " does not hang on the root");
        }
        onPathOf[b] = body;
        path.add(joint);
        b = joints.get(joint).attachment().parent();
      }
      for (int i = path.size() - 1; i >= 0; i--) {
        order.add(path.get(i));
        reached[joints.get(path.get(i)).attachment().child()] = true;
      }
    }
    return order.stream().mapToInt(Integer::intValue).toArray();
  }

  /** Returns the model's name. */
  public String name() {
    return name;
  }

  /** Returns the body at rest. */
  public Root root() {
    return root;
  }

  /** Returns the acceleration of free fall in world axes, m/s². */
  public Vector3 gravity() {
    return gravity;
  }

  /** Returns the moving bodies in file order. */
  public List<Body> bodies() {
    return bodies;
  }

  /** Returns the joints in file order, which is state order. */
  public List<Joint> joints() {
    return joints;
  }

  /**
   * Returns the joints' indices from the root to the leaves: every joint comes after the joint of
   * its parent body.
   */
  public int[] outward() {
    return outward.clone();
  }

  /** Returns the index of the joint whose child is {@code body}. */
  public int jointOf(int body) {
    return jointOfBody[body];
  }

  /** Returns the prescribed motions of joints of the tree. */
  public List<PrescribedMotion> motions() {
    return motions;
  }

  /** Returns how far assembly may move each joint of the tree. */
  public List<StartRole> startRoles() {
    return startRoles;
  }

  /** Returns the cut joints and other constraints, in file order. */
  public List<LoopClosure> closures() {
    return closures;
  }

  /** Returns the joint that a coordinate belongs to, of the tree or cut. */
  public Joint jointOf(Coordinate coordinate) {
    return coordinate instanceof JointCoordinate inTree
        ? joints.get(inTree.joint())
        : ((JointClosure) closures.get(((ClosureCoordinate) coordinate).closure())).joint();
  }

  /**
   * Returns the rate of a leaf of a formula of positions: of a place of a point its velocity, of a
   * position of a coordinate that one's, of time 1, of anything else 0.
   *
   * @throws IllegalArgumentException of an Euler parameter, whose rate is no coordinate
   */
  public Expression rateOf(Expression leaf) {
    if (leaf instanceof Expression.PointPosition point) {
      return new Expression.PointVelocity(point.point(), point.axis());
    } else if (leaf instanceof Expression.CoordinatePosition position) {
      return new Expression.CoordinateVelocity(velocityOf(position.coordinate()));
    }
    return leaf instanceof Expression.Time ? Expression.of(1) : Expression.ZERO;
  }

  private Coordinate velocityOf(Coordinate position) {
    JointType type = jointOf(position).type();
    int surplus = type.positionCount() - type.velocityCount();
    int component =
        position instanceof JointCoordinate inTree
            ? inTree.component()
            : ((ClosureCoordinate) position).component();
    if (component < 0
        || component >= type.positionCount()
        || (type.hasEulerParameters() && component < 4)) {
      throw new IllegalArgumentException(
          "position " + component + " of joint " + jointOf(position).name() + " has no velocity");
    }
    return position instanceof JointCoordinate inTree
        ? new JointCoordinate(inTree.joint(), component - surplus)
        : new ClosureCoordinate(((ClosureCoordinate) position).closure(), component - surplus);
  }

  /** Returns the applied forces besides gravity, in file order. */
  public List<ForceElement> forces() {
    return forces;
  }

  /** Returns whether classes of users compute some of its forces. */
  public boolean hasUserClasses() {
    return forces.stream().anyMatch(UserForceElement.class::isInstance);
  }

  /** Returns the numbers that expressions refer to. */
  public List<Parameter> parameters() {
    return parameters;
  }

  /** Returns the events of a simulation, in file order. */
  public List<Event> events() {
    return events;
  }

  /**
   * Returns the times at which the equations change their form because of an expression of time,
   * such as {@code step(t-1)}, ascending; no more than {@link #MOST_TIME_JUMPS} of them.
   *
   * @param from first time of interest, s
   * @param to last one, s
   */
  public List<Double> timeJumps(double from, double to) {
    return TimePlaces.of(this, from, to);
  }

  /**
   * Returns the times at which the position or the velocity of a driven joint jumps, in order.
   *
   * @param from first time of interest, s; jumps at this time are left out
   * @param to last one, s
   */
  public List<MotionJump> motionJumps(double from, double to) {
    return MotionJumps.of(this, from, to);
  }

  /**
   * Returns whether jumps at times given by formulas are possible in a run: of the equations, or of
   * the motion of a driven joint.
   */
  public boolean mayJump() {
    return MotionJumps.possible(this) || TimePlaces.possible(this);
  }

  /** Returns the same mechanism with other events along its simulation. */
  public Mechanism withEvents(List<Event> other) {
    return new Mechanism(this, parameters, other, furtherStates, samplings, armatures);
  }

  /** Returns the same mechanism with other states besides positions and velocities. */
  public Mechanism withFurtherStates(List<FurtherState> other) {
    return new Mechanism(this, parameters, events, other, samplings, armatures);
  }

  /** Returns the same mechanism with further states that are sampled. */
  public Mechanism withSamplings(List<Sampling> other) {
    return new Mechanism(this, parameters, events, furtherStates, other, armatures);
  }

  /**
   * Returns the same mechanism with other armatures.
   *
   * @throws IllegalArgumentException if one does not fit its joint, or a joint has two
   */
  public Mechanism withArmatures(List<Armature> other) {
    Armature.check(other, joints);
    return new Mechanism(this, parameters, events, furtherStates, samplings, other);
  }

  /** Returns the armatures of the joints that have one, in file order. */
  public List<Armature> armatures() {
    return armatures;
  }

  /** Returns whether inertia of its own resists each velocity of a joint. */
  public boolean isWhollyArmed(int joint) {
    return armatures.stream().anyMatch(a -> a.joint() == joint && a.isWhole());
  }

  /** Returns the samplings that set further states at given times. */
  public List<Sampling> samplings() {
    return samplings;
  }

  /**
   * Returns the formulas that a step could pass over: those with choices that depend on the state,
   * and those that can be large over a short way.
   */
  public List<Expression> watchedFormulas() {
    return WatchedFormulas.of(this);
  }

  /** Returns how far the shapes in contact are inside each other, in file order. */
  public List<Overlap> overlaps() {
    return Overlap.of(this);
  }

  /**
   * Returns whether the state or the equations of a run may change abruptly, or over a short way.
   */
  public boolean mayChangeAbruptly() {
    return !events.isEmpty() || !samplings.isEmpty() || mayJump() || !watchedFormulas().isEmpty();
  }

  /** Returns the states besides positions and velocities, in file order. */
  public List<FurtherState> furtherStates() {
    return furtherStates;
  }

  /**
   * Returns the same mechanism with other values of its parameters.
   *
   * @param values in the order of {@link #parameters}, in the units of the model file
   */
  public Mechanism with(double[] values) {
    List<Parameter> changed = new ArrayList<>();
    for (Parameter parameter : parameters) {
      changed.add(parameter.with(values[changed.size()]));
    }
    return new Mechanism(this, changed, events, furtherStates, samplings, armatures);
  }

  /** Returns whether a joint's coordinates follow a prescribed motion and are no states. */
  public boolean isDriven(int joint) {
    return motionOfJoint[joint] != NOT_DRIVEN;
  }

  /** Returns the index in q of the first position of joint {@code joint}; -1 for a driven joint. */
  public int positionOffset(int joint) {
    return isDriven(joint) ? -1 : positionOffset[joint];
  }

  /** Returns the index in v of the first velocity of joint {@code joint}; -1 for a driven joint. */
  public int velocityOffset(int joint) {
    return isDriven(joint) ? -1 : velocityOffset[joint];
  }

  /** Returns the number of positions, nq. */
  public int positionCount() {
    return positionOffset[joints.size()];
  }

  /** Returns the number of velocities, nv. */
  public int velocityCount() {
    return velocityOffset[joints.size()];
  }

  /** Returns names, units and tolerances of the further states. */
  public List<StateVariable> stateVariables() {
    return furtherStates.stream()
        .map(s -> new StateVariable(s.name(), s.unit(), s.absoluteTolerance()))
        .toList();
  }

  /** Returns the length of the state [q; v; s]: positions, velocities and further states. */
  public int stateCount() {
    return positionCount() + velocityCount() + furtherStates.size();
  }

  /** Returns the index of the first further state in the state [q; v; s]. */
  public int furtherOffset() {
    return positionCount() + velocityCount();
  }

  /**
   * Writes the state at the start as the file gives it, before loops are assembled.
   *
   * @param y state [q; v; s], or [q; v] alone; overwritten
   */
  public void initialState(double[] y) {
    for (int i = 0; furtherOffset() + i < y.length && i < furtherStates.size(); i++) {
      y[furtherOffset() + i] = furtherStates.get(i).start();
    }
    for (int j = 0; j < joints.size(); j++) {
      if (!isDriven(j)) {
        joints.get(j).initialPositions(y, positionOffset[j]);
        joints.get(j).initialVelocities(y, positionCount() + velocityOffset[j]);
      }
    }
  }
}

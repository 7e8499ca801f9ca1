package org.mechservice.robot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.document.Element;
import org.mechservice.robot.Robot.Frame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.mechanism.Armature;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.LawForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Cylindrical;
import org.mechservice.solver.mechanism.joint.Free;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Planar;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Spherical;
import org.mechservice.solver.mechanism.joint.Universal;
import org.mechservice.solver.mechanism.joint.Weld;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

/**
 * A mechanism as a model of MuJoCo: nested bodies with the frames of the mechanism's, each with the
 * joints to the body around it. A body without mass between two joints is left away, and the body
 * beyond has the joints of both. Loops are equations of welded, connected or hinged sites,
 * couplings equations of joints or tendons; springs along couplings and between points are tendons,
 * forces that are linear in an input motors ({@link MjcfMotors}). The start is a key of the name
 * {@code start}.
 *
 * <p>Source: MuJoCo documentation, XML reference.
 */
final class MjcfWriter {
  /** Longer than any tendon, m or rad. */
  private static final double FAR = 1e6;

  /** Half the distance of the two points on the axis of a cut hinge, m. */
  private static final double ARM = 0.1;

  private final MechmlModel model;
  private final Mechanism mechanism;
  private final ExportLosses losses;
  private final MjcfMotors motors;
  private final Map<Integer, List<Integer>> below = new LinkedHashMap<>();
  private final Map<Integer, List<TagBuilder>> sites = new HashMap<>();
  private final Map<JointCoordinate, MjcfCoordinate> along = new HashMap<>();
  private final Map<Integer, double[]> damped = new HashMap<>();
  private final TagBuilder tendons = new TagBuilder("tendon");
  private final TagBuilder equations = new TagBuilder("equality");
  private final List<Double> positions = new ArrayList<>();
  private final List<Double> velocities = new ArrayList<>();
  private final Set<String> tendonNames = new HashSet<>();
  private final Set<Integer> merged = new HashSet<>();
  private boolean moved;

  MjcfWriter(MechmlModel model, ExportLosses losses) {
    this.model = model;
    this.losses = losses;
    mechanism = model.mechanism();
    for (int j : mechanism.outward()) {
      below
          .computeIfAbsent(mechanism.joints().get(j).attachment().parent(), k -> new ArrayList<>())
          .add(j);
    }
    for (int j = 0; j < mechanism.joints().size(); j++) {
      addCoordinates(j);
    }
    motors = new MjcfMotors(mechanism, along, losses);
  }

  /** Gives each coordinate that is a hinge or a slide of MuJoCo its name. */
  private void addCoordinates(int index) {
    Joint joint = mechanism.joints().get(index);
    int count = joint.type().positionCount();
    boolean single = count == 1 && (joint instanceof Revolute || joint instanceof Prismatic);
    boolean several =
        joint instanceof Universal || joint instanceof Cylindrical || joint instanceof Planar;
    for (int k = 0; k < count && (single || several); k++) {
      along.put(
          new JointCoordinate(index, k),
          new MjcfCoordinate(single ? joint.name() : joint.name() + "_" + (k + 1)));
    }
  }

  Element mujoco() {
    mechanism.closures().forEach(this::closure);
    mechanism.forces().forEach(this::force);
    for (Armature armature : mechanism.armatures()) {
      arm(armature);
    }
    TagBuilder world = new TagBuilder("worldbody");
    Frame root = new Frame(mechanism.root().position(), mechanism.root().orientation());
    siteTags(Mechanism.ROOT, root).forEach(world::add);
    for (int joint : below.getOrDefault(Mechanism.ROOT, List.of())) {
      world.add(body(joint, root, List.of()));
    }
    TagBuilder mujoco = new TagBuilder("mujoco").set("model", mechanism.name());
    mujoco.add(new TagBuilder("compiler").set("angle", "radian").set("autolimits", "true"));
    mujoco.add(new TagBuilder("option").set("gravity", UrdfFrames.text(mechanism.gravity())));
    mujoco.add(world).addUnlessEmpty(tendons).addUnlessEmpty(equations);
    mujoco.addUnlessEmpty(motors.actuators());
    if (moved) {
      mujoco.add(
          new TagBuilder("keyframe")
              .add(
                  new TagBuilder("key")
                      .set("name", "start")
                      .set("qpos", list(positions))
                      .set("qvel", list(velocities))));
    }
    loseTheRest();
    return mujoco.element();
  }

  private static String list(List<Double> numbers) {
    return numbers.stream().map(MechmlText::number).collect(Collectors.joining(" "));
  }

  private static TagBuilder placed(TagBuilder tag, Frame frame) {
    if (!frame.at().equals(Vector3.ZERO)) {
      tag.set("pos", UrdfFrames.text(frame.at()));
    }
    if (!frame.turn().isIdentity()) {
      tag.set("quat", list(frame.eulerParameters()));
    }
    return tag;
  }

  /** A joint of a body without mass that a body beyond takes over, with the frame of its child. */
  private record Taken(int joint, Frame child) {}

  /**
   * Returns the body that a joint leads to.
   *
   * @param outer frame of the body inward in the body of the file around this one
   * @param taken the joints of bodies without mass in between
   */
  private TagBuilder body(int index, Frame outer, List<Taken> taken) {
    Joint joint = mechanism.joints().get(index);
    Attachment at = joint.attachment();
    Frame zero =
        new Frame(
            at.parentPoint().minus(at.zeroRotation().apply(at.childPoint())), at.zeroRotation());
    Frame frame = outer.times(zero);
    List<Taken> own = new ArrayList<>(taken);
    own.add(new Taken(index, frame));
    Body body = mechanism.bodies().get(at.child());
    List<Integer> beyond = below.getOrDefault(at.child(), List.of());
    boolean rests =
        own.stream().allMatch(one -> mechanism.joints().get(one.joint()) instanceof Weld);
    if (body.isMassless() && !rests && !isFree(own) && !sites.containsKey(at.child())) {
      boolean passes =
          beyond.size() == 1 && !(mechanism.joints().get(beyond.get(0)) instanceof Free);
      if (passes) {
        merged.add(at.child());
        return body(beyond.get(0), frame, own);
      }
    }
    if (body.isMassless() && !rests) {
      losses.refuse(
          joint.origin(),
          "body \"" + body.name() + "\" has no mass; a body of MuJoCo that moves has one");
    }
    TagBuilder tag = placed(new TagBuilder("body").set("name", body.name()), frame);
    own.forEach(one -> addJoints(tag, one, frame));
    inertial(body).ifPresent(tag::add);
    addLooks(tag, body.name());
    siteTags(at.child(), Frame.SAME).forEach(tag::add);
    for (int next : beyond) {
      tag.add(body(next, Frame.SAME, List.of()));
    }
    return tag;
  }

  private boolean isFree(List<Taken> all) {
    return all.stream().anyMatch(one -> mechanism.joints().get(one.joint()) instanceof Free);
  }

  private static Optional<TagBuilder> inertial(Body body) {
    if (body.isMassless()) {
      return Optional.empty();
    }
    InertiaTensor i = body.inertia();
    return Optional.of(
        new TagBuilder("inertial")
            .set("pos", UrdfFrames.text(body.centerOfMass()))
            .set("mass", body.mass())
            .set("fullinertia", list(List.of(i.xx(), i.yy(), i.zz(), i.xy(), i.xz(), i.yz()))));
  }

  /** Adds what is seen of a body; it has no mass and touches nothing. */
  private void addLooks(TagBuilder tag, String body) {
    for (MjcfLook look : MjcfLook.of(model, body)) {
      if (look.shape().isPresent()) {
        TagBuilder geometry = placed(new TagBuilder("geom"), look.frame());
        geometry.set("type", look.shape().get()).set("size", list(look.size()));
        tag.add(
            geometry
                .set("mass", "0")
                .set("contype", "0")
                .set("conaffinity", "0")
                .set("group", "1"));
      } else {
        losses.add(
            Origin.NONE,
            "a "
                + look.kind()
                + " of body \""
                + body
                + "\" is not shown: its file has another way");
      }
    }
  }

  /** Adds the joints of MuJoCo that a joint is to a body with a frame, and their start. */
  private void addJoints(TagBuilder tag, Taken taken, Frame frame) {
    Joint joint = mechanism.joints().get(taken.joint());
    Attachment at = joint.attachment();
    Frame toBody = frame.inverse().times(taken.child());
    Vector3 point = toBody.at().plus(toBody.turn().apply(at.childPoint()));
    Rotation turn = toBody.turn().times(at.zeroRotation().transposed());
    if (mechanism.isDriven(taken.joint())) {
      losses.add(
          joint.origin(),
          "the motion of joint \"" + joint.name() + "\" is prescribed; in MJCF it is free");
    }
    double[] y = new double[mechanism.stateCount()];
    int q = joint.type().positionCount();
    joint.initialPositions(y, 0);
    joint.initialVelocities(y, q);
    if (joint instanceof Free free) {
      tag.add(
          several(
              new TagBuilder("joint").set("name", joint.name()).set("type", "free"),
              taken.joint()));
      if (at.parent() != Mechanism.ROOT) {
        losses.refuse(
            joint.origin(),
            "joint \"" + joint.name() + "\" is free beyond a body; in MJCF only beyond the world");
      }
      startFree(free, frame, y);
    } else if (joint instanceof Spherical ball) {
      tag.add(
          several(
              new TagBuilder("joint")
                  .set("name", joint.name())
                  .set("type", "ball")
                  .set("pos", UrdfFrames.text(point)),
              taken.joint()));
      startBall(ball, toBody, y);
    } else if (joint instanceof Revolute || joint instanceof Prismatic) {
      Vector3 axis = turn.apply(joint.axes().get(0));
      addSingle(tag, taken.joint(), 0, joint instanceof Revolute, point, axis, y, q);
    } else if (joint instanceof Cylindrical) {
      Vector3 axis = turn.apply(joint.axes().get(0));
      addSingle(tag, taken.joint(), 0, false, point, axis, y, q);
      addSingle(tag, taken.joint(), 1, true, point, axis, y, q);
    } else if (joint instanceof Universal universal) {
      // As for URDF: the inner axis is given in the axes of the parent, the outer in the child's.
      if (universal.fileBody2IsParent()) {
        addSingle(
            tag, taken.joint(), 1, true, point, turn.apply(universal.axis2().negated()), y, q);
        Vector3 outer = toBody.turn().apply(universal.axis1().negated());
        addSingle(tag, taken.joint(), 0, true, point, outer, y, q);
      } else {
        addSingle(tag, taken.joint(), 0, true, point, turn.apply(universal.axis1()), y, q);
        Vector3 outer = toBody.turn().apply(universal.axis2());
        addSingle(tag, taken.joint(), 1, true, point, outer, y, q);
      }
    } else if (joint instanceof Planar planar && !planar.fileBody2IsParent()) {
      Vector3 x = turn.apply(planar.direction());
      Vector3 normal = turn.apply(planar.normal());
      addSingle(tag, taken.joint(), 0, false, point, x, y, q);
      addSingle(tag, taken.joint(), 1, false, point, normal.cross(x), y, q);
      addSingle(tag, taken.joint(), 2, true, point, normal, y, q);
    } else if (!(joint instanceof Weld)) {
      losses.refuse(
          joint.origin(),
          "joint \""
              + joint.name()
              + "\" is of type "
              + joint.type()
              + ", which MJCF does not have; it has R, P, S, F and W, and C, U and PL as several");
    }
  }

  private void addSingle(
      TagBuilder tag,
      int index,
      int component,
      boolean turns,
      Vector3 point,
      Vector3 axis,
      double[] y,
      int velocity) {
    MjcfCoordinate coordinate =
        Optional.ofNullable(along.get(new JointCoordinate(index, component))).orElseThrow();
    TagBuilder one =
        new TagBuilder("joint")
            .set("name", coordinate.name())
            .set("type", turns ? "hinge" : "slide")
            .set("pos", UrdfFrames.text(point))
            .set("axis", UrdfFrames.text(axis));
    coordinate.addTo(one);
    tag.add(one);
    start(List.of(y[component]), List.of(y[velocity + component]), y[component] != 0);
  }

  /** Adds armature and damping, which a joint of several freedoms has once for all of them. */
  private TagBuilder several(TagBuilder tag, int index) {
    Joint joint = mechanism.joints().get(index);
    // MuJoCo's free joint is at the origin of the body, and so are its velocities.
    boolean atOrigin =
        !(joint instanceof Free) || joint.attachment().childPoint().equals(Vector3.ZERO);
    mechanism.armatures().stream()
        .filter(one -> one.joint() == index)
        .map(one -> one.inertias().stream().mapToDouble(Double::doubleValue).toArray())
        .forEach(all -> one(tag, "armature", joint, all, atOrigin));
    Optional.ofNullable(damped.get(index))
        .ifPresent(all -> one(tag, "damping", joint, all, atOrigin));
    return tag;
  }

  private void one(TagBuilder tag, String attribute, Joint joint, double[] each, boolean atOrigin) {
    if (atOrigin && Arrays.stream(each).allMatch(value -> value == each[0])) {
      tag.set(attribute, each[0]);
    } else {
      losses.add(
          joint.origin(),
          "the "
              + attribute
              + " of joint \""
              + joint.name()
              + "\" is left out: MJCF has one for all its velocities, at the origin of the body");
    }
  }

  /** Takes a force against a velocity of a joint with several; returns whether it is one. */
  private boolean damps(JointForce force) {
    if (!(force.coordinate() instanceof JointCoordinate at)) {
      return false;
    }
    Joint joint = mechanism.joints().get(at.joint());
    Expression velocity = new Expression.CoordinateVelocity(at);
    Optional<LinearRelation> sum =
        LinearRelation.of(force.force(), mechanism, velocity::equals)
            .filter(one -> one.constant() == 0 && one.factor(velocity) < 0);
    if (sum.isEmpty() || !joint.type().hasEulerParameters()) {
      return false;
    }
    double[] all =
        damped.computeIfAbsent(at.joint(), key -> new double[joint.type().velocityCount()]);
    all[at.component()] -= sum.get().factor(velocity);
    return true;
  }

  /** Takes the friction of a ball in its socket; returns whether it is one. */
  private boolean rubs(LawForce force) {
    List<Optional<Double>> numbers = force.numbers().stream().map(this::number).toList();
    if (force.law() != PairLaw.ROTATION_FRICTION || numbers.contains(Optional.<Double>empty())) {
      return false;
    }
    Set<Integer> bodies = Set.of(force.frame1().body(), force.frame2().body());
    for (int i = 0; i < mechanism.joints().size(); i++) {
      if (mechanism.joints().get(i) instanceof Spherical ball
          && bodies.equals(Set.of(ball.attachment().parent(), ball.attachment().child()))) {
        double[] all = damped.computeIfAbsent(i, key -> new double[3]);
        double damping = numbers.get(0).orElseThrow();
        Arrays.setAll(all, k -> all[k] + damping);
        if (numbers.get(1).orElseThrow() != 0) {
          losses.add(
              force.origin(),
              "the dry friction of \""
                  + force.name()
                  + "\" is left out: that of MJCF acts along each of three axes");
        }
        return true;
      }
    }
    return false;
  }

  private void start(List<Double> q, List<Double> v, boolean elsewhere) {
    positions.addAll(q);
    velocities.addAll(v);
    moved |= elsewhere || v.stream().anyMatch(one -> one != 0);
  }

  private static Rotation rotation(double[] e) {
    return Frame.rotation(e[0], e[1], e[2], e[3]);
  }

  /** MuJoCo: place and quaternion, velocity in the world, angular velocity in the body. */
  private void startFree(Free free, Frame zero, double[] y) {
    Attachment at = free.attachment();
    Frame moved = new Frame(new Vector3(y[4], y[5], y[6]), rotation(Arrays.copyOfRange(y, 0, 4)));
    Frame child = free.fileBody2IsParent() ? moved.inverse() : moved;
    Frame root = new Frame(mechanism.root().position(), mechanism.root().orientation());
    Frame pose =
        root.times(new Frame(at.parentPoint(), Rotation.IDENTITY))
            .times(child)
            .times(new Frame(at.childPoint().negated(), Rotation.IDENTITY));
    Vector3 spin = new Vector3(y[7], y[8], y[9]);
    Vector3 slide = new Vector3(y[10], y[11], y[12]);
    boolean rests = spin.equals(Vector3.ZERO) && slide.equals(Vector3.ZERO);
    if (free.fileBody2IsParent() && !rests) {
      losses.add(
          free.origin(),
          "the start velocity of joint \"" + free.name() + "\" is left out: it is given backwards");
      spin = Vector3.ZERO;
      slide = Vector3.ZERO;
    }
    Vector3 turning = root.turn().apply(spin);
    Vector3 point = pose.turn().apply(at.childPoint());
    Vector3 speed = root.turn().apply(slide).minus(turning.cross(point));
    Vector3 local = pose.turn().transposed().apply(turning);
    List<Double> q = new ArrayList<>(List.of(pose.at().x(), pose.at().y(), pose.at().z()));
    q.addAll(pose.eulerParameters());
    boolean elsewhere = !pose.equals(zero);
    start(q, List.of(speed.x(), speed.y(), speed.z(), local.x(), local.y(), local.z()), elsewhere);
  }

  private void startBall(Spherical ball, Frame toBody, double[] y) {
    Rotation moved = rotation(Arrays.copyOfRange(y, 0, 4));
    Rotation turn = ball.fileBody2IsParent() ? moved.transposed() : moved;
    Vector3 spin = new Vector3(y[4], y[5], y[6]);
    Vector3 local = ball.fileBody2IsParent() ? spin.negated() : turn.transposed().apply(spin);
    Rotation inBody = toBody.turn().times(turn).times(toBody.turn().transposed());
    Vector3 v = toBody.turn().apply(local);
    start(
        new Frame(Vector3.ZERO, inBody).eulerParameters(),
        List.of(v.x(), v.y(), v.z()),
        !turn.isIdentity());
  }

  private List<TagBuilder> siteTags(int body, Frame root) {
    return sites.getOrDefault(body, List.of()).stream()
        .map(
            site ->
                root.equals(Frame.SAME) ? site : placed(new TagBuilder("frame"), root).add(site))
        .toList();
  }

  /** Adds a site of a body and returns its name. */
  private String site(String wished, int body, Frame frame) {
    sites
        .computeIfAbsent(body, key -> new ArrayList<>())
        .add(placed(new TagBuilder("site").set("name", wished), frame));
    return wished;
  }

  private String point(String wished, BodyPoint point) {
    return site(wished, point.body(), new Frame(point.position(), Rotation.IDENTITY));
  }

  private void closure(LoopClosure closure) {
    if (closure instanceof JointClosure cut && !cut.isDriven()) {
      Attachment at = cut.joint().attachment();
      Rotation back = at.zeroRotation().transposed();
      String name = closure.name();
      if (cut.joint() instanceof Weld) {
        equate("weld", name, at, Vector3.ZERO, back);
        return;
      } else if (cut.joint() instanceof Spherical) {
        equate("connect", name, at, Vector3.ZERO, back);
        return;
      } else if (cut.joint() instanceof Revolute) {
        // Two points of the axis: one of their equations follows from the others.
        Vector3 axis = cut.joint().axes().get(0).times(ARM);
        equate("connect", name + "_1", at, axis, back);
        equate("connect", name + "_2", at, axis.negated(), back);
        return;
      }
    } else if (closure instanceof CoordinateClosure coupling && couple(coupling)) {
      return;
    }
    losses.refuse(
        closure.origin(),
        "\""
            + closure.name()
            + "\" is an equation that MJCF does not have: it has loops of W, S and R, and linear"
            + " couplings of hinges and slides");
  }

  /**
   * @param aside of the joint's point, in the axes of the parent, m
   * @param back from the parent's axes to the child's
   */
  private void equate(String kind, String name, Attachment at, Vector3 aside, Rotation back) {
    String one =
        site(name + "_a", at.parent(), new Frame(at.parentPoint().plus(aside), Rotation.IDENTITY));
    String two =
        site(name + "_b", at.child(), new Frame(at.childPoint().plus(back.apply(aside)), back));
    equations.add(new TagBuilder(kind).set("name", name).set("site1", one).set("site2", two));
  }

  private boolean isPosition(Expression expression) {
    return expression instanceof Expression.CoordinatePosition position
        && position.coordinate() instanceof JointCoordinate of
        && along.containsKey(of);
  }

  private MjcfCoordinate coordinate(Expression position) {
    return Optional.ofNullable(
            along.get((JointCoordinate) ((Expression.CoordinatePosition) position).coordinate()))
        .orElseThrow();
  }

  /** Returns the names of the coordinates of a sum with their factors, in the model's order. */
  private Map<String, Double> terms(LinearRelation relation) {
    Map<String, Double> terms = new LinkedHashMap<>();
    relation.factors().keySet().stream()
        .sorted(
            Comparator.comparing(
                one -> {
                  JointCoordinate of =
                      (JointCoordinate) ((Expression.CoordinatePosition) one).coordinate();
                  return 10L * of.joint() + of.component();
                }))
        .filter(one -> relation.factor(one) != 0)
        .forEach(one -> terms.put(coordinate(one).name(), relation.factor(one)));
    return terms;
  }

  /** Takes a linear coupling: of two coordinates as joints, else as a tendon over them. */
  private boolean couple(CoordinateClosure coupling) {
    Optional<LinearRelation> sum =
        LinearRelation.of(coupling.relation(), mechanism, this::isPosition);
    if (sum.isEmpty() || sum.get().factors().isEmpty()) {
      return false;
    }
    Map<String, Double> terms = terms(sum.get());
    double constant = sum.get().constant();
    List<String> names = new ArrayList<>(terms.keySet());
    if (names.size() == 2) {
      // The coordinate with the factor 1 follows, as the import writes it; else the second.
      int follower = terms.getOrDefault(names.get(0), 0.0) == 1 ? 0 : 1;
      double own = terms.getOrDefault(names.get(follower), 1.0);
      double other = terms.getOrDefault(names.get(1 - follower), 0.0);
      equations.add(
          new TagBuilder("joint")
              .set("name", coupling.name())
              .set("joint1", names.get(follower))
              .set("joint2", names.get(1 - follower))
              .set("polycoef", list(List.of(-constant / own, -other / own, 0.0, 0.0, 0.0))));
    } else {
      equations.add(
          new TagBuilder("tendon")
              .set("name", coupling.name())
              .set("tendon1", tendon(coupling.name(), terms, new TagBuilder("fixed")))
              .set("polycoef", list(List.of(-constant, 1.0, 0.0, 0.0, 0.0))));
    }
    return true;
  }

  private String tendon(String wished, Map<String, Double> terms, TagBuilder tag) {
    String name = wished;
    while (!tendonNames.add(name)) {
      name += "_";
    }
    tag.set("name", name);
    terms.forEach(
        (joint, factor) ->
            tag.add(new TagBuilder("joint").set("joint", joint).set("coef", factor)));
    tendons.add(tag);
    return name;
  }

  private void force(ForceElement force) {
    Optional<MjcfCoordinate> place =
        force
            .jointCoordinate()
            .filter(JointCoordinate.class::isInstance)
            .flatMap(of -> Optional.ofNullable(along.get((JointCoordinate) of)));
    boolean taken =
        (force instanceof JointSpringDamper spring
                && place.isPresent()
                && place.get().take(spring, mechanism, losses))
            || (force instanceof JointFriction friction
                && place.isPresent()
                && place.get().take(friction, mechanism, losses))
            || (force instanceof JointForce motor
                && (place.isPresent() ? motors.take(motor) : damps(motor)))
            || (force instanceof LawForce law && rubs(law))
            || (force instanceof SpringDamper spring && take(spring))
            || (force instanceof CouplingSpringDamper spring && take(spring));
    if (!taken) {
      losses.add(
          force.origin(),
          "force \"" + force.name() + "\" (" + force.kind() + ") is left out: MJCF has none such");
    }
  }

  private Optional<Double> number(Expression expression) {
    return LinearRelation.number(expression, mechanism);
  }

  private boolean take(SpringDamper spring) {
    Optional<TagBuilder> tag =
        spring(
            "spatial",
            spring.stiffness(),
            spring.damping(),
            spring.length0(),
            spring.force0(),
            spring.side());
    if (tag.isEmpty()) {
      return false;
    }
    String name = spring.name();
    while (!tendonNames.add(name)) {
      name += "_";
    }
    tag.get().set("name", name);
    String one = point(name + "_a", spring.point1());
    String two = point(name + "_b", spring.point2());
    tag.get().add(new TagBuilder("site").set("site", one));
    tendons.add(tag.get().add(new TagBuilder("site").set("site", two)));
    return true;
  }

  private boolean take(CouplingSpringDamper spring) {
    Optional<LinearRelation> sum = LinearRelation.of(spring.along(), mechanism, this::isPosition);
    if (sum.isEmpty() || sum.get().factors().isEmpty()) {
      return false;
    }
    Expression rest =
        new Expression.Sum(spring.rest(), new Expression.Constant(-sum.orElseThrow().constant()));
    Optional<TagBuilder> tag =
        spring("fixed", spring.stiffness(), spring.damping(), rest, spring.force0(), spring.side());
    tag.ifPresent(one -> tendon(spring.name(), terms(sum.get()), one));
    return tag.isPresent();
  }

  /** Returns a tendon with a spring; empty if it has none such. */
  private Optional<TagBuilder> spring(
      String kind,
      Expression stiffness,
      Expression damping,
      Expression rest,
      Expression force0,
      Side side) {
    Optional<Double> k = number(stiffness);
    Optional<Double> c = number(damping);
    Optional<Double> at = number(rest);
    Optional<Double> tension = number(force0);
    if (k.isEmpty() || c.isEmpty() || at.isEmpty() || tension.isEmpty()) {
      return Optional.empty();
    }
    boolean both = side == Side.BOTH;
    boolean pulls = tension.get() != 0;
    if ((!both && c.get() != 0) || (pulls && k.get() == 0)) {
      return Optional.empty();
    }
    double length = pulls ? at.get() - tension.get() / k.get() : at.get();
    double least = kind.equals("fixed") ? -FAR : 0;
    String lengths =
        switch (side) {
          // -1 alone would be the length at the start.
          case BOTH -> list(length == -1 ? List.of(length, length) : List.of(length));
          case ABOVE -> list(List.of(least, length));
          case BELOW -> list(List.of(length, FAR));
        };
    TagBuilder tag = new TagBuilder(kind).set("stiffness", k.get());
    return Optional.of(tag.set("damping", c.get()).set("springlength", lengths));
  }

  private void arm(Armature armature) {
    for (int k = 0; k < armature.inertias().size(); k++) {
      MjcfCoordinate coordinate = along.get(new JointCoordinate(armature.joint(), k));
      if (coordinate != null) {
        coordinate.arm(armature.inertias().get(k));
      }
    }
  }

  private void loseTheRest() {
    List<String> lost = new ArrayList<>(motors.unused());
    model.settings().events().forEach(event -> lost.add("event \"" + event.name() + "\""));
    model.outputs().forEach(output -> lost.add("output \"" + output.name() + "\""));
    for (int body : merged) {
      if (!model.solids(mechanism.bodies().get(body).name()).isEmpty()) {
        lost.add("what body \"" + mechanism.bodies().get(body).name() + "\" looks like");
      }
    }
    lost.forEach(what -> losses.add(Origin.NONE, what + " is left out: MJCF has none such"));
  }
}

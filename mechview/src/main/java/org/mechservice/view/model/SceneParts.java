package org.mechservice.view.model;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import org.mechservice.mechml.Look;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.Road;
import org.mechservice.mechml.Route;
import org.mechservice.mechml.Solid;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.KnifeEdgeClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;
import org.mechservice.solver.mechanism.force.Bushing;
import org.mechservice.solver.mechanism.force.Contact;
import org.mechservice.solver.mechanism.force.CouplingSpringDamper;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.ForceTorque;
import org.mechservice.solver.mechanism.force.ForceVisitor;
import org.mechservice.solver.mechanism.force.JointForce;
import org.mechservice.solver.mechanism.force.JointFriction;
import org.mechservice.solver.mechanism.force.JointSpringDamper;
import org.mechservice.solver.mechanism.force.LawForce;
import org.mechservice.solver.mechanism.force.NamedPoint;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.mechanism.force.PathForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneLook;
import org.mechservice.view.scene.SceneRoad;
import org.mechservice.view.scene.SceneRope;
import org.mechservice.view.scene.SceneSolid;

/** Translates the parts of a mechanism in one position to the parts of a scene. */
final class SceneParts {
  private static final Vector3 Z = new Vector3(0, 0, 1);

  private final TreeGeometry tree;
  private final Mechanism mechanism;
  private final TreeMotion motion;
  private final double t;
  private final ShownForces shown = new ShownForces();

  /**
   * Takes a position.
   *
   * @param motion after a sweep to the position; not modified
   * @param t the time of the position, s
   */
  SceneParts(TreeMotion motion, double t) {
    tree = motion.tree();
    mechanism = tree.mechanism();
    this.motion = motion;
    this.t = t;
  }

  static Point3 point(Vector3 v) {
    return new Point3(v.x(), v.y(), v.z());
  }

  private static Anchor anchor(BodyPoint point) {
    return new Anchor(point.body(), point(point.position()));
  }

  BodyPose rootPose() {
    return pose(Mechanism.ROOT);
  }

  /** Returns where a body is. */
  BodyPose pose(int body) {
    double[] rotation = body == Mechanism.ROOT ? tree.rootRotation : motion.worldRotation;
    int link = tree.linkOf(body);
    double[] r = new double[3];
    tree.fromReference(new BodyPoint(body, Vector3.ZERO), r, 0);
    double[] origin = new double[3];
    motion.points.position(link, r, 0, origin, 0);
    return BodyPose.of(
        new Point3(origin[0], origin[1], origin[2]),
        rotation,
        body == Mechanism.ROOT ? 0 : 9 * link);
  }

  List<SceneBody> bodies(Map<String, String> geometries, MechmlModel model) {
    List<SceneBody> bodies = new ArrayList<>();
    for (Body body : mechanism.bodies()) {
      InertiaTensor i = body.inertia();
      bodies.add(
          new SceneBody(
              body.name(),
              pose(bodies.size()),
              body.mass(),
              point(body.centerOfMass()),
              List.of(i.xx(), i.yy(), i.zz(), i.xy(), i.xz(), i.yz()),
              geometries.getOrDefault(body.name(), ""),
              solids(model.solids(body.name())),
              looks(model.looks(body.name()))));
    }
    return bodies;
  }

  /** Translates the solids of a body. */
  static List<SceneSolid> solids(List<Solid> solids) {
    return solids.stream().map(SceneParts::solid).toList();
  }

  /** Translates the looks of a body. */
  static List<SceneLook> looks(List<Look> looks) {
    return looks.stream().map(SceneParts::look).toList();
  }

  private static SceneLook look(Look look) {
    double half = look.angle() / 2;
    Point3 e = point(look.axis()).times(Math.sin(half));
    return new SceneLook(
        solids(look.solids()),
        new BodyPose(point(look.origin()), Math.cos(half), e.x(), e.y(), e.z()),
        look.colour().orElse(SceneLook.NO_COLOUR),
        look.opacity());
  }

  private static SceneSolid solid(Solid solid) {
    if (solid instanceof Solid.Block block) {
      return new SceneSolid.Block(point(block.center()), point(block.edges()));
    } else if (solid instanceof Solid.Ball ball) {
      return new SceneSolid.Ball(point(ball.center()), ball.radius());
    } else if (solid instanceof Solid.Surface surface) {
      return new SceneSolid.Surface(surface.file(), surface.scale(), point(surface.origin()));
    }
    Solid.Round round = (Solid.Round) solid;
    return new SceneSolid.Round(
        point(round.from()), point(round.to()), round.radius(), round.top(), round.inner());
  }

  List<SceneJoint> joints() {
    List<SceneJoint> joints = new ArrayList<>();
    for (Joint joint : mechanism.joints()) {
      joints.add(joint(joint, false, mechanism.isDriven(joints.size())));
    }
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof JointClosure cut) {
        joints.add(joint(cut.joint(), true, !cut.motion().isEmpty()));
      }
    }
    return joints;
  }

  static SceneJoint joint(Joint joint, boolean cut, boolean driven) {
    Attachment at = joint.attachment();
    List<Vector3> axes = parentAxisFirst(joint);
    return new SceneJoint(
        joint.name(),
        joint.type(),
        cut,
        driven,
        new Anchor(at.parent(), point(at.parentPoint())),
        new Anchor(at.child(), point(at.childPoint())),
        point(axes.isEmpty() ? Vector3.ZERO : axes.get(0)),
        point(axes.size() < 2 ? Vector3.ZERO : axes.get(1)));
  }

  /** The axis fixed in the parent, in its axes, then that of the child, if there is one. */
  private static List<Vector3> parentAxisFirst(Joint joint) {
    List<Vector3> axes = joint.axes();
    if (!joint.fileBody2IsParent() || axes.isEmpty()) {
      return axes;
    }
    return axes.size() == 2
        ? List.of(axes.get(1), axes.get(0))
        : List.of(joint.attachment().zeroRotation().apply(axes.get(0)));
  }

  List<SceneConstraint> constraints() {
    List<SceneConstraint> constraints = new ArrayList<>();
    for (LoopClosure closure : mechanism.closures()) {
      if (closure instanceof DistanceClosure one) {
        SceneConstraint.Kind kind =
            one.hasRod() ? SceneConstraint.Kind.ROD : SceneConstraint.Kind.DISTANCE;
        constraints.add(constraint(one.name(), kind, one.point1(), one.point2(), Vector3.ZERO));
      } else if (closure instanceof PointOnLineClosure one) {
        SceneConstraint.Kind kind = SceneConstraint.Kind.POINT_ON_LINE;
        constraints.add(constraint(one.name(), kind, one.point(), one.line(), one.direction()));
      } else if (closure instanceof PointOnPlaneClosure one) {
        SceneConstraint.Kind kind = SceneConstraint.Kind.POINT_ON_PLANE;
        constraints.add(constraint(one.name(), kind, one.point(), one.plane(), one.normal()));
      } else if (closure instanceof RollingClosure one) {
        constraints.add(
            new SceneConstraint(
                one.name(),
                SceneConstraint.Kind.ROLLING,
                List.of(anchor(one.centre()), anchor(one.plane())),
                point(one.normal()),
                Optional.of(new SceneConstraint.Wheel(point(one.axle()), one.size())),
                List.of()));
      } else if (closure instanceof KnifeEdgeClosure one) {
        SceneConstraint.Kind kind = SceneConstraint.Kind.KNIFE_EDGE;
        constraints.add(constraint(one.name(), kind, one.point(), one.ground(), one.side()));
      } else if (closure instanceof CoordinateClosure one) {
        constraints.add(
            new SceneConstraint(
                one.name(),
                SceneConstraint.Kind.COUPLING,
                one.points().stream().map(SceneParts::anchor).toList(),
                Point3.ZERO,
                Optional.empty(),
                coupled(one.relation())));
      }
    }
    return constraints;
  }

  private static SceneConstraint constraint(
      String name,
      SceneConstraint.Kind kind,
      BodyPoint first,
      BodyPoint second,
      Vector3 direction) {
    return new SceneConstraint(
        name,
        kind,
        List.of(anchor(first), anchor(second)),
        point(direction),
        Optional.empty(),
        List.of());
  }

  /** Returns the names of the joints whose coordinates an expression contains. */
  private List<String> coupled(Expression relation) {
    return new Tape(List.of(relation))
        .leaves().stream()
            .filter(Expression.CoordinatePosition.class::isInstance)
            .map(leaf -> ((Expression.CoordinatePosition) leaf).coordinate())
            .map(coordinate -> mechanism.jointOf(coordinate).name())
            .distinct()
            .toList();
  }

  List<SceneForce> forces() {
    List<SceneForce> forces = new ArrayList<>();
    for (ForceElement force : mechanism.forces()) {
      forces.add(force.accept(shown));
    }
    return forces;
  }

  /** Returns the ropes, cables and muscles. */
  List<SceneRope> ropes(Map<String, Route> routes) {
    List<SceneRope> ropes = new ArrayList<>();
    new TreeMap<>(routes)
        .forEach(
            (name, route) ->
                ropes.add(
                    new SceneRope(
                        name,
                        route.muscle(),
                        route.stops().stream().map(this::stop).toList(),
                        route
                            .plane()
                            .map(SceneParts::frame)
                            .orElse(new SceneRope.Frame(Anchor.ROOT, BodyPose.WORLD)))));
    return ropes;
  }

  private SceneRope.Stop stop(Route.Stop stop) {
    if (stop instanceof Route.Eye eye) {
      return new SceneRope.Eye(anchor(eye.at()));
    } else if (stop instanceof Route.Pulley one) {
      return new SceneRope.Pulley(
          anchor(one.centre()), value(one.radius()), one.left(), one.held());
    } else if (stop instanceof Route.Around one) {
      return new SceneRope.Around(
          anchor(one.centre()),
          point(one.axis().orElse(Vector3.ZERO)),
          value(one.radius()),
          one.side().stream().map(SceneParts::anchor).toList(),
          one.inside());
    }
    return new SceneRope.Branch();
  }

  private static SceneRope.Frame frame(BodyFrame frame) {
    return new SceneRope.Frame(frame.body(), pose(frame));
  }

  private static BodyPose pose(BodyFrame frame) {
    Rotation axes = frame.axes();
    double[] rows = {
      axes.xx(), axes.xy(), axes.xz(), axes.yx(), axes.yy(), axes.yz(), axes.zx(), axes.zy(),
      axes.zz()
    };
    return BodyPose.of(point(frame.position()), rows, 0);
  }

  /** Returns the surfaces whose height changes; contacts on one surface share it. */
  List<SceneRoad> roads(Map<String, Road> roads) {
    Map<Road, List<SceneForce>> shared = new LinkedHashMap<>();
    for (SceneForce force : forces()) {
      Road road = roads.get(force.name());
      if (road != null) {
        shared.computeIfAbsent(road, key -> new ArrayList<>()).add(force);
      }
    }
    List<SceneRoad> all = new ArrayList<>();
    shared.forEach(
        (road, forces) ->
            all.add(
                new SceneRoad(
                    forces.get(0).name(),
                    road.frame().body(),
                    pose(road.frame()),
                    x -> value(road.height(), x),
                    forces.stream().map(force -> force.anchors().get(0)).toList(),
                    forces.stream().mapToDouble(SceneForce::radius).max().orElse(0))));
    return all;
  }

  private static SceneForce between(String name, SceneForce.Kind kind, List<BodyPoint> points) {
    Function<BodyPoint, Anchor> anchor = SceneParts::anchor;
    return new SceneForce(
        name, kind, points.stream().map(anchor).toList(), Point3.ZERO, false, 0, "");
  }

  private SceneForce inJoint(String name, SceneForce.Kind kind, Coordinate coordinate) {
    Joint joint = mechanism.jointOf(coordinate);
    SceneJoint shown = joint(joint, false, false);
    return new SceneForce(
        name, kind, List.of(shown.first(), shown.second()), Point3.ZERO, false, 0, joint.name());
  }

  /** Returns a force as an arrow along it, or a moment if there is no force. */
  private SceneForce wrench(ForceTorque wrench) {
    List<Expression> all = wrench.components();
    boolean pushes = !all.subList(0, 3).stream().allMatch(SceneParts::isZero);
    List<Expression> shown = all.subList(pushes ? 0 : 3, pushes ? 3 : 6);
    Point3 direction = direction(shown);
    boolean inBody = wrench.axes() == ForceTorque.Axes.BODY;
    return new SceneForce(
        wrench.name(),
        pushes ? SceneForce.Kind.FORCE : SceneForce.Kind.MOMENT,
        List.of(anchor(wrench.point())),
        inBody ? pose(wrench.point().body()).turn(direction) : direction,
        inBody,
        0,
        "");
  }

  /** Returns the direction at the start; of a vector that is zero then, the one it can take. */
  private Point3 direction(List<Expression> components) {
    double[] v = new double[3];
    double[] possible = new double[3];
    for (int i = 0; i < 3; i++) {
      v[i] = value(components.get(i));
      possible[i] = isZero(components.get(i)) ? 0 : 1;
    }
    Point3 atStart = new Point3(v[0], v[1], v[2]);
    double size = atStart.norm();
    if (size > 0 && Double.isFinite(size)) {
      return atStart.times(1 / size);
    }
    Point3 allowed = new Point3(possible[0], possible[1], possible[2]);
    return allowed.norm() == 0 ? Point3.ZERO : allowed.times(1 / allowed.norm());
  }

  private static boolean isZero(Expression expression) {
    return expression instanceof Expression.Constant constant && constant.value() == 0;
  }

  /** Returns the value at the start, with 0 for whatever depends on the state. */
  private double value(Expression expression) {
    return value(expression, 0);
  }

  /** Returns the same of a function of an argument. */
  private double value(Expression expression, double argument) {
    FormulaEvaluation evaluation = new FormulaEvaluation(List.of(expression));
    for (int leaf = 0; leaf < evaluation.leaves().size(); leaf++) {
      Expression kind = evaluation.leaves().get(leaf);
      if (kind instanceof Expression.Time) {
        evaluation.setLeaf(leaf, t);
      } else if (kind instanceof Expression.Argument) {
        evaluation.setLeaf(leaf, argument);
      } else if (kind instanceof Expression.ParameterValue parameter) {
        evaluation.setLeaf(leaf, mechanism.parameters().get(parameter.index()).value());
      }
    }
    evaluation.values();
    return evaluation.value(0);
  }

  /** Each kind of force as it is drawn. */
  private final class ShownForces implements ForceVisitor<SceneForce> {
    @Override
    public SceneForce springDamper(SpringDamper one) {
      boolean stiff = !isZero(one.stiffness());
      boolean damped = !isZero(one.damping());
      SceneForce.Kind kind =
          stiff && damped
              ? SceneForce.Kind.SPRING_DAMPER
              : damped ? SceneForce.Kind.DAMPER : SceneForce.Kind.SPRING;
      return between(one.name(), kind, List.of(one.point1(), one.point2()));
    }

    @Override
    public SceneForce bushing(Bushing one) {
      return between(
          one.name(),
          SceneForce.Kind.BUSHING,
          List.of(one.frame1().origin(), one.frame2().origin()));
    }

    @Override
    public SceneForce forceTorque(ForceTorque one) {
      return wrench(one);
    }

    @Override
    public SceneForce couplingSpringDamper(CouplingSpringDamper one) {
      boolean rope = !one.points().isEmpty();
      List<Anchor> anchors =
          rope
              ? one.points().stream().map(SceneParts::anchor).toList()
              : joints().stream()
                  .filter(joint -> coupled(one.along()).contains(joint.name()))
                  .map(SceneJoint::second)
                  .toList();
      return new SceneForce(
          one.name(),
          rope ? SceneForce.Kind.ROPE : SceneForce.Kind.COUPLING,
          anchors,
          Point3.ZERO,
          false,
          0,
          "");
    }

    @Override
    public SceneForce pathForce(PathForce one) {
      return new SceneForce(
          one.name(),
          SceneForce.Kind.ROPE,
          one.points().stream().map(SceneParts::anchor).toList(),
          Point3.ZERO,
          false,
          0,
          "");
    }

    @Override
    public SceneForce contact(Contact one) {
      int surface = one.surface().body();
      return new SceneForce(
          one.name(),
          SceneForce.Kind.CONTACT,
          List.of(anchor(one.center()), anchor(one.surface().origin())),
          pose(surface).turn(point(one.surface().axes().apply(Z))),
          false,
          value(one.radius()),
          "");
    }

    @Override
    public SceneForce pairForce(PairForce one) {
      // A sphere touches a shape about frame 1; a disc, a box or a wheel touches its plane.
      PairForce.Shape shape = one.shape();
      boolean disc = shape instanceof PairForce.Disc;
      double radius = radius(shape);
      boolean onPlane = disc || radius == 0;
      Point3 normal = point(one.frame1().axes().apply(Z));
      return new SceneForce(
          one.name(),
          SceneForce.Kind.CONTACT,
          List.of(anchor(one.frame2().origin()), anchor(one.frame1().origin())),
          onPlane ? pose(one.frame1().body()).turn(normal) : Point3.ZERO,
          false,
          radius,
          "",
          disc ? point(one.frame2().axes().apply(Z)) : Point3.ZERO,
          box(one));
    }

    private static double radius(PairForce.Shape shape) {
      if (shape instanceof PairForce.Sphere sphere) {
        return sphere.radius();
      }
      return shape instanceof PairForce.Disc disc ? disc.radius() : 0;
    }

    /** Returns the box that touches; none if its edges are inputs of the model. */
    private static Optional<SceneForce.Box> box(PairForce one) {
      return one.shape() instanceof PairForce.Box box
              && box.edges().x() * box.edges().y() * box.edges().z() > 0
          ? Optional.of(new SceneForce.Box(SceneParts.pose(one.frame2()), point(box.edges())))
          : Optional.empty();
    }

    @Override
    public SceneForce lawForce(LawForce one) {
      return between(
          one.name(), SceneForce.Kind.USER, List.of(one.frame1().origin(), one.frame2().origin()));
    }

    @Override
    public SceneForce jointSpringDamper(JointSpringDamper one) {
      return inJoint(one.name(), SceneForce.Kind.JOINT_SPRING, one.coordinate());
    }

    @Override
    public SceneForce jointForce(JointForce one) {
      return inJoint(one.name(), SceneForce.Kind.JOINT_FORCE, one.coordinate());
    }

    @Override
    public SceneForce jointFriction(JointFriction one) {
      return inJoint(one.name(), SceneForce.Kind.JOINT_FRICTION, one.coordinate());
    }

    @Override
    public SceneForce userForce(UserForceElement one) {
      return between(
          one.name(), SceneForce.Kind.USER, one.points().stream().map(NamedPoint::point).toList());
    }
  }
}

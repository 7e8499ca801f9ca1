package org.mechservice.report;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.mechservice.report.method.Candidate;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.solution.Reference;
import org.mechservice.report.solution.ReferenceMaker;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ModelEvents.Action;
import org.mechservice.solver.api.capability.ModelEvents.Direction;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.Call;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.Product;
import org.mechservice.solver.expression.Expression.Sum;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.FurtherChange;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.PrescribedMotion;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.Sampling;
import org.mechservice.solver.mechanism.StateChange;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.StartRole;
import org.mechservice.solver.simulation.RuntimeSolver;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/**
 * Scenes whose state jumps and whose motion is known in closed form: a ball of 1 kg that drops from
 * 10 m and keeps 0.8 of its speed at each bounce; a bar of 1 m that hangs, without gravity, from a
 * cart whose velocity turns round at 0.5 s.
 */
final class EventScenes {
  static final double GRAVITY = 9.81;
  static final double HEIGHT = 10;
  static final double RESTITUTION = 0.8;
  private static final Vector3 X = new Vector3(1, 0, 0);
  private static final Vector3 Y = new Vector3(0, 1, 0);
  private static final Vector3 Z = new Vector3(0, 0, 1);

  private EventScenes() {}

  static Event bounce() {
    return bounce(RESTITUTION, 0);
  }

  /** A bounce that keeps another part of the speed, or takes place at another height. */
  static Event bounce(double restitution, double height) {
    Expression reflected = new Product(Expression.of(-restitution), velocity());
    return new Event(
        "bounce",
        new Sum(position(), Expression.of(-height)),
        Direction.FALLING,
        Action.SET,
        List.of(new StateChange(0, List.of(), List.of(reflected))),
        Origin.NONE);
  }

  /** What happens when the ball passes a height. */
  static Event passing(double height, Action action) {
    Expression above = new Sum(position(), Expression.of(-height));
    return new Event("passing", above, Direction.BOTH, action, List.of(), Origin.NONE);
  }

  private static Expression position() {
    return new CoordinatePosition(new JointCoordinate(0, 0));
  }

  private static Expression velocity() {
    return new CoordinateVelocity(new JointCoordinate(0, 0));
  }

  static Mechanism ball(Event... events) {
    Body mass = new Body("ball", 1, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE);
    Joint slide = new Prismatic("height", on(-1, 0), Z, HEIGHT, 0, Origin.NONE);
    return mechanism(Z.times(-GRAVITY), List.of(mass), List.of(slide), List.of())
        .withEvents(List.of(events));
  }

  /** A ball whose height a sampled state takes at the start, and not again before the end. */
  static Mechanism sampledBall() {
    FurtherState seen = FurtherState.held("seen", -1, "m", FurtherState.Role.SAMPLED, Origin.NONE);
    return ball()
        .withFurtherStates(List.of(seen))
        .withSamplings(
            List.of(
                new Sampling(
                    "seen", 100, 0, List.of(new FurtherChange(0, position())), Origin.NONE)));
  }

  static Mechanism cartAndBar() {
    Expression late = new Sum(new Time(), Expression.of(-0.5));
    InertiaTensor thin = new InertiaTensor(1.0 / 12, 1.0 / 12, 0, 0, 0, 0);
    return mechanism(
        Vector3.ZERO,
        List.of(
            new Body("cart", 2, Vector3.ZERO, InertiaTensor.ZERO, Origin.NONE),
            new Body("bar", 1, Z.times(-0.5), thin, Origin.NONE)),
        List.of(
            new Prismatic("drive", on(-1, 0), X, 0, 0, Origin.NONE),
            new Revolute("hinge", on(0, 1), Y, 0, 0, Origin.NONE)),
        List.of(new PrescribedMotion(0, List.of(new Call(MathFunction.ABS, List.of(late))))));
  }

  private static Attachment on(int parent, int child) {
    return new Attachment(parent, Vector3.ZERO, child, Vector3.ZERO, Rotation.IDENTITY);
  }

  private static Mechanism mechanism(
      Vector3 gravity, List<Body> bodies, List<Joint> joints, List<PrescribedMotion> motions) {
    return new Mechanism(
        "Scene",
        new Root("ground", Vector3.ZERO, Rotation.IDENTITY),
        gravity,
        bodies,
        joints,
        motions,
        Collections.nCopies(joints.size(), StartRole.PREFERRED),
        List.of(),
        List.of(),
        List.of());
  }

  static Model model(Mechanism mechanism, String formulation, double end) {
    RunSettings settings = new RunSettings(0, end, 0.1, "ode113", 1e-6, 1e-8);
    return DataDriven.model(
        new CompactModel(mechanism, formulation, "none", settings), UserForceSource.NONE);
  }

  static Candidate candidate(
      Mechanism mechanism, String formulation, String integrator, double end) {
    return new Candidate(
        new SimulationMethod(formulation, MethodNames.NONE, integrator),
        () -> model(mechanism, formulation, end),
        new RuntimeSolver());
  }

  /** All methods that fit an open chain. */
  static List<Candidate> candidates(Mechanism mechanism, double end) {
    List<Candidate> all = new ArrayList<>();
    for (String formulation : List.of("DTR", "DSR")) {
      for (String integrator : List.of("ode113", "DE", "ode15s", "ode15sR")) {
        all.add(candidate(mechanism, formulation, integrator, end));
      }
    }
    all.add(candidate(mechanism, "RR", "ode15sR", end));
    all.add(candidate(mechanism, "RR-JF", "ode15sR", end));
    return all;
  }

  /** Two formulations. */
  static List<ReferenceMaker.Source> sources(Mechanism mechanism, double end) {
    return List.of(
        new ReferenceMaker.Source("DTR", candidate(mechanism, "DTR", "ode113", end)::problem),
        new ReferenceMaker.Source("DSR", candidate(mechanism, "DSR", "ode113", end)::problem));
  }

  /** Height and velocity of the ball. */
  static double[] ballAt(double t) {
    double since = t;
    double height = HEIGHT;
    double speed = 0;
    double fall = Math.sqrt(2 * HEIGHT / GRAVITY);
    while (since > fall) {
      since -= fall;
      speed = RESTITUTION * (GRAVITY * fall - speed);
      height = 0;
      fall = 2 * speed / GRAVITY;
    }
    return new double[] {
      height + speed * since - GRAVITY * since * since / 2, speed - GRAVITY * since
    };
  }

  /** Angle of the bar and its rate: 3/2 of the jump over its length, about minus y. */
  static double[] barAt(double t) {
    return t < 0.5 ? new double[2] : new double[] {3 * (t - 0.5), 3};
  }

  /** The same times with states of a closed form. */
  static Reference exact(Reference made, java.util.function.DoubleFunction<double[]> form) {
    double[][] states =
        java.util.Arrays.stream(made.times()).mapToObj(form).toArray(double[][]::new);
    return new Reference(
        made.times(),
        states,
        made.floor(),
        made.rounding(),
        made.amplification(),
        made.jumps(),
        List.of());
  }
}

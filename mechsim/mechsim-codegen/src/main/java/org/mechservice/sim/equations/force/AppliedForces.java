package org.mechservice.sim.equations.force;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.mechservice.sim.equations.coordinates.ClosestPointSearch;
import org.mechservice.sim.equations.coordinates.ClosestPointSearch.Curve;
import org.mechservice.sim.equations.coordinates.CutCoordinateTerms;
import org.mechservice.sim.equations.coordinates.JointCoordinates;
import org.mechservice.sim.equations.coordinates.JointLinks;
import org.mechservice.sim.equations.coordinates.PairMotion;
import org.mechservice.sim.equations.coordinates.Relation;
import org.mechservice.sim.equations.coordinates.RelativeFrameMotion;
import org.mechservice.sim.equations.coordinates.StateFormulas;
import org.mechservice.sim.equations.kinematics.BodyPoints;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.scene.ForceReach;
import org.mechservice.solver.api.capability.DirectedForces;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.PathMotion;
import org.mechservice.solver.force.law.ClosestFoot;
import org.mechservice.solver.force.law.ContactLoad;
import org.mechservice.solver.force.law.CoordinateLaw;
import org.mechservice.solver.force.law.CoordinateLoad;
import org.mechservice.solver.force.law.PairLoad;
import org.mechservice.solver.force.law.SpringLaw;
import org.mechservice.solver.links.Labels;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.FurtherState;
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
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.mechanism.force.PathForce;
import org.mechservice.solver.mechanism.force.SpringDamper;
import org.mechservice.solver.mechanism.force.UserForceElement;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;
import org.mechservice.solver.symbol.Substitution;

/** The forces of a mechanism as equations of one program, each in its own section. */
public final class AppliedForces {
  private final Program program;
  private final Expressions expressions;
  private final Links mechanism;
  private final BodyPoints points;
  private final JointLinks links;
  private final CutCoordinateTerms cuts;
  private final JointCoordinates joints;
  private final boolean placed;
  private final LinkKinematics kinematics;
  private final StateFormulas formulas;
  private final Terms terms = new Terms();

  public AppliedForces(Program program, Links mechanism, Coordinates coordinates) {
    this.program = program;
    this.expressions = program.expressions();
    this.mechanism = mechanism;
    this.points = new BodyPoints(expressions, mechanism);
    this.links = new JointLinks(expressions, mechanism, coordinates);
    this.placed = ForceReach.of(mechanism.mechanism()).areShared();
    this.kinematics = new LinkKinematics(program, mechanism, coordinates, placed);
    this.cuts = new CutCoordinateTerms(expressions, mechanism, points, kinematics);
    this.joints = new JointCoordinates(mechanism.mechanism(), links, cuts);
    int firstState = mechanism.positionCount() + mechanism.velocityCount();
    this.formulas = new StateFormulas(expressions, joints, points, kinematics, firstState);
    List<FurtherState> states = mechanism.mechanism().furtherStates();
    for (int i = 0; i < states.size(); i++) {
      program.named(
          "s_" + Labels.sanitized(states.get(i).name()), expressions.input(firstState + i));
    }
  }

  /** Returns the positions and velocities of the links. */
  public LinkKinematics kinematics() {
    return kinematics;
  }

  /**
   * Derives the forces in file order, with their wrenches and joint forces.
   *
   * @param checked whether the program ends if a force has no direction
   */
  public Loads loads(boolean checked) {
    placeFrames();
    Loads loads = new Loads(expressions, mechanism);
    List<ForceElement> elements = mechanism.mechanism().forces();
    for (int i = 0; i < elements.size(); i++) {
      if (elements.get(i) instanceof UserForceElement) {
        continue;
      }
      section(elements.get(i));
      ForceTerm term = term(elements.get(i));
      term.apply(loads);
      if (checked) {
        guard(i, term);
      }
    }
    if (elements.stream().anyMatch(UserForceElement.class::isInstance)) {
      program.section("Forces written as classes, already evaluated.", "given");
      new UserForceInputs(expressions, mechanism, points, links).apply(loads);
    }
    return loads;
  }

  /** Computes the places that forces share in sections of their own, before those of the forces. */
  private void placeFrames() {
    if (!placed) {
      return;
    }
    for (ForceElement element : written()) {
      List<Integer> on = element.bodies().stream().map(points::link).toList();
      for (int i = 0; i < on.size(); i++) {
        int other = on.size() == 1 ? Links.ROOT : on.get(i == 0 ? 1 : i - 1);
        kinematics.place(kinematics.commonAncestor(on.get(i), other), on.get(i));
      }
    }
  }

  /** Returns the forces with equations; loads of user force classes are inputs. */
  private List<ForceElement> written() {
    return mechanism.mechanism().forces().stream()
        .filter(element -> !(element instanceof UserForceElement))
        .toList();
  }

  private void guard(int force, ForceTerm term) {
    term.direction()
        .ifPresent(
            direction ->
                program.guard(
                    new Program.Guard(
                        direction.size(),
                        expressions.constant(direction.least()),
                        DirectedForces.result(force),
                        "the force has no direction")));
  }

  /** Returns the potential energy of all forces, J. */
  public Scalar potential() {
    placeFrames();
    Scalar sum = expressions.zero();
    for (ForceElement element : written()) {
      section(element);
      sum = sum.plus(term(element).potential());
    }
    return sum;
  }

  /** Returns the power of the non-conservative part of each force, in file order, W. */
  public List<Scalar> powers() {
    placeFrames();
    List<Scalar> powers = new ArrayList<>();
    for (ForceElement element : written()) {
      section(element);
      powers.add(term(element).power());
    }
    return powers;
  }

  /** Returns the output values of all forces, in file order. */
  public List<Scalar> values() {
    placeFrames();
    List<Scalar> values = new ArrayList<>();
    for (ForceElement element : written()) {
      section(element);
      values.addAll(term(element).values());
    }
    return values;
  }

  /** Returns expressions of time, parameters and the state as scalars. */
  public List<Scalar> scalars(List<Expression> expressions) {
    program.section("Formulas.", "formulas");
    return expressions.stream().map(formulas::scalar).toList();
  }

  /** Returns the derivatives of the further states, s' = f(t, q, v, s). */
  public List<Scalar> furtherRates() {
    List<FurtherState> states = mechanism.mechanism().furtherStates();
    if (states.isEmpty()) {
      return List.of();
    }
    program.section("Further states: s' = f(t, q, v, s).", "states");
    return states.stream().map(state -> formulas.scalar(state.derivative())).toList();
  }

  private void section(ForceElement element) {
    program.section(
        "Force " + element.name() + " (" + element.getClass().getSimpleName() + ").",
        "f_" + Labels.sanitized(element.name()));
  }

  private ForceTerm term(ForceElement element) {
    return element.accept(terms);
  }

  /** The equations of each kind of force. */
  private final class Terms implements ForceVisitor<ForceTerm> {
    /** Returns the coefficients of a force. */
    private List<Scalar> coefficients(ForceElement force) {
      return force.coefficients().stream().map(one -> formulas.scalar(one.value())).toList();
    }

    @Override
    public ForceTerm springDamper(SpringDamper s) {
      PairMotion pair = new PairMotion(kinematics, points, s.point1(), s.point2());
      return new SpringTerm(s.name(), pair, SpringLaw.of(s.side(), coefficients(s)));
    }

    @Override
    public ForceTerm jointForce(JointForce f) {
      Scalar size = formulas.scalar(f.force());
      Scalar power = size.times(joints.velocity(f.coordinate()));
      CoordinateLoad load = new CoordinateLoad(size, expressions.zero(), power);
      return new CoordinateTerm(joints, f.coordinate(), load);
    }

    @Override
    public ForceTerm couplingSpringDamper(CouplingSpringDamper s) {
      List<Scalar> coefficients = coefficients(s);
      Relation relation = new Relation(expressions, links, cuts, s.along());
      Scalar rate = relation.rate();
      CoordinateLaw law = CoordinateLaw.of(s.side());
      return new CouplingTerm(relation, rate, law.of(relation.value(), rate, coefficients));
    }

    @Override
    public ForceTerm pathForce(PathForce f) {
      Relation relation = new Relation(expressions, links, cuts, f.along());
      Scalar rate = relation.rate();
      Scalar tension =
          new Substitution(
                  expressions,
                  Map.of(
                      formulas.pathMotion(PathMotion.LENGTH),
                      relation.value(),
                      formulas.pathMotion(PathMotion.RATE),
                      rate))
              .of(formulas.scalar(f.tension()));
      Scalar force = tension.negated();
      return new CouplingTerm(
          relation, rate, new CoordinateLoad(force, expressions.zero(), force.times(rate)));
    }

    @Override
    public ForceTerm pairForce(PairForce f) {
      return new PairForceTerm(
          new RelativeFrameMotion(kinematics, points, f.frame1(), f.frame2()), formulas, f);
    }

    @Override
    public ForceTerm lawForce(LawForce f) {
      RelativeFrameMotion frames =
          new RelativeFrameMotion(kinematics, points, f.frame1(), f.frame2());
      return new PairTerm(frames, List.of(f.law().of(frames, coefficients(f))));
    }

    @Override
    public ForceTerm userForce(UserForceElement f) {
      throw new IllegalArgumentException("the loads of force " + f.name() + " are inputs");
    }

    /**
     * Returns the term of a joint's spring, whose component is an index among positions; that of
     * its force is one among velocities.
     */
    @Override
    public ForceTerm jointSpringDamper(JointSpringDamper s) {
      Coordinate position = s.coordinate();
      Coordinate velocity = joints.velocityOf(position);
      List<Scalar> coefficients = coefficients(s);
      Scalar q = joints.position(position);
      Scalar v = joints.velocity(velocity);
      CoordinateLaw law = CoordinateLaw.of(s.side());
      return new CoordinateTerm(joints, velocity, law.of(q, v, coefficients));
    }

    @Override
    public ForceTerm jointFriction(JointFriction f) {
      Coordinate coordinate = f.coordinate();
      Scalar v = joints.velocity(coordinate);
      CoordinateLoad load = CoordinateLaw.FRICTION.of(expressions.zero(), v, coefficients(f));
      return new CoordinateTerm(joints, coordinate, load);
    }

    @Override
    public ForceTerm forceTorque(ForceTorque f) {
      List<Scalar> c = new ArrayList<>();
      f.components().forEach(component -> c.add(formulas.scalar(component)));
      int link = points.link(f.point().body());
      ScalarVector force = new ScalarVector(c.get(0), c.get(1), c.get(2));
      ScalarVector torque = new ScalarVector(c.get(3), c.get(4), c.get(5));
      boolean inWorld = f.axes() == ForceTorque.Axes.WORLD;
      return new ExternalForceTerm(
          kinematics,
          link,
          points.inLink(f.point()),
          inWorld ? kinematics.fromWorld(link, force) : fromBody(f.point(), force),
          inWorld ? kinematics.fromWorld(link, torque) : fromBody(f.point(), torque),
          c);
    }

    private ScalarVector fromBody(BodyPoint point, ScalarVector v) {
      return points.axes(point.body(), Rotation.IDENTITY).times(v);
    }

    @Override
    public ForceTerm contact(Contact f) {
      BodyFrame sphere = new BodyFrame(f.center().body(), f.center().position(), Rotation.IDENTITY);
      RelativeFrameMotion frames = new RelativeFrameMotion(kinematics, points, f.surface(), sphere);
      boolean ofCentre = !f.tracks().isEmpty();
      List<Expression> curves = ofCentre ? f.tracks() : List.of(f.height());
      ContactLoad.Coefficients coefficients = ContactLoad.Coefficients.of(coefficients(f));
      List<PairLoad> touches = new ArrayList<>();
      for (Expression height : curves) {
        Curve curve = Curve.of(expressions, height);
        ScalarVector place = frames.displacement();
        ClosestFoot foot = ClosestPointSearch.foot(curve, place.x(), place.z(), ofCentre);
        touches.add(new ContactLoad(frames, coefficients, foot));
      }
      return new PairTerm(frames, touches);
    }

    @Override
    public ForceTerm bushing(Bushing f) {
      RelativeFrameMotion frames =
          new RelativeFrameMotion(kinematics, points, f.frame1(), f.frame2());
      return new PairTerm(frames, List.of(f.pairLaw().of(frames, coefficients(f))));
    }
  }
}

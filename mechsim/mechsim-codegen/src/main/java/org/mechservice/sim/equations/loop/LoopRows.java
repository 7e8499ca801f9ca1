package org.mechservice.sim.equations.loop;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import org.mechservice.sim.equations.coordinates.CutCoordinateTerms;
import org.mechservice.sim.equations.coordinates.JointLinks;
import org.mechservice.sim.equations.coordinates.PairTerm;
import org.mechservice.sim.equations.coordinates.PairTerms;
import org.mechservice.sim.equations.coordinates.Relation;
import org.mechservice.sim.equations.coordinates.RelativeFrameMotion;
import org.mechservice.sim.equations.kinematics.BodyPoints;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.sim.equations.kinematics.TimeFunctions;
import org.mechservice.sim.equations.recursion.ForceSweep;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PairFunction;
import org.mechservice.solver.kinematics.pair.RollingShape;
import org.mechservice.solver.links.Labels;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.DistanceClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.KnifeEdgeClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.closure.PointOnLineClosure;
import org.mechservice.solver.mechanism.closure.PointOnPlaneClosure;
import org.mechservice.solver.mechanism.closure.RollingClosure;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The equations of the loops of a mechanism, Φ = 0, with J and γ, in the order of {@link
 * LoopEquations} (docs/theory/loops.md#cutting).
 */
public final class LoopRows {
  private final Program program;
  private final Expressions expressions;
  private final Links mechanism;
  private final Coordinates coordinates;
  private final LinkKinematics kinematics;
  private final BodyPoints points;
  private final VelocityRows rows;
  private final Optional<ForceSweep> sweep;
  private final TreeGeometry tree;

  /**
   * @param sweep accelerations of the links with zero joint accelerations, if γ is requested
   */
  public LoopRows(
      Program program,
      Links mechanism,
      Coordinates coordinates,
      LinkKinematics kinematics,
      VelocityRows rows,
      Optional<ForceSweep> sweep) {
    this.program = program;
    this.expressions = program.expressions();
    this.mechanism = mechanism;
    this.coordinates = coordinates;
    this.kinematics = kinematics;
    this.points = new BodyPoints(expressions, mechanism);
    this.rows = rows;
    this.sweep = sweep;
    this.tree = new TreeGeometry(mechanism.mechanism());
  }

  /** Receives an equation. */
  interface Taker {
    void take(int row, LoopRow equation);
  }

  /** Derives the equations, a section for each closure. */
  void each(Taker taker) {
    int row = 0;
    for (LoopClosure closure : mechanism.mechanism().closures()) {
      program.section(
          "Loop: " + closure.name() + ".\nPhi, J by the forces that would keep it, Phi' = J v",
          Labels.sanitized(closure.name()));
      for (LoopRow equation : equations(closure)) {
        taker.take(row++, equation);
      }
    }
  }

  /**
   * Adds the forces Jᵀ λ, a section for each closure.
   *
   * @param multiplier λ of each equation
   */
  public void addForces(IntFunction<Scalar> multiplier, Loads loads) {
    int row = 0;
    for (LoopClosure closure : mechanism.mechanism().closures()) {
      program.section(
          "Forces of loop: " + closure.name() + ".", Labels.sanitized(closure.name()) + "_force");
      if (closure instanceof CoordinateClosure relation) {
        relation(relation).addForce(multiplier.apply(row++), loads);
        continue;
      }
      Pair pair = pair(closure);
      RelativeFrameMotion frames = pair.frames();
      ScalarVector force = ScalarVector.zero(expressions);
      ScalarVector moment = force;
      for (PairTerm term : pair.terms(frames)) {
        Scalar lambda = multiplier.apply(row++);
        force = force.plus(term.byShift().times(lambda));
        moment = moment.plus(term.byTurn().times(lambda));
      }
      frames.addWrench(force, moment, loads);
    }
  }

  /**
   * An equation between two bodies.
   *
   * @param row with an empty row of J, and with Φ_t instead of Φ'
   * @param frames motion of the second body relative to the first
   * @param byShift gradient by displacements of the second body, in the axes of its frame 1
   * @param byTurn gradient by rotations
   * @param loads wrenches of a unit multiplier
   */
  record Between(
      LoopRow row,
      RelativeFrameMotion frames,
      ScalarVector byShift,
      ScalarVector byTurn,
      Loads loads) {
    /** Returns the link or root at which the ways of the bodies to the root meet. */
    int meets() {
      return frames.ancestor();
    }
  }

  /** Derives equations that are all between two bodies, without J. */
  List<Between> between() {
    List<Between> all = new ArrayList<>();
    for (LoopClosure closure : mechanism.mechanism().closures()) {
      program.section("Loop: " + closure.name() + ".", Labels.sanitized(closure.name()));
      all.addAll(pair(closure).between());
    }
    return all;
  }

  private List<LoopRow> equations(LoopClosure closure) {
    return closure instanceof CoordinateClosure relation
        ? List.of(relationRow().row(relation(relation)))
        : pair(closure).equations();
  }

  private Relation relation(CoordinateClosure closure) {
    return new Relation(
        expressions,
        new JointLinks(expressions, mechanism, coordinates),
        new CutCoordinateTerms(expressions, mechanism, points, kinematics),
        closure.relation());
  }

  private RelationRow relationRow() {
    return new RelationRow(
        expressions,
        new JointLinks(expressions, mechanism, coordinates),
        mechanism,
        rows,
        new LoopEquations(tree).length(),
        sweep);
  }

  private Pair pair(LoopClosure closure) {
    if (closure instanceof JointClosure cut) {
      CutJoint joint = new CutJoint(tree, cut.joint());
      List<PairFunction> functions = new ArrayList<>(joint.forbidden());
      for (int k = 0; k < cut.motion().size(); k++) {
        functions.add(joint.coordinate(k));
      }
      return new Pair(joint.point1(), joint.point2(), functions, cut.motion());
    } else if (closure instanceof DistanceClosure distance) {
      PairFunction function = PairFunction.distance(distance.distance());
      return new Pair(distance.point1(), distance.point2(), List.of(function), List.of());
    } else if (closure instanceof PointOnPlaneClosure plane) {
      PairFunction function = PairFunction.displacement("off the plane", plane.normal());
      return new Pair(plane.plane(), plane.point(), List.of(function), List.of());
    } else if (closure instanceof RollingClosure rolling) {
      RollingShape shape =
          new RollingShape(rolling.normal(), rolling.axle(), rolling.radius(), rolling.tube());
      return new Pair(rolling.plane(), rolling.centre(), PairFunction.rolling(shape), List.of());
    } else if (closure instanceof KnifeEdgeClosure edge) {
      PairFunction function = PairFunction.edgeVelocity(edge.side());
      return new Pair(edge.ground(), edge.point(), List.of(function), List.of());
    }
    PointOnLineClosure line = (PointOnLineClosure) closure;
    List<PairFunction> functions = PairFunction.offLine(line.direction());
    return new Pair(line.line(), line.point(), functions, List.of());
  }

  private static BodyFrame frame(BodyPoint point) {
    return new BodyFrame(point.body(), point.position(), Rotation.IDENTITY);
  }

  /** Functions of the relative pose of two bodies; the last ones follow prescribed motions. */
  private final class Pair {
    private final BodyPoint a;
    private final BodyPoint b;
    private final List<PairFunction> functions;
    private final List<Expression> motions;

    Pair(BodyPoint a, BodyPoint b, List<PairFunction> functions, List<Expression> motions) {
      this.a = a;
      this.b = b;
      this.functions = functions;
      this.motions = motions;
    }

    RelativeFrameMotion frames() {
      return new RelativeFrameMotion(kinematics, points, frame(a), frame(b));
    }

    List<PairTerm> terms(RelativeFrameMotion frames) {
      PairTerms forms = new PairTerms(expressions, frames);
      return functions.stream().map(function -> function.as(forms)).toList();
    }

    List<LoopRow> equations() {
      RelativeFrameMotion frames = frames();
      List<LoopRow> equations = new ArrayList<>();
      List<PairTerm> terms = terms(frames);
      for (int i = 0; i < terms.size(); i++) {
        Scalar[] jacobian = rows.zeros();
        frames.addRow(terms.get(i).byShift(), terms.get(i).byTurn(), rows, jacobian);
        equations.add(equation(frames, terms.get(i), i, jacobian));
      }
      return equations;
    }

    List<Between> between() {
      RelativeFrameMotion frames = frames();
      List<Between> equations = new ArrayList<>();
      List<PairTerm> terms = terms(frames);
      for (int i = 0; i < terms.size(); i++) {
        PairTerm term = terms.get(i);
        Loads loads = new Loads(expressions, mechanism);
        frames.addWrench(term.byShift(), term.byTurn(), loads);
        LoopRow whole = equation(frames, term, i, new Scalar[0]);
        Scalar ofTime = whole.rate().minus(term.rate(frames.omega(), frames.rate()));
        LoopRow row =
            new LoopRow(whole.value(), ofTime, whole.offset(), whole.jacobian(), whole.size());
        equations.add(new Between(row, frames, term.byShift(), term.byTurn(), loads));
      }
      return equations;
    }

    private LoopRow equation(RelativeFrameMotion frames, PairTerm term, int i, Scalar[] jacobian) {
      int vanishing = functions.size() - motions.size();
      LoopRow row = row(frames, term, jacobian);
      return i < vanishing ? row : following(row, term, motions.get(i - vanishing));
    }
  }

  private LoopRow row(RelativeFrameMotion frames, PairTerm term, Scalar[] jacobian) {
    ScalarVector none = ScalarVector.zero(expressions);
    ScalarVector alpha = sweep.map(frames::alpha).orElse(none);
    ScalarVector acceleration = sweep.map(frames::acceleration).orElse(none);
    return new LoopRow(
        term.value(),
        term.rate(frames.omega(), frames.rate()),
        term.acceleration(alpha, acceleration),
        jacobian,
        Optional.empty());
  }

  /** Returns a coordinate minus its prescribed value. */
  private LoopRow following(LoopRow row, PairTerm term, Expression motion) {
    Scalar wanted = new TimeFunctions(expressions).scalar(motion);
    Differentiation byTime =
        new Differentiation(
            expressions, Map.of(expressions.input(Program.TIME), expressions.one()));
    Scalar difference = row.value().minus(wanted);
    Scalar rate = byTime.of(wanted);
    return new LoopRow(
        term.countsTurns() ? PairTerms.nearest(difference, 2 * Math.PI) : difference,
        row.rate().minus(rate),
        row.offset().minus(byTime.of(rate)),
        row.jacobian(),
        row.size());
  }
}

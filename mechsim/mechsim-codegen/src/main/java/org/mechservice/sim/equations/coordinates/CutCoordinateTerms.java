package org.mechservice.sim.equations.coordinates;

import java.util.HashMap;
import java.util.Map;
import org.mechservice.sim.equations.kinematics.BodyPoints;
import org.mechservice.sim.equations.kinematics.LinkKinematics;
import org.mechservice.solver.closure.equations.UnwrappedAngles;
import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.pair.CutJoint;
import org.mechservice.solver.kinematics.pair.PointCoordinate;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Scalar;

/**
 * The coordinates of cut joints in one program. The angles at the last accepted step are inputs
 * after the state, in the order of {@link UnwrappedAngles}; each angle is taken on the nearest
 * whole turn.
 */
public final class CutCoordinateTerms {
  private final Expressions expressions;
  private final Links mechanism;
  private final BodyPoints points;
  private final LinkKinematics kinematics;
  private final Map<ClosureCoordinate, CutCoordinate> known = new HashMap<>();
  private final Map<PointPosition, CutCoordinate> knownPoints = new HashMap<>();

  public CutCoordinateTerms(
      Expressions expressions, Links mechanism, BodyPoints points, LinkKinematics kinematics) {
    this.expressions = expressions;
    this.mechanism = mechanism;
    this.points = points;
    this.kinematics = kinematics;
  }

  /** Returns the coordinate of a position. */
  public CutCoordinate ofPosition(ClosureCoordinate position) {
    ClosureCoordinate velocity = UnwrappedAngles.velocityOf(mechanism.mechanism(), position);
    CutCoordinate coordinate = ofVelocity(velocity);
    PairTerm term = coordinate.term();
    if (!term.countsTurns()) {
      return coordinate;
    }
    Mechanism described = mechanism.mechanism();
    int states = described.stateCount();
    int counted = UnwrappedAngles.of(described).indexOf(position);
    Scalar before = expressions.input(states + counted);
    Scalar way = PairTerms.nearest(term.value().minus(before), 2 * Math.PI);
    return new CutCoordinate(coordinate.frames(), term, before.plus(way));
  }

  /** Returns the coordinate of a velocity; its angle is not unwrapped. */
  CutCoordinate ofVelocity(ClosureCoordinate velocity) {
    return known.computeIfAbsent(velocity, this::derived);
  }

  private CutCoordinate derived(ClosureCoordinate velocity) {
    Mechanism described = mechanism.mechanism();
    CutJoint joint =
        new CutJoint(new TreeGeometry(described), UnwrappedAngles.joint(described, velocity));
    RelativeFrameMotion frames =
        new RelativeFrameMotion(kinematics, points, frame(joint.point1()), frame(joint.point2()));
    PairTerm term = joint.coordinate(velocity.component()).as(new PairTerms(expressions, frames));
    return new CutCoordinate(frames, term, term.value());
  }

  /** Returns a world coordinate of a point. */
  CutCoordinate ofPoint(PointPosition position) {
    return knownPoints.computeIfAbsent(position, this::derived);
  }

  private CutCoordinate derived(PointPosition position) {
    PointCoordinate coordinate =
        PointCoordinate.of(new TreeGeometry(mechanism.mechanism()), position);
    RelativeFrameMotion frames =
        new RelativeFrameMotion(
            kinematics, points, frame(coordinate.origin()), frame(position.point()));
    PairTerm term = coordinate.function().as(new PairTerms(expressions, frames));
    return new CutCoordinate(frames, term, term.value());
  }

  private static BodyFrame frame(BodyPoint point) {
    return new BodyFrame(point.body(), point.position(), Rotation.IDENTITY);
  }
}

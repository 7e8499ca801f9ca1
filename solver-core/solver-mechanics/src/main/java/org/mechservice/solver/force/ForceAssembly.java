package org.mechservice.solver.force;

import org.mechservice.solver.expression.BodyFrame;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.ContactLaw;
import org.mechservice.solver.force.applied.CoordinateForce;
import org.mechservice.solver.force.applied.CutCoordinateLaw;
import org.mechservice.solver.force.applied.CutCoordinates;
import org.mechservice.solver.force.applied.FrameForce;
import org.mechservice.solver.force.applied.FrameMotion;
import org.mechservice.solver.force.applied.PrintedFrameLaw;
import org.mechservice.solver.force.applied.PrintedScalarLaw;
import org.mechservice.solver.force.applied.ScalarLaw;
import org.mechservice.solver.force.applied.TreeCoordinate;
import org.mechservice.solver.force.formula.CoupledSpring;
import org.mechservice.solver.force.formula.CutJointForce;
import org.mechservice.solver.force.formula.ExpressionJointForce;
import org.mechservice.solver.force.formula.ExpressionWrench;
import org.mechservice.solver.force.formula.FormulaLaw;
import org.mechservice.solver.force.formula.TensionLaw;
import org.mechservice.solver.force.law.CoordinateLaw;
import org.mechservice.solver.force.law.Side;
import org.mechservice.solver.force.user.AppliedUserForce;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.kinematics.pair.CutJoint;
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

/** Creates applied forces from their descriptions. */
final class ForceAssembly implements ForceVisitor<AppliedForce> {
  private final TreeMotion motion;
  private final TreeGeometry tree;
  private final UserForceSource source;

  ForceAssembly(TreeMotion motion, UserForceSource source) {
    this.motion = motion;
    this.tree = motion.tree();
    this.source = source;
  }

  /** Returns the applied force of a description. */
  AppliedForce at(ForceElement element) {
    return element.accept(this);
  }

  @Override
  public AppliedForce springDamper(SpringDamper force) {
    FrameMotion line = new FrameMotion(motion, parallel(force.point1()), parallel(force.point2()));
    return new FrameForce(force, line, new PrintedFrameLaw(force, force.pairLaw(), 3));
  }

  @Override
  public AppliedForce jointSpringDamper(JointSpringDamper force) {
    return ofPosition(force, force.coordinate(), spring(force, force.side()));
  }

  @Override
  public AppliedForce bushing(Bushing force) {
    FrameMotion frames = new FrameMotion(motion, force.frame1(), force.frame2());
    return new FrameForce(force, frames, new PrintedFrameLaw(force, force.pairLaw(), 12));
  }

  @Override
  public AppliedForce forceTorque(ForceTorque force) {
    checkBody(force.name(), force.point().body());
    return new ExpressionWrench(force, motion);
  }

  @Override
  public AppliedForce jointForce(JointForce force) {
    return force.coordinate() instanceof ClosureCoordinate cut
        ? new CutJointForce(force, motion, cut)
        : new ExpressionJointForce(
            force, motion, TreeCoordinate.ofVelocity(tree, (JointCoordinate) force.coordinate()));
  }

  @Override
  public AppliedForce couplingSpringDamper(CouplingSpringDamper force) {
    return new CoupledSpring(force, force.along(), motion, spring(force, force.side()));
  }

  @Override
  public AppliedForce pathForce(PathForce force) {
    return new CoupledSpring(force, force.along(), motion, new TensionLaw(force, motion));
  }

  @Override
  public AppliedForce contact(Contact force) {
    FrameMotion frames = new FrameMotion(motion, force.surface(), parallel(force.center()));
    return new FrameForce(force, frames, new ContactLaw(force));
  }

  @Override
  public AppliedForce pairForce(PairForce force) {
    FrameMotion frames = new FrameMotion(motion, force.frame1(), force.frame2());
    return new FrameForce(force, frames, new FormulaLaw(force, motion));
  }

  @Override
  public AppliedForce lawForce(LawForce force) {
    FrameMotion frames = new FrameMotion(motion, force.frame1(), force.frame2());
    int values = force.law().row().orElseThrow().outputs().size();
    return new FrameForce(force, frames, new PrintedFrameLaw(force, force.law(), values));
  }

  @Override
  public AppliedForce jointFriction(JointFriction force) {
    return ofVelocity(
        force, force.coordinate(), new PrintedScalarLaw(force, CoordinateLaw.FRICTION));
  }

  @Override
  public AppliedForce userForce(UserForceElement force) {
    return new AppliedUserForce(force, motion, source);
  }

  private static ScalarLaw spring(ForceElement element, Side side) {
    return new PrintedScalarLaw(element, CoordinateLaw.of(side));
  }

  private AppliedForce ofPosition(ForceElement element, Coordinate coordinate, ScalarLaw law) {
    if (coordinate instanceof ClosureCoordinate cut) {
      CutJoint joint = CutCoordinates.joint(tree, cut);
      int component = CutCoordinates.velocityOfPosition(joint, cut.component());
      return onCut(element, joint, component, CutCoordinates.start(joint, cut.component()), law);
    }
    TreeCoordinate at = TreeCoordinate.ofPosition(tree, (JointCoordinate) coordinate);
    if (at.velocity() < 0) {
      throw new IllegalArgumentException(
          "force " + element.name() + " acts on an Euler parameter, which has no force");
    }
    return new CoordinateForce(element, motion, at, law);
  }

  private AppliedForce ofVelocity(ForceElement element, Coordinate coordinate, ScalarLaw law) {
    if (coordinate instanceof ClosureCoordinate cut) {
      return onCut(element, CutCoordinates.joint(tree, cut), cut.component(), 0, law);
    }
    TreeCoordinate at = TreeCoordinate.ofVelocity(tree, (JointCoordinate) coordinate);
    return new CoordinateForce(element, motion, at, law);
  }

  private AppliedForce onCut(
      ForceElement element, CutJoint joint, int component, double start, ScalarLaw law) {
    CutCoordinateLaw carried =
        new CutCoordinateLaw(motion, joint, joint.coordinate(component), start, law);
    return new FrameForce(element, CutCoordinates.frames(motion, joint), carried);
  }

  private static BodyFrame parallel(BodyPoint point) {
    return new BodyFrame(point.body(), point.position(), Rotation.IDENTITY);
  }

  private void checkBody(String force, int body) {
    if (body < BodyPoint.ROOT || body >= tree.mechanism().bodies().size()) {
      throw new IllegalArgumentException("force " + force + " names a body that is not there");
    }
  }
}

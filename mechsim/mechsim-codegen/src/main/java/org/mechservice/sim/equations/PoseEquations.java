package org.mechservice.sim.equations;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.links.Axes;
import org.mechservice.solver.links.BodyPlacement;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.step.EulerParameterTerms;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Poses and velocities of the bodies of an open chain in world axes, for the body frames of the
 * model file, not the computing frames of the dynamics.
 *
 * <p>Euler parameters are products of those of the joints (half angles), so that no orientation
 * needs its own formula; their common sign is arbitrary.
 */
public final class PoseEquations {
  /**
   * Pose and velocity of a link in the world.
   *
   * @param position of its computing origin from the world origin, m
   * @param rotation from its computing axes to world axes
   * @param attitude from its own axes to world axes
   * @param velocity of its origin, world axes, m/s
   * @param omega angular velocity, world axes, rad/s
   */
  private record Pose(
      ScalarVector position,
      ScalarMatrix rotation,
      EulerParameterTerms attitude,
      ScalarVector velocity,
      ScalarVector omega) {}

  private final Program program = new Program();
  private final Expressions expressions = program.expressions();
  private final Coordinates coordinates;
  private final Links mechanism;

  private PoseEquations(Links mechanism) {
    this.mechanism = mechanism;
    this.coordinates = new Coordinates(program, mechanism);
  }

  /**
   * Derives the program from the state [q; v] to the numbers of {@link BodyPoses}, bodies in file
   * order, except that e0 may be negative.
   */
  public static Program derive(Links mechanism) {
    return new PoseEquations(mechanism).derive();
  }

  private Program derive() {
    List<Pose> poses = new ArrayList<>();
    for (Link link : mechanism.links()) {
      program.section(
          "Pose: " + link.title() + ".\np = p_p + R_p r, R = R_p R_q, e = e_p e_q",
          link.bodyLabel());
      Pose joint = atJoint(link, link.parent() == Links.ROOT ? root() : poses.get(link.parent()));
      Pose slid = link.slides() ? slid(link, joint) : joint;
      Pose pose = link.turns() ? turned(link, slid) : link.isBall() ? ball(link, slid) : slid;
      poses.add(named(link, pose));
      putOutBodies(poses.size() - 1, pose);
    }
    program.section("Pose: bodies welded to the root.", "root");
    putOutBodies(Links.ROOT, root());
    return program;
  }

  private void putOutBodies(int link, Pose pose) {
    for (int body = 0; body < mechanism.bodies().size(); body++) {
      if (mechanism.bodies().get(body).link() == link) {
        putOut(body, mechanism.bodies().get(body), pose);
      }
    }
  }

  private Pose root() {
    ScalarVector none = ScalarVector.zero(expressions);
    Rotation orientation = mechanism.mechanism().root().orientation();
    return new Pose(
        ScalarVector.of(expressions, mechanism.mechanism().root().position()),
        matrix(orientation),
        EulerParameterTerms.of(expressions, orientation),
        none,
        none);
  }

  private ScalarMatrix matrix(Rotation rotation) {
    double[][] elements = Axes.elements(rotation);
    return ScalarMatrix.of((i, j) -> expressions.constant(elements[i][j]));
  }

  /** The link's frame at q = 0: the parent's, taken to the joint. */
  private Pose atJoint(Link link, Pose parent) {
    ScalarVector way = parent.rotation().times(ScalarVector.of(expressions, link.offset()));
    Rotation axes = link.axes().rotation();
    return new Pose(
        parent.position().plus(way),
        parent.rotation().times(matrix(axes)),
        parent.attitude().times(EulerParameterTerms.of(expressions, link.zeroRotation())),
        parent.velocity().plus(parent.omega().cross(way)),
        parent.omega());
  }

  private Pose turned(Link link, Pose joint) {
    Scalar cosine = coordinates.cosine(link);
    Scalar sine = coordinates.sine(link);
    ScalarVector x = joint.rotation().column(0);
    ScalarVector y = joint.rotation().column(1);
    ScalarVector z = joint.rotation().column(2);
    ScalarVector turnedX = x.times(cosine).plus(y.times(sine));
    ScalarVector turnedY = y.times(cosine).plus(x.times(sine.negated()));
    List<ScalarVector> columns = List.of(turnedX, turnedY, z);
    Scalar half = coordinates.position(link).times(0.5);
    EulerParameterTerms turn =
        EulerParameterTerms.about(
            link.axis(),
            program.named("cos_half_" + link.jointLabel(), expressions.cosine(half)),
            program.named("sin_half_" + link.jointLabel(), expressions.sine(half)));
    return new Pose(
        joint.position(),
        ScalarMatrix.of((i, j) -> columns.get(j).at(i)),
        joint.attitude().times(turn),
        joint.velocity(),
        joint.omega().plus(z.times(coordinates.velocity(link))));
  }

  private Pose slid(Link link, Pose joint) {
    ScalarVector z = joint.rotation().column(2);
    ScalarVector way = z.times(coordinates.way(link));
    return new Pose(
        joint.position().plus(way),
        joint.rotation(),
        joint.attitude(),
        joint.velocity().plus(joint.omega().cross(way)).plus(z.times(coordinates.wayRate(link))),
        joint.omega());
  }

  private Pose ball(Link link, Pose joint) {
    EulerParameterTerms e = coordinates.eulerParameters(link).normalised();
    ScalarMatrix rotation = joint.rotation().times(coordinates.ballRotation(link));
    ScalarVector v = coordinates.ballVelocity(link);
    ScalarVector relative =
        link.inverse() ? rotation.times(v.map(Scalar::negated)) : joint.rotation().times(v);
    return new Pose(
        joint.position(),
        rotation,
        joint.attitude().times(link.inverse() ? e.inverse() : e),
        joint.velocity(),
        joint.omega().plus(relative));
  }

  private Pose named(Link link, Pose pose) {
    String label = link.bodyLabel();
    program.named("p_" + label, pose.position());
    program.named("R_" + label, pose.rotation());
    program.named("v_" + label, pose.velocity());
    program.named("omega_" + label, pose.omega());
    for (int i = 0; i < 4; i++) {
      program.named("e" + i + "_" + label, pose.attitude().at(i));
    }
    return pose;
  }

  /** Outputs the pose of a body, transformed from the computing frame to its own. */
  private void putOut(int body, BodyPlacement place, Pose pose) {
    ScalarVector arm = pose.rotation().times(ScalarVector.of(expressions, place.origin()));
    ScalarVector velocity = pose.velocity().plus(pose.omega().cross(arm));
    EulerParameterTerms attitude =
        pose.attitude().times(EulerParameterTerms.of(expressions, place.toLink()));
    List<Scalar> numbers = new ArrayList<>(pose.position().plus(arm).components());
    for (int i = 0; i < 4; i++) {
      numbers.add(attitude.at(i));
    }
    numbers.addAll(velocity.components());
    numbers.addAll(pose.omega().components());
    for (int i = 0; i < numbers.size(); i++) {
      program.output(BodyPoses.NUMBERS_PER_BODY * body + i, numbers.get(i));
    }
  }
}

package org.mechservice.sim.equations;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.sim.equations.force.AppliedForces;
import org.mechservice.sim.equations.force.MassiveRodTerms;
import org.mechservice.sim.equations.kinematics.Coordinates;
import org.mechservice.sim.equations.recursion.VelocityRows;
import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.step.LinkStep;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Kinetic energy ½ Σ (m v·v + ω·I ω) over the centres of mass with ½ A v² of armatures, and
 * potential energy −Σ m g·p of a tree, p from the world origin, plus the energy of springs and of
 * rods that close loops.
 *
 * <p>Positions are not needed: the sweep carries the direction of gravity outwards in body axes,
 * together with the height of each joint.
 */
public final class EnergyEquations {
  /**
   * Values carried outwards from link to link.
   *
   * @param omega angular velocity, rad/s
   * @param velocity velocity of the computing origin, m/s
   * @param gravity g in computing axes, m/s²
   * @param fall g·p of the computing origin, m²/s²
   */
  private record Movement(
      ScalarVector omega, ScalarVector velocity, ScalarVector gravity, Scalar fall) {}

  private final Program program = new Program();
  private final Expressions expressions = program.expressions();
  private final Coordinates coordinates;
  private final Links mechanism;

  private EnergyEquations(Links mechanism) {
    this.mechanism = MassiveRodTerms.withEnds(mechanism);
    this.coordinates = new Coordinates(program, mechanism).inSharedForms(this.mechanism);
  }

  /**
   * Derives the program from the state [q; v] to kinetic energy (output 0) and potential energy
   * (output 1), J.
   */
  public static Program derive(Links mechanism) {
    return new EnergyEquations(mechanism).derive();
  }

  private Program derive() {
    Scalar kinetic = expressions.zero();
    Scalar potential = expressions.constant(potentialOfFixedMass());
    List<Movement> movements = new ArrayList<>();
    for (Link link : mechanism.links()) {
      program.section(
          "Energy: "
              + link.title()
              + ".\nT += (m (v + omega x c)^2 + omega.I omega) / 2, U -= m g.(p + c)",
          link.bodyLabel());
      Movement parent = link.parent() == Links.ROOT ? root() : movements.get(link.parent());
      Movement movement = named(link, outwards(link, parent));
      movements.add(movement);
      kinetic = kinetic.plus(kinetic(link, movement));
      ScalarVector center = coordinates.numbers(link, link.centerOfMass());
      Scalar fall = movement.fall().plus(movement.gravity().dot(center));
      potential = potential.minus(fall.times(coordinates.number(link, link.mass())));
      program.named("T_" + link.bodyLabel(), kinetic);
      program.named("U_" + link.bodyLabel(), potential);
    }
    AppliedForces applied = new AppliedForces(program, mechanism, coordinates);
    VelocityRows rows = new VelocityRows(expressions, mechanism, coordinates);
    MassiveRodTerms rods = new MassiveRodTerms(expressions, mechanism, applied.kinematics(), rows);
    potential = potential.plus(applied.potential()).plus(rods.potential(mechanism.mechanism()));
    kinetic = kinetic.plus(rods.kinetic());
    program.section("Kinetic and potential energy.", "energy");
    program.output(0, kinetic);
    program.output(1, potential);
    return program;
  }

  private Movement root() {
    Mechanism described = mechanism.mechanism();
    ScalarVector none = ScalarVector.zero(expressions);
    double fall = described.gravity().dot(described.root().position());
    return new Movement(
        none, none, ScalarVector.of(expressions, mechanism.gravity()), expressions.constant(fall));
  }

  private Movement named(Link link, Movement movement) {
    String label = link.bodyLabel();
    program.named("omega_" + label, movement.omega());
    program.named("v_" + label, movement.velocity());
    program.named("g_" + label, movement.gravity());
    program.named("fall_" + label, movement.fall());
    return movement;
  }

  private Movement outwards(Link link, Movement parent) {
    ScalarVector offset = coordinates.numbers(link, link.offset());
    LinkStep step = coordinates.step(link);
    Movement atJoint =
        new Movement(
            step.toChild(parent.omega()),
            step.toChild(parent.velocity().plus(parent.omega().cross(offset))),
            step.toChild(parent.gravity()),
            parent.fall().plus(parent.gravity().dot(offset)));
    if (link.isBall()) {
      return link.inverse() ? turnedBack(link, atJoint) : turnedBall(link, atJoint);
    }
    Movement slid = link.slides() ? slid(link, atJoint) : atJoint;
    return link.turns() ? turned(link, slid) : slid;
  }

  private Movement turned(Link link, Movement joint) {
    Scalar cosine = coordinates.cosine(link);
    Scalar back = coordinates.sine(link).negated();
    ScalarVector omega = joint.omega().turned(2, cosine, back);
    return new Movement(
        new ScalarVector(omega.x(), omega.y(), omega.z().plus(coordinates.velocity(link))),
        joint.velocity().turned(2, cosine, back),
        joint.gravity().turned(2, cosine, back),
        joint.fall());
  }

  private Movement slid(Link link, Movement joint) {
    Scalar zero = expressions.zero();
    ScalarVector way = new ScalarVector(zero, zero, coordinates.way(link));
    ScalarVector rate = new ScalarVector(zero, zero, coordinates.wayRate(link));
    return new Movement(
        joint.omega(),
        joint.velocity().plus(joint.omega().cross(way)).plus(rate),
        joint.gravity(),
        joint.fall().plus(joint.gravity().dot(way)));
  }

  private Movement turnedBall(Link link, Movement joint) {
    ScalarMatrix toChild = coordinates.ballRotation(link).transposed();
    ScalarVector omega = joint.omega().plus(coordinates.ballVelocity(link));
    return new Movement(
        toChild.times(omega),
        toChild.times(joint.velocity()),
        toChild.times(joint.gravity()),
        joint.fall());
  }

  private Movement turnedBack(Link link, Movement joint) {
    ScalarMatrix toChild = coordinates.ballRotation(link).transposed();
    ScalarVector back = coordinates.ballVelocity(link).map(Scalar::negated);
    return new Movement(
        toChild.times(joint.omega()).plus(back),
        toChild.times(joint.velocity()),
        toChild.times(joint.gravity()),
        joint.fall());
  }

  /** −m g·p of the bodies welded to the root. */
  private double potentialOfFixedMass() {
    Mechanism described = mechanism.mechanism();
    double atRoot = described.gravity().dot(described.root().position());
    return -mechanism.fixedMass() * (atRoot + mechanism.gravity().dot(mechanism.fixedCenter()));
  }

  private Scalar kinetic(Link link, Movement movement) {
    ScalarVector omega = movement.omega();
    ScalarVector center = coordinates.numbers(link, link.centerOfMass());
    ScalarVector velocity = movement.velocity().plus(omega.cross(center));
    InertiaTensor inertia = link.inertia();
    double[][] tensor = {
      {inertia.xx(), inertia.xy(), inertia.xz()},
      {inertia.xy(), inertia.yy(), inertia.yz()},
      {inertia.xz(), inertia.yz(), inertia.zz()}
    };
    ScalarMatrix half = ScalarMatrix.of((i, j) -> coordinates.number(link, tensor[i][j] / 2));
    Scalar energy =
        velocity
            .dot(velocity)
            .times(coordinates.number(link, link.mass() / 2))
            .plus(omega.dot(half.times(omega)));
    return link.armature() == 0 ? energy : energy.plus(kineticOfArmature(link));
  }

  /** Returns ½ A v². */
  private Scalar kineticOfArmature(Link link) {
    Scalar square =
        link.isBall()
            ? coordinates.ballVelocity(link).dot(coordinates.ballVelocity(link))
            : coordinates.velocity(link).squared();
    return square.times(link.armature() / 2);
  }
}

package org.mechservice.sim.build.dynamics;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.sim.symbolic.Differentiation;
import org.mechservice.sim.symbolic.Expressions;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;
import org.mechservice.sim.symbolic.ScalarMatrix;
import org.mechservice.sim.symbolic.ScalarVector;

/** Coordinates of the links in one program, with their sines and cosines. */
final class Coordinates {
  private final Program program;
  private final Expressions expressions;
  private final TimeFunctions functions;
  private final Differentiation byTime;
  private final Map<Link, ScalarMatrix> rotations = new HashMap<>();

  Coordinates(Program program, Links links) {
    this.program = program;
    this.expressions = program.expressions();
    this.functions = new TimeFunctions(expressions, links.mechanism().parameters());
    this.byTime =
        new Differentiation(
            expressions, Map.of(expressions.input(Program.TIME), expressions.one()));
  }

  /** Returns the link's coordinate, rad or m. */
  Scalar position(Link link) {
    return named("q_", link, drivenOr(link, link.position()));
  }

  /** Returns the link's velocity, rad/s or m/s. */
  Scalar velocity(Link link) {
    return link.isDriven()
        ? named("v_", link, byTime.of(position(link)))
        : named("v_", link, expressions.input(link.velocity()));
  }

  /** Returns what is known of the link's acceleration beforehand: 0 unless it is driven. */
  Scalar drivenAcceleration(Link link) {
    return link.isDriven() ? named("a_", link, byTime.of(velocity(link))) : expressions.zero();
  }

  private Scalar drivenOr(Link link, int input) {
    return link.motion().isPresent()
        ? functions.scalar(link.motion().get())
        : expressions.input(input);
  }

  private Scalar named(String kind, Link link, Scalar value) {
    return program.named(kind + link.jointLabel(), value);
  }

  /** Returns the way along z, m. */
  Scalar way(Link link) {
    return position(link).times(link.way());
  }

  /** Returns its rate, m/s. */
  Scalar wayRate(Link link) {
    return velocity(link).times(link.way());
  }

  /** Returns the sine of a turning link's angle. */
  Scalar sine(Link link) {
    return named("sin_", link, expressions.sine(position(link)));
  }

  /** Returns the cosine of a turning link's angle. */
  Scalar cosine(Link link) {
    return named("cos_", link, expressions.cosine(position(link)));
  }

  /** Returns the angular velocity of the file's body 2 relative to body 1, in body 1's axes. */
  ScalarVector ballVelocity(Link link) {
    ScalarVector velocity =
        new ScalarVector(
            expressions.input(link.velocity()),
            expressions.input(link.velocity() + 1),
            expressions.input(link.velocity() + 2));
    return program.named("v_" + link.jointLabel(), velocity);
  }

  /** Returns the Euler parameters as the state has them. */
  EulerParameters eulerParameters(Link link) {
    Scalar[] e = new Scalar[4];
    for (int i = 0; i < 4; i++) {
      e[i] = expressions.input(link.position() + i);
      program.named("e" + i + "_" + link.jointLabel(), e[i]);
    }
    return new EulerParameters(List.of(e));
  }

  /** Returns the rotation from the link's axes to its parent's, by R(e/|e|) or its transpose. */
  ScalarMatrix ballRotation(Link link) {
    ScalarMatrix known = rotations.get(link);
    if (known == null) {
      ScalarMatrix rotation = eulerParameters(link).rotation();
      known = link.inverse() ? rotation.transposed() : rotation;
      program.named("R_" + link.jointLabel(), known);
      rotations.put(link, known);
    }
    return known;
  }
}

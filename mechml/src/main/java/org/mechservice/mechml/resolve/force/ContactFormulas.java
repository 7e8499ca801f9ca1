package org.mechservice.mechml.resolve.force;

import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.larger;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.minus;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.negated;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.product;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.quotient;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.root;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.square;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.sum;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.text.Origin;

/**
 * Push and friction at the places where two bodies touch, summed up.
 *
 * <p>Friction without sticking is −μ N s / √(s² + v₀²), s the sliding velocity: a body on a slope
 * creeps. Friction that sticks has a state z, the elastic displacement before sliding divided by δ,
 * and is −μ N (z + τ z′), the model of Dupont, Hayward, Armstrong and Altpeter (IEEE Trans. Autom.
 * Control 47 (2002) 787) with a stiffness that is proportional to N:
 *
 * <p>z′ = (s − a(|z|) max(0, s·z) z / z²) / δ, a = max(0, (|z| − 0.7) / 0.3).
 *
 * <p>Below 0.7 μ N the displacement is elastic, so that not even a shaken body creeps; up to μ N a
 * constant load is held at rest; in steady sliding |z| = 1. While the bodies are apart z decays
 * with the time constant τ.
 */
final class ContactFormulas {
  /** Share of the friction limit up to which the displacement is elastic. */
  private static final double ELASTIC = 0.7;

  /** Keeps directions defined where their size is zero. */
  private static final Expression TINY = Expression.of(1e-20);

  private final ContactCoefficients law;
  private final RelativeFrames frames;
  private final String name;
  private final Origin origin;
  private final List<FurtherState> states;
  private final int firstState;

  private ExpressionVector force = ExpressionVector.ZERO;
  private ExpressionVector moment = ExpressionVector.ZERO;
  private ExpressionVector friction = ExpressionVector.ZERO;
  private Expression normal = Expression.ZERO;
  private Expression potential = Expression.ZERO;
  private Expression potentialRate = Expression.ZERO;
  private final List<Expression> depths = new ArrayList<>();

  /**
   * @param states receives the states of friction; the first of them follows those already there
   */
  ContactFormulas(
      String name,
      ContactCoefficients law,
      RelativeFrames frames,
      List<FurtherState> states,
      Origin origin) {
    this.name = name;
    this.law = law;
    this.frames = frames;
    this.states = states;
    this.origin = origin;
    firstState = states.size();
  }

  RelativeFrames frames() {
    return frames;
  }

  /**
   * Adds a place of contact.
   *
   * @param depth penetration, m
   * @param n unit normal from body 1 to body 2, in the axes of frame 1
   * @param arm the place on body 2, from the origin of frame 2, m
   */
  void add(Expression depth, ExpressionVector n, ExpressionVector arm) {
    ExpressionVector velocity = frames.velocityAt(arm);
    Expression rate = negated(velocity.dot(n));
    ContactCoefficients.Push pushed = law.new Push(depth, rate);
    Expression push = pushed.force();
    ExpressionVector rubbing = ExpressionVector.ZERO;
    if (law.rubs()) {
      ExpressionVector sliding = velocity.normalTo(n);
      rubbing = law.sticks() ? sticking(pushed, push, sliding, n) : slipping(push, sliding);
    }
    ExpressionVector all = n.times(push).plus(rubbing);
    force = force.plus(all);
    moment = moment.plus(arm.cross(all));
    friction = friction.plus(rubbing);
    normal = sum(normal, push);
    potential = sum(potential, pushed.potential());
    potentialRate = sum(potentialRate, product(pushed.elastic(), rate));
    depths.add(depth);
  }

  private ExpressionVector slipping(Expression push, ExpressionVector sliding) {
    Expression root = root(sum(sliding.dot(sliding), square(law.slidingSpeed())));
    return sliding.times(negated(quotient(product(law.friction(), push), root)));
  }

  private ExpressionVector sticking(
      ContactCoefficients.Push pushed,
      Expression push,
      ExpressionVector sliding,
      ExpressionVector n) {
    int first = states.size();
    List<Expression> parts = new ArrayList<>();
    for (Expression component : sliding.components()) {
      parts.add(
          ExpressionAlgebra.isZero(component)
              ? Expression.ZERO
              : new Expression.StateValue(first + count(parts)));
    }
    ExpressionVector z = ExpressionVector.of(parts);
    Expression square = sum(z.dot(z), TINY);
    Expression over =
        quotient(minus(root(square), Expression.of(ELASTIC)), Expression.of(1 - ELASTIC));
    Expression share = larger(Expression.ZERO, over);
    Expression outwards = larger(Expression.ZERO, sliding.dot(z));
    ExpressionVector yielding = z.times(quotient(product(share, outwards), square));
    Expression touch = pushed.touch();
    ExpressionVector strain = sliding.less(yielding).times(quotient(touch, law.stickLength()));
    ExpressionVector decay = z.times(quotient(minus(Expression.of(1), touch), law.stickTime()));
    ExpressionVector rate = strain.less(decay);
    for (int i = 0; i < 3; i++) {
      if (!ExpressionAlgebra.isZero(parts.get(i))) {
        String state = name + ".stick" + (states.size() - firstState + 1);
        states.add(new FurtherState(state, 0, rate.components().get(i), "1", 0, origin));
      }
    }
    ExpressionVector held = z.plus(rate.times(law.stickTime())).normalTo(n);
    return held.times(negated(product(law.friction(), push)));
  }

  private static int count(List<Expression> parts) {
    return (int) parts.stream().filter(part -> !ExpressionAlgebra.isZero(part)).count();
  }

  /**
   * Returns the contact.
   *
   * @param kind in words
   * @param mostDepth penetration beyond which the formulas mean nothing, m; zero for none
   * @param shape of body 2 in pictures
   */
  PairForce force(String kind, Expression mostDepth, PairForce.Shape shape) {
    List<Expression> wrench = new ArrayList<>(moment.components());
    wrench.addAll(force.components());
    Expression deepest = depths.stream().reduce(ExpressionAlgebra::larger).orElseThrow();
    List<PairForce.Value> values = new ArrayList<>();
    values.add(new PairForce.Value("penetration", "m", deepest));
    values.add(new PairForce.Value("normal", "N", normal));
    values.add(new PairForce.Value("frictionX", "N", friction.x()));
    values.add(new PairForce.Value("frictionY", "N", friction.y()));
    if (!ExpressionAlgebra.isZero(friction.z())) {
      values.add(new PairForce.Value("frictionZ", "N", friction.z()));
    }
    return new PairForce(
        name,
        kind,
        frames.frame1(),
        frames.frame2(),
        wrench,
        potential,
        potentialRate,
        values,
        mostDepth,
        shape,
        origin);
  }
}

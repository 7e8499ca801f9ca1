package org.mechservice.sim.equations.force;

import java.util.List;
import java.util.function.Function;
import org.mechservice.sim.equations.coordinates.ClosestPointSearch;
import org.mechservice.sim.equations.coordinates.RelativeFrameMotion;
import org.mechservice.sim.equations.recursion.Loads;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Push and friction of a surface at the closest point of each of its curves, summed up. Legend: R
 * the radius; (x, y, z) the centre in the surface's frame; n = (−sin θ, 0, cos θ) the normal and t
 * = (cos θ, 0, sin θ) the tangent; (s, r) sliding velocity along t and y at the point R below the
 * centre along n.
 */
final class ContactTerm implements ForceTerm {
  /**
   * Coefficients of a contact.
   *
   * @param radius m
   * @param push law of the push
   * @param friction coefficient
   * @param frictionSpeed m/s
   * @param ofCentre whether the curves are those of the centre, else the surface
   */
  record Coefficients(
      Scalar radius, PushLaw push, Scalar friction, Scalar frictionSpeed, boolean ofCentre) {}

  private final RelativeFrameMotion frames;
  private final Coefficients c;
  private final List<Touch> touches;

  /**
   * @param frames the sphere's frame (any axes) relative to the surface's
   */
  ContactTerm(
      RelativeFrameMotion frames,
      Coefficients coefficients,
      List<ClosestPointSearch.Curve> curves) {
    this.frames = frames;
    this.c = coefficients;
    this.touches = curves.stream().map(Touch::new).toList();
  }

  /** Push and friction at the closest point of one curve. */
  private final class Touch {
    private final ClosestPointSearch point;
    private final Scalar depth;
    private final Scalar depthRate;
    private final Scalar normal;
    private final Scalar slideAlong;
    private final Scalar slideAcross;
    private final Scalar along;
    private final Scalar across;

    Touch(ClosestPointSearch.Curve curve) {
      ScalarVector place = frames.displacement();
      Expressions e = place.x().expressions();
      Scalar reach = c.ofCentre() ? e.zero() : c.radius();
      point = new ClosestPointSearch(curve, place.x(), place.z(), c.ofCentre());
      ScalarVector u = frames.rate();
      ScalarVector omega = frames.omega();
      Scalar sine = point.sine;
      Scalar cosine = point.cosine;
      depth = reach.minus(point.distance);
      depthRate = sine.times(u.x()).minus(cosine.times(u.z()));
      normal = c.push().force(depth, depthRate);
      Scalar slip = cosine.times(u.x()).plus(sine.times(u.z()));
      Scalar spin = cosine.times(omega.x()).plus(sine.times(omega.z()));
      slideAlong = slip.minus(omega.y().times(c.radius()));
      slideAcross = u.y().plus(spin.times(c.radius()));
      if (c.friction().isZero()) {
        along = e.zero();
        across = e.zero();
        return;
      }
      Scalar root =
          slideAlong
              .squared()
              .plus(slideAcross.squared())
              .plus(c.frictionSpeed().squared())
              .squareRoot();
      Scalar most = normal.times(c.friction().negated());
      along = slideAlong.over(root).times(most);
      across = slideAcross.over(root).times(most);
    }

    private void apply(Loads loads) {
      Scalar sine = point.sine;
      Scalar cosine = point.cosine;
      ScalarVector force =
          new ScalarVector(
              cosine.times(along).minus(sine.times(normal)),
              across,
              sine.times(along).plus(cosine.times(normal)));
      Scalar lever = across.times(c.radius());
      ScalarVector moment =
          new ScalarVector(
              lever.times(cosine), along.times(c.radius().negated()), lever.times(sine));
      frames.addWrench(force, moment, loads);
    }

    /** Returns the power of the wrench plus the rate of the potential energy. */
    private Scalar power() {
      Scalar friction = along.times(slideAlong).plus(across.times(slideAcross));
      return friction.minus(c.push().dissipative(depth, depthRate).times(depthRate));
    }
  }

  private Scalar sum(Function<Touch, Scalar> part) {
    return touches.stream().map(part).reduce(Scalar::plus).orElseThrow();
  }

  @Override
  public void apply(Loads loads) {
    touches.forEach(touch -> touch.apply(loads));
  }

  @Override
  public Scalar potential() {
    return sum(touch -> c.push().potential(touch.depth));
  }

  @Override
  public Scalar power() {
    return sum(Touch::power);
  }

  @Override
  public List<Scalar> values() {
    Scalar deepest =
        touches.stream()
            .map(touch -> touch.depth)
            .reduce((a, b) -> a.expressions().function(MathFunction.MAX, a, b))
            .orElseThrow();
    return List.of(
        deepest, sum(touch -> touch.normal), sum(touch -> touch.along), sum(touch -> touch.across));
  }
}

package org.mechservice.mechml.resolve.force;

import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.call;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.isZero;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.minus;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.negated;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.product;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.quotient;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.root;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.smaller;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.square;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.sum;
import static org.mechservice.mechml.resolve.force.ExpressionAlgebra.times;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.force.PairForce;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.text.Origin;

/**
 * The tyre model TMeasy: G. Rill, Road Vehicle Dynamics, CRC Press 2012, chapter 3, without
 * self-aligning and bore torques.
 *
 * <p>The road is a plane at the place of contact, through the heights h a tenth of the radius
 * before and behind it. Its normal n and the axle a give the directions e_x = a × n and e_y = n ×
 * e_x, and the wheel's plane the way from the centre down to the road, −r_S (e_x × a). With the
 * deflection r₀ − r_S the load is F_z = max(0, k pos + c d/dt pos). The slips are
 *
 * <p>s_x = −(v_x − r_D Ω) / (r_D |Ω| + v_N), s_y = −v_y / (r_D |Ω| + v_N), r_D = ⅔ r₀ + ⅓ r_S,
 *
 * <p>normalised by ŝ, and the force F(s) of the combined slip s is a curve of five numbers: its
 * slope at zero, its maximum and where it slides, each interpolated in φ between the two directions
 * and in F_z between two loads.
 *
 * <p>A direction with a stiffness c and a damping d has the deflection x of the tyre as a state: v*
 * d x′ + v* c x = −f (v + x′) with f = F/s and v* = (r_D |Ω| + v_N) ŝ; its force is c x + d x′.
 */
final class TyreFormulas {
  /** Distance of the two heights from the centre of the contact, as a share of the radius. */
  private static final double REACH = 0.1;

  /** Keeps the direction φ of a slip of zero defined. */
  private static final double TINY = 1e-12;

  /**
   * Vertical coefficients.
   *
   * @param radius r₀, m
   * @param stiffness k, N/m
   * @param damping c, N·s/m
   * @param smoothing of pos, m
   */
  record Vertical(
      Expression radius, Expression stiffness, Expression damping, Expression smoothing) {}

  /**
   * Forces of one direction.
   *
   * @param name of the direction
   * @param once slope at zero, N; slip and force of the maximum; slip and force where sliding
   *     begins, at the nominal load
   * @param twice the same at twice that load
   * @param stiffness c, N/m; zero without a deflection
   * @param damping d, N·s/m
   */
  record Curve(
      String name,
      List<Expression> once,
      List<Expression> twice,
      Expression stiffness,
      Expression damping) {}

  private static final Expression ONE = Expression.of(1);

  private final RelativeFrames frames;
  private final Vertical vertical;
  private final Curve along;
  private final Curve across;
  private final Expression load;
  private final Expression restSpeed;
  private final Expression rolling;
  private final Expression height;

  TyreFormulas(
      RelativeFrames frames,
      Vertical vertical,
      Curve along,
      Curve across,
      Expression load,
      Expression restSpeed,
      Expression rolling,
      Expression height) {
    this.frames = frames;
    this.vertical = vertical;
    this.along = along;
    this.across = across;
    this.load = load;
    this.restSpeed = restSpeed;
    this.rolling = rolling;
    this.height = height;
  }

  /** The five numbers of a direction at the present load, divided by its share of the nominal. */
  private record Numbers(
      Expression slope, Expression slip, Expression force, Expression sliding, Expression slid) {}

  private static Numbers at(Curve curve, Expression share) {
    List<Expression> once = curve.once();
    List<Expression> twice = curve.twice();
    return new Numbers(
        ofLoad(once.get(0), twice.get(0), share),
        between(once.get(1), twice.get(1), share),
        ofLoad(once.get(2), twice.get(2), share),
        between(once.get(3), twice.get(3), share),
        ofLoad(once.get(4), twice.get(4), share));
  }

  /** 2 Y(1) − ½ Y(2) − (Y(1) − ½ Y(2)) share: the quadratic through 0, Y(1), Y(2), by the load. */
  private static Expression ofLoad(Expression once, Expression twice, Expression share) {
    Expression half = times(0.5, twice);
    Expression bend = minus(once, half);
    return minus(minus(times(2, once), half), product(bend, share));
  }

  private static Expression between(Expression once, Expression twice, Expression share) {
    return sum(once, product(minus(twice, once), minus(share, ONE)));
  }

  /** Returns the normalisation ŝ of a direction beside the other one. */
  private static Expression norm(Numbers own, Numbers other) {
    Expression slips = quotient(own.slip(), sum(own.slip(), other.slip()));
    Expression mine = quotient(own.force(), own.slope());
    Expression others = quotient(other.force(), other.slope());
    return sum(slips, quotient(mine, sum(mine, others)));
  }

  /** Returns √(c² x² + s² y²). */
  private static Expression mixed(Expression c2, Expression x, Expression s2, Expression y) {
    return root(sum(product(c2, square(x)), product(s2, square(y))));
  }

  /**
   * Returns the tyre.
   *
   * @param states receives its deflections
   */
  PairForce force(String name, List<FurtherState> states, Origin origin) {
    ExpressionVector axle = frames.axis2(2);
    ExpressionVector centre = frames.displacement();
    Expression radius = vertical.radius();

    // the road: two heights about the place below the centre
    ExpressionVector flatX = unit(axle.cross(ExpressionVector.Z));
    Expression below = minus(centre.x(), product(radius, flatX.cross(axle).x()));
    Expression reach = times(REACH, radius);
    Expression ahead = ExpressionAlgebra.at(height, sum(below, reach));
    Expression behind = ExpressionAlgebra.at(height, minus(below, reach));
    boolean flat = isZero(height);
    Expression slope = flat ? Expression.ZERO : quotient(minus(ahead, behind), times(2, reach));
    Expression ground = flat ? Expression.ZERO : times(0.5, sum(ahead, behind));
    ExpressionVector n =
        flat
            ? ExpressionVector.Z
            : unit(new ExpressionVector(negated(slope), Expression.ZERO, ONE));

    ExpressionVector ex = flat ? flatX : unit(axle.cross(n));
    ExpressionVector ey = n.cross(ex);
    ExpressionVector up = ex.cross(axle);
    ExpressionVector place = new ExpressionVector(below, centre.y(), ground);
    Expression cosine = n.dot(up);
    Expression staticRadius = quotient(n.dot(centre.less(place)), cosine);
    ExpressionVector arm = up.times(negated(staticRadius));

    // the load
    Expression deflection = minus(radius, staticRadius);
    Expression rate = negated(quotient(n.dot(frames.rate()), cosine));
    ContactCoefficients law =
        new ContactCoefficients(
            vertical.stiffness(),
            vertical.damping(),
            Expression.ZERO,
            1,
            vertical.smoothing(),
            Expression.ZERO,
            ONE,
            Expression.ZERO,
            ONE);
    Expression fz = law.new Push(deflection, rate).force();
    Expression share = quotient(fz, load);

    // velocities of the contact, the rotation about the axle left out
    Expression spin = frames.omega().dot(axle);
    ExpressionVector turning = frames.omega().less(axle.times(spin));
    ExpressionVector velocity = frames.rate().plus(turning.cross(arm));
    Expression rollingRadius = sum(times(2.0 / 3, radius), times(1.0 / 3, staticRadius));
    Expression circumferential = product(rollingRadius, spin);
    Expression slidingX = minus(ex.dot(velocity), circumferential);
    Expression slidingY = ey.dot(velocity);
    Expression transport = sum(call(MathFunction.ABS, circumferential), restSpeed);
    Expression slipX = negated(quotient(slidingX, transport));
    Expression slipY = negated(quotient(slidingY, transport));

    // the curve of the combined slip
    Numbers x = at(along, share);
    Numbers y = at(across, share);
    Expression normX = norm(x, y);
    Expression normY = norm(y, x);
    Expression sx = quotient(slipX, normX);
    Expression sy = quotient(slipY, normY);
    Expression square = sum(sum(square(sx), square(sy)), Expression.of(TINY));
    Expression slip = root(square);
    Expression c2 = quotient(sum(square(sx), Expression.of(0.5 * TINY)), square);
    Expression s2 = quotient(sum(square(sy), Expression.of(0.5 * TINY)), square);
    Expression initial = mixed(c2, product(x.slope(), normX), s2, product(y.slope(), normY));
    Expression most = mixed(c2, quotient(x.slip(), normX), s2, quotient(y.slip(), normY));
    Expression maximum = mixed(c2, x.force(), s2, y.force());
    Expression end = mixed(c2, quotient(x.sliding(), normX), s2, quotient(y.sliding(), normY));
    Expression slid = mixed(c2, x.slid(), s2, y.slid());
    Expression rise = smaller(ONE, quotient(slip, most));
    Expression form = minus(quotient(product(initial, most), maximum), Expression.of(2));
    Expression rising =
        quotient(product(initial, smaller(slip, most)), sum(ONE, product(rise, sum(rise, form))));
    Expression fall = call(MathFunction.SMOOTH_STEP, quotient(minus(slip, most), minus(end, most)));
    Expression size = minus(rising, product(minus(maximum, slid), fall));
    Expression perSlip = product(share, quotient(size, slip));

    Side sideX = new Side(along, perSlip, slidingX, sx, product(transport, normX));
    Side sideY = new Side(across, perSlip, slidingY, sy, product(transport, normY));
    Expression fx = sideX.force(name, states, origin);
    Expression fy = sideY.force(name, states, origin);
    ExpressionVector force = n.times(fz).plus(ex.times(fx)).plus(ey.times(fy));
    ExpressionVector moment = arm.cross(force);
    if (!isZero(rolling)) {
      Expression direction =
          quotient(circumferential, root(sum(square(circumferential), square(restSpeed))));
      Expression resisting = product(product(rolling, product(fz, radius)), direction);
      moment = moment.less(axle.times(resisting));
    }
    List<Expression> wrench = new ArrayList<>(moment.components());
    wrench.addAll(force.components());
    return new PairForce(
        name,
        "tyre",
        frames.frame1(),
        frames.frame2(),
        wrench,
        Expression.ZERO,
        Expression.ZERO,
        List.of(
            new PairForce.Value("deflection", "m", deflection),
            new PairForce.Value("load", "N", fz),
            new PairForce.Value("longitudinal", "N", fx),
            new PairForce.Value("lateral", "N", fy),
            new PairForce.Value("slipX", "1", slipX),
            new PairForce.Value("slipY", "1", slipY),
            new PairForce.Value("camber", "rad", call(MathFunction.ASIN, axle.dot(n)))),
        radius,
        new PairForce.Disc(radius instanceof Expression.Constant constant ? constant.value() : 0),
        origin);
  }

  private static ExpressionVector unit(ExpressionVector v) {
    return v.times(quotient(ONE, root(v.dot(v))));
  }

  /**
   * One direction of the force.
   *
   * @param perSlip f = F/s, N
   * @param sliding v, m/s
   * @param slip normalised
   * @param speed v*, m/s
   */
  private record Side(
      Curve curve, Expression perSlip, Expression sliding, Expression slip, Expression speed) {

    Expression force(String name, List<FurtherState> states, Origin origin) {
      if (isZero(curve.stiffness())) {
        return product(perSlip, slip);
      }
      Expression deflection = new Expression.StateValue(states.size());
      Expression spring = product(curve.stiffness(), deflection);
      Expression rate =
          negated(
              quotient(
                  sum(product(speed, spring), product(perSlip, sliding)),
                  sum(product(speed, curve.damping()), perSlip)));
      states.add(
          new FurtherState(name + "." + curve.name() + "Deflection", 0, rate, "m", 0, origin));
      return sum(spring, product(curve.damping(), rate));
    }
  }
}

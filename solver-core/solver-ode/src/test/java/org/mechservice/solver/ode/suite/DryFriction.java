package org.mechservice.solver.ode.suite;

import java.util.Arrays;
import org.mechservice.solver.ode.JacobianSystem;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.ResidualJacobianSystem;
import org.mechservice.solver.ode.ResidualSystem;

/**
 * A block on a spring, let go at rest and moved by friction of one unit on a belt of velocity V:
 * y'' = −s(y' − V) − y, with s = sgn, which no method is told of, or a hyperbolic tangent nearly as
 * steep.
 *
 * @param width of the hyperbolic tangent; 0: a jump
 * @param belt V; 0: a floor
 */
public record DryFriction(double width, double belt) implements JacobianSystem {
  /** Arc that is only the rounding of one that begins where the block reaches the velocity. */
  private static final double SHORTEST = 1e-9;

  /** On a floor. */
  public DryFriction(double width) {
    this(width, 0);
  }

  @Override
  public int dimension() {
    return 2;
  }

  @Override
  public void derivative(double t, double[] y, double[] yDot) {
    yDot[0] = y[1];
    yDot[1] = -law(y[1]) - y[0];
  }

  /** Of the jump there is none. */
  @Override
  public void jacobian(double t, double[] y, double[] jacobian) {
    double cosh = width == 0 ? 1 : StrictMath.cosh((y[1] - belt) / width);
    jacobian[1] = -1;
    jacobian[2] = 1;
    jacobian[3] = width == 0 ? 0 : -1 / (width * cosh * cosh);
  }

  /** The same without its Jacobian. */
  public OdeSystem differenced() {
    return new FunctionOde(2, this::derivative);
  }

  /** The same as y' − f(t, y) = 0. */
  public ResidualSystem residual() {
    return new ImplicitOde(2, this::residual);
  }

  private void residual(double t, double[] y, double[] yDot, double[] residual) {
    derivative(t, y, residual);
    residual[0] = yDot[0] - residual[0];
    residual[1] = yDot[1] - residual[1];
  }

  /** The same with friction as an algebraic unknown, y = [x, v, force]: of index 1. */
  public ResidualSystem withForceUnknown() {
    return new Algebraic(3, 2) {
      @Override
      public void residual(double t, double[] y, double[] yDot, double[] residual) {
        residual[0] = yDot[0] - y[1];
        residual[1] = yDot[1] + y[0] - y[2];
        residual[2] = y[2] + law(y[1]);
      }
    };
  }

  /**
   * The same block in two halves that a loop holds together, y = [x, v, x2, v2, force, shift], in
   * the stabilised form of index 2 (Gear, Gupta and Leimkuhler 1985). The spring pulls one half,
   * the belt the other.
   */
  public ResidualSystem inTwoHalves() {
    return new Algebraic(6, 4) {
      @Override
      public void residual(double t, double[] y, double[] yDot, double[] residual) {
        residual[0] = yDot[0] - y[1] + y[5];
        residual[1] = 0.5 * yDot[1] + y[0] - y[4];
        residual[2] = yDot[2] - y[3] - y[5];
        residual[3] = 0.5 * yDot[3] + law(y[3]) + y[4];
        residual[4] = y[3] - y[1];
        residual[5] = y[2] - y[0];
      }
    };
  }

  private double law(double velocity) {
    double slip = velocity - belt;
    return width == 0 ? Math.signum(slip) : StrictMath.tanh(slip / width);
  }

  /** A system whose last components are algebraic. */
  private abstract static class Algebraic implements ResidualSystem {
    private final int dimension;
    private final int firstAlgebraic;

    Algebraic(int dimension, int firstAlgebraic) {
      this.dimension = dimension;
      this.firstAlgebraic = firstAlgebraic;
    }

    @Override
    public final int dimension() {
      return dimension;
    }

    @Override
    public final Component component(int index) {
      return index < firstAlgebraic ? Component.DIFFERENTIAL : Component.ALGEBRAIC;
    }
  }

  /** The same with the derivatives of the residual. */
  public ResidualJacobianSystem residualWithJacobians() {
    return new Known(this);
  }

  private record Known(DryFriction friction) implements ResidualJacobianSystem {
    @Override
    public int dimension() {
      return 2;
    }

    @Override
    public void residual(double t, double[] y, double[] yDot, double[] residual) {
      friction.residual(t, y, yDot, residual);
    }

    @Override
    public void jacobians(double t, double[] y, double[] yDot, double[] fy, double[] fyDot) {
      friction.jacobian(t, y, fy);
      Arrays.setAll(fy, i -> -fy[i]);
      fyDot[0] = 1;
      fyDot[3] = 1;
    }
  }

  /**
   * The solution for a jump: half periods of π round ±1, until the block stops where the spring is
   * weaker than friction.
   *
   * @param start y(0) > 0
   */
  public static double[] exact(double start, double t) {
    double y = start;
    double since = 0;
    while (Math.abs(y) > 1) {
      double centre = Math.copySign(1, y);
      double phase = t - since;
      if (phase <= Math.PI) {
        double amplitude = y - centre;
        return new double[] {
          centre + amplitude * StrictMath.cos(phase), -amplitude * StrictMath.sin(phase)
        };
      }
      since += Math.PI;
      y = 2 * centre - y;
    }
    return new double[] {y, 0};
  }

  /**
   * The solution for a jump on a belt that moves: arcs round ±1 as long as the block slips, then a
   * straight line while it sticks, until the spring is as strong as friction, then an arc that
   * never sticks again.
   *
   * @param start y(0)
   * @param belt velocity, positive
   */
  public static double[] exactOnBelt(double start, double belt, double t) {
    double centre = 1;
    double y = start;
    double v = 0;
    double left = t;
    while (true) {
      double radius = Math.hypot(y - centre, v);
      double angle = StrictMath.atan2(-v, y - centre);
      double arc = left;
      if (radius > belt) {
        double touches = -StrictMath.asin(belt / radius);
        arc = ((centre > 0 ? -Math.PI - touches : touches) - angle) % (2 * Math.PI);
        arc += arc < SHORTEST ? 2 * Math.PI : 0;
      }
      if (arc >= left) {
        double end = angle + left;
        return new double[] {centre + radius * StrictMath.cos(end), -radius * StrictMath.sin(end)};
      }
      left -= arc;
      y = centre + radius * StrictMath.cos(angle + arc);
      v = belt;
      if (Math.abs(y) < 1) {
        return stuck(y, belt, left);
      }
      centre = -centre;
    }
  }

  private static double[] stuck(double y, double belt, double left) {
    double loose = left - (1 - y) / belt;
    return loose <= 0
        ? new double[] {y + belt * left, belt}
        : new double[] {1 + belt * StrictMath.sin(loose), belt * StrictMath.cos(loose)};
  }
}

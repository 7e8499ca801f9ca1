package org.mechservice.sim.equations.kinematics;

import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.step.EulerParameterTerms;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * The kinematic equations: q' = v, and e' = ½ (0, ω) ∘ e for Euler parameters
 * (docs/theory/motion.md#positions).
 */
public final class PositionRates {
  private final Program program;
  private final Links mechanism;
  private final Coordinates coordinates;

  public PositionRates(Program program, Links mechanism, Coordinates coordinates) {
    this.program = program;
    this.mechanism = mechanism;
    this.coordinates = coordinates;
  }

  /** Receives the rate of a position of the state. */
  public interface Taker {
    void take(int position, Scalar rate);
  }

  /** Outputs the rates in their own section. */
  public void putOut() {
    each(program::output);
  }

  /** Derives the rates in their own section and passes them to a receiver. */
  public void each(Taker taker) {
    boolean balls = false;
    for (Link link : mechanism.links()) {
      balls |= link.isBall() && !link.isDriven();
    }
    program.section(balls ? "q' = v, e' = (0, v) e / 2" : "q' = v", "q");
    for (Link link : mechanism.links()) {
      if (link.isDriven()) {
        continue;
      }
      if (link.isBall()) {
        EulerParameterTerms rate =
            coordinates.eulerParameters(link).rate(coordinates.ballVelocity(link));
        for (int i = 0; i < 4; i++) {
          taker.take(link.position() + i, rate.at(i));
        }
      } else {
        taker.take(link.position(), coordinates.velocity(link));
      }
    }
  }
}

package org.mechservice.sim.equations.kinematics;

import org.mechservice.solver.links.Link;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * Outputs accelerations or forces of the links' degrees of freedom at the indices of their
 * velocities in the state.
 */
public final class JointOutputs {
  private final Links mechanism;
  private final Coordinates coordinates;

  public JointOutputs(Links mechanism, Coordinates coordinates) {
    this.mechanism = mechanism;
    this.coordinates = coordinates;
  }

  /**
   * Outputs the values.
   *
   * @param ofLink values of each link's degrees of freedom, by axis
   */
  public void putOut(ScalarVector[] ofLink, Program program) {
    putOut(ofLink, program, 0);
  }

  /** Outputs the values, with all indices increased by {@code shift}. */
  public void putOut(ScalarVector[] ofLink, Program program, int shift) {
    for (int i = 0; i < ofLink.length; i++) {
      Link link = mechanism.links().get(i);
      if (link.isDriven()) {
        continue;
      }
      if (link.isBall()) {
        ScalarVector values = coordinates.ballToState(link, ofLink[i]);
        for (int k = 0; k < 3; k++) {
          program.output(shift + link.velocity() + k, values.at(k));
        }
      } else {
        program.output(shift + link.velocity(), ofLink[i].z());
      }
    }
  }
}

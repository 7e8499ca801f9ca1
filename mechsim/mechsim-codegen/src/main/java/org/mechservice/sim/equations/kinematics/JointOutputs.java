package org.mechservice.sim.equations.kinematics;

import org.mechservice.sim.equations.links.Link;
import org.mechservice.sim.equations.links.Links;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.ScalarVector;

/** Puts accelerations or forces of the links' freedoms out where the state has their velocities. */
public final class JointOutputs {
  private final Links mechanism;
  private final Coordinates coordinates;

  public JointOutputs(Links mechanism, Coordinates coordinates) {
    this.mechanism = mechanism;
    this.coordinates = coordinates;
  }

  /**
   * Puts the values out.
   *
   * @param ofLink of each link the values of its freedoms, at the axes they have
   */
  public void putOut(ScalarVector[] ofLink, Program program) {
    putOut(ofLink, program, 0);
  }

  /** The same, all places moved by {@code shift}. */
  public void putOut(ScalarVector[] ofLink, Program program, int shift) {
    for (int i = 0; i < ofLink.length; i++) {
      Link link = mechanism.links().get(i);
      if (link.isBall()) {
        ScalarVector values = coordinates.ballToState(link, ofLink[i]);
        for (int k = 0; k < 3; k++) {
          program.output(shift + link.velocity() + k, values.at(k));
        }
      } else if (!link.isDriven()) {
        program.output(shift + link.velocity(), ofLink[i].z());
      }
    }
  }
}

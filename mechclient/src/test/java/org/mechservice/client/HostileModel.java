package org.mechservice.client;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.RunSettings;

/** A model that a hostile server makes: it acts as soon as it is loaded. */
public final class HostileModel implements Model {
  static final String DONE = "org.mechservice.client.hostile";

  static {
    System.setProperty(DONE, "yes");
  }

  @Override
  public ModelDescription description() {
    return new ModelDescription(
        "hostile",
        "DTR",
        List.of(new JointVariables("j", JointType.R)),
        new RunSettings(0, 24, 1, "ode113", 1e-3, 1e-3));
  }

  @Override
  public void initialState(double[] y) {
    y[0] = 0;
  }
}

package org.mechservice.client;

import java.util.List;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.RunSettings;

/** A model that uses nothing which is not allowed, and too much of it. */
public final class GreedyModel implements Model {
  @Override
  public ModelDescription description() {
    long[] more = new long[Integer.MAX_VALUE - 8];
    return new ModelDescription(
        "greedy",
        "DTR",
        List.of(new JointVariables("j", JointType.R)),
        new RunSettings(0, more.length, 1, "ode113", 1e-3, 1e-3));
  }

  @Override
  public void initialState(double[] y) {
    y[0] = 0;
  }
}

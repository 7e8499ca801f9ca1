package org.mechservice.solver.simulation;

import java.io.IOException;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.Solver;

/** Runs a model from start to end and puts out its rows. */
public final class Simulation implements Solver {
  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    throw new UnsupportedOperationException();
  }
}

package org.mechservice.sim.service;

import java.io.IOException;
import java.util.Optional;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.ResultSink;
import org.mechservice.solver.api.RunControl;
import org.mechservice.solver.api.RunReport;
import org.mechservice.solver.api.RunRequest;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.Solver;

/**
 * Computes in this process.
 *
 * @param solver integrates
 * @param model used by this run alone
 * @param request what is wanted
 * @param checkpoints of the run
 */
record ModelRun(Solver solver, Model model, RunRequest request, RunCheckpoints checkpoints)
    implements RunTask {
  @Override
  public ModelDescription description() {
    return model.description();
  }

  @Override
  public RunSettings settings() {
    return request.settings();
  }

  @Override
  public void initialState(double[] y) {
    model.initialState(y);
  }

  @Override
  public Optional<RunCheckpoints> checkpointsOfRun() {
    return Optional.of(checkpoints);
  }

  @Override
  public RunReport run(ResultSink sink, RunControl control) throws IOException {
    return solver.run(model, request, sink, control, checkpoints);
  }
}

package org.mechservice.client;

import java.io.IOException;
import java.util.List;
import java.util.OptionalDouble;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.Solver;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.api.run.RunControl;
import org.mechservice.solver.api.run.RunReport;
import org.mechservice.solver.api.run.RunRequest;

/** Puts out t and t²; tells in the report which loader it came from. */
public final class SquareSolver implements Solver {
  @Override
  public RunReport run(Model model, RunRequest request, ResultSink sink, RunControl control)
      throws IOException {
    sink.begin(List.of(new Variable("t", "s"), new Variable("j.q", "rad")));
    for (int t = 0; t <= request.settings().tEnd(); t++) {
      sink.row(new double[] {t, (double) t * t});
    }
    return new RunReport(
        new Outcome.Completed(),
        model.description().name(),
        "DTR",
        request.settings(),
        1,
        0,
        1,
        25,
        24,
        0.1,
        OptionalDouble.empty(),
        OptionalDouble.empty(),
        false,
        String.valueOf(getClass().getClassLoader().getName()));
  }
}

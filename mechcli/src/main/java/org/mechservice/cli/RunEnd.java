package org.mechservice.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.client.RunResult;
import org.mechservice.solver.api.Outcome;
import org.mechservice.solver.standalone.JsonText;
import org.mechservice.solver.standalone.ReportText;

/**
 * What a command does with a run that has come to its end: it keeps the rows, prints the report and
 * tells the shell.
 *
 * @param out for the report
 * @param err for messages
 * @param json whether the report is one JSON object
 * @param quiet whether nothing but messages is printed
 */
record RunEnd(PrintWriter out, PrintWriter err, boolean json, boolean quiet) {
  /**
   * Keeps the rows of a run, prints its report and says why it ended if it did not reach the end.
   *
   * @return exit status
   */
  int tell(RunResult result, ResultFiles files) throws IOException {
    Map<String, Object> report = new LinkedHashMap<>(result.report());
    if (files.rows() > 0) {
      files.keep().ifPresent(hash -> report.put("resultsSha256", hash));
    }
    if (json) {
      out.println(JsonText.write(report));
    } else if (!quiet) {
      out.print(ReportText.format(report));
    }
    // Now: after an interrupt the process ends as soon as the run is closed.
    out.flush();
    return status(result.outcome(), files);
  }

  private int status(Outcome outcome, ResultFiles files) {
    if (outcome instanceof Outcome.Failed failed) {
      err.println(failed.failure().message() + files.whereRowsAre());
      return ExitStatus.SIMULATION_FAILED;
    } else if (outcome instanceof Outcome.Stopped) {
      err.println("S-045 stopped on request at " + files.reached() + "." + files.whereRowsAre());
      return ExitStatus.INTERRUPTED;
    }
    return ExitStatus.DONE;
  }

  /** Keeps the rows that came before a run was lost, and says where. */
  static String keptRows(ResultFiles files) throws IOException {
    boolean kept = files.rows() > 0 && files.keep().isPresent();
    return kept ? "; rows up to " + files.reached() + " are in " + files : "";
  }
}

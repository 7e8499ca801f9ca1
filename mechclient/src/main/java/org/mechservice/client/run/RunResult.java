package org.mechservice.client.run;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.solver.api.run.Outcome;

/**
 * Outcome and report of a run.
 *
 * @param outcome completed, stopped on request, or failed; the rows up to then are valid
 * @param report the run report as ordered key and value pairs, values being {@link String}, {@link
 *     Long}, {@link Double} or {@link Boolean}; times in s, sizes in bytes, energies in J
 */
public record RunResult(Outcome outcome, Map<String, Object> report) {
  public RunResult {
    report = Collections.unmodifiableMap(new LinkedHashMap<>(report));
  }
}

package org.mechservice.sim.service.run;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.sim.service.results.RunColumns;
import org.mechservice.sim.service.results.RunIdentity;

/**
 * A run that a client has requested.
 *
 * @param identity its names and its owner
 * @param task computes it
 * @param columns of its rows
 * @param setUp entries of the run report about the set-up: the model's SHA-256, why this
 *     formulation, set-up times; in the order of the report
 */
public record RunPlan(
    RunIdentity identity, RunTask task, RunColumns columns, Map<String, Object> setUp) {
  public RunPlan {
    setUp = Collections.unmodifiableMap(new LinkedHashMap<>(setUp));
  }
}

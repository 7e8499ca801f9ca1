package org.mechservice.study;

import java.io.IOException;
import java.util.Map;

/** Runs points: a model in this process, or one on hosts. */
@FunctionalInterface
public interface PointEvaluation {
  /**
   * Runs a point. May be called by several threads.
   *
   * @param parameters values of factors by name, in the units that the model file gives them;
   *     factors that are left out keep the file's values
   * @return the values, or why there are none: a failure is no exception
   * @throws IOException if the point could not be run for reasons of its surroundings
   */
  PointOutcome run(Map<String, Double> parameters) throws IOException;
}

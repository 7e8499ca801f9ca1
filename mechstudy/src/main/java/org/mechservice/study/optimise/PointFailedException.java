package org.mechservice.study.optimise;

import java.util.ArrayList;
import java.util.List;

/** The quantities of a problem cannot be computed at one point. */
public final class PointFailedException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * Returns the failure of something at values of variables.
   *
   * @param what it is, such as the run
   */
  public static PointFailedException at(
      List<DesignVariable> variables, double[] point, String what, String why) {
    List<String> parts = new ArrayList<>();
    for (int j = 0; j < point.length; j++) {
      parts.add(variables.get(j).name() + "=" + point[j]);
    }
    return new PointFailedException(what + " at " + String.join(", ", parts) + " failed: " + why);
  }

  /**
   * @param message why, with the code of the run's failure where it has one
   */
  public PointFailedException(String message) {
    super(message);
  }
}

package org.mechservice.report.stability;

import java.util.List;
import org.mechservice.report.method.BuildRefusedException;
import org.mechservice.report.method.MethodList;

/** Builds the models of a suite with every method that fits. */
public interface SuiteBuilds {
  /**
   * A model of the suite.
   *
   * @param methods with the model built for each
   * @param warnings of the reader, in the order of the file
   */
  record Built(MethodList methods, List<String> warnings) {
    public Built {
      warnings = List.copyOf(warnings);
    }
  }

  /**
   * Builds a case's model.
   *
   * @throws BuildRefusedException if it cannot be built at all
   */
  Built build(ExtremeCase wanted) throws BuildRefusedException;
}

package org.mechservice.mechml.resolve;

import java.util.Optional;
import org.mechservice.solver.mechanism.Joint;

/** Reads joints of one type. A new type is a new reader, entered in {@link JointsReader}. */
interface JointReader {
  /**
   * Returns the joint with body1 as parent and body2 as child, as the file gives it; empty if
   * something was wrong and has been reported.
   */
  Optional<Joint> read(JointInput input);
}

package org.mechservice.sim.build;

import java.util.SortedMap;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.solver.api.Model;

/**
 * A generated model and its class files.
 *
 * @param source what it was generated from
 * @param generated its source
 * @param options what it was built for
 * @param classFiles class file bytes by binary class name; not to be modified
 */
public record CompiledModel(
    MechmlModel source,
    GeneratedModel generated,
    BuildOptions options,
    SortedMap<String, byte[]> classFiles) {

  /** Returns a new instance of the model, for one run. */
  public Model newInstance() {
    throw new UnsupportedOperationException();
  }
}

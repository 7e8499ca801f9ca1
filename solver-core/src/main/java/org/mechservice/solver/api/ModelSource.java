package org.mechservice.solver.api;

/** A class of a model JAR that makes the model instead of being it: the compact form is such. */
public interface ModelSource {
  /** Returns a new model, for one run. */
  Model model();

  /**
   * Returns the model of an instance of a JAR's model class.
   *
   * @param instance a {@link Model} or a source of one
   * @throws ClassCastException if it is neither
   */
  static Model of(Object instance) {
    return instance instanceof ModelSource source ? source.model() : (Model) instance;
  }
}

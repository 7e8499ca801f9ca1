package org.mechservice.sim.scene;

import org.mechservice.solver.catalogue.MessageCode;

/**
 * Thrown if a model cannot be built as requested; the message begins with the code of the error
 * catalogue.
 */
public final class ModelBuildException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  private final MessageCode code;

  /**
   * @param code entry of the error catalogue, such as {@code S-081}
   * @param text the problem, its reason and the remedy
   */
  public ModelBuildException(MessageCode code, String text) {
    super(code + " " + text);
    this.code = code;
  }

  /** Returns the entry of the error catalogue. */
  public MessageCode code() {
    return code;
  }
}

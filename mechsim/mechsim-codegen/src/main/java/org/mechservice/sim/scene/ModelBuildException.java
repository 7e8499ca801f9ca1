package org.mechservice.sim.scene;

import org.mechservice.solver.catalogue.MessageCode;

/**
 * A scene cannot become a model as asked; the message begins with the code of the error catalogue.
 */
public final class ModelBuildException extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  private final MessageCode code;

  /**
   * @param code entry of the error catalogue, such as {@code S-081}
   * @param text what does not fit, why, and what to do
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

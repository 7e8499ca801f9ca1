package org.mechservice.sim.scene;

import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.Origin;

/**
 * A property of a scene that its author may not have intended.
 *
 * @param code entry of the error catalogue
 * @param text the finding and the advice
 * @param origin position in the model file
 */
public record Finding(MessageCode code, String text, Origin origin) {

  /** Returns place, code and text as one line. */
  @Override
  public String toString() {
    String place = origin.toString();
    return (place.isEmpty() ? "" : place + ": ") + code + " " + text;
  }
}

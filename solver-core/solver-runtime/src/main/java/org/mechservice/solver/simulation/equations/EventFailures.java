package org.mechservice.solver.simulation.equations;

import java.util.Locale;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.catalogue.MessageCode;

/** Failures of a run after an event. */
final class EventFailures {
  private EventFailures() {}

  /** Explains an event that sets a state to a value that is not finite. */
  static Failure eventNotFinite(double t, String event, String state) {
    return atEvent(
        MessageCode.EVENT_VALUE_NOT_FINITE,
        "The event sets state \"" + state + "\" to a value that is not finite.",
        t,
        event,
        "Check the expressions it sets joints by.");
  }

  /** Explains an event after which no state closes the loops. */
  static Failure eventOpensLoops(double t, String event, Optional<Defects.Defect> why) {
    return atEvent(
        MessageCode.EVENT_BREAKS_LOOPS,
        "The loops cannot be closed with the values that the event sets.",
        t,
        why.map(defect -> event + ", " + defect.part()).orElse(event),
        "Set values that are possible for the mechanism.");
  }

  /** Explains an event that sets a state to a value that contradicts the loops. */
  static Failure eventContradictsLoops(
      double t, String event, String state, double given, double wanted) {
    return atEvent(
        MessageCode.EVENT_BREAKS_LOOPS,
        String.format(
            Locale.ROOT,
            "The loops give state \"%s\" another value, %.6g, than the event sets, %.6g.",
            state,
            given,
            wanted),
        t,
        event,
        "Set as many coordinates as the mechanism has degrees of freedom, to values that fit.");
  }

  private static Failure atEvent(
      MessageCode code, String cause, double t, String event, String advice) {
    return new Failure(code, cause, t, 0, 0, event, advice);
  }
}

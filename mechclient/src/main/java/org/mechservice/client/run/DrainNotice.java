package org.mechservice.client.run;

import java.util.Arrays;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.idl.SimEvent;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Checks whether the host of a run is being drained. It queries the host once a second, which costs
 * little; a callback could be lost.
 */
final class DrainNotice {
  /** Message code of a draining host for a run that can continue on another host. */
  private static final String MOVABLE = MessageCode.HOST_DRAINING.code();

  private static final long MILLIS_BETWEEN = 1000;
  private static final int MOST_EVENTS = 500;

  private final HostedRun place;
  private String id = "";
  private long askedAt = System.nanoTime();
  private long lastEvent;
  private boolean arrived;
  private boolean ignored;

  DrainNotice(HostedRun place) {
    this.place = place;
  }

  /**
   * Returns whether it is time to leave the host; at most once a second.
   *
   * @throws ServiceException if the host is lost
   */
  boolean isTimeToLeave() {
    if (ignored || System.nanoTime() - askedAt < MILLIS_BETWEEN * 1_000_000) {
      return false;
    }
    askedAt = System.nanoTime();
    return arrived || hasArrived();
  }

  private boolean hasArrived() {
    if (id.isEmpty()) {
      id = place.id();
    }
    for (SimEvent event :
        place.calls().read(() -> place.session().pollEvents(lastEvent, MOST_EVENTS, 0))) {
      lastEvent = event.seqNo;
      arrived |=
          event.info.simId.equals(id)
              && Arrays.stream(event.messages).anyMatch(said -> said.code.equals(MOVABLE));
    }
    return arrived;
  }

  /** Ignores all further notices: the run stays. */
  void ignore() {
    ignored = true;
  }
}

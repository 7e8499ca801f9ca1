package org.mechservice.server;

import java.time.Duration;
import org.mechservice.sim.service.HostLimits;

/**
 * What of a server only tests set otherwise.
 *
 * @param hostLease how long a host is kept without a renewal
 * @param hostCheck how often hosts are asked for their load
 * @param hostAnswer longest wait for a host's answer
 * @param limits of the server's own process
 */
record ServerTuning(
    Duration hostLease, Duration hostCheck, Duration hostAnswer, HostLimits limits) {
  /**
   * A host renews at a third of its lease; one that hangs is noticed within seconds and does not
   * hold up an administrator for longer than he would wait.
   */
  static final ServerTuning DEFAULT =
      new ServerTuning(
          Duration.ofSeconds(15), Duration.ofSeconds(3), Duration.ofSeconds(2), HostLimits.DEFAULT);
}

package org.mechservice.server;

import java.time.Duration;

/**
 * What of a server only tests set otherwise.
 *
 * @param hostLease how long a host is kept without a renewal
 * @param hostCheck how often hosts are asked for their load and what happened
 * @param hostAnswer longest wait for a host's answer
 */
record ServerTuning(Duration hostLease, Duration hostCheck, Duration hostAnswer) {
  /**
   * A host renews at a third of its lease. One that hangs is known as dead after three renewals it
   * has missed; one whose connection closes, within a second.
   */
  static final ServerTuning DEFAULT =
      new ServerTuning(Duration.ofSeconds(5), Duration.ofMillis(500), Duration.ofSeconds(2));
}

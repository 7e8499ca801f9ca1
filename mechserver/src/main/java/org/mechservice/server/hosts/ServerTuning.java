package org.mechservice.server.hosts;

import java.time.Duration;

/**
 * Settings of a server that only tests change.
 *
 * @param hostLease how long a host is kept without a renewal
 * @param hostCheck interval of requesting load and events of hosts
 * @param hostAnswer time without an answer after which a host is silent
 * @param hostWait longest wait of an administrator for the present state of a host; after it the
 *     last known state is shown
 */
public record ServerTuning(
    Duration hostLease, Duration hostCheck, Duration hostAnswer, Duration hostWait) {
  /**
   * A host renews at a third of its lease. One that hangs is known as dead after three renewals it
   * has missed; one whose connection closes, within a second.
   */
  public static final ServerTuning DEFAULT =
      new ServerTuning(
          Duration.ofSeconds(5),
          Duration.ofMillis(500),
          Duration.ofSeconds(2),
          Duration.ofMillis(500));

  /** Everybody waits for hosts until they are silent. */
  public ServerTuning(Duration hostLease, Duration hostCheck, Duration hostAnswer) {
    this(hostLease, hostCheck, hostAnswer, hostAnswer);
  }
}

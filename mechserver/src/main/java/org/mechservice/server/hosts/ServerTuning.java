package org.mechservice.server.hosts;

import java.time.Duration;

/**
 * What of a server only tests set otherwise.
 *
 * @param hostLease how long a host is kept without a renewal
 * @param hostCheck how often hosts are asked for their load and what happened
 * @param hostAnswer a host that has not answered for so long is silent
 * @param hostWait how long an administrator waits for what a host has to say now; then he is told
 *     what it said last
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

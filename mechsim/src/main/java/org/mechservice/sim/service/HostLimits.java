package org.mechservice.sim.service;

import java.time.Duration;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.MAX_MECHML_BYTES;

/**
 * What a host allows.
 *
 * @param lease how long a session lives without a call
 * @param sessions sessions at once
 * @param simulations simulations of one session at once
 * @param cursors open cursors of one simulation at once
 * @param modelBytes size of a model file
 * @param resultBytes size of one simulation's rows
 */
public record HostLimits(
    Duration lease, int sessions, int simulations, int cursors, int modelBytes, long resultBytes) {

  /**
   * The limits of a host nobody configured. A client renews at a third of the lease, so two
   * renewals may be lost; the counts keep one client from taking all memory; rows go to disk.
   */
  public static final HostLimits DEFAULT =
      new HostLimits(Duration.ofMinutes(2), 200, 64, 16, MAX_MECHML_BYTES.value, 64L << 30);

  /** Returns the same limits with another lease. */
  public HostLimits withLease(Duration other) {
    return new HostLimits(other, sessions, simulations, cursors, modelBytes, resultBytes);
  }

  /** Returns the lease in the contract's unit, at least 1 s. */
  int leaseSeconds() {
    return (int) Math.max(1, lease.toSeconds());
  }

  static void requireBelow(int limit, int present, String name, String what) throws LimitExceeded {
    if (present >= limit) {
      throw Refusal.limit(
          name, limit, present + 1L, "no more than " + limit + " " + what + " at once");
    }
  }

  /** Returns the limits as the contract lists them. */
  public Limit[] toLimits() {
    return new Limit[] {
      new Limit("lease", "s", leaseSeconds(), "a session lives this long without a call"),
      new Limit("sessions", "1", sessions, "sessions on one host at once"),
      new Limit("simulations", "1", simulations, "simulations of one session at once"),
      new Limit("cursors", "1", cursors, "open cursors of one simulation at once"),
      new Limit("modelBytes", "B", modelBytes, "size of a model file"),
      new Limit("resultBytes", "B", resultBytes, "size of the rows of one simulation")
    };
  }
}

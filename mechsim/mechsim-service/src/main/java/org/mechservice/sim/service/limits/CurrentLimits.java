package org.mechservice.sim.service.limits;

import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.Limit;

/** The limits of a host, which its operator may change while it runs. */
public final class CurrentLimits {
  private volatile HostLimits limits;

  public CurrentLimits(HostLimits atStart) {
    limits = atStart;
  }

  /** Returns the present limits. */
  public HostLimits now() {
    return limits;
  }

  /**
   * Changes some limits, all of them or none; the others stay as they are.
   *
   * @throws InvalidOption if one of them is unknown or makes no sense
   */
  public synchronized void change(Limit[] values) throws InvalidOption {
    limits = limits.with(values);
  }
}

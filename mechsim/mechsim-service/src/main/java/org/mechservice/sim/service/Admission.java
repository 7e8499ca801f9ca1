package org.mechservice.sim.service;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.Collection;
import java.util.Locale;
import java.util.function.Supplier;
import org.mechservice.idl.LimitExceeded;

/** Decides whether a host takes one more simulation. */
final class Admission {
  private static final double MEGABYTE = 1e6;

  private final LimitsInForce limits;
  private final Supplier<Collection<Session>> sessions;

  /**
   * @param sessions those of the host
   */
  Admission(LimitsInForce limits, Supplier<Collection<Session>> sessions) {
    this.limits = limits;
    this.sessions = sessions;
  }

  /**
   * Makes sure that a session, its client and the host have room.
   *
   * @throws LimitExceeded if one of them has not
   */
  void requirePlace(Session session) throws LimitExceeded {
    session.requirePlaceForSimulation();
    long ofClient =
        sessions.get().stream()
            .filter(other -> other.owner().equals(session.owner()))
            .flatMap(other -> other.runs().stream())
            .filter(run -> !run.ended())
            .count();
    limits.now().requireBelow(HostLimit.CLIENT_RUNS, ofClient);
    requireMemory();
  }

  private void requireMemory() throws LimitExceeded {
    long most = limits.now().bound(HostLimit.MEMORY);
    long used = usedAfterCollection();
    if (used > most) {
      throw HostLimit.MEMORY.refusal(
          most,
          used,
          String.format(
              Locale.ROOT,
              "the host uses %.0f MB of memory and is allowed %.0f MB; try again later,"
                  + " or another host",
              used / MEGABYTE,
              most / MEGABYTE));
    }
  }

  /** Returns what was in use when unused objects were last collected: what is really needed. */
  private static long usedAfterCollection() {
    long used = 0;
    for (MemoryPoolMXBean pool : ManagementFactory.getMemoryPoolMXBeans()) {
      MemoryUsage after = pool.getCollectionUsage();
      if (pool.getType() == MemoryType.HEAP && after != null) {
        used += after.getUsed();
      }
    }
    return used;
  }
}

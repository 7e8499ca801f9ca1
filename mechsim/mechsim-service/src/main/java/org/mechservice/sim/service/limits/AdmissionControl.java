package org.mechservice.sim.service.limits;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.Locale;
import java.util.function.ToLongFunction;
import org.mechservice.idl.LimitExceeded;

/** Decides whether a host accepts one more simulation. */
public final class AdmissionControl {
  private static final double MEGABYTE = 1e6;

  private final CurrentLimits limits;
  private final ToLongFunction<String> runsOfClient;

  /**
   * @param runsOfClient counts the runs of a client that have not ended
   */
  public AdmissionControl(CurrentLimits limits, ToLongFunction<String> runsOfClient) {
    this.limits = limits;
    this.runsOfClient = runsOfClient;
  }

  /**
   * Makes sure that a session, its client and the host have room for one more simulation.
   *
   * @param client owner of the session
   * @param simulationsOfSession simulations that the session has
   * @throws LimitExceeded if one of them has no room
   */
  public void requirePlace(String client, int simulationsOfSession) throws LimitExceeded {
    limits.now().requireBelow(HostLimit.SIMULATIONS, simulationsOfSession);
    limits.now().requireBelow(HostLimit.CLIENT_RUNS, runsOfClient.applyAsLong(client));
    requireMemory();
  }

  /**
   * Makes sure that a client has room for one more model, in a session or of a simulation.
   *
   * @param others bytes of the other models in its sessions and of its simulations
   * @param bytes of the model
   * @throws LimitExceeded if it has not
   */
  public void requireModelRoom(long others, long bytes) throws LimitExceeded {
    long most = limits.now().bound(HostLimit.CLIENT_MODEL_BYTES);
    if (others + bytes > most) {
      throw HostLimit.CLIENT_MODEL_BYTES.refusal(
          most,
          others + bytes,
          "the models of your sessions and simulations would have "
              + (others + bytes)
              + " bytes; this host takes at most "
              + most
              + " of one client; end those that are no longer needed");
    }
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

  /** Returns the heap in use after the latest garbage collection, bytes. */
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

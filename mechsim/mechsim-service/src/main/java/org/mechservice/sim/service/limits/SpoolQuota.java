package org.mechservice.sim.service.limits;

import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import org.mechservice.idl.LimitExceeded;

/** The disk space of the rows of a host's runs, and its limits. */
public final class SpoolQuota {
  private static final double MEGABYTE = 1e6;

  private final CurrentLimits limits;
  private final LongSupplier freeDisk;
  private final AtomicLong used = new AtomicLong();
  private final Map<String, AtomicLong> usedByClient = new ConcurrentHashMap<>();

  /**
   * @param freeDisk returns what the disk of the rows has left, B
   */
  public SpoolQuota(CurrentLimits limits, LongSupplier freeDisk) {
    this.limits = limits;
    this.freeDisk = freeDisk;
  }

  /** Returns what the disk of the rows has left, B. */
  public long freeDisk() {
    return freeDisk.getAsLong();
  }

  /** Returns what one client has of the space. */
  public Share of(String client) {
    return new Share(usedByClient.computeIfAbsent(client, c -> new AtomicLong()));
  }

  /** The disk space of the rows of one client's runs. */
  public final class Share {
    private final AtomicLong own;

    private Share(AtomicLong own) {
      this.own = own;
    }

    /**
     * Reserves space for rows that are going to be written.
     *
     * @param more bytes
     * @param ofRun bytes the run will have then
     * @throws LimitReachedException if that is more than the run, its client or all runs may have,
     *     or the disk is nearly full
     */
    public void take(long more, long ofRun) throws LimitReachedException {
      long most = limits.now().bound(HostLimit.RESULT_BYTES);
      if (ofRun > most) {
        throw new LimitReachedException(
            HostLimit.RESULT_BYTES,
            "the rows of the run are more than the "
                + megabytes(most)
                + " this host keeps of one; make t-step larger or choose fewer columns");
      }
      long least = leastFree();
      if (least > 0 && freeDisk() - more < least) {
        throw new LimitReachedException(HostLimit.FREE_DISK, nearlyFull(freeDisk(), least));
      }
      note(more);
      long ofClient = limits.now().bound(HostLimit.CLIENT_SPOOL_BYTES);
      if (own.get() > ofClient) {
        giveBack(more);
        throw new LimitReachedException(
            HostLimit.CLIENT_SPOOL_BYTES,
            "the rows of all your runs are more than the "
                + megabytes(ofClient)
                + " this host keeps of one client; destroy runs that are no longer needed");
      }
      long all = limits.now().bound(HostLimit.SPOOL_BYTES);
      if (used.get() > all) {
        giveBack(more);
        throw new LimitReachedException(
            HostLimit.SPOOL_BYTES,
            "the rows of all runs are more than the "
                + megabytes(all)
                + " this host keeps; destroy runs that are no longer needed");
      }
    }

    /** Counts rows that are on disk already. */
    public void note(long bytes) {
      own.addAndGet(bytes);
      used.addAndGet(bytes);
    }

    /** Frees space. */
    public void giveBack(long bytes) {
      note(-bytes);
    }
  }

  /** Returns the bytes taken. */
  public long used() {
    return used.get();
  }

  /**
   * Makes sure that a run whose rows are foreseeable fits.
   *
   * @param client owner of the run
   * @param bytes what it will put out
   * @throws LimitExceeded if it does not, or the disk is nearly full
   */
  public void require(String client, double bytes, String whatToDo) throws LimitExceeded {
    HostLimits now = limits.now();
    long free = freeDisk();
    long ofRun = now.bound(HostLimit.RESULT_BYTES);
    if (bytes > ofRun) {
      throw HostLimit.RESULT_BYTES.refusal(ofRun, (long) bytes, whatToDo);
    }
    long least = leastFree();
    if (free - bytes < least) {
      throw HostLimit.FREE_DISK.refusal(least, (long) bytes, nearlyFull(free, least));
    }
    AtomicLong own = usedByClient.get(client);
    long ofClient = own == null ? 0 : own.get();
    if (bytes > now.bound(HostLimit.CLIENT_SPOOL_BYTES) - ofClient) {
      throw HostLimit.CLIENT_SPOOL_BYTES.refusal(
          now.of(HostLimit.CLIENT_SPOOL_BYTES),
          ofClient + (long) bytes,
          "the rows of this and all your other runs are more than this host keeps of one client;"
              + " destroy runs that are no longer needed, or try another host");
    }
    long left = now.bound(HostLimit.SPOOL_BYTES) - used.get();
    if (bytes > left) {
      throw HostLimit.SPOOL_BYTES.refusal(
          now.of(HostLimit.SPOOL_BYTES),
          used.get() + (long) bytes,
          "the rows of this and all other runs are more than this host keeps;"
              + " destroy runs that are no longer needed, or try another host");
    }
  }

  /** Returns the space that runs leave free, B; 0: none. */
  private long leastFree() {
    return Math.max(0, limits.now().of(HostLimit.FREE_DISK));
  }

  private static String nearlyFull(long free, long least) {
    return "the disk for the rows of this host has "
        + megabytes(free)
        + " left, and with the rows of this run it would have less than the "
        + megabytes(least)
        + " that stay free; destroy runs that are no longer needed, or try another host";
  }

  private static String megabytes(long bytes) {
    return String.format(Locale.ROOT, "%.1f MB", bytes / MEGABYTE);
  }
}

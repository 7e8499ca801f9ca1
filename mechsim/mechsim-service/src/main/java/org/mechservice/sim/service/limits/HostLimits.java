package org.mechservice.sim.service.limits;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.Limit;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.solver.catalogue.MessageCode;

/** The values of all limits of a host. Immutable. */
public final class HostLimits {
  /** The value of a limit that is not set. */
  public static final long UNLIMITED = -1;

  /** Limits that protect the host from dead and hostile clients. */
  private static final Set<HostLimit> NEVER_UNLIMITED =
      Set.of(HostLimit.LEASE, HostLimit.CONNECTIONS, HostLimit.MODEL_BYTES);

  /** The default limits. */
  public static final HostLimits DEFAULT = new HostLimits(new EnumMap<>(HostLimit.class));

  /** The limits of a process that computes for the user who started it, and ends with it. */
  public static final HostLimits OWN =
      DEFAULT
          .with(HostLimit.WALL_TIME, UNLIMITED)
          .with(HostLimit.CPU_TIME, UNLIMITED)
          .with(HostLimit.RESULT_BYTES, UNLIMITED)
          .with(HostLimit.CLIENT_SESSIONS, UNLIMITED)
          .with(HostLimit.CLIENT_BUILDS, UNLIMITED)
          .with(HostLimit.SET_UP_TIME, UNLIMITED)
          .with(HostLimit.SET_UP_MEMORY, UNLIMITED)
          .with(HostLimit.MODEL_LOOPS, UNLIMITED)
          .with(HostLimit.CLIENT_MODEL_BYTES, UNLIMITED)
          .with(HostLimit.CLIENT_SPOOL_BYTES, UNLIMITED)
          .with(HostLimit.CLIENT_KEPT, UNLIMITED)
          .with(HostLimit.SPOOL_BYTES, UNLIMITED)
          .with(HostLimit.FREE_DISK, 0)
          .with(HostLimit.MEMORY, UNLIMITED)
          .with(HostLimit.WORKER_MEMORY, UNLIMITED);

  private static final int RESERVED_CONNECTIONS = 20;

  /** Time within which a host notices that a run has used up its processor time, s. */
  private static final int GRACE = 30;

  private final Map<HostLimit, Long> changed;

  private HostLimits(Map<HostLimit, Long> changed) {
    this.changed = changed;
  }

  /** Returns the value of a limit, or {@link #UNLIMITED}. */
  public long of(HostLimit limit) {
    return changed.getOrDefault(limit, limit.initial());
  }

  /** Returns the value of a limit, or the largest number there is. */
  public long bound(HostLimit limit) {
    long value = of(limit);
    return value == UNLIMITED ? Long.MAX_VALUE : value;
  }

  /** Returns what a process for classes of users may use at most. */
  public WorkerBounds ofWorker() {
    long ofHost = changed.getOrDefault(HostLimit.MEMORY, UNLIMITED);
    long heap = bound(HostLimit.WORKER_MEMORY);
    if (ofHost != UNLIMITED) {
      heap = Math.min(heap, ofHost);
    }
    long cpu = of(HostLimit.CPU_TIME);
    // The kernel ends a worker only if its host has not.
    return new WorkerBounds(
        heap == Long.MAX_VALUE ? UNLIMITED : heap, cpu == UNLIMITED ? UNLIMITED : cpu + GRACE);
  }

  /** Returns the lease in the contract's unit. */
  public int leaseSeconds() {
    return (int) Math.min(of(HostLimit.LEASE), Integer.MAX_VALUE);
  }

  /**
   * Returns the number of connections allowed including those reserved for operators and hosts, who
   * must connect when clients have used up their own.
   */
  public int connectionsAtAll() {
    return (int) Math.min(of(HostLimit.CONNECTIONS) + RESERVED_CONNECTIONS, Integer.MAX_VALUE);
  }

  /**
   * Returns the same limits but one.
   *
   * @throws IllegalArgumentException with code S-015 if the value makes no sense
   */
  public HostLimits with(HostLimit limit, long value) {
    boolean unlimited = value == UNLIMITED && !NEVER_UNLIMITED.contains(limit);
    if (value < limit.least() && !unlimited) {
      throw new IllegalArgumentException(
          MessageCode.LIMIT_VALUE
              + " limit "
              + limit.label()
              + " cannot be "
              + value
              + "; it must be at least "
              + limit.least()
              + (limit.unit().equals("1") ? "" : " " + limit.unit())
              + (NEVER_UNLIMITED.contains(limit) ? "" : ", or -1 for unlimited"));
    }
    Map<HostLimit, Long> all = new EnumMap<>(HostLimit.class);
    all.putAll(changed);
    all.put(limit, value);
    return new HostLimits(all);
  }

  /**
   * Returns the same limits but some, given by name.
   *
   * @throws IllegalArgumentException with code S-015 if there is no such limit, or a value makes no
   *     sense
   */
  public HostLimits with(String label, long value) {
    return with(
        HostLimit.named(label)
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        MessageCode.LIMIT_VALUE
                            + " there is no limit \""
                            + label
                            + "\"; there are "
                            + Arrays.stream(HostLimit.values())
                                .map(HostLimit::label)
                                .collect(Collectors.joining(", ")))),
        value);
  }

  /**
   * Returns the same limits but those an operator sends.
   *
   * @throws InvalidOption if one of them is unknown or makes no sense
   */
  public HostLimits with(Limit[] values) throws InvalidOption {
    HostLimits limits = this;
    for (Limit limit : values) {
      try {
        limits = limits.with(limit.name, limit.value);
      } catch (IllegalArgumentException e) {
        throw new InvalidOption(
            MessageCode.LIMIT_VALUE.code(),
            String.valueOf(e.getMessage()).substring(6),
            limit.name);
      }
    }
    return limits;
  }

  /**
   * Makes sure that there is room for one more.
   *
   * @throws LimitExceeded if there is not
   */
  public void requireBelow(HostLimit limit, long present) throws LimitExceeded {
    if (present >= bound(limit)) {
      throw limit.refusal(of(limit), present + 1, "no more than " + of(limit) + " " + limit.text());
    }
  }

  /** Returns the limits as the contract lists them. */
  public Limit[] toLimits() {
    return Arrays.stream(HostLimit.values())
        .map(limit -> new Limit(limit.label(), limit.unit(), of(limit), limit.text()))
        .toArray(Limit[]::new);
  }
}

package org.mechservice.sim.host;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.function.LongSupplier;

/**
 * The load of the processors: of the whole machine, and by this process. Both are means over an
 * interval of at least {@value #INTERVAL_SECONDS} s, however often they are asked for; over shorter
 * ones the system counts nothing or one full tick.
 */
final class MachineLoad {
  static final int INTERVAL_SECONDS = 2;

  /** The source of the counts. */
  interface Source {
    /**
     * Returns the share of the machine's processors in use since this was last asked, 0 to 1;
     * negative if it is not known.
     */
    double machineSinceLastAsked();

    /** Returns the processor time of this process since its start, ns. */
    long processNanos();
  }

  /**
   * Shares of the machine's processors, 0 to 1.
   *
   * @param machine in use by all
   * @param process in use by this process
   */
  record Sample(double machine, double process) {}

  /** The system counts for the whole process, so that there is one for all hosts in it. */
  private static final class OfThisMachine {
    static final MachineLoad SAMPLED =
        new MachineLoad(source(), System::nanoTime, Runtime.getRuntime().availableProcessors());
  }

  private final Source source;
  private final LongSupplier clock;
  private final int processors;
  private long sampledAt;
  private long processNanos;
  private Sample latest = new Sample(0, 0);

  /**
   * @param clock time in ns
   */
  MachineLoad(Source source, LongSupplier clock, int processors) {
    this.source = source;
    this.clock = clock;
    this.processors = processors;
    sampledAt = clock.getAsLong();
    processNanos = source.processNanos();
    source.machineSinceLastAsked();
  }

  /** Returns that of this machine; counts from the first call on. */
  static MachineLoad ofThisMachine() {
    return OfThisMachine.SAMPLED;
  }

  /** Returns the latest means; 0 until the first interval is over. */
  synchronized Sample now() {
    long now = clock.getAsLong();
    long passed = now - sampledAt;
    if (passed >= Duration.ofSeconds(INTERVAL_SECONDS).toNanos()) {
      long used = source.processNanos();
      double process = (double) (used - processNanos) / passed / processors;
      double machine = source.machineSinceLastAsked();
      sampledAt = now;
      processNanos = used;
      double own = Math.min(1, Math.max(0, process));
      // What is not known is at least what this process uses.
      latest = new Sample(Double.isNaN(machine) || machine < 0 ? own : Math.min(1, machine), own);
    }
    return latest;
  }

  private static Source source() {
    try {
      if (ManagementFactory.getOperatingSystemMXBean() instanceof OperatingSystemMXBean system) {
        return new Counted(system);
      }
    } catch (NoClassDefFoundError e) {
      // A Java reduced to what it needs may lack the module jdk.management.
      return new Estimated();
    }
    return new Estimated();
  }

  /** The counts of the system. */
  private record Counted(OperatingSystemMXBean system) implements Source {
    @Override
    public double machineSinceLastAsked() {
      return system.getCpuLoad();
    }

    @Override
    public long processNanos() {
      return system.getProcessCpuTime();
    }
  }

  /** The figures that every Java has: the number of waiting processes, and the time of this one. */
  private static final class Estimated implements Source {
    @Override
    public double machineSinceLastAsked() {
      var system = ManagementFactory.getOperatingSystemMXBean();
      return system.getSystemLoadAverage() / system.getAvailableProcessors();
    }

    @Override
    public long processNanos() {
      return ProcessHandle.current().info().totalCpuDuration().map(Duration::toNanos).orElse(0L);
    }
  }
}

package org.mechservice.admin.live;

import org.mechservice.idl.HostLoad;

/**
 * The load of a host at one time.
 *
 * @param at when; UTC, ms since 1970-01-01
 * @param cpuLoad share of the machine's processors in use, 0 to 1
 * @param memoryUsed memory the process used, bytes
 * @param running simulations that ran
 * @param queued simulations that waited
 */
public record LoadSample(long at, double cpuLoad, long memoryUsed, int running, int queued) {
  static LoadSample of(HostLoad load, long at) {
    return new LoadSample(at, load.cpuLoad, load.memoryUsed, load.running, load.queued);
  }
}

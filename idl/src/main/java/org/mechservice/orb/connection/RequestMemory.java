package org.mechservice.orb.connection;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The memory of an ORB for large messages that are still arriving. The ORB takes memory for a
 * message as soon as its header announces the length; peers that announce much and send little
 * would take all of it. If the memory does not suffice, the connection that has sent nothing for a
 * while is closed; if there is none, the new message is refused.
 */
final class RequestMemory {
  private static final long STALLED_NANOS = 2_000_000_000;

  private final long size;
  private final Map<RequestStream, Long> arriving = new HashMap<>();
  private long used;

  RequestMemory() {
    this(Runtime.getRuntime().maxMemory() / 4);
  }

  /**
   * @param size bytes that may be in use
   */
  RequestMemory(long size) {
    this.size = size;
  }

  /** Takes room for a message; returns whether there is some. One message always has room. */
  boolean take(RequestStream stream, long bytes) {
    while (true) {
      Optional<RequestStream> inTheWay;
      synchronized (this) {
        if (used == 0 || used + bytes <= size) {
          used += bytes;
          arriving.merge(stream, bytes, Long::sum);
          return true;
        }
        inTheWay =
            arriving.keySet().stream()
                .filter(other -> other.stalledNanos() > STALLED_NANOS)
                .max(Comparator.comparingLong(RequestStream::stalledNanos));
      }
      if (inTheWay.isEmpty()) {
        return false;
      }
      inTheWay.get().abandon(); // which gives its room back
    }
  }

  synchronized void giveBack(RequestStream stream, long bytes) {
    used -= bytes;
    arriving.computeIfPresent(stream, (s, all) -> all > bytes ? all - bytes : null);
  }

  synchronized long used() {
    return used;
  }
}

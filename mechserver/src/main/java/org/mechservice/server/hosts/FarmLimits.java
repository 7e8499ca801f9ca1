package org.mechservice.server.hosts;

import java.util.LinkedHashMap;
import java.util.Map;
import org.mechservice.idl.InvalidOption;
import org.mechservice.idl.Limit;
import org.mechservice.sim.service.limits.CurrentLimits;
import org.mechservice.sim.service.limits.HostLimits;

/**
 * The limits of a server and of all its hosts. A limit that an operator sets for all of them also
 * applies to hosts that join later, which otherwise have limits of their own.
 */
public final class FarmLimits {
  private final CurrentLimits own;
  private final HostDirectory directory;
  private final Map<String, Limit> set = new LinkedHashMap<>();

  /**
   * @param own limits of the server's own process
   */
  public FarmLimits(CurrentLimits own, HostDirectory directory) {
    this.own = own;
    this.directory = directory;
  }

  public HostLimits inForce() {
    return own.now();
  }

  /**
   * Sets limits everywhere; on a host that does not answer now, as soon as it does.
   *
   * @throws InvalidOption if one of them is unknown or makes no sense; none is set then
   */
  public void change(Limit[] values) throws InvalidOption {
    own.change(values);
    synchronized (set) {
      for (Limit limit : values) {
        set.put(limit.name, limit);
      }
    }
    directory.callAll(
        host -> {
          host.setLimits(values);
          return true;
        });
  }

  /** Sets on a host that has joined what was set everywhere before. */
  void joined(RegisteredHost host) {
    Limit[] values;
    synchronized (set) {
      values = set.values().toArray(Limit[]::new);
    }
    if (values.length > 0) {
      var unused =
          directory
              .calls()
              .query(
                  host.host(),
                  joined -> {
                    joined.setLimits(values);
                    return true;
                  });
    }
  }
}

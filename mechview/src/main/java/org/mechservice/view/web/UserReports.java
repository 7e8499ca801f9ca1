package org.mechservice.view.web;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.client.MechConnection;
import org.mechservice.orb.http.AccessToken;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The latest reports of all users, by ids that cannot be guessed. One is made at a time: two would
 * disturb each other's times.
 */
final class UserReports implements AutoCloseable {
  private static final int MOST_KEPT = 20;

  private final MechConnection service;
  private final ModelExports exports;
  private final Map<String, UserReport> all = new LinkedHashMap<>();

  UserReports(MechConnection service, ModelExports exports) {
    this.service = service;
    this.exports = exports;
  }

  /**
   * Starts a measurement.
   *
   * @param model MechML text's bytes
   * @return its identity
   */
  synchronized String start(byte[] model) throws IOException {
    if (all.values().stream().anyMatch(one -> !one.hasEnded())) {
      throw new RefusedRequestException(
          503,
          MessageCode.TOO_MANY_PAGES
              + " methods of another model are being measured, and two reports would disturb"
              + " each other; try again when it has ended");
    }
    if (all.size() >= MOST_KEPT) {
      all.remove(all.keySet().iterator().next()).close();
    }
    String id = AccessToken.random();
    all.put(id, new UserReport(service, exports, model));
    return id;
  }

  /**
   * Returns a measurement.
   *
   * @throws RefusedRequestException if there is none, or it is no longer kept
   */
  synchronized UserReport get(String id) {
    UserReport one = all.get(id);
    if (one == null) {
      throw new RefusedRequestException(
          404,
          MessageCode.REQUEST_UNUSABLE
              + " the request cannot be used: the report is no longer kept; measure again");
    }
    return one;
  }

  @Override
  public void close() {
    List<UserReport> open;
    synchronized (this) {
      open = List.copyOf(all.values());
      all.clear();
    }
    open.forEach(UserReport::close);
  }
}

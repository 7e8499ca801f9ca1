package org.mechservice.view.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.client.MechConnection;
import org.mechservice.orb.http.AccessToken;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.solver.catalogue.MessageCode;

/** The latest runs of all users, by ids that cannot be guessed. */
final class UserRuns implements AutoCloseable {
  private static final int MOST_ACTIVE = 32;
  private static final int MOST_KEPT = 100;

  private final MechConnection service;
  private final Map<String, UserRun> runs = new LinkedHashMap<>();

  UserRuns(MechConnection service) {
    this.service = service;
  }

  /**
   * Starts a run.
   *
   * @return its identity
   */
  synchronized String start(UserRun.Order order) throws IOException {
    if (runs.values().stream().filter(run -> !run.hasEnded()).count() >= MOST_ACTIVE) {
      throw new RefusedRequestException(
          503,
          MessageCode.TOO_MANY_PAGES
              + " more than "
              + MOST_ACTIVE
              + " runs of this page go on already; wait for one to end or cancel one");
    }
    while (runs.size() >= MOST_KEPT) {
      String oldest =
          runs.entrySet().stream()
              .filter(run -> run.getValue().hasEnded())
              .findFirst()
              .orElseThrow()
              .getKey();
      runs.remove(oldest).close();
    }
    UserRun run = new UserRun(order, Files.createTempDirectory("mechweb"));
    String id = AccessToken.random();
    runs.put(id, run);
    Thread thread = new Thread(() -> run.run(service), "mechservice-user-run");
    thread.setDaemon(true);
    thread.start();
    return id;
  }

  /**
   * Returns a run.
   *
   * @throws RefusedRequestException if there is none, or it is no longer kept
   */
  synchronized UserRun get(String id) {
    UserRun run = runs.get(id);
    if (run == null) {
      throw new RefusedRequestException(
          404,
          MessageCode.REQUEST_UNUSABLE
              + " the request cannot be used: the run is no longer kept; run it again");
    }
    return run;
  }

  /** Returns identities and titles of the runs that are kept, in the order of their starts. */
  synchronized JsonObject list() {
    JsonArray all = new JsonArray();
    runs.forEach(
        (id, run) -> {
          JsonObject one = new JsonObject();
          one.addProperty("run", id);
          one.addProperty("title", run.title());
          all.add(one);
        });
    JsonObject list = new JsonObject();
    list.add("runs", all);
    return list;
  }

  @Override
  public void close() {
    List<UserRun> all;
    synchronized (this) {
      all = List.copyOf(runs.values());
      runs.clear();
    }
    all.forEach(UserRun::close);
  }
}

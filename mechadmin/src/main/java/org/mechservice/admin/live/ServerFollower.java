package org.mechservice.admin.live;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.AdminFailure;
import org.mechservice.admin.ServerReading;
import org.mechservice.idl.ServiceEvent;

/**
 * Follows one server: reads its state after each event, at most five times and at least twice a
 * second.
 */
final class ServerFollower implements Runnable {
  private static final int EVENT_WAIT_MILLIS = 400;
  private static final long SHORTEST_PERIOD_NANOS = TimeUnit.MILLISECONDS.toNanos(200);
  private static final long SILENT_PAUSE_NANOS = TimeUnit.SECONDS.toNanos(1);
  private static final int EVENTS_AT_ONCE = 1000;

  private final AdminConsole console;
  private final String server;
  private final LiveView view;
  private final Thread thread;
  private long lastEvent;
  private long startedAt;

  ServerFollower(AdminConsole console, String server, LiveView view) {
    this.console = console;
    this.server = server;
    this.view = view;
    thread = new Thread(this, "mechservice-admin-follower");
    thread.setDaemon(true);
  }

  void start() {
    thread.start();
  }

  @Override
  public void run() {
    try {
      while (!Thread.currentThread().isInterrupted()) {
        long began = System.nanoTime();
        ServerReading reading = console.read(server);
        view.took(reading);
        boolean answers =
            reading instanceof ServerReading.Answering answering && awaitEvent(answering);
        long period = answers ? SHORTEST_PERIOD_NANOS : SILENT_PAUSE_NANOS;
        TimeUnit.NANOSECONDS.sleep(period - (System.nanoTime() - began));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Waits a moment for something to happen; returns whether the server answered. */
  private boolean awaitEvent(ServerReading.Answering reading) {
    if (reading.status().info.startedAt != startedAt) {
      startedAt = reading.status().info.startedAt;
      lastEvent = 0; // a server that was started anew counts from one again
    }
    try {
      List<ServiceEvent> happened;
      int wait = EVENT_WAIT_MILLIS;
      do {
        happened = console.events(server, lastEvent, EVENTS_AT_ONCE, wait);
        view.record(server, happened);
        wait = 0;
        if (!happened.isEmpty()) {
          lastEvent = happened.get(happened.size() - 1).seqNo;
        }
      } while (happened.size() == EVENTS_AT_ONCE);
      return true;
    } catch (AdminFailure e) {
      return false; // the next reading says why
    }
  }

  void close() {
    thread.interrupt();
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}

package org.mechservice.admin.watch;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.jline.keymap.BindingReader;
import org.jline.keymap.KeyMap;
import org.jline.terminal.Attributes;
import org.jline.terminal.Terminal;
import org.jline.utils.Display;
import org.jline.utils.InfoCmp.Capability;
import org.jline.utils.NonBlockingReader;
import org.mechservice.admin.AdminAction;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.AdminFailure;
import org.mechservice.admin.DetailText;
import org.mechservice.admin.KnownSimulation;
import org.mechservice.admin.ServerReading;
import org.mechservice.admin.live.LiveView;

/**
 * Shows servers, hosts and simulations as they are, over the whole screen of a terminal, until the
 * operator quits. What is asked of a server is asked aside, so that keys always answer.
 */
public final class Watch {
  private static final long REFRESH_MILLIS = 250;
  private static final int SMALLEST_WIDTH = 40;
  private static final int SMALLEST_HEIGHT = 8;

  private final AdminConsole console;
  private final Terminal terminal;
  private final Display display;
  private final WatchState state = new WatchState();
  private final ConcurrentLinkedQueue<Runnable> answers = new ConcurrentLinkedQueue<>();
  private final ExecutorService aside =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "mechservice-admin-watch");
            thread.setDaemon(true);
            return thread;
          });

  /**
   * @param console whose servers are shown; stays open
   * @param terminal a terminal that can place its cursor; stays open
   */
  public Watch(AdminConsole console, Terminal terminal) {
    this.console = console;
    this.terminal = terminal;
    display = new Display(terminal, true);
  }

  /** Shows until the operator ends it, or the terminal goes away. */
  public void run() {
    Attributes before = terminal.enterRawMode();
    terminal.puts(Capability.enter_ca_mode);
    terminal.puts(Capability.keypad_xmit);
    terminal.puts(Capability.cursor_invisible);
    try (LiveView view = new LiveView(console)) {
      follow(view);
    } finally {
      aside.shutdownNow();
      terminal.puts(Capability.cursor_normal);
      terminal.puts(Capability.keypad_local);
      terminal.puts(Capability.exit_ca_mode);
      terminal.flush();
      terminal.setAttributes(before);
    }
  }

  private void follow(LiveView view) {
    KeyMap<WatchKey> keys = WatchKey.of(terminal);
    BindingReader reader = new BindingReader(terminal.reader());
    while (true) {
      List<ServerReading> readings = view.readings();
      draw(readings);
      int next = reader.peekCharacter(REFRESH_MILLIS);
      for (Runnable answer = answers.poll(); answer != null; answer = answers.poll()) {
        answer.run();
      }
      if (next == NonBlockingReader.EOF) {
        return;
      } else if (next != NonBlockingReader.READ_EXPIRED) {
        WatchKey key = reader.readBinding(keys);
        if (key == null || press(key, state.listed(readings))) {
          return;
        }
      }
    }
  }

  private void draw(List<ServerReading> readings) {
    int width = Math.max(SMALLEST_WIDTH, terminal.getWidth());
    int height = Math.max(SMALLEST_HEIGHT, terminal.getHeight());
    display.resize(height, width);
    WatchScreen screen = new WatchScreen(width, height, Instant.now());
    display.update(new ArrayList<>(screen.lines(readings, state)), 0);
  }

  /** Returns whether the operator has seen enough. */
  private boolean press(WatchKey key, List<KnownSimulation> listed) {
    WatchState.Wish wish = state.press(key, listed);
    state
        .chosen(listed)
        .ifPresent(
            chosen -> {
              if (wish == WatchState.Wish.INSPECT) {
                inspect(chosen);
              } else if (wish == WatchState.Wish.CANCEL) {
                cancel(chosen);
              }
            });
    return wish == WatchState.Wish.QUIT;
  }

  private void inspect(KnownSimulation chosen) {
    aside(
        () -> {
          String text =
              new DetailText(Instant.now())
                  .format(console.show(chosen.server(), chosen.summary().simId));
          return () -> state.show(text);
        });
  }

  private void cancel(KnownSimulation chosen) {
    AdminAction action =
        new AdminAction.StopSimulation(chosen.summary().simId, "stopped by the operator");
    aside(
        () -> {
          console.perform(chosen.server(), action);
          return () -> state.notice("done: " + action.summary());
        });
  }

  /** Asks a server something; the answer changes the screen when it is there. */
  private interface Query {
    Runnable query();
  }

  private void aside(Query question) {
    state.notice("…");
    Future<?> unused =
        aside.submit(
            () -> {
              try {
                answers.add(question.query());
              } catch (AdminFailure failure) {
                answers.add(() -> state.notice(failure.text()));
              }
            });
  }
}

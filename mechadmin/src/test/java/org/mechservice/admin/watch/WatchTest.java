package org.mechservice.admin.watch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.jline.terminal.Size;
import org.jline.terminal.impl.ExternalTerminal;
import org.jline.utils.AttributedString;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.ScriptedAdmin;
import org.mechservice.admin.ServerReading;
import org.mechservice.idl.SimState;

/** The full screen: what it shows, and what its keys do on a terminal of its own. */
class WatchTest {
  private static final int PATIENCE = 600;
  private static final long CHECK_MILLIS = 100;

  private static ScriptedAdmin server;

  private final WatchState state = new WatchState();

  @BeforeAll
  static void start() {
    server = new ScriptedAdmin("lab");
  }

  @BeforeEach
  void script() {
    server.forget();
    server.host("big", 0.5, true, "");
    server.host("gone", 0, false, "dropped: its connection failed");
    server.simulation("aaaa-1", "big", "arm", SimState.SIM_RUNNING);
    server.simulation("bbbb-2", "big", "zebra", SimState.SIM_QUEUED);
    server.simulation("cccc-3", "big", "leg", SimState.SIM_DONE);
    server.failed("dddd-4", "big", "knee\u001b[2J", "too small");
  }

  @AfterAll
  static void end() {
    server.close();
  }

  private static List<ServerReading> readings() {
    return List.of(server.reading());
  }

  private static List<String> lines(List<ServerReading> readings, WatchState state, int height) {
    return new WatchScreen(120, height, Instant.now())
        .lines(readings, state).stream().map(AttributedString::toString).toList();
  }

  @Test
  void serversHostsAndWhatGoesOnAreShown() {
    List<String> lines = lines(readings(), state, 20);
    assertThat(lines).hasSize(20);
    assertThat(lines.get(0)).contains("servers 1 of 1 up   running 1   queued 1   failed 1");
    assertThat(lines.get(1)).contains("lab  up  " + server.address());
    assertThat(lines.get(2)).contains("big", "[######------]", "50 %", "768 MiB", "1 of 4");
    assertThat(lines.get(3)).contains("gone", "lost", "its connection failed");
    assertThat(lines).anySatisfy(line -> assertThat(line).contains("aaaa-1", "arm", "running"));
    assertThat(lines).noneSatisfy(line -> assertThat(line).contains("leg"));
    assertThat(lines.get(19)).contains("s sort: age", "f show: going on", "q quit");
  }

  @Test
  void noLineIsWiderThanTheScreenAndNoNameSteersIt() {
    state.press(WatchKey.FILTER, List.of());
    for (AttributedString line : new WatchScreen(60, 12, Instant.now()).lines(readings(), state)) {
      assertThat(line.columnLength()).isLessThanOrEqualTo(60);
      assertThat(line.toString()).doesNotContain("\u001b");
    }
    assertThat(lines(readings(), state, 20)).anySatisfy(l -> assertThat(l).contains("knee?[2J"));
  }

  @Test
  void moreServersThanFitLeaveRoomForSimulations() {
    for (int i = 0; i < 50; i++) {
      server.host("host" + i, 0, true, "");
    }
    List<String> lines = lines(readings(), state, 20);
    assertThat(lines).anySatisfy(line -> assertThat(line).contains("lines more"));
    assertThat(lines).anySatisfy(line -> assertThat(line).contains("aaaa-1"));
  }

  @Test
  void choiceStaysWithItsSimulationWhileOthersComeAndGo() {
    List<ServerReading> before = readings();
    state.press(WatchKey.LAST, state.listed(before));
    String chosen = state.chosen(state.listed(before)).orElseThrow().summary().simId;
    server.simulation("eeee-5", "big", "new", SimState.SIM_RUNNING);
    assertThat(state.chosen(state.listed(readings())).orElseThrow().summary().simId)
        .isEqualTo(chosen);
  }

  @Test
  void keysSortAndFilter() {
    List<ServerReading> readings = readings();
    assertThat(state.listed(readings))
        .extracting(k -> k.summary().simId)
        .containsExactly("bbbb-2", "aaaa-1");
    state.press(WatchKey.REVERSE, List.of());
    assertThat(state.listed(readings))
        .extracting(k -> k.summary().simId)
        .containsExactly("aaaa-1", "bbbb-2");
    state.press(WatchKey.FILTER, List.of());
    assertThat(state.listed(readings)).extracting(k -> k.summary().simId).containsExactly("dddd-4");
    state.press(WatchKey.FILTER, List.of());
    assertThat(state.listed(readings)).hasSize(4);
    for (SortOrder order : SortOrder.values()) {
      assertThat(state.sort()).isEqualTo(order);
      state.press(WatchKey.SORT, List.of());
    }
  }

  @Test
  void onlyYesCancels() {
    List<ServerReading> readings = readings();
    for (WatchKey key : WatchKey.values()) {
      state.press(WatchKey.CANCEL, state.listed(readings));
      assertThat(lines(readings, state, 20).get(19)).startsWith("Stop bbbb-2 zebra?");
      assertThat(state.press(key, state.listed(readings)))
          .isEqualTo(key == WatchKey.YES ? WatchState.Wish.CANCEL : WatchState.Wish.NOTHING);
    }
  }

  @Test
  void keysOfATerminalInspectAndCancelAndQuit() throws Exception {
    ByteArrayOutputStream seen = new ByteArrayOutputStream();
    try (PipedOutputStream keys = new PipedOutputStream();
        ExternalTerminal terminal =
            new ExternalTerminal(
                "test", "xterm", new PipedInputStream(keys), seen, StandardCharsets.UTF_8);
        AdminConsole console = new AdminConsole(List.of(server.address()), AdminConsole.PATIENCE)) {
      terminal.setSize(new Size(120, 24));
      Thread watching = new Thread(() -> new Watch(console, terminal).run());
      watching.start();
      await(() -> screen(seen).contains("zebra"));
      press(keys, "\u001b[B"); // down, to the older of the two
      press(keys, "\r");
      await(() -> screen(seen).contains("x real time"));
      press(keys, "q"); // back
      press(keys, "cy");
      await(() -> server.calls().contains("kill aaaa-1 stopped by the operator"));
      await(() -> screen(seen).contains("done: stop simulation aaaa-1"));
      press(keys, "q");
      watching.join();
    }
  }

  private static void press(PipedOutputStream keys, String text) throws IOException {
    keys.write(text.getBytes(StandardCharsets.UTF_8));
    keys.flush();
  }

  /** Everything written so far, without what places and colours it. */
  private static String screen(ByteArrayOutputStream seen) {
    return seen.toString(StandardCharsets.UTF_8).replaceAll("\u001b\\[[0-9;?]*[A-Za-z]", "");
  }

  private static void await(BooleanSupplier condition) throws InterruptedException {
    for (int i = 0; i < PATIENCE && !condition.getAsBoolean(); i++) {
      Thread.sleep(CHECK_MILLIS);
    }
    assertThat(condition.getAsBoolean()).isTrue();
  }
}

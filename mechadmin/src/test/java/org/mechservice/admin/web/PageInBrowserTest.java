package org.mechservice.admin.web;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.ScriptedAdmin;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimState;

/** The page in a real browser, against scripted servers. */
@Tag("soak")
class PageInBrowserTest {
  private static final Path PICTURES = Path.of("../docs/pictures");

  private final AccessTokens tokens = AccessTokens.random();
  private ScriptedAdmin lab;
  private ScriptedAdmin west;
  private AdminConsole console;
  private AdminWeb web;
  private final Path profile;
  private Chromium browser;

  PageInBrowserTest(@TempDir Path folder) {
    profile = folder.resolve("profile");
  }

  @BeforeEach
  void start() throws Exception {
    lab = new ScriptedAdmin("lab");
    west = new ScriptedAdmin("west");
    lab.host("lab", 0.34, true, "");
    lab.host("workshop", 0.93, true, "");
    lab.host("attic", 0.02, false, "dropped: its connection failed: nobody answers at its address");
    west.host("west", 0.11, true, "");
    String[] models = {"FiveBarPendulum", "DriverC0", "AndrewsSqueezer", "FlyballGovernor"};
    SimState[] states = {SimState.SIM_RUNNING, SimState.SIM_QUEUED, SimState.SIM_DONE};
    for (int i = 0; i < 12; i++) {
      (i % 4 == 3 ? west : lab)
          .simulation(
              "%08d-0000-4000-8000-000000000000".formatted(10_000_019 * (i + 1)),
              i % 4 == 3 ? "west" : i % 2 == 0 ? "lab" : "workshop",
              models[i % 4],
              states[i % 3]);
    }
    lab.failed(
        FAILED,
        "workshop",
        "SliderCrank",
        "t=1.5 s, h=1e-9 s: the step became too small at joint \"knee\".");
    lab.curves("10000019-0000-4000-8000-000000000000", 300);
    lab.loadOfSimulations();
    west.loadOfSimulations();
    lab.happened("server-started", Severity.SEV_INFO, "", "server lab has started");
    lab.happened("host-joined", Severity.SEV_INFO, "", "host workshop joined from 10.0.0.2:8");
    lab.happened("host-lost", Severity.SEV_WARNING, "S-019", "host attic dropped: nobody answers");
    lab.happened("sim-failed", Severity.SEV_ERROR, "N-003", "the step became too small");
    console = new AdminConsole(List.of(lab.address(), west.address()), AdminConsole.PATIENCE);
    web = new AdminWeb(console, 0, tokens, Optional.empty());
    browser = Chromium.start(profile).orElseThrow();
  }

  private static final String FAILED = "5f0c9a1e-0000-4000-8000-000000000000";

  @AfterEach
  void end() throws Exception {
    browser.close();
    web.close();
    console.close();
    lab.close();
    west.close();
  }

  @Test
  void everyViewIsPicturedOnDeskAndPhoneByDayAndNight() throws Exception {
    browser.look(1280, 900, false);
    browser.open(web.url(tokens.admin()), "true");
    browser.awaitText("FiveBarPendulum");
    browser.awaitText("host attic dropped");
    browser.screenshot(PICTURES.resolve("admin-overview.png"));
    browser.look(1280, 900, true);
    browser.screenshot(PICTURES.resolve("admin-overview-dark.png"));
    browser.look(390, 844, false);
    browser.screenshot(PICTURES.resolve("admin-overview-phone.png"));
    browser.evaluate("document.querySelector('.simulations').scrollIntoView()");
    browser.screenshot(PICTURES.resolve("admin-simulations-phone.png"));
    browser.look(1280, 900, false);
    String id = "10000019-0000-4000-8000-000000000000";
    browser.evaluate("location.hash = '#/sim/" + lab.address() + "/" + id + "'");
    browser.waitFor("document.querySelectorAll('svg .curve').length === 4");
    browser.look(1280, 900, true);
    browser.evaluate("location.hash = '#/sim/" + lab.address() + "/" + FAILED + "'");
    browser.awaitText("Try ode15s.");
    browser.screenshot(PICTURES.resolve("admin-failed-dark.png"));
    browser.look(1280, 900, false);
    browser.evaluate("location.hash = '#/host/" + lab.address() + "/workshop'");
    browser.waitFor("document.querySelectorAll('svg .curve').length === 3");
    browser.click("button", "Drain");
    browser.awaitText("mech admin --server " + lab.address() + " drain host:workshop");
    browser.screenshot(PICTURES.resolve("admin-host.png"));
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void namesOfStrangersStayText() throws Exception {
    String script = "<script>window.hacked = 1</script>";
    String image = "<img src=x onerror='window.hacked = 1'>";
    lab.host("\"><b onmouseover=alert(1)>/%2e%00#?&", 0.1, true, image);
    lab.simulation(
        "eeee-" + image, "\"><b onmouseover=alert(1)>/%2e%00#?&", script, SimState.SIM_RUNNING);
    lab.failed("ffff-1", "javascript:alert(1)", image, script + "\u202e gnirts");
    lab.happened("sim-failed", Severity.SEV_ERROR, "N-003", image);
    browser.open(web.url(tokens.admin()), "true");
    browser.awaitText(script);
    for (String view : List.of("", "simulations", "failures", "events")) {
      browser.evaluate("location.hash = '#/" + view + "'");
      if (view.equals("failures")) {
        browser.click("summary", "1 earlier");
      }
      browser.awaitText(view.equals("events") ? image : view.equals("failures") ? image : script);
    }
    browser.evaluate(
        "location.hash = '#/sim/' + encodeURIComponent('"
            + lab.address()
            + "') + '/' + encodeURIComponent("
            + Chromium.quoted("eeee-" + image)
            + ")");
    browser.awaitText(script);
    browser.click("summary", "Model");
    browser.awaitText("<!-- " + script + " -->");
    browser.click("dl a", "\"><b onmouseover");
    browser.waitFor("document.querySelector('h1').textContent.startsWith('\"><b')");
    browser.click("button", "Drain");
    browser.awaitText("drain 'host:\"><b");
    assertThat(browser.evaluate("window.hacked === undefined").getAsBoolean()).isTrue();
    assertThat(
            browser
                .evaluate("document.querySelectorAll('main img, main b[onmouseover]').length")
                .getAsInt())
        .isZero();
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void keyboardAloneReachesAnActionAndConfirmsIt() throws Exception {
    browser.open(web.url(tokens.admin()), "true");
    browser.awaitText("FiveBarPendulum");
    for (int i = 0; i < 60 && !focused().equals("Drain"); i++) {
      browser.press("Tab");
    }
    assertThat(focused()).isEqualTo("Drain");
    browser.press("Enter");
    browser.awaitText("mech admin --server " + lab.address() + " drain");
    assertThat(
            browser
                .evaluate("document.querySelector('dialog').contains(document.activeElement)")
                .getAsBoolean())
        .isTrue();
    browser.press("Escape");
    browser.waitFor("document.querySelector('dialog') === null");
    assertThat(lab.calls()).isEmpty();
    browser.press("Enter");
    browser.awaitText("mech admin --server " + lab.address() + " drain");
    browser.press("Enter");
    browser.awaitText("Done: drain the server");
    assertThat(lab.calls()).containsExactly("drain ");
    browser.waitFor(
        "[...document.querySelectorAll('.server .chip')][0].textContent === 'draining'");
  }

  @Test
  void pageThatLoadsShowsNoEmptyFarm() throws Exception {
    lab.hang();
    west.hang();
    AccessTokens own = AccessTokens.random();
    try (AdminConsole asking =
            new AdminConsole(List.of(lab.address(), west.address()), AdminConsole.PATIENCE);
        AdminWeb page = new AdminWeb(asking, 0, own, Optional.empty())) {
      browser.open(page.url(own.admin()), "true");
      browser.waitFor("document.querySelectorAll('.tile b').length === 6");
      browser.waitFor("document.querySelectorAll('.server .chip').length === 2");
      browser.awaitText("Loading …");
      assertThat(tiles()).containsOnly("…");
      lab.goOn();
      west.goOn();
      browser.waitFor("document.querySelector('.tile b').textContent === '2 of 2'");
    }
  }

  private List<String> tiles() throws Exception {
    return browser
        .evaluate("[...document.querySelectorAll('.tile b')].map(tile => tile.textContent)")
        .getAsJsonArray()
        .asList()
        .stream()
        .map(tile -> tile.getAsString())
        .toList();
  }

  @Test
  void failuresAreGroupedCountedByDayAndAcknowledged() throws Exception {
    for (int i = 0; i < 35; i++) {
      lab.failed("model-" + i, "workshop", "SliderCrank", "t=1.5 s: the step became too small.");
    }
    browser.open(web.url(tokens.admin()), "true");
    browser.awaitText("FiveBarPendulum");
    browser.waitFor("document.querySelectorAll('.tile b')[5].textContent === '36'");
    assertThat(
            browser
                .evaluate("document.querySelectorAll('.tile')[5].classList.contains('alarm')")
                .getAsBoolean())
        .as("mistakes in models raise no alarm")
        .isFalse();
    browser.evaluate("location.hash = '#/failures'");
    browser.awaitText("Failures of models: 36");
    assertThat(browser.evaluate("document.querySelectorAll('article').length").getAsInt())
        .isEqualTo(1);
    browser.click("button", "Acknowledge all");
    browser.awaitText("No new failures.");
    browser.evaluate("location.hash = '#/'");
    browser.waitFor("document.querySelectorAll('.tile b')[5].textContent === '0'");
    browser.evaluate("location.hash = '#/failures'");
    browser.click("button", "Show older and acknowledged");
    browser.awaitText("Failures of models: 36");
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void limitsAndPlacementAreSetFromThePage() throws Exception {
    browser.open(web.url(tokens.admin()), "true");
    browser.awaitText("FiveBarPendulum");
    browser.evaluate("location.hash = '#/server/" + lab.address() + "'");
    browser.click("summary", "Limits");
    browser.awaitText("Runs that wait for a place");
    browser.click("tbody td button", "Change");
    browser.evaluate("document.querySelector('dialog input').value = '50'");
    browser.click("dialog button.primary", "Change");
    browser.awaitText("Done: set queue=50");
    browser.waitFor("document.querySelector('details td.number').textContent === '50'");
    browser.click("details .actions button", "Change");
    browser.evaluate("document.querySelector('dialog select').value = 'pinned'");
    browser.click("dialog button.primary", "Change");
    browser.awaitText("Choice of hosts: pinned");
    assertThat(lab.calls()).containsExactly("limit  queue=50", "placement pinned");
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void noisyCurveIsABandThatContainsItsPeak() throws Exception {
    String id = "10000019-0000-4000-8000-000000000000";
    lab.noise(id, 601);
    browser.look(1280, 900, false);
    browser.open(web.url(tokens.admin()), "true");
    browser.awaitText("FiveBarPendulum");
    browser.evaluate("location.hash = '#/sim/" + lab.address() + "/" + id + "'");
    browser.waitFor("document.querySelectorAll('svg .band').length > 0");
    browser.screenshot(Path.of("target/noisy-curve.png"));
    assertThat(
            browser
                .evaluate(
                    "Math.abs(document.querySelector('svg .band').getBBox().height"
                        + " - (150 - 6 - 20 - 4)) < 0.5")
                .getAsBoolean())
        .as("the band reaches from the least to the largest value")
        .isTrue();
    assertThat(browser.problems()).isEmpty();
  }

  private String focused() throws Exception {
    return browser.evaluate("document.activeElement.textContent").getAsString();
  }

  @Test
  void monitorSeesEverythingAndCanDoNothing() throws Exception {
    browser.open(web.url(tokens.monitor()), "true");
    browser.awaitText("FiveBarPendulum");
    assertThat(
            browser
                .evaluate(
                    "[...document.querySelectorAll('main .actions button, main td button')].every(b"
                        + " => b.disabled)")
                .getAsBoolean())
        .isTrue();
    String status =
        "fetch('/api/actions', {method: 'POST', headers: {'Content-Type': 'application/json',"
            + " Authorization: 'Bearer ' + sessionStorage.getItem('mechservice-token')}, body:"
            + " JSON.stringify({server: '"
            + lab.address()
            + "', action: 'drain', host: ''})}).then(r => r.status)";
    assertThat(browser.evaluate(status).getAsInt()).isEqualTo(403);
    browser.evaluate("location.hash = '#/audit'");
    browser.awaitText("S-133 ");
    assertThat(lab.calls()).isEmpty();
    browser.evaluate("sessionStorage.clear()");
    browser.open("http://127.0.0.1:" + web.port() + "/", "true");
    browser.awaitText("This page needs a token");
  }

  @Test
  void serverThatHangsIsShownAndTheOthersGoOn() throws Exception {
    browser.open(web.url(tokens.admin()), "true");
    browser.awaitText("west");
    west.hang();
    browser.awaitText("S-032 the server at " + west.address() + " did not answer in time");
    browser.awaitText("1 of 2");
    lab.simulation("eeee-1", "lab", "StillAlive", SimState.SIM_RUNNING);
    browser.awaitText("StillAlive");
    west.goOn();
    browser.awaitText("2 of 2");
  }

  @Test
  void thousandFinishedAndTwoHundredRunningStayFluid() throws Exception {
    for (int i = 0; i < 1000; i++) {
      lab.simulation("done-" + i, "lab", "Finished" + i, SimState.SIM_DONE);
    }
    for (int i = 0; i < 200; i++) {
      lab.simulation("runs-" + i, "workshop", "Running" + i, SimState.SIM_RUNNING);
    }
    browser.look(1280, 900, false);
    long opened = System.nanoTime();
    browser.open(web.url(tokens.admin()), "true");
    browser.awaitText("Running199");
    double shown = (System.nanoTime() - opened) * 1e-9;
    browser.evaluate("location.hash = '#/simulations'");
    browser.awaitText("of 1213");
    assertThat(browser.evaluate("document.querySelectorAll('tbody tr').length").getAsInt())
        .isEqualTo(50);
    browser.evaluate(
        "window.frames_ = []; (function next(last) { requestAnimationFrame(now => {"
            + " window.frames_.push(now - last); next(now); }); })(performance.now())");
    for (int round = 0; round < 20; round++) {
      lab.advance();
      Thread.sleep(300);
    }
    JsonArray frames =
        browser.evaluate("window.frames_.slice(1).sort((a, b) => a - b)").getAsJsonArray();
    browser.evaluate("document.querySelector('input[type=search]').value = 'running19'");
    long typed = System.nanoTime();
    browser.evaluate(
        "document.querySelector('input[type=search]').dispatchEvent(new Event('input'))");
    browser.awaitText("11 in all");
    double filtered = (System.nanoTime() - typed) * 1e-9;
    assertThat(browser.problems()).isEmpty();
    report(shown, filtered, frames);
  }

  private void report(double shown, double filtered, JsonArray frames) throws Exception {
    Files.writeString(
        Path.of("../docs/reports/admin-page.md"),
        String.format(
            Locale.ROOT,
            """
            # The admin page with many simulations

            Measured on %s by `mvn verify -Psoak`: JDK %s, headless Chromium, %d processors, load average %.1f; a scripted server with 1008 finished and 205 running or waiting simulations, of which 200 make progress three times a second.

            | what | measured |
            |---|---|
            | from opening the page to the simulations on it | %.2f s |
            | filter typed to list filtered | %.3f s |
            | rows on the page | 50 |
            | time from picture to picture, median of %d | %.0f ms |
            | of 95 in 100, no longer than | %.0f ms |
            | longest | %.0f ms |
            """,
            LocalDate.now(ZoneOffset.UTC),
            Runtime.version(),
            Runtime.getRuntime().availableProcessors(),
            ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage(),
            shown,
            filtered,
            frames.size(),
            frames.get(frames.size() / 2).getAsDouble(),
            frames.get(frames.size() * 95 / 100).getAsDouble(),
            frames.get(frames.size() - 1).getAsDouble()));
  }
}

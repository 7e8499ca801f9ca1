package org.mechservice.admin.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.ScriptedServer;
import org.mechservice.admin.live.LiveView;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimState;

/** The page in a real browser, against scripted servers. */
@Tag("soak")
class PageInBrowserTest {
  private static final Path PICTURES = Path.of("../docs/pictures");

  private final AccessTokens tokens = AccessTokens.random();
  private ScriptedServer lab;
  private ScriptedServer west;
  private AdminConsole console;
  private AdminWeb web;
  private Chromium browser;

  @BeforeEach
  void start() throws Exception {
    lab = new ScriptedServer("lab");
    west = new ScriptedServer("west");
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
    lab.happened("server-started", Severity.SEV_INFO, "", "server lab has started");
    lab.happened("host-joined", Severity.SEV_INFO, "", "host workshop joined from 10.0.0.2:8");
    lab.happened("host-lost", Severity.SEV_WARNING, "S-019", "host attic dropped: nobody answers");
    lab.happened("sim-failed", Severity.SEV_ERROR, "N-003", "the step became too small");
    console = new AdminConsole(List.of(lab.address(), west.address()), LiveView.PATIENCE);
    web = new AdminWeb(console, 0, tokens, Optional.empty());
    browser = Chromium.start();
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
    browser.open(web.url(tokens.admin()));
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
    browser.await("document.querySelectorAll('svg .curve').length === 4");
    browser.screenshot(PICTURES.resolve("admin-simulation.png"));
    browser.look(390, 844, true);
    browser.screenshot(PICTURES.resolve("admin-simulation-phone-dark.png"));
    browser.look(1280, 900, true);
    browser.evaluate("location.hash = '#/sim/" + lab.address() + "/" + FAILED + "'");
    browser.awaitText("Try ode15s.");
    browser.screenshot(PICTURES.resolve("admin-failed-dark.png"));
    browser.look(1280, 900, false);
    browser.evaluate("location.hash = '#/host/" + lab.address() + "/workshop'");
    browser.await("document.querySelectorAll('svg .curve').length === 3");
    browser.click("button", "Drain");
    browser.awaitText("mech admin --server " + lab.address() + " drain host:workshop");
    browser.screenshot(PICTURES.resolve("admin-host.png"));
    assertThat(browser.complaints()).isEmpty();
  }
}

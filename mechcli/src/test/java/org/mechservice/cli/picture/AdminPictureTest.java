package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.web.AccessTokens;
import org.mechservice.admin.web.AdminWeb;
import org.mechservice.admin.web.Chromium;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.run.RemoteRun;
import org.mechservice.server.MechServerProcess;
import org.mechservice.server.ServerSettings;
import org.mechservice.solver.api.result.ColumnGroup;

/** Takes the picture of a simulation on the admin page, from a simulation of a server. */
@Tag("soak")
class AdminPictureTest {
  private static final Path PICTURES = Path.of("../docs/pictures");
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @TempDir Path folder;

  @Test
  void simulationIsPictured() throws Exception {
    AccessTokens tokens = AccessTokens.random();
    try (MechServerProcess server =
            MechServerProcess.start(new ServerSettings("lab", "127.0.0.1", 0, 2));
        MechConnection connection = MechConnection.open(server.url());
        MechSession session = connection.openSession();
        AdminConsole console = new AdminConsole(List.of(server.url()), PATIENCE);
        AdminWeb web = new AdminWeb(console, 0, tokens, Optional.empty());
        Chromium browser = Chromium.start(folder.resolve("profile")).orElseThrow()) {
      session.loadModel(Path.of("../examples/four-bar/long-form.xml"));
      try (RemoteRun run =
          session.prepareRemoteRun(
              SimulationOptions.asInFile()
                  .endTime(20)
                  .outputStep(0.01)
                  .columns(Set.of(ColumnGroup.ENERGY, ColumnGroup.CONSTRAINTS)))) {
        run.start();
        browser.look(1280, 900, false);
        browser.open(web.url(tokens.admin()), "true");
        browser.waitFor("document.body.innerText.includes('done')");
        browser.evaluate(
            "location.hash = '#/sim/' + encodeURIComponent('"
                + server.url()
                + "') + '/"
                + run.id()
                + "'");
        // The curves arrive after the figures; a picture of both must be of one time.
        browser.waitFor(
            "document.querySelectorAll('svg .curve').length === 4 &&"
                + " [...document.querySelectorAll('svg text')].filter(t => t.textContent === '20"
                + " s').length === 4 && document.getAnimations().length === 0");
        Files.write(PICTURES.resolve("admin-simulation.png"), browser.screenshot());
        browser.look(390, 844, true);
        Files.write(PICTURES.resolve("admin-simulation-phone-dark.png"), browser.screenshot());
        assertThat(browser.problems()).isEmpty();
      }
    }
  }
}

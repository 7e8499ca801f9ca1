package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.web.AccessTokens;
import org.mechservice.admin.web.AdminWeb;
import org.mechservice.admin.web.Chromium;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

/** axe-core has no serious findings on the pages that are files, and on the page of operators. */
@Tag("slow")
class AccessibilityTest {
  private static final Path PENDULUM = Path.of("..", "examples", "pendulum", "pendulum.xml");

  @TempDir private static Path folder = Path.of("");

  @RegisterExtension static final InstalledBrowser BROWSER = new InstalledBrowser();

  private static Path made(String file, String... words) {
    Path page = folder.resolve(file);
    List<String> all = new ArrayList<>(List.of(words));
    all.addAll(List.of(file.endsWith(".csv") ? "--out" : "-o", page.toString()));
    StringWriter err = new StringWriter();
    int status =
        Mech.run(
            new PrintWriter(new StringWriter()), new PrintWriter(err), all.toArray(new String[0]));
    assertThat(status).as(err.toString()).isEqualTo(ExitStatus.DONE);
    return page;
  }

  private static void requireNoFindings(String address, String ready) throws Exception {
    Chromium browser = BROWSER.get();
    for (boolean dark : new boolean[] {false, true}) {
      browser.look(1280, 900, dark);
      browser.open(address, ready);
      assertThat(browser.accessibilityFindings()).as("dark: %s", dark).isEmpty();
    }
  }

  @Test
  void playerHasNoSeriousFinding() throws Exception {
    BROWSER.get();
    requireNoFindings(
        made("player.html", "view", PENDULUM.toString()).toUri().toString(),
        "Boolean(globalThis.mechPlayer)");
  }

  @Test
  void plotHasNoSeriousFinding() throws Exception {
    BROWSER.get();
    Path result = made("r.csv", "simulate", PENDULUM.toString());
    requireNoFindings(
        made("plot.html", "plot", result.toString()).toUri().toString(),
        "document.querySelector('canvas, svg') !== null");
  }

  @ValueSource(strings = {"pendulum", "driver-c0", "stability"})
  @ParameterizedTest
  void reportHasNoSeriousFinding(String report) throws Exception {
    requireNoFindings(
        Path.of("..", "docs", "reports", "pages", report + ".html").toUri().toString(), "true");
  }

  @Test
  void pageOfOperatorsHasNoSeriousFinding() throws Exception {
    BROWSER.get();
    AccessTokens tokens = AccessTokens.random();
    List<String> nobody = List.of("corbaloc::127.0.0.1:1/MechServer");
    try (AdminConsole console = new AdminConsole(nobody, AdminConsole.PATIENCE);
        AdminWeb web = new AdminWeb(console, 0, tokens, Optional.empty())) {
      requireNoFindings(web.url(tokens.admin()), "document.body.innerText.includes('127.0.0.1:1')");
    }
  }
}

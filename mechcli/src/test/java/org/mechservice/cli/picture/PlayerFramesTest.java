package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.admin.web.Chromium;
import org.mechservice.load.SoakPage;

/**
 * What one picture of the player costs the thread of its page. The processor's time is counted, not
 * the clock's, and without the painting of triangles, which another process of the browser does: on
 * a graphics card, or by the processor where there is none.
 */
@Tag("slow")
class PlayerFramesTest {
  private static final double FRAME_MS = 1000.0 / 60;
  private static final List<String> ALL =
      List.of("reactions", "forces", "traces", "frames", "names");
  private static final int FRAMES = 50;

  private static final String TEN_PICTURES =
      """
      new Promise(done => {
        let left = 10;
        const next = () => (left-- > 0 ? requestAnimationFrame(next) : done(0));
        next();
      })
      """;

  private static final String ONE_TRIANGLE =
      """
      for (const name of ['drawArrays', 'drawArraysInstanced']) {
        const draw = WebGL2RenderingContext.prototype[name];
        WebGL2RenderingContext.prototype[name] = function(mode, first, count, copies) {
          draw.call(this, mode, first, 3, 1);
        };
      }
      """;

  @RegisterExtension static final InstalledBrowser BROWSER = new InstalledBrowser();

  @TempDir Path folder;

  private static Map<String, Double> spent(Chromium browser) throws Exception {
    JsonObject answer = browser.call("Performance.getMetrics", Map.of());
    Map<String, Double> spent = new HashMap<>();
    for (JsonElement metric : answer.getAsJsonArray("metrics")) {
      JsonObject one = metric.getAsJsonObject();
      spent.put(one.get("name").getAsString(), one.get("value").getAsDouble());
    }
    return spent;
  }

  /** Returns the processor time of one picture, ms. */
  private static double each(String name, Map<String, Double> before, Map<String, Double> after) {
    double seconds =
        Objects.requireNonNull(after.get(name)) - Objects.requireNonNull(before.get(name));
    return 1000 * seconds / FRAMES;
  }

  /** 60 pictures a second leave 16.7 ms, of which the script of the page takes a part. */
  @ValueSource(strings = {"driver/driver-c0", "extremes/chain_1000"})
  @ParameterizedTest
  void scriptOfAPictureTakesLessThanASixtiethOfASecond(String model) throws Exception {
    Chromium browser = BROWSER.get();
    browser.look(400, 400, false);
    browser.call("Performance.enable", Map.of("timeDomain", "threadTicks"));
    Path file = Path.of("..", "examples", model + ".xml");
    browser.open(PlayerInBrowserTest.view(file, folder));
    browser.evaluate(ONE_TRIANGLE);
    Spent spent = measure(browser);
    System.out.printf("%s: script of a picture %.2f ms%n", model, spent.script());
    assertThat(spent.script()).isPositive().isLessThan(FRAME_MS);
  }

  @Tag("soak")
  @Test
  void pictureOfTheDriverTakesAFractionOfASixtiethOfASecond() throws Exception {
    SoakPage page =
        new SoakPage(
            "Frame times of the player",
            "Processor time that one picture of a playing player takes in the thread of its page,"
                + " ms, by the DevTools of Chromium without a window (mean of "
                + FRAMES
                + " pictures): the script of the page, its layout and styles (the numbers that"
                + " change), and all the thread does, garbage and the browser's own work included."
                + " 60 pictures a second leave 16.7 ms. The painting of the triangles is not in it:"
                + " another process does it, on a graphics card where there is one. So that a"
                + " machine without one keeps up, every call that draws is made, but with a single"
                + " triangle. \"All\" shows reactions, forces, traces, body frames and names as"
                + " well.",
            0);
    page.line("| scene | shown | script | layout and styles | whole thread | share of 16.7 ms |");
    page.line("|---|---|---|---|---|---|");
    Chromium browser = BROWSER.get();
    browser.look(400, 400, false);
    browser.call("Performance.enable", Map.of("timeDomain", "threadTicks"));
    for (String model :
        List.of(
            "pendulum/pendulum",
            "five-point-suspension/five-point-suspension",
            "driver/driver-c0",
            "extremes/chain_1000",
            "benchmarks/bouncing_ball")) {
      Path file = Path.of("..", "examples", model + ".xml");
      browser.open(PlayerInBrowserTest.view(file, folder));
      browser.evaluate(ONE_TRIANGLE);
      measure(browser, page, model, "usual");
      for (String toggle : ALL) {
        browser.evaluate("document.getElementById('show-" + toggle + "')?.click()");
      }
      measure(browser, page, model, "all");
    }
    page.write("player-frames.md");
  }

  /**
   * Processor time of one picture, ms.
   *
   * @param script of the page
   * @param layout and styles
   * @param thread all that its thread does
   */
  private record Spent(double script, double layout, double thread) {}

  private static Spent measure(Chromium browser) throws Exception {
    browser.evaluate(TEN_PICTURES);
    Map<String, Double> before = spent(browser);
    for (int seen = 0; seen < FRAMES; seen += 10) {
      browser.evaluate(TEN_PICTURES);
    }
    Map<String, Double> after = spent(browser);
    return new Spent(
        each("ScriptDuration", before, after),
        each("LayoutDuration", before, after) + each("RecalcStyleDuration", before, after),
        each("TaskDuration", before, after));
  }

  private static void measure(Chromium browser, SoakPage page, String model, String shown)
      throws Exception {
    Spent spent = measure(browser);
    page.line(
        "| %s | %s | %.2f | %.2f | %.2f | %.0f %% |",
        model.replaceFirst(".*/", ""),
        shown,
        spent.script(),
        spent.layout(),
        spent.thread(),
        100 * spent.thread() / FRAME_MS);
    // Half a frame is left to the browser; a machine of half this speed still keeps the 60. What
    // shows the forces and names of 1 000 bodies may take the whole of it.
    boolean many = model.startsWith("extremes") && shown.equals("all");
    assertThat(spent.script() + spent.layout())
        .as(model + " " + shown)
        .isLessThan(many ? FRAME_MS : FRAME_MS / 2);
  }
}

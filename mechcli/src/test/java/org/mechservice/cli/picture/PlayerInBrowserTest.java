package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.offset;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.admin.web.Chromium;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

/** The player in a real browser: it draws, moves, obeys the keyboard and fetches nothing. */
@Tag("slow")
class PlayerInBrowserTest {
  @TempDir private static Path folder = Path.of("");

  @RegisterExtension static final InstalledBrowser BROWSER = new InstalledBrowser();

  private static Path view(Path model) {
    return view(model, folder);
  }

  /** Writes the player's page of a model into a folder. */
  static Path view(Path model, Path folder) {
    Path page = folder.resolve(model.getFileName() + ".html");
    StringWriter err = new StringWriter();
    int status =
        Mech.run(
            new PrintWriter(new StringWriter()),
            new PrintWriter(err),
            "view",
            model.toString(),
            "--user-code",
            model.resolveSibling(".").toString(),
            "--unconfined",
            "-o",
            page.toString());
    assertThat(status).as(err.toString()).isEqualTo(ExitStatus.DONE);
    return page;
  }

  private static void requireQuiet(Chromium browser, Path page) {
    assertThat(browser.problems()).isEmpty();
    assertThat(browser.requests()).containsExactly(page.toUri().toString());
  }

  @CsvSource({
    "pendulum/pendulum.xml, bar5, 3.000 s",
    "five-point-suspension/five-point-suspension.xml, Wheel, 2.000 s",
    "driver/driver-c0.xml, head, 0.2500 s",
    "benchmarks/bouncing_ball.xml, Ball, 12.00 s",
  })
  @ParameterizedTest
  void sliderMovesTheBodiesOfEveryExample(String model, String body, String end) throws Exception {
    Chromium browser = BROWSER.get();
    Path page = view(Path.of("..", "examples").resolve(model));
    browser.open(page);
    browser.evaluate(
        "{ const f = document.getElementById('follow');"
            + " f.value = [...f.options].find(o => o.text === '"
            + body
            + "').value; f.dispatchEvent(new Event('change')); }");
    browser.press("Home");
    browser.evaluate(
        "if (document.getElementById('play').ariaLabel === 'Pause')"
            + " document.getElementById('play').click()");
    browser.press("Home");
    String start = browser.text("readout");
    browser.evaluate(
        "{ const s = document.getElementById('time'); s.value = (Number(s.max) + Number(s.min)) /"
            + " 3; s.dispatchEvent(new Event('input')); }");
    browser.waitFor("mechPlayer.frameTimes().length > 3");

    assertThat(start).contains(body);
    assertThat(browser.text("readout")).contains(body).isNotEqualTo(start);
    assertThat(browser.text("clock")).endsWith(end);
    assertThat(browser.evaluate("document.getElementById('problem').hidden").getAsBoolean())
        .isTrue();
    for (String toggle : new String[] {"reactions", "forces", "traces", "frames", "names"}) {
      browser.evaluate("document.getElementById('show-" + toggle + "')?.click()");
    }
    double[] times = browser.numbers("mechPlayer.frameTimes()");
    Arrays.sort(times);
    System.out.printf("%s: a frame takes %.1f ms in software%n", model, times[times.length / 2]);
    requireQuiet(browser, page);
  }

  @Test
  void keysPlayStepAndChangeSpeed() throws Exception {
    Chromium browser = BROWSER.get();
    Path page = view(Path.of("..", "examples", "pendulum", "pendulum.xml"));
    browser.open(page);
    String playing = "document.getElementById('play').ariaLabel === 'Pause'";
    assertThat(browser.evaluate(playing).getAsBoolean()).isTrue();
    browser.press(" ");
    assertThat(browser.evaluate(playing).getAsBoolean()).isFalse();
    browser.press("Home");
    assertThat(browser.text("clock")).startsWith("0.000 s");
    browser.press("ArrowRight");
    assertThat(browser.text("clock")).startsWith("0.010 s");
    browser.press("ArrowRight");
    browser.press("ArrowLeft");
    assertThat(browser.text("clock")).startsWith("0.010 s");
    browser.press("End");
    assertThat(browser.text("clock")).startsWith("3.000 s");
    browser.press("+");
    assertThat(browser.evaluate("document.getElementById('speed').selectedOptions[0].text"))
        .hasToString("\"2×\"");
    browser.press("4");
    assertThat(browser.evaluate("document.querySelector('[data-view=top]').ariaPressed"))
        .hasToString("\"true\"");
    requireQuiet(browser, page);
  }

  @Test
  void bodiesAreChosenHiddenAndMeasuredByTheKeyboard() throws Exception {
    Chromium browser = BROWSER.get();
    Path page = view(Path.of("..", "examples", "pendulum", "pendulum.xml"));
    browser.open(page);
    browser.press(" ");
    browser.press("n");
    browser.press("n");
    assertThat(browser.text("readout")).contains("bar2", "1 kg", "kinetic energy");
    browser.press("h");
    assertThat(browser.evaluate("document.querySelector('[data-act=hide]').ariaPressed"))
        .hasToString("\"true\"");
    browser.press("a");
    assertThat(browser.evaluate("document.querySelector('[data-act=hide]').ariaPressed"))
        .hasToString("\"false\"");
    // from a point of the first bar to one a metre further on it
    browser.evaluate("mechPlayer.addMeasure('distance', [[0, 0, 0, 0], [0, 1, 0, 0]])");
    assertThat(browser.numbers("mechPlayer.measures()")[0]).isCloseTo(1, offset(1e-6));
    browser.press("Escape");
    assertThat(browser.numbers("[mechPlayer.selected()]")[0]).isNegative();
    requireQuiet(browser, page);
  }

  /** Reactions across the plane of a planar mechanism are zeros but for rounding. */
  @Test
  void curveOfRoundingAloneIsDrawnAsZero() throws Exception {
    Chromium browser = BROWSER.get();
    Path page = view(Path.of("..", "examples", "benchmarks", "slider_crank_planar.xml"));
    browser.open(page);
    browser.evaluate(
        "{ const box = [...document.querySelectorAll('#columns input')]"
            + ".find(one => /\\.fy$/.test(one.ariaLabel));"
            + " [...document.querySelectorAll('#tree > button')][0].click(); box.click(); }");
    double[] range = browser.numbers("mechPlayer.ranges().at(-1)");
    assertThat(range[0]).isLessThanOrEqualTo(-1);
    assertThat(range[1]).isGreaterThanOrEqualTo(1);
    requireQuiet(browser, page);
  }

  /** The ways that the page draws are as long as those of the run, but for the chords of arcs. */
  @Test
  void ropesAreAsLongAsInTheRun() throws Exception {
    Chromium browser = BROWSER.get();
    Path page = view(Path.of("..", "examples", "elements", "pathForce.xml"));
    browser.open(page);
    browser.press(" ");
    // on the cylinder of 50 mm an arc of less than a quarter turn, in 16 chords: R θ³/(24 · 16²)
    double chords = 0.05 * Math.pow(Math.PI / 2, 3) / (24 * 256);
    for (String time : new String[] {"0", "0.25", "0.5", "0.75", "1"}) {
      double[] cable =
          browser.numbers(
              "(mechPlayer.seek("
                  + time
                  + "), [mechPlayer.ropeLength('cable')[0], mechPlayer.value('cable.length')])");
      assertThat(cable[0]).as("cable at " + time).isCloseTo(cable[1], offset(chords));
      double[] cord =
          browser.numbers("[...mechPlayer.ropeLength('cord'), mechPlayer.value('cord.length')]");
      // half of what is behind the branch counts; poses in the page have seven digits
      assertThat(cord[0] + 0.5 * cord[1]).as("cord at " + time).isCloseTo(cord[2], offset(1e-6));
    }
    requireQuiet(browser, page);
  }

  @Test
  void thousandBodiesAreDrawnByAFewCalls() throws Exception {
    Chromium browser = BROWSER.get();
    Path page = view(Path.of("..", "examples", "extremes", "chain_1000.xml"));
    browser.open(page);
    browser.waitFor("mechPlayer.frameTimes().length > 3");
    double[] calls = browser.numbers("[mechPlayer.drawn().calls]");
    assertThat(calls[0]).isBetween(2.0, 40.0);
    double[] times = browser.numbers("mechPlayer.frameTimes()");
    Arrays.sort(times);
    System.out.printf("1000 bodies: a frame takes %.1f ms in software%n", times[times.length / 2]);
    requireQuiet(browser, page);
  }

  @Test
  void pageWithTheModelInItRunsItAgainWhenASliderMoves() throws Exception {
    Chromium browser = BROWSER.get();
    Path page = live(Path.of("..", "examples", "pendulum", "pendulum.xml"));
    browser.open(page);
    double[] fromFile = browser.numbers("[mechPlayer.last('t'), mechPlayer.last('j1.q')]");
    assertThat(fromFile[0]).isEqualTo(3);
    // what mech simulate gives at a tolerance of 1e-12, to ten tolerances of the file
    assertThat(fromFile[1]).isCloseTo(1.8533808, offset(1e-4));
    move(browser, "j2.v", "0.5");
    assertThat(browser.numbers("[mechPlayer.last('j1.q')]")[0])
        .isNotCloseTo(fromFile[1], offset(0.01));
    browser.evaluate("document.querySelector('#live button').click()");
    assertThat(browser.numbers("[mechPlayer.last('j1.q')]")).containsExactly(fromFile[1]);
    double[] times = browser.numbers("mechPlayer.runTimes()");
    Arrays.sort(times);
    System.out.printf("pendulum: 3 s simulated in the page in %.1f ms%n", times[0]);
    requireQuiet(browser, page);
  }

  @Test
  void pageWithTheModelInItShowsEventsAndEnergyOfEachRun() throws Exception {
    Chromium browser = BROWSER.get();
    Path page = live(Path.of("..", "examples", "benchmarks", "bouncing_ball.xml"));
    browser.open(page);
    String marks = "document.querySelectorAll('#marks b').length";
    double[] fromFile = browser.numbers("[" + marks + "]");
    assertThat(fromFile[0]).isPositive();
    assertThat(browser.evaluate("document.querySelector('#live p').textContent").toString())
        .contains((int) fromFile[0] + " event");
    assertThat(browser.evaluate("document.getElementById('readout').textContent").toString())
        .contains("energy since start");
    // from higher up the ball hits the floor less often
    move(browser, "height.q", "19");
    assertThat(browser.numbers("[" + marks + "]")[0]).isPositive().isLessThan(fromFile[0]);
    requireQuiet(browser, page);
  }

  /** Writes the page of a model that the browser simulates; skips the test without a compiler. */
  private Path live(Path model) {
    Path page = folder.resolve("live.html");
    StringWriter err = new StringWriter();
    int status =
        Mech.run(
            new PrintWriter(new StringWriter()),
            new PrintWriter(err),
            "view",
            model.toString(),
            "--live",
            page.toString());
    assumeTrue(
        !err.toString().contains("no compiler for WebAssembly"),
        "no compiler for WebAssembly here: the page is not tried");
    assertThat(status).as(err.toString()).isEqualTo(ExitStatus.DONE);
    return page;
  }

  private static void move(Chromium browser, String slider, String value) throws Exception {
    browser.evaluate(
        "{ const s = document.querySelector('#live input[data-name=\""
            + slider
            + "\"]'); s.value = '"
            + value
            + "'; s.dispatchEvent(new Event('input')); }");
  }

  @Test
  void everyControlHasAName() throws Exception {
    Chromium browser = BROWSER.get();
    browser.open(view(Path.of("..", "examples", "pendulum", "pendulum.xml")));

    assertThat(
            browser.numbers(
                "[[...document.querySelectorAll('input, select, button')].filter(e =>"
                    + " !(e.ariaLabel || e.textContent.trim() || e.labels?.length)).length]"))
        .containsExactly(0);
    assertThat(
            browser.numbers(
                "[[...document.querySelectorAll('input, select')].filter(e =>"
                    + " !(e.ariaLabel || e.labels?.length)).length]"))
        .containsExactly(0);
  }

  @Test
  void hostileNamesStayText() throws Exception {
    Chromium browser = BROWSER.get();
    String name = "&lt;/script>&lt;img src=x onerror=document.title=1>";
    Path model = folder.resolve("hostile.xml");
    Files.writeString(
        model,
        Files.readString(Path.of("..", "examples", "pendulum", "pendulum.xml"))
            .replace("FiveBarPendulum", name)
            .replace("\"bar5\"", '"' + name + '"'));
    Path page = view(model);
    browser.open(page);
    browser.evaluate("document.getElementById('show-names').click()");
    browser.waitFor("document.querySelectorAll('#labels span').length === 5");

    assertThat(browser.evaluate("document.querySelectorAll('img').length").getAsInt()).isZero();
    assertThat(browser.text("name")).isEqualTo("</script><img src=x onerror=document.title=1>");
    requireQuiet(browser, page);
  }
}

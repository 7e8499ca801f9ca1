package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.Gson;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.admin.web.Chromium;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.guard.UserCode;
import org.mechservice.mechml.document.Document;
import org.mechservice.view.web.UserWeb;

/** The page for users in a real browser, against an embedded server. */
@Tag("slow")
class WebInBrowserTest {
  private static final String PARAMETERS =
      """
        <Parameters>
          <parameter name="k" value="1.0"/>
        </Parameters>
      """;

  @TempDir private static Path folder = Path.of("");

  @RegisterExtension static final InstalledBrowser BROWSER = new InstalledBrowser();
  private static ServiceConnection service;
  private static String pendulum = "";

  @BeforeAll
  static void start() throws Exception {
    service = ServiceConnection.open(new ServerOption(), 4, UserCode.NONE);
    pendulum = Files.readString(Path.of("..", "examples", "pendulum", "pendulum.xml"));
  }

  @AfterAll
  static void end() throws Exception {
    service.close();
  }

  private Chromium browser;
  private UserWeb web;

  @BeforeEach
  void openPage() throws Exception {
    browser = BROWSER.get();
    web =
        new UserWeb(
            service.connection(),
            SceneReader::read,
            new WebExports(),
            Map.of("small", "<MechML/>"),
            Document.dtd(),
            0);
    browser.look(1280, 900, false);
    browser.open(web.url(), "document.getElementById('server').textContent !== ''");
  }

  @AfterEach
  void closePage() {
    web.close();
  }

  private static String quoted(String text) {
    return new Gson().toJson(text);
  }

  private void drop(String fileName, String text) throws Exception {
    browser.evaluate(
        "{ const d = new DataTransfer(); d.items.add(new File(["
            + quoted(text)
            + "], "
            + quoted(fileName)
            + ")); document.body.dispatchEvent(new DragEvent('drop',"
            + " { dataTransfer: d, bubbles: true, cancelable: true })); }");
    browser.waitFor("document.getElementById('messages').children.length > 0");
  }

  private void click(String id) throws Exception {
    browser.evaluate("document.getElementById('" + id + "').click()");
  }

  private void type(String id, String value) throws Exception {
    browser.evaluate(
        "{ const e = document.getElementById('"
            + id
            + "'); e.value = "
            + quoted(value)
            + "; e.dispatchEvent(new Event('input')); e.dispatchEvent(new Event('change')); }");
  }

  private void waitForState(String state) throws Exception {
    browser.waitFor("document.getElementById('state').textContent.includes('" + state + "')");
  }

  @Test
  void droppedModelShowsWhatCheckSaysWithItsLine() throws Exception {
    drop("bad.xml", pendulum.replaceFirst("<body name=\"bar2\"", "<body nmae=\"bar2\""));

    String message = browser.text("messages");
    assertThat(message).startsWith("Line 26: M-").contains("nmae");
    browser.evaluate("document.querySelector('#messages button').click()");
    assertThat(
            browser
                .evaluate(
                    "document.getElementById('text').value.slice(0,"
                        + " document.getElementById('text').selectionStart).split('\\n').length")
                .getAsInt())
        .isEqualTo(26);
    drop("good.xml", pendulum);
    browser.waitFor("!document.getElementById('drawing').hidden");
    assertThat(browser.text("messages")).contains("The model can be used.");
    assertThat(browser.text("report")).contains("freedom");
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void runMovesWhileItRunsAndIsCancelled() throws Exception {
    drop("pendulum.xml", pendulum);
    type("tEnd", "100000");
    click("run");
    browser.waitFor("parseFloat(document.getElementById('clock').textContent) > 0");
    String clock = browser.text("clock");
    byte[] seen = browser.screenshot();
    browser.waitFor("document.getElementById('clock').textContent !== " + quoted(clock));
    // a busy machine shows the text some pictures later
    byte[] moved = browser.screenshot();
    for (int again = 0; again < 50 && Arrays.equals(moved, seen); again++) {
      moved = browser.screenshot();
    }
    assertThat(moved).isNotEqualTo(seen);
    double millis =
        browser
            .evaluate(
                "new Promise(done => { const began = performance.now();"
                    + " const state = document.getElementById('state');"
                    + " new MutationObserver(() => state.textContent.includes('cancelled')"
                    + " && done(performance.now() - began)).observe(state,"
                    + " { childList: true, characterData: true, subtree: true });"
                    + " document.getElementById('cancel').click(); })")
            .getAsDouble();
    System.out.printf("page: a cancel is seen after %.0f ms%n", millis);
    assertThat(browser.text("history")).contains("FiveBarPendulum", "cancelled");
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void parametersAreSlidersAndRunsAreCompared() throws Exception {
    Files.createDirectories(folder.resolve("files"));
    browser.call(
        "Browser.setDownloadBehavior",
        Map.of("behavior", "allow", "downloadPath", folder.resolve("files").toString()));
    drop(
        "tuned.xml",
        pendulum
            .replaceFirst("(?=<Bodies>)", PARAMETERS)
            .replaceFirst("<mass value=\"1.0\"", "<mass value=\"k\""));
    type("tEnd", "0.2");
    click("run");
    waitForState("Run 1: done");
    browser.evaluate(
        "{ const s = document.querySelector('#parameters input[type=range]'); s.value = 1.5;"
            + " s.dispatchEvent(new Event('input')); }");
    click("run");
    waitForState("Run 2: done");

    assertThat(browser.evaluate("document.querySelectorAll('#history > li').length").getAsInt())
        .isEqualTo(2);
    assertThat(browser.text("history")).contains("k = 1.5");
    browser.evaluate("document.querySelector('[aria-label=\"Download run 2 as CSV\"]').click()");
    Path file = folder.resolve("files").resolve("FiveBarPendulum-2.csv");
    for (int i = 0; i < 500 && !Files.exists(file); i++) {
      Thread.sleep(20);
    }
    assertThat(Files.readString(file)).startsWith("t,").contains("\n0.2");
    assertThat(browser.problems()).isEmpty();
  }

  private void write(String text) throws Exception {
    browser.call("Input.insertText", Map.of("text", text));
  }

  @Test
  void editorCompletesElementsAttributesAndTheirValues() throws Exception {
    browser.evaluate("document.getElementById('text').focus()");
    write("<MechML><MBSsimulation><dynamic><f");
    assertThat(browser.text("choices")).isEqualTo("formulation");
    browser.press("Enter");
    write(" clo");
    browser.press("Tab");
    write("p");
    assertThat(browser.text("choices")).isEqualTo("projectionpenalty");
    browser.press("ArrowDown");
    browser.press("Enter");

    assertThat(browser.evaluate("document.getElementById('text').value").getAsString())
        .isEqualTo("<MechML><MBSsimulation><dynamic><formulation closure=\"penalty\"");
    assertThat(browser.evaluate("document.activeElement.id").getAsString()).isEqualTo("text");
    write("\"/></dynamic></MBSsimulation><MBSmodel><Forces><spring");
    assertThat(browser.text("choices")).isEqualTo("springDamper");
    browser.press("Escape");
    assertThat(browser.evaluate("document.getElementById('choices').hidden").getAsBoolean())
        .isTrue();
    assertThat(browser.problems()).isEmpty();
    write("<");
    assertThat(browser.accessibilityFindings()).isEmpty();
  }

  @Test
  void modelOfAFolderFindsItsFilesAndRunsOutlastThePage() throws Exception {
    String table = Files.readString(Path.of("..", "examples", "elements", "table.xml"));
    browser.evaluate(
        "{ const d = new DataTransfer(); d.items.add(new File(["
            + quoted(Files.readString(Path.of("..", "examples", "elements", "pulse.csv")))
            + "], 'pulse.csv')); d.items.add(new File(["
            + quoted(table)
            + "], 'table.xml')); document.body.dispatchEvent(new DragEvent('drop',"
            + " { dataTransfer: d, bubbles: true, cancelable: true })); }");
    browser.waitFor("document.getElementById('messages').children.length > 0");
    assertThat(browser.text("messages")).contains("The model can be used.");
    assertThat(browser.text("attached")).contains("pulse.csv");
    click("run");
    waitForState("Run 1: done");
    browser.open(web.url(), "document.getElementById('history').children.length === 1");
    waitForState("Run 1: done");
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void messagesBelongToTheTextThatIsShown() throws Exception {
    drop("bad.xml", pendulum.replaceFirst("<body name=\"bar2\"", "<body nmae=\"bar2\""));
    assertThat(browser.text("messages")).contains("nmae");
    type("text", pendulum);
    assertThat(browser.text("messages")).isEqualTo("The text has changed since it was checked.");
    assertThat(browser.evaluate("document.getElementById('drawing').hidden").getAsBoolean())
        .isTrue();
  }

  @Test
  void oneOfSeveralSimulationsIsChosen() throws Exception {
    drop(
        "two.xml",
        pendulum.replaceFirst(
            "(?=<MBSmodel )",
            "<MBSsimulation name=\"short\"><dynamic><timeSet tini=\"0\" tend=\"0.25\""
                + " tstep=\"0.05\"/></dynamic></MBSsimulation>"));
    assertThat(browser.text("simulation")).contains("2 short <dynamic>");
    browser.evaluate(
        "{ const s = document.getElementById('simulation'); s.value = '2';"
            + " s.dispatchEvent(new Event('change')); }");
    browser.waitFor("!document.getElementById('check').disabled");
    click("run");
    waitForState("Run 1: done");
    browser.waitFor("document.getElementById('time').max === '0.25'");
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void hostileNamesStayText() throws Exception {
    String name = "&lt;/script>&lt;img src=x onerror=document.title=1>";
    drop(
        "\"><img src=x onerror=document.title=1>.xml",
        pendulum.replace("FiveBarPendulum", name).replace("\"bar5\"", '"' + name + '"'));
    type("tEnd", "0.1");
    click("run");
    waitForState("Run 1: done");

    assertThat(browser.evaluate("document.title").getAsString()).isEqualTo("MechService");
    String others = "document.querySelectorAll('img:not(#drawing, #differing)').length";
    assertThat(browser.evaluate(others).getAsInt()).isZero();
    assertThat(browser.text("history")).contains("<img src=x");
    drop("<script>document.title=1</script>.xml", "<img src=x onerror=document.title=1>");
    assertThat(browser.evaluate("document.title").getAsString()).isEqualTo("MechService");
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void modelOfFiveMegabytesIsCheckedAndRun() throws Exception {
    String filler = "<!-- " + "a long remark of a careful author\n".repeat(160_000) + " -->";
    drop("large.xml", pendulum.replaceFirst("(?=<Bodies>)", filler));
    assertThat(browser.text("messages")).contains("The model can be used.");
    type("tEnd", "0.1");
    click("run");
    waitForState("Run 1: done");
    assertThat(browser.problems()).isEmpty();
  }

  @Test
  void pageOnDeskAndPhoneByDayAndNightHasNoSeriousFinding() throws Exception {
    drop("pendulum.xml", pendulum.replaceFirst("(?=<Bodies>)", PARAMETERS));
    type("tEnd", "0.5");
    click("run");
    waitForState("Run 1: done");
    for (int width : new int[] {1280, 390}) {
      for (boolean dark : new boolean[] {false, true}) {
        browser.look(width, 900, dark);
        assertThat(browser.accessibilityFindings()).as("%d %s", width, dark).isEmpty();
        assertThat(browser.evaluate("document.documentElement.scrollWidth - innerWidth").getAsInt())
            .as("width beyond the window")
            .isLessThanOrEqualTo(0);
      }
    }
  }

  @Tag("soak")
  @Test
  void pageIsPictured() throws Exception {
    Path pictures = Files.createDirectories(Path.of("..", "docs", "pictures"));
    drop(
        "flyball.xml",
        Files.readString(
            Path.of("..", "examples", "benchmarks", "A05_flyball.xml"), StandardCharsets.UTF_8));
    click("run");
    waitForState("Run 1: done");
    browser.look(1280, 1000, false);
    browser.evaluate("new Promise(done => setTimeout(done, 1200))");
    Files.write(pictures.resolve("web.png"), browser.screenshot());
  }
}

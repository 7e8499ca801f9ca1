package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.view.player.Film;

/** What {@code mech view} takes and what it refuses. */
@Tag("slow")
class ViewCommandTest {
  private static final String PENDULUM =
      Path.of("..", "examples", "pendulum", "pendulum.xml").toString();

  private static final String SUSPENSION =
      Path.of("..", "examples", "five-point-suspension", "five-point-suspension.xml").toString();

  private final StringWriter err = new StringWriter();

  @TempDir private Path folder = Path.of("");

  private int mech(String... words) {
    return Mech.run(new PrintWriter(new StringWriter()), new PrintWriter(err), words);
  }

  private String file(String name) {
    return folder.resolve(name).toString();
  }

  @Test
  void oneRunBecomesAPageAndAnAnimatedScene() throws IOException {
    int status = mech("view", PENDULUM, "-o", file("v.html"), "-o", file("v.glb"));

    assertThat(err.toString()).isEmpty();
    assertThat(status).isEqualTo(ExitStatus.DONE);
    assertThat(folder.resolve("v.html")).content().contains("\"FiveBarPendulum\"", "\"j5.fx\"");
    assertThat(Files.readAllBytes(folder.resolve("v.glb"))).startsWith('g', 'l', 'T', 'F');
  }

  @Test
  void resultsWithBodiesAreShownWithoutARun() throws IOException {
    mech("simulate", PENDULUM, "--columns", "bodies", "--out", file("r.csv"), "--quiet");

    int status = mech("view", file("r.csv"), "--model", PENDULUM, "-o", file("v.html"));

    assertThat(err.toString()).isEmpty();
    assertThat(status).isEqualTo(ExitStatus.DONE);
    assertThat(folder.resolve("v.html")).content().contains("\"bar5.e3\"");
  }

  @Test
  void resultsWithoutBodiesAreRefusedWithTheCommandThatMakesThem() {
    mech("simulate", PENDULUM, "--out", file("r.csv"), "--quiet");

    int status = mech("view", file("r.csv"), "--model", PENDULUM, "-o", file("v.html"));

    assertThat(status).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString())
        .startsWith("S-041 " + file("r.csv") + " has no column \"bar1.x\"")
        .contains("mech simulate " + PENDULUM + " --columns bodies --out " + file("r.csv"));
    assertThat(folder.resolve("v.html")).doesNotExist();
  }

  @Test
  void pageWithTheModelInItIsForModelsThatCExpresses() {
    assertThat(mech("view", PENDULUM)).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041 -o FILE.html is missing");
    assertThat(mech("view", file("r.csv"), "--model", PENDULUM, "--live", file("v.html")))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("--live needs a model");
    assertThat(mech("view", PENDULUM, "--live", file("v.glb"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("the page is a .html file");
    assertThat(mech("view", PENDULUM, "--tunable", "g", "-o", file("v.html")))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("--tunable is for the page of --live");
    assertThat(mech("view", SUSPENSION, "--live", file("v.html"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("S-170").contains("fBody");
    assertThat(folder).isEmptyDirectory();
  }

  @Test
  void resultsNeedTheirModelAndModelsTakeNone() {
    assertThat(mech("view", file("r.csv"), "-o", file("v.html"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(mech("view", PENDULUM, "--model", PENDULUM, "-o", file("v.html")))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString().lines())
        .allMatch(line -> line.startsWith("S-041 ") && line.contains("--model"))
        .hasSize(2);
  }

  @Test
  void otherFormatsAreRefusedBeforeTheRun() {
    assertThat(mech("view", PENDULUM, "-o", file("v.avi"))).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041 --output").contains(".html, .glb, .mp4");
  }

  private static final String WHEEL =
      """
      <MechML>
        <MBSsimulation><dynamic><timeSet tini="0" tend="2" tstep="0.1"/></dynamic></MBSsimulation>
        <MBSmodel name="wheel" massUnits="kg" lengthUnits="m" silence="no-gravity">
          <Bodies>
            <body name="ground"/>
            <body name="wheel"><cylinder from="0;-0.01;0" to="0;0.01;0" radius="0.2" mass="1"/></body>
          </Bodies>
          <Joints>
            <joint name="axle" type="R" body1="ground" body2="wheel" at="0;0;0" axis="0;1;0"/>
          </Joints>
          <topology>
            <root name="ground"/>
            <relCoorVals><jointVal name="axle" velVals="60"/></relCoorVals>
          </topology>
        </MBSmodel>
      </MechML>
      """;

  /** A wheel that turns by 6 rad from one row of its file to the next would seem to turn back. */
  @Test
  void rowsOfAFastMotionAreCloseEnoughForTheEye() throws IOException {
    Files.writeString(folder.resolve("wheel.xml"), WHEEL);

    assertThat(mech("view", file("wheel.xml"), "-o", file("v.html"))).isEqualTo(ExitStatus.DONE);

    assertThat(err.toString()).isEmpty();
    String page = Files.readString(folder.resolve("v.html"));
    assertThat(page).containsPattern("\"frames\":2[23]\\d");
  }

  @Test
  void resultsOfAFastMotionAreSaidToBeTooCoarse() throws IOException {
    Files.writeString(folder.resolve("wheel.xml"), WHEEL);
    mech("simulate", file("wheel.xml"), "--columns", "bodies", "--out", file("r.csv"), "--quiet");

    mech("view", file("r.csv"), "--model", file("wheel.xml"), "-o", file("v.html"));

    assertThat(err.toString())
        .startsWith("body wheel turns by 0.955 turns from one row to the next")
        .contains("--t-step");
  }

  @Test
  void sizesAndViewsOfFilmsAreCheckedBeforeTheRun() {
    assertThat(mech("view", PENDULUM, "-o", file("v.html"), "--size", "801x600"))
        .isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).startsWith("S-041 --size 801x600: films need even numbers of px");
  }

  @Test
  void momentAndFilmAreTakenByTheBrowserOfTheMachine() throws IOException {
    Path still = folder.resolve("v.png");
    Path film = folder.resolve("v.mp4");
    assumeTrue(Film.lacking(film).isEmpty(), "Chromium or ffmpeg is not installed");

    int status =
        mech(
            "view",
            PENDULUM,
            "-o",
            still.toString(),
            "-o",
            film.toString(),
            "--size",
            "320x200",
            "--fps",
            "2",
            "--speed",
            "2");

    assertThat(err.toString()).isEmpty();
    assertThat(status).isEqualTo(ExitStatus.DONE);
    BufferedImage picture = ImageIO.read(still.toFile());
    assertThat(picture.getWidth()).isEqualTo(320);
    assertThat(picture.getHeight()).isEqualTo(200);
    assertThat(Files.readAllBytes(film)).contains('f', 't', 'y', 'p');
  }
}

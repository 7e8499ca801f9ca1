package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;
import org.mechservice.cli.shell.ExitStatus;

/** {@code mech show} draws models and explains what it cannot draw. */
class ShowCommandTest {
  private static final String EXAMPLES = "../examples/";
  private static final String PENDULUM = EXAMPLES + "pendulum/pendulum.xml";

  @TempDir private Path folder;
  private final StringWriter err = new StringWriter();

  private int show(String model, String output, String... options) {
    String[] line = new String[4 + options.length];
    line[0] = "show";
    line[1] = model;
    line[2] = "-o";
    line[3] = folder.resolve(output).toString();
    System.arraycopy(options, 0, line, 4, options.length);
    return Mech.run(new PrintWriter(new StringWriter()), new PrintWriter(err), line);
  }

  @Test
  void drawingNamesThePartsAndTheDegreesOfFreedom() throws IOException {
    assertThat(show(PENDULUM, "m.svg")).isEqualTo(ExitStatus.DONE);

    assertThat(folder.resolve("m.svg"))
        .content()
        .contains("revolute joint j5", ">bar3<", "5 bodies, 5 joints: 5 degrees of freedom");
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void redundantEquationsAreInTheCaption() throws IOException {
    assertThat(show(EXAMPLES + "extremes/fourbar_redundant.xml", "m.svg"))
        .isEqualTo(ExitStatus.DONE);

    assertThat(folder.resolve("m.svg"))
        .content()
        .contains("3 are redundant", "revolute joint R4, cut");
  }

  @Test
  void userForcesNeedNoClasses() {
    assertThat(show(EXAMPLES + "driver/driver-c0.xml", "m.png", "--dark"))
        .isEqualTo(ExitStatus.DONE);
    assertThat(folder.resolve("m.png")).isNotEmptyFile();
  }

  @Test
  void robotIsDrawnFromItsUrdf() throws IOException {
    String arm = EXAMPLES + "robot/arm.urdf";
    assertThat(show(arm, "m.svg")).isEqualTo(ExitStatus.DONE);
    assertThat(folder.resolve("m.svg")).content().contains("degrees of freedom", "revolute joint");

    assertThat(show(arm, "n.svg", "--set", "a=1")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(err.toString()).contains("is a robot, which has no parameters");
  }

  @Test
  void viewIsChosenByName() throws IOException {
    assertThat(show(PENDULUM, "xz.svg", "--view", "xz")).isEqualTo(ExitStatus.DONE);
    assertThat(show(PENDULUM, "iso.svg", "--view", "iso")).isEqualTo(ExitStatus.DONE);

    assertThat(Files.readString(folder.resolve("xz.svg")))
        .isNotEqualTo(Files.readString(folder.resolve("iso.svg")));
  }

  @Test
  void mistakesAreExplainedAndNothingIsWritten() throws IOException {
    Path broken = Files.writeString(folder.resolve("broken.xml"), "<MechML/>");

    assertThat(show("no.xml", "m.svg")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(show(PENDULUM, "m.html")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(show(PENDULUM, "m.svg", "--view", "zz")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(show(PENDULUM, "m.svg", "--set", "no=1")).isEqualTo(ExitStatus.BAD_INPUT);
    assertThat(show(broken.toString(), "m.svg")).isEqualTo(ExitStatus.BAD_INPUT);

    assertThat(err.toString()).contains("no.xml", ".svg, .png", "broken.xml");
    assertThat(folder.resolve("m.svg")).doesNotExist();
  }
}

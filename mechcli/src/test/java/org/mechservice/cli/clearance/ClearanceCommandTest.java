package org.mechservice.cli.clearance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.cli.Mech;

class ClearanceCommandTest {
  /** An arm turns by 2π/s; its ball passes a post on the ground that 36 rows a turn step over. */
  private static final String ARM =
      """
      <?xml version="1.0"?>
      <!DOCTYPE MechML SYSTEM "MechML.dtd">
      <MechML>
        <MBSsimulation><dynamic>
          <timeSet tini="0" tend="1" tstep="1/36"/>
          <integrator name="ode113" relTol="1e-10" absTol="1e-12"/>
        </dynamic></MBSsimulation>
        <MBSmodel name="Arm" massUnits="kg" lengthUnits="mm">
          <Parameters><parameter name="gap" value="1.001464"/></Parameters>
          <Bodies>
            <body name="Ground">
              <point name="o" x="0" y="0" z="0"/><point name="p" x="0" y="110 + gap" z="0"/>
              <vector name="z" vx="0" vy="0" vz="1"/>
              <sphere radius="5" point="p" mass="1"/>
            </body>
            <body name="arm">
              <point name="o" x="0" y="0" z="0"/><point name="p" x="100" y="0" z="0"/>
              <vector name="z" vx="0" vy="0" vz="1"/>
              <sphere radius="5" point="p" mass="1"/>
            </body>
            <body name="bare">
              <point name="o" x="0" y="0" z="0"/><vector name="z" vx="0" vy="0" vz="1"/>
              <cog x="0" y="0" z="0"/><mass value="1"/><inertiaTensor Ixx="1" Iyy="1" Izz="1"/>
            </body>
          </Bodies>
          <Joints>
            <joint name="turn" type="R">
              <body1 name="Ground" point="o" vector="z"/><body2 name="arm" point="o" vector="z"/>
            </joint>
            <joint name="other" type="R">
              <body1 name="Ground" point="o" vector="z"/><body2 name="bare" point="o" vector="z"/>
            </joint>
          </Joints>
          <topology><root name="Ground"/><relCoorVals>
            <jointVal name="turn" posVals="0.02" velVals="2*PI"/>
          </relCoorVals></topology>
        </MBSmodel>
      </MechML>
      """;

  @TempDir Path folder;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int run(String... options) throws IOException {
    Path model = folder.resolve("arm.xml");
    Files.writeString(model, ARM);
    String[] words = new String[options.length + 2];
    words[0] = "clearance";
    words[1] = model.toString();
    System.arraycopy(options, 0, words, 2, options.length);
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  @Test
  void passageIsFoundWithInstantPointsAndBound() throws Exception {
    assertThat(run("--pairs", "Ground:arm", "--accuracy", "1e-4mm", "--json")).isZero();
    JsonObject pair =
        JsonParser.parseString(out.toString())
            .getAsJsonObject()
            .getAsJsonArray("pairs")
            .get(0)
            .getAsJsonObject();
    // twice the accuracy for the rows, once for the search
    assertThat(pair.get("distance").getAsDouble()).isCloseTo(1.001464e-3, within(3e-7));
    assertThat(pair.get("bound").getAsDouble()).isBetween(1.001464e-3 - 4e-7, 1.001464e-3);
    assertThat(pair.get("time").getAsDouble()).isCloseTo(0.25 - 0.02 / (2 * Math.PI), within(1e-3));
    assertThat(pair.getAsJsonArray("pointOnB").get(1).getAsDouble()).isCloseTo(0.105, within(1e-5));
  }

  /**
   * The bound holds at a coarse accuracy, too, where the distance found is larger than the least.
   */
  @ParameterizedTest
  @CsvSource({"1mm", "0.1mm", "0.01mm", "0.001mm"})
  void boundIsBelowTheLeastDistance(String accuracy) throws Exception {
    assertThat(run("--pairs", "Ground:arm", "--accuracy", accuracy, "--json")).isZero();
    JsonObject pair =
        JsonParser.parseString(out.toString())
            .getAsJsonObject()
            .getAsJsonArray("pairs")
            .get(0)
            .getAsJsonObject();
    assertThat(pair.get("bound").getAsDouble()).isLessThanOrEqualTo(1.001464e-3);
    // the run itself errs by its tolerance of 1e-10
    assertThat(pair.get("distance").getAsDouble()).isGreaterThan(1.001464e-3 - 1e-9);
  }

  @ParameterizedTest
  @CsvSource({"1mm, 0", "0.99mm, 0", "1.01mm, 1", "1.1e-3m, 1"})
  void statusSaysWhetherTheDistanceIsKept(String least, int status) throws Exception {
    assertThat(run("--pairs", "Ground:arm", "--least", least, "--accuracy", "1e-4mm"))
        .isEqualTo(status);
    assertThat(out.toString()).contains("Ground - arm  1.0014").contains("at all times at least");
  }

  @Test
  void hitIsFoundThoughEachRowIsClear() throws Exception {
    Path curve = folder.resolve("d.csv");
    assertThat(
            run(
                "--pairs",
                "Ground:arm",
                "--set",
                "gap=-1",
                "--least",
                "1e-3mm",
                "-o",
                curve.toString()))
        .isEqualTo(1);
    assertThat(out.toString()).contains("touch or overlap at 0.2");
    List<String> rows = Files.readAllLines(curve);
    assertThat(rows.get(0)).isEqualTo("t,Ground - arm");
    assertThat(rows).hasSizeGreaterThan(37);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--pairs|Ground:nobody|S-218|there are Ground, arm, bare",
        "--pairs|Ground:bare|S-218|has no shape",
        "--pairs|arm|S-041|takes two bodies A:B",
        "--pairs|arm:arm|S-041|takes two bodies A:B",
        "--least|2|S-041|a positive length with its unit",
        "--least|2kg|S-041|a positive length with its unit",
        "--accuracy|-1mm|S-041|a positive length with its unit",
        "--set|nothing=1|nothing|"
      })
  void whatCannotBeUsedIsNamed(String option, String value, String code, String text)
      throws Exception {
    assertThat(run(option, value)).isEqualTo(2);
    assertThat(err.toString()).contains(code).contains(text == null ? "" : text);
  }

  @Test
  void bodiesWithAJointInCommonAreLeftOut() throws Exception {
    assertThat(run()).isEqualTo(2);
    assertThat(err.toString()).contains("S-218 no two bodies have a shape and no joint in common");
  }
}

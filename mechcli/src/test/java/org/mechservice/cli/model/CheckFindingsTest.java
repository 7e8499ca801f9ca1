package org.mechservice.cli.model;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.Mech;

/** The files of {@code mech check} for programs. */
class CheckFindingsTest {
  @TempDir private Path folder;

  private final StringWriter err = new StringWriter();

  private int check(String model, String... more) throws IOException {
    Path file = Files.writeString(folder.resolve("model.xml"), model);
    String[] words = new String[more.length + 6];
    System.arraycopy(
        new String[] {"check", file.toString(), "--sarif", "out.sarif", "--junit", "out.xml"},
        0,
        words,
        0,
        6);
    words[3] = folder.resolve("out.sarif").toString();
    words[5] = folder.resolve("out.xml").toString();
    System.arraycopy(more, 0, words, 6, more.length);
    return Mech.run(new PrintWriter(new StringWriter()), new PrintWriter(err), words);
  }

  private JsonObject run() throws IOException {
    JsonObject log =
        JsonParser.parseString(Files.readString(folder.resolve("out.sarif"))).getAsJsonObject();
    assertThat(log.get("version").getAsString()).isEqualTo("2.1.0");
    return log.getAsJsonArray("runs").get(0).getAsJsonObject();
  }

  private String cases() throws IOException {
    return Files.readString(folder.resolve("out.xml"));
  }

  private static String pendulum(String gravity, String mass) {
    return """
        <MechML><MBSsimulation><dynamic><timeSet tini="0" tend="1" tstep="0.1"/></dynamic>
        </MBSsimulation><MBSmodel name="m" massUnits="kg" lengthUnits="m">
        <Bodies><body name="g"/><body name="b"><cog x="0" y="0" z="-1"/><mass value="MASS"/></body>
        </Bodies><Joints>
        <joint name="j" type="R" body1="g" body2="b" at="0;0;0" axis="0;1;0"/>
        </Joints><Forces><gravity gx="GRAVITY" gy="0" gz="0"/></Forces>
        <topology><root name="g"/></topology></MBSmodel></MechML>
        """
        .replace("GRAVITY", gravity)
        .replace("MASS", mass);
  }

  @Test
  void cleanModelHasNoResultsAndOneCase() throws IOException {
    assertThat(check(pendulum("9.81", "1"))).as(err.toString()).isZero();
    assertThat(run().getAsJsonArray("results")).isEmpty();
    assertThat(cases()).contains("tests=\"1\" failures=\"0\"");
  }

  @Test
  void warningsAreTestsThatFailUnderStrict() throws IOException {
    assertThat(check(pendulum("0", "1"))).isZero();
    JsonArray results = run().getAsJsonArray("results");
    assertThat(results).isNotEmpty();
    JsonObject first = results.get(0).getAsJsonObject();
    assertThat(first.get("level").getAsString()).isEqualTo("warning");
    assertThat(first.get("ruleId").getAsString()).matches("[MNS]-\\d{3}");
    assertThat(cases()).contains("failures=\"0\"");
    assertThat(check(pendulum("0", "1"), "--strict")).isEqualTo(2);
    int warnings = results.size();
    assertThat(cases()).contains("tests=\"%d\" failures=\"%d\"".formatted(warnings + 1, warnings));
  }

  @Test
  void errorsHaveTheirPlace() throws IOException {
    assertThat(check(pendulum("0", "one"))).isEqualTo(2);
    JsonObject result = run().getAsJsonArray("results").get(0).getAsJsonObject();
    assertThat(result.get("level").getAsString()).isEqualTo("error");
    JsonObject place =
        result
            .getAsJsonArray("locations")
            .get(0)
            .getAsJsonObject()
            .getAsJsonObject("physicalLocation");
    assertThat(place.getAsJsonObject("region").get("startLine").getAsInt()).isEqualTo(3);
    assertThat(place.getAsJsonObject("artifactLocation").get("uri").getAsString())
        .isEqualTo(folder.resolve("model.xml").toString());
    assertThat(cases()).contains("failures=\"1\"", "name=\"a run of the model can begin\"");
    assertThat(err.toString()).contains("model.xml:3");
  }
}

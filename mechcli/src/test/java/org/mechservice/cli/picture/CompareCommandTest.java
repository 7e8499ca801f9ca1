package org.mechservice.cli.picture;

import static org.assertj.core.api.Assertions.assertThat;

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

class CompareCommandTest {
  private static final String ROWS = "t,x,y\n0,0,1\n1,1,1\n2,2,1\n";

  @TempDir private Path folder;

  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  private int mech(String... words) {
    return Mech.run(new PrintWriter(out), new PrintWriter(err), words);
  }

  private String file(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text).toString();
  }

  @Test
  void equalResultsOfTwoFormatsGiveStatusZero() throws IOException {
    String a = file("a.csv", ROWS);
    String b = file("b.tsv", ROWS.replace(',', '\t'));

    assertThat(mech("compare", a, b, "--tolerance", "0")).as(err.toString()).isZero();
    assertThat(out.toString()).startsWith("0 of 2 signals differ");
  }

  @Test
  void differentResultsGiveStatusOneAndTheWorstSignalFirst() throws IOException {
    String a = file("a.csv", ROWS);
    String b = file("b.csv", ROWS.replace("1,1,1", "1,1.5,1.0000001"));

    assertThat(mech("compare", a, b)).isEqualTo(1);
    assertThat(out.toString().lines().toList().get(2))
        .startsWith("x ")
        .contains("1.5")
        .endsWith("*");

    mech("compare", a, b, "--quiet");
    assertThat(err.toString()).isEmpty();
  }

  @Test
  void jsonNamesEverySignal() throws IOException {
    String a = file("a.csv", ROWS);
    String b = file("b.csv", ROWS.replace(",y", ",z"));

    assertThat(mech("compare", a, b, "--json")).isEqualTo(1);
    JsonObject said = JsonParser.parseString(out.toString()).getAsJsonObject();
    assertThat(said.get("equal").getAsBoolean()).isFalse();
    assertThat(said.getAsJsonArray("remarks")).hasSize(2);
    assertThat(said.getAsJsonArray("signals")).hasSize(1);
  }

  @Test
  void signalsAreTestCases() throws IOException {
    String a = file("a.csv", ROWS);
    String b = file("b.csv", ROWS.replace("1,1,1", "1,1.5,1"));
    Path cases = folder.resolve("cases.xml");
    assertThat(mech("compare", a, b, "--quiet", "--junit", cases.toString())).isEqualTo(1);
    assertThat(Files.readString(cases))
        .startsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"mech compare ")
        .contains("tests=\"3\" failures=\"1\" errors=\"0\"")
        .contains("name=\"x\"><failure message=\"x is 1")
        .contains("name=\"y\"></testcase>");
    String c = file("c.csv", ROWS.replace(",y", ",z"));
    assertThat(mech("compare", a, c, "--quiet", "--junit", cases.toString())).isEqualTo(1);
    assertThat(Files.readString(cases))
        .contains("name=\"columns, units and interval are the same\"><failure");
  }

  @Test
  void unreadableFilesAndNegativeTolerancesGiveStatusTwo() throws IOException {
    String a = file("a.csv", ROWS);

    assertThat(mech("compare", a, folder.resolve("none.csv").toString())).isEqualTo(2);
    assertThat(mech("compare", a, file("b.csv", "no,numbers\nx,y\n"))).isEqualTo(2);
    assertThat(mech("compare", a, a, "--tolerance", "-1")).isEqualTo(2);
    assertThat(err.toString().lines().map(line -> line.substring(0, 5)))
        .containsExactly("S-042", "S-177", "S-041");
  }

  @Test
  void pictureShowsBothResultsAndTheirDifference() throws IOException {
    String a = file("a.csv", ROWS);
    String b = file("b.csv", ROWS.replace("1,1,1", "1,1.5,1"));
    Path picture = folder.resolve("d.svg");

    assertThat(mech("compare", a, b, "-o", picture.toString())).isEqualTo(1);
    assertThat(Files.readString(picture))
        .contains("1 of 2 signals differ", "second − first", "largest difference at t = 1.0")
        .contains("a.csv", "b.csv");
    assertThat(mech("compare", a, a, "-o", picture.toString())).isZero();
    assertThat(Files.readString(picture)).contains("0 of 2 signals differ");
    assertThat(mech("compare", a, file("c.csv", "t,z\n0,1\n"), "-o", picture.toString()))
        .isEqualTo(2);
    assertThat(mech("compare", a, b, "-o", "d.pdf")).isEqualTo(2);
  }
}

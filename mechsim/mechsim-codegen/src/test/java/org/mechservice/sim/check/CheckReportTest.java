package org.mechservice.sim.check;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.Severity;

class CheckReportTest {
  @Test
  void thePendulumsReportForPeople() {
    assertThat(CheckReport.of(Scenes.model(Scenes.pendulum())).text())
        .startsWith(
            """
            FiveBarPendulum

              Ground
              +- j1 (R): bar1, 1 kg
                 +- j2 (R): bar2, 1 kg
                    +- j3 (R): bar3, 1 kg
                       +- j4 (R): bar4, 1 kg
                          +- j5 (R): bar5, 1 kg

            Degrees of freedom: 5; bodies: 5; mass: 5 kg; loops: 0; redundant equations: 0
            Formulation: DTR (auto: the scene is an open chain, which articulated bodies solve in \
            O(n)), 863 operations per evaluation

            State y = [q; v]:
              q[0] v[0]  j1  R  rad, rad/s  axis 0 1 0
              q[1] v[1]  j2  R  rad, rad/s  axis 0 0.6 0.8
            """)
        .contains("\nWarnings: none\n")
        .contains("  poses of the bodies: the column group \"bodies\" was not asked for\n");
  }

  @Test
  void freedomsAreCountedAndJudgedByRank() throws Exception {
    CheckReport report = example("extremes/fourbar_redundant.xml");
    assertThat(report.text())
        .contains(
            "Degrees of freedom: 1 (3 of the tree less 2 independent of 5 equations; by count alone"
                + " -2)")
        .contains("redundant equations: 3");
    JsonObject json = JsonParser.parseString(report.json()).getAsJsonObject();
    assertThat(json.get("degreesOfFreedom").getAsInt()).isEqualTo(1);
    assertThat(json.get("degreesOfFreedomByCount").getAsInt()).isEqualTo(-2);
  }

  @Test
  void masslessChainOfThreeCrossingHingesIsOfferedAsASphericalJoint() throws Exception {
    CheckReport report = example("extremes/gimbal_q2_0.4.xml");
    assertThat(report.text())
        .contains("Could be simpler:\n  joints \"ja\", \"jb\", \"jc\" turn about one point")
        .contains("needs neither body");
    assertThat(JsonParser.parseString(report.json()).getAsJsonObject().getAsJsonArray("simpler"))
        .hasSize(1);
  }

  @Test
  void springsInTheChainAreNamedInTheOffer() throws Exception {
    assertThat(example("driver/driver-free-c0.xml").scene().offers())
        .hasSize(7)
        .allMatch(offer -> offer.contains("What acts on the angles (\""));
  }

  /** Coaxial hinges, hinges with a heavy body between them, and two hinges are no ball joint. */
  @ParameterizedTest
  @CsvSource({
    "extremes/coaxial_massless.xml",
    "extremes/near_massless_0.xml",
    "pendulum/pendulum.xml"
  })
  void otherChainsAreNotOffered(String file) throws Exception {
    assertThat(example(file).text()).doesNotContain("Could be simpler");
  }

  @Test
  void theReportAsJsonHasTheSameContent() {
    JsonObject report =
        JsonParser.parseString(CheckReport.of(Scenes.model(Scenes.pendulum())).json())
            .getAsJsonObject();
    assertThat(report.get("degreesOfFreedom").getAsInt()).isEqualTo(5);
    assertThat(report.get("formulation").getAsString()).isEqualTo("DTR");
    assertThat(report.getAsJsonArray("roadmap")).hasSize(5);
    JsonObject second = report.getAsJsonArray("roadmap").get(1).getAsJsonObject();
    assertThat(second.get("axis").getAsString()).isEqualTo("0 0.6 0.8");
    assertThat(report.getAsJsonArray("warnings")).isEmpty();
    assertThat(report.getAsJsonArray("leftOut").get(0).getAsJsonObject().keySet())
        .containsExactly("what", "why");
  }

  @Test
  void whatTheReaderNoticedComesFirst() {
    MechmlModel plain = Scenes.model(Scenes.pendulum());
    Diagnostic noticed =
        new Diagnostic(
            Severity.WARNING, MessageCode.MORE_MESSAGES, "odd", "p.xml", 3, 4, "MechML/MBSmodel");
    MechmlModel model = new MechmlModel(plain.mechanism(), plain.settings(), List.of(noticed));
    assertThat(CheckReport.of(model).warnings()).containsExactly("p.xml:3:4: M-019 odd");
  }

  @Test
  void layoutsOfDataFilesAreStated() throws Exception {
    String plain =
        Files.readString(Path.of("..", "..", "examples", "pendulum", "pendulum.xml"))
            .replaceFirst(
                "(?=<Bodies)",
                "<Tables><table name='road' x='0;1' y='0;1' file='road.csv'"
                    + " layout='cells between tabs, decimals with a comma'/></Tables>");
    CheckReport report =
        CheckReport.of(MechmlReader.read("p.xml", plain.getBytes(StandardCharsets.UTF_8)));
    String stated = "table \"road\": road.csv, cells between tabs, decimals with a comma";
    assertThat(report.text()).contains("Data files:\n  " + stated + "\n");
    assertThat(
            JsonParser.parseString(report.json())
                .getAsJsonObject()
                .getAsJsonArray("dataFiles")
                .get(0)
                .getAsString())
        .isEqualTo(stated);
  }

  private static CheckReport example(String file) throws Exception {
    Path path = Path.of("..", "..", "examples").resolve(file);
    return CheckReport.of(
        MechmlReader.read(path.getFileName().toString(), Files.readAllBytes(path)));
  }

  @Test
  void theSuspensionsReportForPeople() throws Exception {
    assertThat(example("five-point-suspension/five-point-suspension.xml").text())
        .startsWith(
            """
            FivePointSuspension

              Ground
              +- j1 (P): Frame, 10 kg
              +- j2 (F): Carrier, 15 kg
                 +- j3 (R): Wheel, 12 kg

            Loops:
              C1 (distance, rod with mass): Carrier - Frame, closing j2 - j1; 1 equation; at the \
            start 2.8e-17 m, 0.0e+00 m/s
            """)
        .contains(
            """
            Degrees of freedom: 3 (8 of the tree less 5 independent of 5 equations); bodies: 3; \
            mass: 49 kg (rods 12); loops: 5; redundant equations: 0
            """,
            """
            State y = [q; v]:
              q[0] v[0]        j1  P  m, m/s  axis 1 0 0
              q[1..7] v[1..6]  j2  F  1 1 1 1 m m m, rad/s rad/s rad/s m/s m/s m/s
            """,
            """
            every evaluation calls the classes of forces "fBody", "fFpsSpringDamper"), \
            1715 operations per evaluation
            """,
            """
            Forces besides gravity:
              fBody (class examples.fivepointsuspension.FpsFBody)
              fFpsSpringDamper (class examples.fivepointsuspension.FpsSpringDamper)

            Not used:
              vector "uFinal" of body "Ground"

            Warnings: none
            """);
  }

  @Test
  void redundantEquationsAreNamed() throws Exception {
    CheckReport report = example("extremes/fourbar_redundant.xml");
    assertThat(report.degreesOfFreedom()).isEqualTo(1);
    assertThat(report.loops().redundant()).isEqualTo(3);
    assertThat(report.warnings())
        .singleElement()
        .asString()
        .startsWith("fourbar_redundant.xml:61: S-090 3 equations of the loops follow from the")
        .contains("\"R4\" (displacement along", "\"R4\" (tilt about");
  }

  @Test
  void aStartThatDoesNotCloseTheLoopsIsTold() throws Exception {
    CheckReport report = example("extremes/fps_inconsistent_rod.xml");
    assertThat(report.warnings())
        .singleElement()
        .asString()
        .startsWith("fps_inconsistent_rod.xml:83: S-092 ")
        .contains("constraint \"C3\" (distance) is 1.0e-03 m");
  }

  @CsvSource({
    "extremes/coaxial_massless.xml, ja jb",
    "extremes/gimbal_q2_1.5707963267948966.xml, ja jb jc"
  })
  @ParameterizedTest
  void jointsWithoutInertiaAreNamedTogether(String file, String joints) throws Exception {
    assertThat(example(file).warnings())
        .singleElement()
        .asString()
        .contains(": N-002 ")
        .contains(Stream.of(joints.split(" ", -1)).map(joint -> "\"" + joint + "\"").toList());
  }

  @CsvSource({
    "benchmarks/A03_andrews.xml, 7, 6, 1",
    "benchmarks/slider_crank_planar.xml, 3, 2, 1",
    "extremes/slider_crank_singular.xml, 2, 1, 1",
    "extremes/gimbal_q2_0.4.xml, 3, 0, 3",
    "driver/driver-c0.xml, 41, 0, 41"
  })
  @ParameterizedTest
  void freedomsAreThoseOfTheTreeLessTheEquations(String file, int tree, int equations, int freedoms)
      throws Exception {
    JsonObject report = JsonParser.parseString(example(file).json()).getAsJsonObject();
    assertThat(report.get("treeFreedoms").getAsInt()).isEqualTo(tree);
    assertThat(report.get("independentEquations").getAsInt()).isEqualTo(equations);
    assertThat(report.get("redundantEquations").getAsInt()).isZero();
    assertThat(report.get("degreesOfFreedom").getAsInt()).isEqualTo(freedoms);
  }
}

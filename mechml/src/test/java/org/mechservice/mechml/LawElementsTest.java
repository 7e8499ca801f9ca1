package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collector;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.unit.Quantity;
import org.mechservice.solver.force.law.ForceRow;
import org.mechservice.solver.force.law.PairLaw;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * Grammar, guide and examples of the forces that are laws with numbers are what their rows say. Run
 * it with {@code -Dgolden.write=true} to print them anew.
 */
class LawElementsTest {
  private static final Path TOP = Path.of("..");
  private static final String END = "<!-- end of laws -->\n";

  private static List<ForceRow> rows() {
    return Stream.of(PairLaw.values()).map(PairLaw::row).flatMap(Optional::stream).toList();
  }

  private static void isPrinted(Path file, String text) throws IOException {
    if (Boolean.getBoolean("golden.write")) {
      Files.writeString(file, text);
    }
    assertThat(file).content().isEqualTo(text);
  }

  /** Returns a text with what stands between a line and the next end of laws. */
  private static String with(String text, String line, String printed) {
    int from = text.indexOf(line);
    assertThat(from).as(line).isNotNegative();
    int begin = text.indexOf('\n', from) + 1;
    return text.substring(0, begin) + printed + text.substring(text.indexOf(END, begin));
  }

  @Test
  void unitsOfAttributesAreThoseOfMechml() {
    for (ForceRow row : rows()) {
      for (ForceRow.Attribute attribute : row.attributes()) {
        assertThatCode(() -> Quantity.inSi(attribute.unit()))
            .as("%s of %s", attribute.name(), row.element())
            .doesNotThrowAnyException();
      }
    }
  }

  @Test
  void grammarHasTheirElements() throws IOException {
    Path file = TOP.resolve("mechml.dtd");
    String names = rows().stream().map(ForceRow::element).collect(Collectors.joining(" | "));
    String declared =
        Files.readString(file).replaceFirst("(<!ENTITY % law )\"[^\"]*\"", "$1\"" + names + "\"");
    String elements = rows().stream().map(LawElementsTest::declaration).collect(joined());
    isPrinted(file, with(declared, "<!-- laws -->", elements));
  }

  private static Collector<CharSequence, ?, String> joined() {
    return Collectors.joining("\n");
  }

  private static String declaration(ForceRow row) {
    StringBuilder text = new StringBuilder("<!ELEMENT ").append(row.element());
    text.append(" (body1, body2)>\n<!ATTLIST ").append(row.element());
    text.append("\n  name CDATA #REQUIRED");
    for (ForceRow.Attribute number : row.attributes()) {
      String mode = number.otherwise().isEmpty() ? "#REQUIRED" : "#IMPLIED";
      text.append("\n  ").append(number.name()).append(" CDATA ").append(mode);
      text.append("\n  ").append(number.name()).append("Unit CDATA #IMPLIED");
    }
    return text.append(">\n").toString();
  }

  @Test
  void guideHasTheirAttributesAndExamples() throws IOException {
    Path file = TOP.resolve("docs/mechml.md");
    String laws = with(Files.readString(file), "<!-- laws: printed", guide());
    isPrinted(file, with(laws, "<!-- examples of laws", examples()));
  }

  private static String guide() {
    StringBuilder text = new StringBuilder();
    text.append("| element | attribute | meaning | unit | default |\n|---|---|---|---|---|\n");
    for (ForceRow row : rows()) {
      text.append("| `").append(row.element()).append("` | `name` | ").append(row.acts());
      text.append(": ").append(row.law()).append(" | | required |\n");
      for (ForceRow.Attribute number : row.attributes()) {
        String condition = number.condition().text();
        text.append("| | `").append(number.name()).append("` | ").append(number.meaning());
        text.append(condition.equals("finite") ? "" : "; " + condition).append(" | ");
        text.append(number.unit().replace("*", " ").replace("^2", "²")).append(" | ");
        text.append(number.otherwise().map(ShortestDecimal::format).orElse("required"));
        text.append(" |\n");
      }
    }
    text.append("\nr is the way from body1's point to body2's. Columns: ");
    text.append(
        rows().stream()
            .map(
                row ->
                    row.outputs().stream()
                        .map(output -> "`" + output.name() + "`")
                        .collect(Collectors.joining(", ", "`" + row.element() + "` has ", "")))
            .collect(Collectors.joining("; ")));
    text.append(".\n");
    for (ForceRow row : rows()) {
      text.append("\n```xml\n").append(element(row, "", "p1", "cart", "p1")).append("```\n");
    }
    return text.toString();
  }

  private static String element(
      ForceRow row, String indent, String point1, String body2, String point2) {
    StringBuilder text = new StringBuilder(indent).append('<').append(row.element());
    text.append(" name=\"law\"");
    for (ForceRow.Attribute number : row.attributes()) {
      text.append(' ').append(number.name()).append("=\"");
      text.append(ShortestDecimal.format(number.example())).append("\" ");
      text.append(number.name()).append("Unit=\"").append(number.unit()).append('"');
    }
    text.append(">\n")
        .append(body(indent, 1, "Ground", point1))
        .append(body(indent, 2, body2, point2));
    return text.append(indent).append("</").append(row.element()).append(">\n").toString();
  }

  private static String body(String indent, int number, String body, String point) {
    return indent + "  <body" + number + " name=\"" + body + "\" point=\"" + point + "\"/>\n";
  }

  private static String examples() {
    StringBuilder text = new StringBuilder("| element | example |\n|---|---|\n");
    for (ForceRow row : rows()) {
      String name = row.element();
      text.append("| `").append(name).append("` | [").append(name);
      text.append("](../examples/elements/").append(name).append(".xml) |\n");
    }
    return text.toString();
  }

  @Test
  void listOfForcesHasThem() throws IOException {
    Path file = TOP.resolve("docs/reference/forces.md");
    String others =
        Files.readString(file).lines().filter(line -> !line.startsWith("| | `")).collect(joined())
            + "\n";
    int before = others.indexOf("| ![force](");
    StringBuilder printed = new StringBuilder();
    for (ForceRow row : rows()) {
      String name = row.element();
      printed.append("| | `").append(name).append("` | ").append(row.acts()).append(" | ");
      printed.append(row.law()).append(" | ").append(row.energy()).append(" | [").append(name);
      printed.append("](../../examples/elements/").append(name).append(".xml) |\n");
    }
    isPrinted(file, others.substring(0, before) + printed + others.substring(before));
  }

  @Test
  void eachHasItsExample() throws IOException {
    for (ForceRow row : rows()) {
      isPrinted(
          TOP.resolve("examples/elements/" + row.element() + ".xml"),
          EXAMPLE
              .replace("LAW", row.law().replace("--", "-"))
              .replace("TRIAL\n", trial(row.example().trial()))
              .replace("END", row.example().end())
              .replace("ELEMENT", row.element())
              .replace("JOINT\n", joint(row.example().trial()))
              .replace("AXIS\n", axis(row.example().trial()))
              .replace("INERTIA\n", inertia(row.example().trial()))
              .replace("START", start(row.example().trial()))
              .replace("FORCE\n", element(row, "      ", "o", "block", "o")));
    }
  }

  private static String trial(ForceRow.Trial trial) {
    return switch (trial) {
      case BLOCK ->
          "between the origin and a block of 1 kg that slides along x, from rest at 1 m.\n";
      case BALL ->
          "between the ground and a ball of 1 kg m^2 that turns about its centre, at first at 0.6"
              + " rad/s.\n";
    };
  }

  private static String joint(ForceRow.Trial trial) {
    return switch (trial) {
      case BLOCK ->
          """
                <joint name="slide" type="P">
                  <body1 name="Ground" point="o" vector="x"/>
                  <body2 name="block" point="o" vector="x"/>
                </joint>
          """;
      case BALL ->
          """
                <joint name="turn" type="S">
                  <body1 name="Ground" point="o"/>
                  <body2 name="block" point="o"/>
                </joint>
          """;
    };
  }

  private static String axis(ForceRow.Trial trial) {
    return switch (trial) {
      case BLOCK -> "        <vector name=\"x\" vx=\"1\" vy=\"0\" vz=\"0\"/>\n";
      case BALL -> "";
    };
  }

  private static String inertia(ForceRow.Trial trial) {
    return switch (trial) {
      case BLOCK -> "";
      case BALL -> "        <inertiaTensor Ixx=\"1\" Iyy=\"1\" Izz=\"1\"/>\n";
    };
  }

  private static String start(ForceRow.Trial trial) {
    return switch (trial) {
      case BLOCK -> "<jointVal name=\"slide\" posVals=\"1\"/>";
      case BALL -> "<jointVal name=\"turn\" velVals=\"0.2; 0.4; 0.4\"/>";
    };
  }

  private static final String EXAMPLE =
      """
      <?xml version="1.0"?>
      <!DOCTYPE MechML SYSTEM "MechML.dtd">
      <!--
      LAW
      TRIAL
      Ends with END.
      -->
      <MechML>
        <MBSsimulation>
          <dynamic>
            <timeSet tini="0" tend="1" tstep="0.1"/>
            <integrator name="ode113" relTol="1e-9" absTol="1e-11"/>
          </dynamic>
        </MBSsimulation>
        <MBSmodel name="ELEMENT" massUnits="kg" lengthUnits="m" silence="no-gravity">
          <Bodies>
            <body name="Ground">
              <point name="o" x="0" y="0" z="0"/>
      AXIS
            </body>
            <body name="block">
              <point name="o" x="0" y="0" z="0"/>
      AXIS
              <mass value="1"/>
      INERTIA
            </body>
          </Bodies>
          <Joints>
      JOINT
          </Joints>
          <Forces>
      FORCE
          </Forces>
          <topology>
            <root name="Ground"/>
            <relCoorVals>
              START
            </relCoorVals>
          </topology>
        </MBSmodel>
      </MechML>
      """;
}

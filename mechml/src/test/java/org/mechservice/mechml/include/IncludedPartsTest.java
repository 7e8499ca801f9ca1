package org.mechservice.mechml.include;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;

/** Models that include the parts of other files. */
class IncludedPartsTest {
  /** A wheel on a spring below a car, with a name of each kind. */
  private static final String CORNER =
      """
      <subsystem massUnits="kg" lengthUnits="m">
        <Parameters>
          <parameter name="x" value="0" unit="m"/>
          <parameter name="k" value="2e4" unit="N/m"/>
          <parameter name="side" value="sqrt(x^2)" unit="m"/>
        </Parameters>
        <Tables><table name="road" x="0;1" y="0;0.01" extrapolation="hold"/></Tables>
        <Bodies>
          <body name="wheel">
            <point name="top" x="x" y="0" z="0.5"/>
            <sphere radius="0.3" point="x; 0; 0.3" mass="30"/>
          </body>
        </Bodies>
        <Joints>
          <joint name="slide" type="P" body1="chassis" body2="wheel" at="x;side;0.3" axis="0;0;1"/>
        </Joints>
        <States><state name="lag" derivative="(slide.v - lag)/0.1"/></States>
        <Forces>
          <springDamper name="spring" k="k" c="1e3" length0="0.2">
            <body1 name="chassis" point="mount"/><body2 name="wheel" point="top"/>
          </springDamper>
          <jointForce name="tyre" joint="slide" expression="-k*(slide.q - road(t)) - 10*lag + chassis.mount.vz*wheel.top.x*gain"/>
        </Forces>
        <Outputs><output name="load" expression="k*(road(t) - slide.q)" unit="N"/></Outputs>
        <relCoorVals><jointVal name="slide" posVals="side/100"/></relCoorVals>
      </subsystem>
      """;

  private static final String CAR =
      """
      <MechML>
        <MBSsimulation><dynamic><timeSet tini="0" tend="1" tstep="0.1"/></dynamic></MBSsimulation>
        <MBSmodel name="Car" massUnits="kg" lengthUnits="m">
          <Parameters><parameter name="base" value="1.3" unit="m"/><parameter name="gain" value="2"/></Parameters>
          %s
          <Bodies>
            <body name="Ground"/>
            <body name="car">
              <point name="front" x="base" y="0" z="0.7"/><point name="rear" x="-base" y="0" z="0.7"/>
              <box x="4" y="1.5" z="1" point="0;0;1" mass="1000"/>
            </body>%s
          </Bodies>
          <Joints><joint name="heave" type="P" body1="Ground" body2="car" axis="0;0;1"/>%s</Joints>
          <Forces>%s<gravity gx="0" gy="0" gz="-9.81"/></Forces>
          <topology><root name="Ground"/></topology>
        </MBSmodel>
        %s
      </MechML>
      """;

  private static String use(String prefix, String sign, String mount) {
    return """
    <include file="corner.part" prefix="%s">
      <parameter name="x" value="%sbase"/>
      <bind name="chassis" to="car"/><bind name="mount" to="%s"/>
    </include>
    """
        .formatted(prefix, sign, mount);
  }

  private static String included(String file, String text) {
    return "<included file=\"" + file + "\"><![CDATA[" + text + "]]></included>";
  }

  private static MechmlModel read(String text) throws MechmlException {
    return MechmlReader.read("car.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  private static String car(String includes, String files) {
    return CAR.formatted(includes, "", "", "", files);
  }

  /** What Instance does by rule, done by hand in the text. */
  private static String byHand(String prefix, String sign, String mount) {
    String text = CORNER.replace("name=\"x\" value=\"0\"", "name=\"x\" value=\"" + sign + "base\"");
    for (String name : List.of("wheel", "slide", "road", "lag", "spring", "tyre", "load", "side")) {
      text = text.replaceAll("\\b" + name + "\\b", prefix + name);
    }
    return text.replaceAll("\\bk\\b(?!=)", prefix + "k")
        .replaceAll("(?<![\\w.\\s])x\\b(?!=)", prefix + "x")
        .replaceAll("\\bchassis\\b", "car")
        .replaceAll("\\bmount\\b", mount);
  }

  private static String section(String text, String name) {
    int from = text.indexOf("<" + name + ">") + name.length() + 2;
    return text.substring(from, text.indexOf("</" + name + ">"));
  }

  /** Each part includes the next one. */
  private static String chain(int parts) {
    StringBuilder all = new StringBuilder();
    for (int i = 0; i < parts; i++) {
      String next = i < parts - 1 ? "<include file=\"p" + (i + 1) + "\" prefix=\"x_\"/>" : "";
      all.append(
          included(
              "p" + i, "<subsystem massUnits=\"kg\" lengthUnits=\"m\">" + next + "</subsystem>"));
    }
    return car("<include file=\"p0\" prefix=\"z_\"/>", all.toString());
  }

  @Test
  void filesInFilesAreBoundedByName() throws MechmlException {
    assertThat(read(chain(50)).mechanism().bodies()).isNotEmpty();
    assertThatThrownBy(() -> read(chain(51)))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("M-075")
        .hasMessageContaining("more than 50 deep");
    assertThatThrownBy(() -> read(chain(3001)))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining("M-004")
        .hasMessageContaining("3001 files");
  }

  @Test
  void includedCornersAreThoseWrittenByHand() throws MechmlException {
    Mechanism brief =
        read(car(use("f_", "", "front") + use("r_", "-", "rear"), included("corner.part", CORNER)))
            .mechanism();
    String front = byHand("f_", "", "front");
    String rear = byHand("r_", "-", "rear");
    String full =
        CAR.formatted(
                "<Tables>" + section(front, "Tables") + section(rear, "Tables") + "</Tables>",
                section(front, "Bodies") + section(rear, "Bodies"),
                section(front, "Joints") + section(rear, "Joints"),
                section(front, "Forces") + section(rear, "Forces"),
                "")
            .replace(
                "</Parameters>",
                section(front, "Parameters") + section(rear, "Parameters") + "</Parameters>")
            .replace(
                "<Forces>",
                "<States>"
                    + section(front, "States")
                    + section(rear, "States")
                    + "</States><Forces>")
            .replace(
                "<root name=\"Ground\"/>",
                "<root name=\"Ground\"/><relCoorVals>"
                    + section(front, "relCoorVals")
                    + section(rear, "relCoorVals")
                    + "</relCoorVals>");
    Mechanism whole = read(full).mechanism();
    assertThat(said(brief)).isEqualTo(said(whole));
    assertThat(brief.joints())
        .extracting(Joint::name)
        .containsExactly("heave", "f_slide", "r_slide");
    assertThat(brief.forces()).hasSize(4);
    assertThat(brief.furtherStates()).hasSize(2);
  }

  /** A mechanism in words without positions in files. */
  private static String said(Mechanism mechanism) {
    return List.of(
            mechanism.bodies(), mechanism.joints(), mechanism.forces(), mechanism.furtherStates())
        .stream()
        .map(part -> part.toString().replaceAll("origin=[^\\]]*", ""))
        .collect(Collectors.joining("\n"));
  }

  @Test
  void errorsNameTheIncludedFileAndItsLine() {
    String broken = CORNER.replace("mass=\"30\"", "mass=\"thirty\"");
    assertThat(messages(car(use("f_", "", "front"), included("corner.part", broken))))
        .hasSize(1)
        .allMatch(m -> m.startsWith("corner.part:11:7: M-022 ") && m.contains("\"f_wheel\""));
    String unclosed = CORNER.replace("</Bodies>", "");
    assertThat(messages(car(use("f_", "", "front"), included("corner.part", unclosed))))
        .allMatch(m -> m.startsWith("corner.part:"))
        .isNotEmpty();
    String invalid = CORNER.replace("radius=", "radios=");
    assertThat(messages(car(use("f_", "", "front"), included("corner.part", invalid))))
        .allMatch(m -> m.startsWith("corner.part:11:7: M-007"))
        .hasSize(1);
  }

  private static List<String> messages(String text) {
    MechmlException thrown = catchThrowableOfType(MechmlException.class, () -> read(text));
    return thrown.diagnostics().stream().map(Object::toString).toList();
  }

  @Test
  void placesInTheRunAreThoseInTheIncludedFile() throws MechmlException {
    Mechanism mechanism =
        read(car(use("f_", "", "front"), included("corner.part", CORNER))).mechanism();
    assertThat(mechanism.joints().get(1).origin().file()).isEqualTo("corner.part");
    assertThat(mechanism.joints().get(1).origin().line()).isEqualTo(15);
    assertThat(mechanism.joints().get(0).origin().file()).isEqualTo("car.xml");
  }

  /** An axle includes the corner twice; a car includes two axles. */
  @Test
  void includedFilesIncludeOthers() throws MechmlException {
    String axle =
        """
        <subsystem massUnits="kg" lengthUnits="m">
          <Parameters><parameter name="at" value="0" unit="m"/></Parameters>
          <include file="corner.part" prefix="l_"><parameter name="x" value="at"/><bind name="chassis" to="frame"/></include>
          <include file="corner.part" prefix="r_"><parameter name="x" value="2*at"/><bind name="chassis" to="frame"/></include>
        </subsystem>
        """;
    String includes =
        "<include file='axle.part' prefix='front_'><parameter name='at' value='base'/>"
            + "<bind name='frame' to='car'/><bind name='mount' to='front'/></include>"
            + "<include file='axle.part' prefix='rear_'>"
            + "<bind name='frame' to='car'/><bind name='mount' to='rear'/></include>";
    Mechanism mechanism =
        read(car(includes, included("axle.part", axle) + included("corner.part", CORNER)))
            .mechanism();
    assertThat(mechanism.joints())
        .extracting(Joint::name)
        .containsExactly("heave", "front_l_slide", "front_r_slide", "rear_l_slide", "rear_r_slide");
    assertThat(mechanism.joints().get(2).attachment().childPoint().x()).isEqualTo(2.6);
  }

  @Test
  void fileThatIncludesItselfIsRefused() {
    String a = "<subsystem massUnits='kg' lengthUnits='m'><include file='b.part'/></subsystem>";
    String b = "<subsystem massUnits='kg' lengthUnits='m'><include file='a.part'/></subsystem>";
    assertThat(
            messages(
                car("<include file='a.part'/>", included("a.part", a) + included("b.part", b))))
        .singleElement()
        .asString()
        .startsWith("b.part:1:")
        .contains("M-075")
        .contains("a.part includes b.part includes a.part");
  }

  /** Ten files, each of which includes the next ten times, would be ten thousand million parts. */
  @Test
  void includesThatMultiplyBeyondTheLimitAreRefused() {
    StringBuilder files = new StringBuilder();
    for (int i = 0; i < 10; i++) {
      String next = "<include file='f" + (i + 1) + "' prefix='%d_'/>";
      StringBuilder inner = new StringBuilder("<subsystem massUnits='kg' lengthUnits='m'>");
      for (int k = 0; k < 10 && i < 9; k++) {
        inner.append(next.formatted(k));
      }
      inner.append(i == 9 ? "<Bodies><body name='b'/></Bodies>" : "").append("</subsystem>");
      files.append(included("f" + i, inner.toString()));
    }
    assertThat(messages(car("<include file='f0'/>", files.toString())))
        .isNotEmpty()
        .allMatch(m -> m.contains("M-004"));
  }

  @Test
  void documentWithTheTextOfAFileIsWrittenBack() throws MechmlException {
    String text =
        car(use("f_", "", "front"), included("corner.part", CORNER + "<!-- ]]]]><![CDATA[> -->"));
    Document document = MechmlReader.document("car.xml", text.getBytes(StandardCharsets.UTF_8));
    String written = DocumentWriter.write(document);
    Document again = MechmlReader.document("car.xml", written.getBytes(StandardCharsets.UTF_8));
    assertThat(DocumentWriter.write(again)).isEqualTo(written);
    assertThat(again.root().children("included").get(0).content())
        .isEqualTo(document.root().children("included").get(0).content());
  }
}

package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.Limits;
import org.mechservice.mechml.resolve.MechmlReader;

/** Files made to exhaust the reader are refused; ordinary large ones are read. */
@Tag("slow")
class HostileFileTest {
  /** Far beyond what any of these needs: it only ends a test that would hang. */
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  private static List<String> codes(String text) {
    return codes(text.getBytes(StandardCharsets.UTF_8));
  }

  private static List<String> codes(byte[] content) {
    return assertTimeoutPreemptively(
        PATIENCE,
        () -> {
          try {
            MechmlReader.read("hostile.xml", content);
            return List.of();
          } catch (MechmlException e) {
            return e.diagnostics().stream().map(said -> said.code().code()).distinct().toList();
          }
        });
  }

  private static String pendulum() throws Exception {
    return Resources.text("sliding-pendulum.xml");
  }

  private static String withEntities(String declarations) throws Exception {
    return pendulum().replace("\"MechML.dtd\"", "\"MechML.dtd\" [" + declarations + "]");
  }

  @Test
  void laughsByTheBillionAreRefused() throws Exception {
    StringBuilder entities = new StringBuilder("<!ENTITY a0 \"0\">");
    for (int i = 1; i < 30; i++) {
      entities.append("<!ENTITY a%d \"%s\">".formatted(i, "&a%d;".formatted(i - 1).repeat(20)));
    }
    String bomb = withEntities(entities.toString());
    assertThat(codes(bomb.replace("x=\"0.5\"", "x=\"&a29;\""))).containsExactly("M-004");
    assertThat(codes(bomb.replace("<Bodies>", "<Bodies>&a29;"))).contains("M-004");
  }

  @Test
  void aLongEntityOftenRepeatedIsRefused() throws Exception {
    String bomb = withEntities("<!ENTITY a \"" + "1+".repeat(500_000) + "\">");
    assertThat(codes(bomb.replace("x=\"0.5\"", "x=\"" + "&a;".repeat(900) + "1\"")))
        .containsExactly("M-004");
  }

  @Test
  void anEntityThatHoldsItselfIsRefused() throws Exception {
    String loop = withEntities("<!ENTITY a \"&b;\"><!ENTITY b \"&a;\">");
    assertThat(codes(loop.replace("x=\"0.5\"", "x=\"&a;\""))).containsExactly("M-001");
  }

  @Test
  void deepNestingIsRefused() throws Exception {
    assertThat(codes("<MechML>" + "<body name='b'>".repeat(1_000_000))).containsExactly("M-004");
  }

  @Test
  void longAttributesAreRefused() throws Exception {
    String sum = "1" + "+1".repeat(1_000_000);
    assertThat(codes(pendulum().replace("x=\"0.5\"", "x=\"" + sum + "\"")))
        .containsExactly("M-004");
  }

  @Test
  void manyAttributesAreRefused() throws Exception {
    StringBuilder attributes = new StringBuilder();
    for (int i = 0; i < 300_000; i++) {
      attributes.append(" a%d='0'".formatted(i));
    }
    assertThat(codes(pendulum().replace("<cog", "<cog" + attributes))).containsExactly("M-012");
  }

  @Test
  void filesBeyondTheLimitAreRefusedUnread() {
    assertThat(codes(new byte[Limits.BYTES + 1])).containsExactly("M-004");
  }

  @Test
  void aMillionElementsAreRefused() throws Exception {
    String points = "<mass value='1'/>".repeat(900_000);
    assertThat(codes(pendulum().replace("<cog", points + "<cog"))).containsExactly("M-004");
  }

  @Test
  void aHundredThousandWrongElementsAreRefused() throws Exception {
    String wrong = "<pointe/>".repeat(100_000);
    assertThat(codes(pendulum().replace("<cog", wrong + "<cog"))).containsExactly("M-012");
  }

  @Test
  void fewerWrongElementsAreExplained() throws Exception {
    String wrong = "<pointe/>".repeat(5_000);
    assertThat(codes(pendulum().replace("<cog", wrong + "<cog"))).containsExactly("M-006", "M-019");
  }

  @Test
  void aHundredThousandPointsAreRead() throws Exception {
    StringBuilder points = new StringBuilder();
    for (int i = 0; i < 100_000; i++) {
      points.append("<point name='q%d' x='%d' y='1/3' z='0'/>".formatted(i, i));
    }
    assertThat(codes(pendulum().replace("<cog", points + "<cog"))).isEmpty();
  }

  @Test
  void aChainOfTwentyThousandBodiesIsRead() throws Exception {
    assertThat(codes(chain(20_000))).isEmpty();
  }

  @Test
  void moreBodiesAreRefused() throws Exception {
    StringBuilder bodies = new StringBuilder();
    for (int i = 0; i <= Limits.BODIES; i++) {
      bodies.append("<body name='more%d'><mass value='1'/></body>".formatted(i));
    }
    assertThat(codes(pendulum().replace("</Bodies>", bodies + "</Bodies>")))
        .containsExactly("M-004");
  }

  @Test
  void aHundredThousandUnknownNamesAreRefused() throws Exception {
    StringBuilder values = new StringBuilder();
    for (int i = 0; i < 100_000; i++) {
      values.append("<jointVal name='hinge%d'/>".formatted(i));
    }
    assertThat(codes(pendulum().replace("</relCoorVals>", values + "</relCoorVals>")))
        .containsExactly("M-014", "M-019");
  }

  /** Ground - b0 - b1 - ... */
  private static String chain(int length) {
    String parts = "<point name='p' x='1' y='0' z='0'/><vector name='u' vx='0' vy='1' vz='0'/>";
    StringBuilder bodies = new StringBuilder("<body name='b-1'>" + parts + "</body>");
    StringBuilder joints = new StringBuilder();
    for (int i = 0; i < length; i++) {
      bodies.append("<body name='b%d'>%s<mass value='1'/></body>".formatted(i, parts));
      joints.append(
          ("<joint name='j%d' type='R'><body1 name='b%d' point='p' vector='u'/>"
                  + "<body2 name='b%d' point='p' vector='u'/></joint>")
              .formatted(i, i - 1, i));
    }
    return """
    <MechML>
      <MBSsimulation><dynamic>
        <timeSet tini='0' tend='1' tstep='0.1'/>
        <integrator name='DE' relTol='1e-5' absTol='1e-5'/>
      </dynamic></MBSsimulation>
      <MBSmodel name='Chain' massUnits='kg' lengthUnits='m'>
        <Bodies>%s</Bodies><Joints>%s</Joints><topology><root name='b-1'/></topology>
      </MBSmodel>
    </MechML>
    """
        .formatted(bodies, joints);
  }
}

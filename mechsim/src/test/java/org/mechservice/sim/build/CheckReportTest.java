package org.mechservice.sim.build;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.Diagnostic;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.Severity;

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
            O(n)), 841 operations per evaluation

            State y = [q; v]:
              q[0] v[0]  j1  R  rad, rad/s  axis 0 1 0
              q[1] v[1]  j2  R  rad, rad/s  axis 0 0.6 0.8
            """)
        .contains("\nWarnings: none\n")
        .contains("  poses of the bodies: the column group \"bodies\" was not asked for\n");
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
        new Diagnostic(Severity.WARNING, "M-099", "odd", "p.xml", 3, 4, "MechML/MBSmodel");
    MechmlModel model = new MechmlModel(plain.mechanism(), plain.settings(), List.of(noticed));
    assertThat(CheckReport.of(model).warnings()).containsExactly("p.xml:3:4: M-099 odd");
  }
}

package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.catalogue.MessageCode;

/** Dense matrices of large mechanisms are told before the run, with their reason. */
class DenseForecastTest {
  private static final String SPRING =
      "<springDamper name='far' k='1' length0='1'>"
          + "<body1 name='k10' point='o'/><body2 name='k200' point='o'/></springDamper>";

  /** A chain of hinges: each joint influences all others, n (n − 1) / 2 pairs. */
  private static MechmlModel chain(int links, String integrator, String forces) {
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    for (int i = 0; i <= links; i++) {
      bodies
          .append("<body name='k" + i + "'><point name='o' x='0' y='0' z='0'/>")
          .append("<point name='e' x='1' y='0' z='0'/><vector name='y' vx='0' vy='1' vz='0'/>")
          .append("<mass value='1'/><inertiaTensor Ixx='1' Iyy='1' Izz='1'/></body>");
      if (i > 0) {
        joints
            .append("<joint name='a" + i + "' type='R'><body1 name='k" + (i - 1))
            .append("' point='e' vector='y'/><body2 name='k" + i)
            .append("' point='o' vector='y'/></joint>");
      }
    }
    String text =
        "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='1'/>"
            + ("<integrator name='"
                + integrator
                + "' relTol='1e-6' absTol='1e-8'/></dynamic></MBSsimulation>")
            + "<MBSmodel name='chain' massUnits='kg' lengthUnits='m'>"
            + ("<Bodies>" + bodies + "</Bodies><Joints>" + joints + "</Joints>")
            + ("<Forces>" + forces + "</Forces><topology><root name='k0'/></topology>")
            + "</MBSmodel></MechML>";
    try {
      return MechmlReader.read("chain.xml", text.getBytes(StandardCharsets.UTF_8));
    } catch (MechmlException e) {
      throw new IllegalArgumentException(e);
    }
  }

  private static List<Finding> forecast(MechmlModel model, String formulation) {
    return RunForecast.of(model, formulation, "auto", model.settings().run()).stream()
        .filter(finding -> finding.code() == MessageCode.DENSE_MATRICES)
        .toList();
  }

  @ParameterizedTest
  @CsvSource({
    "DSR, ode15s, dense matrix of the 620 independent states (3 MB), RR-JF with ode15sR keeps",
    "RR, ode15sR, 47895 pairs of coordinates, formulation RR-JF keeps"
  })
  void aMethodWithADenseMatrixOfALongChainIsNamed(
      String formulation, String integrator, String what, String advice) {
    assertThat(forecast(chain(310, integrator, ""), formulation))
        .singleElement()
        .satisfies(finding -> assertThat(finding.text()).contains(what, advice));
  }

  /** 310 links with a spring from the tenth to the two hundredth. */
  @Test
  void aFarForceIsKeptInTheSparsityOfTheLinks() {
    assertThat(forecast(chain(310, "ode15sR", SPRING), "RR-JF")).isEmpty();
    assertThat(forecast(chain(310, "ode15sR", SPRING), "RR"))
        .singleElement()
        .satisfies(finding -> assertThat(finding.text()).contains("formulation RR-JF keeps"));
  }

  @ParameterizedTest
  @CsvSource({"310, RR-JF, ode15sR", "310, DTR, ode113", "290, RR, ode15sR", "290, DSR, ode15s"})
  void nothingIsSaidOfSparseOrSmallEquations(int links, String formulation, String integrator) {
    assertThat(forecast(chain(links, integrator, ""), formulation)).isEmpty();
  }
}

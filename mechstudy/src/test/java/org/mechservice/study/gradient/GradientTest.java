package org.mechservice.study.gradient;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.library.MechModel;
import org.mechservice.study.Reduction;
import org.mechservice.study.StudyModels;

/** Derivatives against closed forms. */
final class GradientTest {
  private static final double X0 = 0.1;
  private static final double K = 20;
  private static final double M = 2;
  private static final double OMEGA = Math.sqrt(K / M);

  /** The run has a tolerance of 1e-10; some hundred steps add to it. */
  private static final double TOLERANCE = 1e-8;

  private static final List<String> ALL = List.of("k", "m", "x.q", "x.v");

  private static Gradient of(String mechml, List<String> by, GradientMethod method, String... what)
      throws Exception {
    return Gradients.of(
            MechModel.of("model.xml", mechml), by, Stream.of(what).map(Reduction::parse).toList())
        .compute(method);
  }

  /** x = x0 cos(ωt) + v0/ω sin(ωt), ω = √(k/m), and what follows by differentiation. */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void derivativesOfAnOscillatorAreThoseOfItsClosedForm(GradientMethod method) throws Exception {
    Gradient found =
        of(StudyModels.SPRING, ALL, method, "x.q", "integral(x.q)", "at(x.v,0.4)", "x.a");
    double s = Math.sin(OMEGA);
    double c = Math.cos(OMEGA);
    double byK = OMEGA / (2 * K);
    double byM = -OMEGA / (2 * M);
    double last = -X0 * s;
    assertClose(found, 0, X0 * c, last * byK, last * byM, c, s / OMEGA);
    double integral = X0 * (c / OMEGA - s / (OMEGA * OMEGA));
    assertClose(
        found,
        1,
        X0 * s / OMEGA,
        integral * byK,
        integral * byM,
        s / OMEGA,
        (1 - c) / (OMEGA * OMEGA));
    double s4 = Math.sin(0.4 * OMEGA);
    double c4 = Math.cos(0.4 * OMEGA);
    double speed = -X0 * (s4 + 0.4 * OMEGA * c4);
    assertClose(found, 2, -X0 * OMEGA * s4, speed * byK, speed * byM, -OMEGA * s4, c4);
    double a = -X0 * (2 * OMEGA * c - OMEGA * OMEGA * s);
    assertClose(
        found, 3, -X0 * OMEGA * OMEGA * c, a * byK, a * byM, -OMEGA * OMEGA * c, -OMEGA * s);
  }

  /** The least x is −√(x0² + v0²/ω²); x passes zero at ωt = π/2 + v0/(ω x0). */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void extremesAndCrossingsAreThoseOfTheMotion(GradientMethod method) throws Exception {
    Gradient found = of(StudyModels.SPRING, ALL, method, "min(x.q)", "min(x.v)", "crossing(x.q,0)");
    assertClose(found, 0, -X0, 0, 0, -1, 0);
    assertClose(found, 1, -X0 * OMEGA, -X0 * OMEGA / (2 * K), X0 * OMEGA / (2 * M), -OMEGA, 0);
    double time = Math.PI / 2 / OMEGA;
    assertClose(found, 2, time, -time / (2 * K), time / (2 * M), 0, 1 / (OMEGA * OMEGA * X0));
  }

  /** The mean of x² is x0² (1/2 + sin(2ωT) / (4ωT)). */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void derivativesOfMeansFollowTheirIntegrals(GradientMethod method) throws Exception {
    Gradient found = of(StudyModels.SPRING, List.of("k", "x.q"), method, "rms(x.q)", "mean(x.q)");
    double square = 0.5 + Math.sin(2 * OMEGA) / (4 * OMEGA);
    double byOmega = Math.cos(2 * OMEGA) / (2 * OMEGA) - Math.sin(2 * OMEGA) / (4 * OMEGA * OMEGA);
    double rms = Math.sqrt(square);
    assertClose(found, 0, X0 * rms, X0 * byOmega / (2 * rms) * OMEGA / (2 * K), rms);
    double integral = X0 * (Math.cos(OMEGA) / OMEGA - Math.sin(OMEGA) / (OMEGA * OMEGA));
    assertClose(
        found,
        1,
        X0 * Math.sin(OMEGA) / OMEGA,
        integral * OMEGA / (2 * K),
        Math.sin(OMEGA) / OMEGA);
  }

  /** A stiff method follows the same tangents. */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void aStiffMethodGivesTheSameDerivatives(GradientMethod method) throws Exception {
    String stiff = StudyModels.SPRING.replace("ode113", "ode15s");
    Gradient found = of(stiff, ALL, method, "x.q", "integral(x.q)");
    Gradient other = of(StudyModels.SPRING, ALL, method, "x.q", "integral(x.q)");
    for (int i = 0; i < 2; i++) {
      for (int k = 0; k < ALL.size(); k++) {
        // ode15s is of order 5: many more steps add up
        assertThat(found.derivatives()[i][k])
            .isCloseTo(other.derivatives()[i][k], within(100 * TOLERANCE));
      }
    }
  }

  /**
   * A ball falls from h and leaves the floor with e times its speed: with u = √(2gh), it is at t
   * after the first impact at T = u/g at x = e u (t − T) − g (t − T)²/2.
   */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void derivativesCrossAnImpact(GradientMethod method) throws Exception {
    double g = 10;
    double h = X0;
    double e = 0.5;
    double u = Math.sqrt(2 * g * h);
    double rest = 0.2 - u / g;
    Gradient found = of(ball(0.2), List.of("g", "e", "x.q"), method, "x.q", "x.v", "integral(x.q)");
    double byU = e * rest - (e * u - g * rest) / g;
    double byG = byU * u / (2 * g) - rest * rest / 2 + (e * u - g * rest) * u / (g * g);
    assertClose(found, 0, e * u * rest - g * rest * rest / 2, byG, u * rest, byU * g / u);
    double speedByU = e + 1;
    assertClose(
        found, 1, e * u - g * rest, speedByU * u / (2 * g) - rest - u / g, u, speedByU * g / u);
    double fallen = 2.0 / 3 * h * u / g;
    double sum = fallen + e * u * rest * rest / 2 - g * rest * rest * rest / 6;
    double byH = u / g + e * g / u * rest * rest / 2 + (-e * u * rest + g * rest * rest / 2) / u;
    assertThat(found.values()[2]).isCloseTo(sum, within(TOLERANCE));
    assertThat(found.derivatives()[2][1]).isCloseTo(u * rest * rest / 2, within(TOLERANCE));
    assertThat(found.derivatives()[2][2]).isCloseTo(byH, within(TOLERANCE));
  }

  /** An event that ends the run moves its end: the ball falls for √(2h/g). */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void anEndByAnEventMovesWithTheParameters(GradientMethod method) throws Exception {
    String stops =
        ball(0.2)
            .replace("action='set'", "action='stop'")
            .replace("<set name='x' velVals='-e*x.v'/>", "");
    Gradient found = of(stops, List.of("g", "x.q"), method, "x.v", "integral(x.q)", "mean(x.q)");
    double u = Math.sqrt(2 * 10 * X0);
    assertClose(found, 0, -u, -u / 20, -10 / u);
    double integral = 2.0 / 3 * X0 * u / 10;
    assertClose(found, 1, integral, -integral / 20, 1.5 * integral / X0);
    assertClose(found, 2, 2.0 / 3 * X0, 0, 2.0 / 3);
  }

  /**
   * Friction −c sign(v) turns with the motion: the swing from x0 ends at −x0 + 2c/k after half a
   * period.
   */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void derivativesCrossASwitchOfTheForces(GradientMethod method) throws Exception {
    String rubbing =
        StudyModels.SPRING
            .replace("tend='1'", "tend='1.5'")
            .replace("-k*x.q", "-k*x.q-c*signum(x.v)")
            .replace("</Parameters>", "<parameter name='c' value='0.2' unit='N'/></Parameters>")
            .replace("posVals='0.1'", "posVals='0.1' velVals='0'");
    Gradient found = of(rubbing, List.of("c", "x.q"), method, "min(x.q)", "at(x.q,1.5)");
    assertClose(found, 0, -X0 + 2 * 0.2 / K, 2 / K, -1);
    // behind the turn: x = −c/k + (−x0 + 3c/k) cos(ω(t − π/ω))
    double c = Math.cos(1.5 * OMEGA - Math.PI);
    assertClose(found, 1, -0.2 / K + (-X0 + 3 * 0.2 / K) * c, -1 / K + 3 / K * c, -c);
  }

  /**
   * A joint meets an elastic stop at speed v and leaves it after half a period of 0.1 s: the
   * integral of its energy is v²/2 · 0.05 s.
   */
  @ParameterizedTest
  @EnumSource(names = {"FORWARD", "ADJOINT"})
  void derivativesCrossTheStopOfAJoint(GradientMethod method) throws Exception {
    MechModel model = MechModel.read(Path.of("..", "examples", "elements", "joint-P.xml"));
    Gradient found =
        Gradients.of(
                model, List.of("slide.v"), List.of(Reduction.parse("integral(energy.potential)")))
            .compute(method);
    assertClose(found, 0, 0.025, 0.05);
  }

  @Test
  void theAdjointIsTheSameInASmallMemory() throws Exception {
    MechModel model = MechModel.of("model.xml", StudyModels.SPRING).until(200);
    List<Reduction> what = List.of(Reduction.parse("rms(x.q)"));
    Gradient wide = Gradients.of(model, ALL, what).compute(GradientMethod.ADJOINT);
    Gradient narrow = Gradients.of(model, ALL, what).memory(1).compute(GradientMethod.ADJOINT);
    assertThat(narrow.derivatives()).isDeepEqualTo(wide.derivatives());
  }

  @Test
  void theCheaperMethodIsChosenAndSaid() throws Exception {
    Gradient few = of(StudyModels.SPRING, List.of("k"), GradientMethod.AUTO, "x.q");
    assertThat(few.method()).isEqualTo(GradientMethod.FORWARD);
    Gradient many = of(StudyModels.SPRING, ALL, GradientMethod.AUTO, "x.q");
    assertThat(many.method()).isEqualTo(GradientMethod.ADJOINT);
    assertThat(many.reason())
        .isEqualTo("1 output by 4 parameters: about 7.0 runs forward, 4.0 adjoint");
    assertThat(many.differenced()).containsExactly("m");
  }

  @Test
  void whatHasNoDerivativeIsRefusedByName() {
    assertThatThrownBy(() -> of(StudyModels.SPRING, List.of("kk"), GradientMethod.AUTO, "x.q"))
        .hasMessageContaining("\"kk\"; did you mean \"k\"?");
    String stairs = StudyModels.SPRING.replace("-k*x.q", "-k*floor(x.q*100)");
    assertThatThrownBy(() -> of(stairs, List.of("k"), GradientMethod.AUTO, "x.q"))
        .hasMessageStartingWith("floor() of the state");
    assertThatThrownBy(() -> of(StudyModels.SPRING, List.of("k"), GradientMethod.AUTO, "y.q"))
        .hasMessageContaining("gradients know no column \"y.q\"");
  }

  private static String ball(double end) {
    return StudyModels.SPRING
        .replace("tend='1'", "tend='" + end + "'")
        .replace(
            "</dynamic>",
            "<event name='floor' expression='x.q' direction='falling' action='set'><set name='x'"
                + " velVals='-e*x.v'/></event></dynamic>")
        .replace(
            "</Parameters>",
            "<parameter name='g' value='10' unit='m/s^2'/><parameter name='e' value='0.5'/>"
                + "</Parameters>")
        .replace("-k*x.q", "-2*g");
  }

  private static void assertClose(Gradient found, int output, double value, double... slopes) {
    assertThat(found.values()[output]).isCloseTo(value, within(TOLERANCE));
    for (int k = 0; k < slopes.length; k++) {
      assertThat(found.derivatives()[output][k])
          .as("%s by %s", found.outputs().get(output), found.parameters().get(k))
          .isCloseTo(slopes[k], within(TOLERANCE * Math.max(1, Math.abs(slopes[k]))));
    }
  }
}

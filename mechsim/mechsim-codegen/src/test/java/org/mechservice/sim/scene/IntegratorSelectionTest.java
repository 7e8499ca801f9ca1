package org.mechservice.sim.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.scene.forecast.StiffnessForecast;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;

/** The automatic integrator goes by what of the spectrum at the start will last. */
class IntegratorSelectionTest {
  private static final Path EXAMPLES = Path.of("../../examples");

  private static String scene(String path) throws IOException {
    return Files.readString(EXAMPLES.resolve(path + ".xml"), StandardCharsets.UTF_8);
  }

  private static IntegratorSelection choice(String formulation, String text)
      throws MechmlException {
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    return IntegratorSelection.of(formulation, model.mechanism(), model.settings().run());
  }

  @ParameterizedTest
  @CsvSource({
    "extremes/spring_1e12_far_over_critical, 2.00e+08",
    "extremes/spring_1e6_far_over_critical, 1.00e+09",
    "extremes/stiff_1e9_c1e5, 8.87e+04"
  })
  void motionThatDiesAwayFastTakesAnImplicitMethodFromTheStart(String path, String rate)
      throws Exception {
    IntegratorSelection choice = choice("auto", scene(path));
    assertThat(choice.integrator()).isEqualTo("ode15s");
    assertThat(choice.reason()).hasValueSatisfying(why -> assertThat(why).contains(rate + " 1/s"));
  }

  /** 41 velocities, the fastest damped with 2.2e4 1/s over a quarter of a second. */
  @Test
  void largeStiffTreeTakesTheResidualFormUnlessAnotherIsAskedFor() throws Exception {
    String driver = scene("driver/variants/driver-ck100-elements");
    assertThat(choice("auto", driver).integrator()).isEqualTo("ode15sR");
    assertThat(choice("DTR", driver).integrator()).isEqualTo("ode15s");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "driver/variants/driver-c0-elements",
        "extremes/spring_1e12_undamped",
        "extremes/friction_at_rest",
        "extremes/impact_1e9_damped",
        "extremes/rtol_1e-2",
        "extremes/fourbar_redundant",
        "pendulum/pendulum"
      })
  void whatSwingsOrMayCeaseOrIsSlowIsFoundOutAlongTheRun(String path) throws Exception {
    IntegratorSelection choice = choice("auto", scene(path));
    assertThat(choice.integrator()).isEqualTo("switching");
    assertThat(choice.reason()).isEmpty();
  }

  /**
   * A preloaded spring of 2e12 N/m on the tip of two hinged bars: at the start one motion swings
   * with 2.2e6 rad/s, and the preload moves another away with ±3.1e6 1/s, as a buckling column.
   * Nothing decays: there is no damper. Steps counted over 0.01 s: 381 369 by ode113, 1 315 598 by
   * ode15s, twelve and forty times one for each radian at the start.
   */
  @ParameterizedTest
  @CsvSource({"auto, 1e+09", "ode113, 1e+09", "ode15s, 4e+09"})
  void whatThePreloadOfASpringMovesAwayDoesNotDecay(String integrator, String counted)
      throws Exception {
    String text = preloaded();
    assertThat(choice("auto", text).integrator()).isEqualTo("switching");
    MechmlModel model = MechmlReader.read("scene.xml", text.getBytes(StandardCharsets.UTF_8));
    assertThat(StiffnessForecast.of(model, model.settings().run().withIntegrator(integrator)))
        .hasValueSatisfying(
            found ->
                assertThat(found.text())
                    .contains("moves away with 3.08e+06 1/s", counted + " steps", "every method"));
  }

  private static String preloaded() {
    String bar =
        """
        <body name="%s"><point name="p1" x="0" y="0" z="0"/><point name="p2" x="1" y="0" z="0"/>
          <vector name="y" vx="0" vy="1" vz="0"/><cog x="0.5" y="0" z="0"/><mass value="1"/>
          <inertiaTensor Ixx="0" Iyy="1/12" Izz="1/12"/></body>
        """;
    return """
        <!DOCTYPE MechML SYSTEM "MechML.dtd">
        <MechML><MBSsimulation><dynamic><timeSet tini="0" tend="30" tstep="0.01"/>
          <integrator name="auto" relTol="1e-6" absTol="1e-9"/></dynamic></MBSsimulation>
        <MBSmodel name="preloaded" massUnits="kg" lengthUnits="m"><Bodies>
          <body name="Ground"><point name="p1" x="0" y="0" z="0"/>
            <point name="a" x="1.3" y="0" z="1.1"/><vector name="y" vx="0" vy="1" vz="0"/></body>
        """
        + bar.formatted("b0")
        + bar.formatted("b1")
        + """
        </Bodies><Joints>
          <joint name="j0" type="R"><body1 name="Ground" point="p1" vector="y"/>
            <body2 name="b0" point="p1" vector="y"/></joint>
          <joint name="j1" type="R"><body1 name="b0" point="p2" vector="y"/>
            <body2 name="b1" point="p1" vector="y"/></joint>
        </Joints><Forces><springDamper name="s" k="2e12" length0="1">
          <body1 name="Ground" point="a"/><body2 name="b1" point="p2"/></springDamper></Forces>
        <topology><root name="Ground"/><relCoorVals><jointVal name="j0" posVals="0.3" velVals="0"/>
          <jointVal name="j1" posVals="0.5" velVals="0"/></relCoorVals></topology>
        </MBSmodel></MechML>
        """;
  }

  /** A drive as stiff holds all along if it is linear in its coordinate, whatever it follows. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1e6*(0.3*sin(2*t) - j1.q) - 1e5*j1.v | ode15s",
        "-(1e5/2)*j1.v*2 + 3 | ode15s",
        "-1e5*j1.v*smoothStep(t) | switching",
        "-1e5*j1.v*abs(j1.v) - 1e5*j1.v | switching",
        "-1e5*bar1.p2.vz | switching",
        "5*sin(t) | switching"
      })
  void driveTakesAnImplicitMethodFromTheStartIfItIsLinear(String force, String integrator)
      throws Exception {
    String driven =
        scene("pendulum/pendulum")
            .replace(
                "</Forces>",
                "<jointForce name=\"m\" joint=\"j1\" expression=\"" + force + "\"/></Forces>");
    assertThat(choice("auto", driven).integrator()).isEqualTo(integrator);
  }

  /** A mass that lies on a spring; it swings with 1e5 rad/s by the amplitude given, m. */
  private static String lyingOnASpring(double off) {
    return """
        <MechML><MBSsimulation><dynamic><timeSet tini="0" tend="10" tstep="0.1"/>
          <integrator name="auto" relTol="1e-6" absTol="1e-6"/></dynamic></MBSsimulation>
        <MBSmodel name="spring" massUnits="kg" lengthUnits="m"><Bodies>
          <body name="G"><point name="o" x="0" y="0" z="0"/><vector name="z" vx="0" vy="0"
            vz="1"/></body><body name="a"><point name="o" x="0" y="0" z="0"/><vector name="z"
            vx="0" vy="0" vz="1"/><mass value="1"/></body></Bodies>
        <Joints><joint name="z" type="P"><body1 name="G" point="o" vector="z"/><body2 name="a"
          point="o" vector="z"/></joint></Joints>
        <Forces><jointForce name="k" joint="z" expression="-1e10*z.q"/></Forces>
        <topology><root name="G"/><relCoorVals><jointVal name="z" posVals="%s"/></relCoorVals>
        </topology></MBSmodel></MechML>
        """
        .formatted(off);
  }

  /** Below the tolerances the spring need not be followed; above them every method has to. */
  @ParameterizedTest
  @CsvSource({"1e-14, ode15sR", "1e-3, switching"})
  void undampedSpringIsFollowedOnlyIfItSwings(double off, String integrator) throws Exception {
    assertThat(choice("auto", lyingOnASpring(off)).integrator()).isEqualTo(integrator);
    assertThat(choice("DTR", lyingOnASpring(off)).integrator()).isEqualTo("switching");
  }

  /**
   * A beam of links on ball joints with bushings.
   *
   * @param damping of a joint, N·m·s
   */
  private static String beam(int links, double damping) {
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    StringBuilder forces = new StringBuilder();
    double length = 0.5 / links;
    double mass = 0.0566 / links;
    double turned = mass * length * length / 12;
    for (int i = 1; i <= links; i++) {
      String before = i == 1 ? "G" : "b" + (i - 1);
      bodies.append(
          ("<body name='b%d'><point name='s' x='0' y='0' z='0'/><point name='e' x='%s' y='0'"
                  + " z='0'/><cog x='%s' y='0' z='0'/><mass value='%s'/><inertiaTensor Ixx='2.4e-8'"
                  + " Iyy='%s' Izz='%s'/></body>")
              .formatted(i, length, length / 2, mass, turned, turned + 2e-8));
      joints.append(
          ("<joint name='j%d' type='S'><body1 name='%s' point='e'/><body2 name='b%d' point='s'/>"
                  + "</joint>")
              .formatted(i, before, i));
      double k = 6.0 * links;
      double c = damping * links / 32;
      forces.append(
          ("<bushing name='k%d' k='0;0;0;%s;%s;%s' c='0;0;0;%s;%s;%s'><body1 name='%s' point='e'/>"
                  + "<body2 name='b%d' point='s'/></bushing>")
              .formatted(i, k, k, 12 * k, c, c, 12 * c, before, i));
    }
    return ("<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='0.2' tstep='0.01'/><integrator"
            + " name='auto' relTol='1e-5' absTol='1e-6'/></dynamic></MBSsimulation><MBSmodel"
            + " name='beam' massUnits='kg' lengthUnits='m'><Bodies><body name='G'><point name='e'"
            + " x='0' y='0' z='0'/></body>%s</Bodies><Joints>%s</Joints><Forces>%s<forceTorque"
            + " name='tip' body='b%d' point='e' frame='world' fy='-6.29' fz='6.29'/></Forces>"
            + "<topology><root name='G'/></topology></MBSmodel></MechML>")
        .formatted(bodies, joints, forces, links);
  }

  /**
   * What the trial prefers does no more than 1.5 times the operations of the other method over a
   * stretch that it has not seen: four times as many steps.
   */
  @ParameterizedTest
  @CsvSource({"8, 0.004", "8, 0.4", "16, 0.004", "16, 0.4", "32, 0.004"})
  void whatTheTrialPrefersIsTheCheaperOneBeyondIt(int links, double damping) throws Exception {
    MechmlModel model =
        MechmlReader.read("beam.xml", beam(links, damping).getBytes(StandardCharsets.UTF_8));
    RunSettings run = model.settings().run();
    IntegratorSelection choice = IntegratorSelection.of("auto", model.mechanism(), run);
    assertThat(choice.reason())
        .hasValueSatisfying(why -> assertThat(why).contains("operations counted in a trial"));
    MethodTrial trial =
        MethodTrial.of(model.mechanism(), Formulation.RR_JF, IntegrationMethod.ODE15SR, run);
    double later = Math.min(run.tEnd(), 4 * trial.end());
    RunSettings longer = run.withOutput(later, later);
    MethodTrial residual =
        MethodTrial.whole(model.mechanism(), Formulation.RR_JF, IntegrationMethod.ODE15SR, longer);
    MethodTrial articulated =
        MethodTrial.whole(model.mechanism(), Formulation.DTR, IntegrationMethod.ODE15S, longer);
    double chosen =
        choice.integrator().equals("ode15s") ? articulated.operations() : residual.operations();
    assertThat(chosen)
        .isLessThanOrEqualTo(1.5 * Math.min(articulated.operations(), residual.operations()));
  }

  @Test
  void trialsAreTheSameEachTime() throws Exception {
    String beam = beam(8, 0.004);
    assertThat(choice("auto", beam)).isEqualTo(choice("auto", beam));
  }

  @Test
  void residualFormulationsHaveOneIntegrator() throws Exception {
    assertThat(choice("RR", scene("pendulum/pendulum")).integrator()).isEqualTo("ode15sR");
  }
}

package org.mechservice.mechml.resolve.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.dynamics.DataDrivenModel;

/** Damping and friction of a spherical joint, as attributes of it. */
class BallFrictionTest {
  /** A body with the moments 1, 2 and 3 kg·m² that turns in the ground or, with a, in the world. */
  private static MechmlModel model(String attributes) throws MechmlException {
    String inWorld = "body1=\"ground\" body2=\"ball\" at=\"0;0;0\"";
    boolean world = attributes.contains("WORLD");
    String text =
        """
        <MechML><MBSsimulation><dynamic><timeSet tini="0" tend="1" tstep="0.1"/></dynamic>
        </MBSsimulation><MBSmodel name="m" massUnits="kg" lengthUnits="m">
        <Bodies><body name="ground"><point name="o" x="0" y="0" z="0"/></body>
        <body name="ball"><point name="o" x="0" y="0" z="0"/><mass value="1"/>
        <inertiaTensor Ixx="1" Iyy="2" Izz="3"/></body></Bodies>
        <Joints><joint name="s" type="S" ATTRIBUTES>ENDS</joint></Joints>
        <Forces><gravity gx="0" gy="0" gz="0"/></Forces>
        <topology><root name="ground"/></topology></MBSmodel></MechML>
        """
            .replace("ATTRIBUTES", attributes.replace("WORLD", inWorld))
            .replace(
                "ENDS",
                world
                    ? ""
                    : "<body1 name=\"ground\" point=\"o\"/><body2 name=\"ball\" point=\"o\"/>");
    return MechmlReader.read("m.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  /**
   * Euler's equations without the gyroscopic moment, which the axes of the state do not have: about
   * one axis the torque is (c + f/√(ω² + s²)) ω.
   */
  @ParameterizedTest
  @CsvSource({
    "damping='0.4', 0.4, 0, 1",
    "friction='0.3' frictionSpeed='0.1', 0, 0.3, 0.1",
    "damping='0.4' friction='0.3' frictionSpeed='0.1' WORLD, 0.4, 0.3, 0.1",
  })
  void actAgainstTheAngularVelocity(String attributes, double c, double f, double s)
      throws MechmlException {
    MechmlModel model = model(attributes.replace('\'', '"'));
    DataDrivenModel equations = new DataDrivenModel(model.mechanism(), model.settings().run());
    for (int axis = 0; axis < 3; axis++) {
      double[] y = {1, 0, 0, 0, 0, 0, 0};
      y[4 + axis] = 0.7;
      double[] rate = new double[7];
      equations.derivative(0, y, rate);
      double torque = (c + f / Math.hypot(0.7, s)) * 0.7;
      // a handful of roundings
      assertThat(rate[4 + axis]).isCloseTo(-torque / (axis + 1), within(1e-14));
    }
  }

  @Test
  void columnIsThePowerLost() throws MechmlException {
    MechmlModel model = model("damping=\"0.4\"");
    assertThat(model.mechanism().forces())
        .singleElement()
        .satisfies(force -> assertThat(force.name()).isEqualTo("s.friction"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "damping='-1' | must not be negative",
        "friction='1' | friction needs frictionSpeed beside it",
        "friction='1' frictionSpeed='0' | must be positive",
        "stiffness='1' damping='2' | has no springs or stops; use a bushing",
        "damping='1;1;1' | damping",
      })
  void otherValuesAreRefused(String attributes, String what) {
    assertThatThrownBy(() -> model(attributes.replace('\'', '"')))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining(what);
  }
}

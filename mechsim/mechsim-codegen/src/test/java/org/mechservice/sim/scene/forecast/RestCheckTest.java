package org.mechservice.sim.scene.forecast;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Bodies that nothing moves, and warnings that are silenced.
 *
 * <pre>
 *   Ground --- swing (R about y) --- bar        hangs down at q = 0
 *          --- spin (R about z) --- disc        gravity has no moment about z
 * </pre>
 */
class RestCheckTest {
  /** The model; what stands in place of FORCES and STARTS is to be given. */
  private static String model(String attributes, String forces, String starts) {
    String axes =
        "<point name='o' x='0' y='0' z='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector name='z'"
            + " vx='0' vy='0' vz='1'/>";
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='2' tstep='0.1'/></dynamic>"
        + "</MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m' "
        + attributes
        + "><Bodies><body name='Ground'>"
        + axes
        + "</body><body name='bar'>"
        + axes
        + "<cog x='0' y='0' z='-0.5'/><mass value='1'/></body><body name='disc'>"
        + axes
        + "<mass value='2'/><inertiaTensor Ixx='0.1' Iyy='0.1' Izz='0.2'/></body></Bodies><Joints>"
        + joint("swing", "bar", "y")
        + joint("spin", "disc", "z")
        + "</Joints><Forces>"
        + forces
        + "<gravity gx='0' gy='0' gz='-9.81'/></Forces><topology><root name='Ground'/><relCoorVals>"
        + starts
        + "</relCoorVals></topology></MBSmodel></MechML>";
  }

  private static String joint(String name, String body, String vector) {
    return "<joint name='"
        + name
        + "' type='R'><body1 name='Ground' point='o' vector='"
        + vector
        + "'/><body2 name='"
        + body
        + "' point='o' vector='"
        + vector
        + "'/></joint>";
  }

  private static List<String> warnings(String text, ReadOptions options) throws MechmlException {
    byte[] content = text.getBytes(StandardCharsets.UTF_8);
    MechmlModel model = MechmlReader.read("m.xml", content, options);
    return CheckReport.of(model).warnings();
  }

  private static List<String> warnings(String forces, String starts) throws MechmlException {
    return warnings(model("", forces, starts), ReadOptions.NONE);
  }

  @Test
  void bodiesAtRestInEquilibriumAreNamed() throws MechmlException {
    assertThat(warnings("", ""))
        .singleElement()
        .asString()
        .contains("N-036 nothing moves bodies \"bar\", \"disc\"");
  }

  @Test
  void bodyThatGravityCannotMoveIsNamedBesideOneThatSwings() throws MechmlException {
    assertThat(warnings("", "<jointVal name='swing' posVals='0.3'/>"))
        .singleElement()
        .asString()
        .contains("N-036 nothing moves body \"disc\"");
  }

  /** A velocity, a motion, a torque over time, and a spring between the two bodies. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "|<jointVal name='spin' velVals='1'/>",
        "|<jointVal name='spin' driven='t^2'/>",
        "<jointForce name='f' joint='spin' expression='t'/>|",
        "<jointForce name='f' joint='spin' expression='-swing.q'/>|",
        "<springDamper name='s' k='10' length0='1'><body1 name='bar' point='o'/><body2"
            + " name='disc' point='o'/></springDamper>|"
      })
  void bodyThatSomethingMovesIsNot(String forcesAndStarts) throws MechmlException {
    String[] parts = forcesAndStarts.split("\\|", -1);
    String swinging = parts[1] + "<jointVal name='swing' posVals='0.3'/>";

    assertThat(warnings(parts[0].replace("length0='1'", ""), swinging)).isEmpty();
  }

  /** A coupling and a torque on a point over time, and constraints that time moves. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "<couplingSpringDamper name='k' expression='spin.q - 0.1*smoothStep(t-1)' quantity='angle'"
            + " k='100'/>",
        "<forceTorque name='f' body='disc' point='o' tz='0.1*smoothStep(t-1)'/>",
        "|<CoordConstraint name='c' expression='spin.q - swing.q - 0.1*smoothStep(t-1)'/>",
        "|<CoordConstraint name='c' expression='spin.q - ramp(t)'/>"
      })
  void bodyThatAFormulaOfTimeMovesLaterIsNot(String forcesAndConstraints) throws MechmlException {
    String[] parts = (forcesAndConstraints + "|").split("\\|", -1);
    String text =
        model("", parts[0], "")
            .replace("<Forces>", "<Constraints>" + parts[1] + "</Constraints><Forces>")
            .replace("<Constraints></Constraints>", "")
            .replace(
                "<Bodies>", "<Tables><table name='ramp' x='0;1;2' y='0;0;1'/></Tables><Bodies>");

    assertThat(warnings(text, ReadOptions.NONE))
        .noneMatch(warning -> warning.contains("N-036") && warning.contains("\"disc\""));
  }

  @Test
  void silencedWarningsAreNotGiven() throws MechmlException {
    String still = model("silence='body-stays-at-rest'", "", "");
    ReadOptions asked = ReadOptions.NONE.silencing(Set.of(MessageCode.BODY_STAYS_AT_REST.code()));

    assertThat(warnings(still, ReadOptions.NONE)).isEmpty();
    assertThat(warnings(model("", "", ""), asked)).isEmpty();
  }
}

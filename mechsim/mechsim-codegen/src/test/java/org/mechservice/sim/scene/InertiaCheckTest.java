package org.mechservice.sim.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.check.CheckReport;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.DataDrivenModel;

/** Joints that no inertia resists at the start are found before a run, which would end there. */
class InertiaCheckTest {
  private static MechmlModel model(String bodies, String joints, String rest)
      throws MechmlException {
    String text =
        "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.1'/></dynamic>"
            + "</MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m'><Bodies>"
            + "<body name='ground'/>"
            + bodies
            + "</Bodies><Joints>"
            + joints
            + "</Joints>"
            + rest
            + "<topology><root name='ground'/></topology></MBSmodel></MechML>";
    boolean hasOneVelocity = joints.contains("type='R'") || joints.contains("type='P'");
    String forces =
        "<Forces><gravity gx='0' gy='0' gz='-1'/>"
            + (hasOneVelocity ? "<jointForce name='f' joint='j1' expression='1'/>" : "")
            + "</Forces><topology>";
    return MechmlReader.read(
        "m.xml", text.replace("<topology>", forces).getBytes(StandardCharsets.UTF_8));
  }

  private static String body(String name, String mass, String more) {
    return "<body name='" + name + "'><mass value='" + mass + "'/>" + more + "</body>";
  }

  private static String joint(String name, String type, String body1, String body2, String axis) {
    return String.format(
        "<joint name='%s' type='%s' body1='%s' body2='%s'%s/>",
        name, type, body1, body2, axis.isEmpty() ? "" : " axis='" + axis + "'");
  }

  private static List<String> warnings(MechmlModel model) {
    return CheckReport.of(model).warnings();
  }

  /** Returns whether the accelerations at the start are singular, as a run would find. */
  private static boolean isSingular(MechmlModel model) {
    DataDrivenModel equations = new DataDrivenModel(model.mechanism(), model.settings().run());
    double[] y = new double[equations.description().stateCount()];
    equations.initialState(y);
    return equations.derivative(0, y, new double[y.length]) != ExplicitModel.REGULAR;
  }

  /** A point mass on the axis of a hinge, or at the centre of a ball joint, or on a line to it. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "R|0;0;1|",
        "R|0;0;1|<cog x='0' y='0' z='0.3'/>",
        "C|0;0;1|",
        "S||",
        "S||<cog x='0.3' y='0' z='0'/>"
      })
  void massOnTheAxisIsNoInertiaAboutIt(String text) throws MechmlException {
    String[] parts = text.split("\\|", -1);
    MechmlModel model =
        model(
            body("m", "1", "").replace("<mass", parts[2] + "<mass"),
            joint("j1", parts[0], "ground", "m", parts[1]),
            "");
    assertThat(isSingular(model)).isTrue();
    assertThat(warnings(model))
        .singleElement()
        .asString()
        .contains("S-086 joint \"j1\" moves body \"m\" in a direction in which neither");
  }

  @Test
  void massBesideTheAxisIsInertia() throws MechmlException {
    MechmlModel model =
        model(
            "<body name='m'><cog x='1e-3' y='0' z='0'/><mass value='1e-3'/></body>",
            joint("j1", "R", "ground", "m", "0;0;1"),
            "");
    assertThat(isSingular(model)).isFalse();
    assertThat(warnings(model)).isEmpty();
  }

  @Test
  void pointMassBeyondAnotherJointIsFoundThere() throws MechmlException {
    MechmlModel model =
        model(
            body("a", "1", "<inertiaTensor Ixx='1' Iyy='1' Izz='1'/>") + body("m", "1", ""),
            joint("j1", "P", "ground", "a", "0;0;1") + joint("j2", "R", "a", "m", "0;1;0"),
            "");
    assertThat(isSingular(model)).isTrue();
    assertThat(warnings(model)).singleElement().asString().contains("S-086 joint \"j2\"");
  }

  /** Two hinges about one axis, the body between them a point on it. */
  @Test
  void axesThatCoincideAreNamedTogether() throws MechmlException {
    MechmlModel model =
        model(
            body("a", "1", "") + body("m", "1", "<inertiaTensor Ixx='1' Iyy='1' Izz='1'/>"),
            joint("j1", "R", "ground", "a", "0;0;1") + joint("j2", "R", "a", "m", "0;0;1"),
            "");
    assertThat(isSingular(model)).isTrue();
    assertThat(warnings(model))
        .singleElement()
        .asString()
        .contains("N-002 at the start no inertia resists joint \"j1\", when it moves together")
        .contains("\"j2\"");
  }

  /** A light body that carries a heavy one: what is left is there, and lost in double precision. */
  @ParameterizedTest
  @CsvSource({"P, 1, 1e15, 1.0e+15", "P, 1e-8, 1e8, 1.0e+16", "R, 2, 1e15, 5.0e+14"})
  void bodiesOfTooDifferentSizesAreNamedWithTheirRatio(
      String type, String light, String heavy, String ratio) throws MechmlException {
    String tensor = "<inertiaTensor Ixx='%1$s' Iyy='%1$s' Izz='%1$s'/>";
    MechmlModel model =
        model(
            body("l", light, tensor.formatted(light)) + body("h", heavy, tensor.formatted(heavy)),
            joint("j1", type, "ground", "l", "0;0;1") + joint("j2", type, "l", "h", "0;0;1"),
            "");
    assertThat(isSingular(model)).isTrue();
    assertThat(warnings(model))
        .singleElement()
        .asString()
        .contains("N-002 at the start the inertia at joint \"j1\" is singular to double precision")
        .contains("only body \"l\"", "one part in " + ratio, "most of it body \"h\"");
    DataDrivenModel equations = new DataDrivenModel(model.mechanism(), model.settings().run());
    double[] y = new double[equations.description().stateCount()];
    equations.initialState(y);
    equations.derivative(0, y, new double[y.length]);
    assertThat(equations.lastDefect().cause()).contains("one part in " + ratio);
  }

  @Test
  void sizesThatDoublePrecisionTellsApartAreNotNamed() throws MechmlException {
    MechmlModel model =
        model(
            body("l", "1", "") + body("h", "1e12", ""),
            joint("j1", "P", "ground", "l", "0;0;1") + joint("j2", "P", "l", "h", "0;0;1"),
            "");
    assertThat(isSingular(model)).isFalse();
    assertThat(warnings(model)).noneMatch(warning -> warning.contains("N-002"));
  }

  /** A constraint that has nothing to do with the joint, and one that holds it. */
  @ParameterizedTest
  @CsvSource({"p.q - r.q, true", "p.q - j1.q, false"})
  void jointsOfLoopsAreJudgedByTheirConstraints(String relation, boolean found)
      throws MechmlException {
    MechmlModel model =
        model(
            body("m", "1", "") + body("a", "1", "") + body("b", "1", ""),
            joint("j1", "R", "ground", "m", "0;0;1")
                + joint("p", "P", "ground", "a", "0;0;1")
                + joint("r", "P", "ground", "b", "0;0;1"),
            "<Constraints><CoordConstraint name='c' expression='" + relation + "'/></Constraints>");
    assertThat(warnings(model).stream().anyMatch(warning -> warning.contains("S-086")))
        .isEqualTo(found);
  }
}

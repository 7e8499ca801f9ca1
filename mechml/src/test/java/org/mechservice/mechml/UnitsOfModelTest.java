package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.expression.ConstantEvaluation;
import org.mechservice.mechml.expression.ExpressionParser;
import org.mechservice.mechml.expression.Scope;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Accuracy;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.mechanism.joint.Prismatic;
import org.mechservice.solver.mechanism.joint.Revolute;
import org.mechservice.solver.mechanism.joint.Screw;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

/** Units of the file and of single values. */
class UnitsOfModelTest {
  private static final Pattern LENGTH = Pattern.compile("\\b(x|y|z|gx|gy|gz)=\"([^\"]*)\"");
  private static final Pattern MASS = Pattern.compile("\\bvalue=\"([^\"]*)\"");
  private static final Pattern INERTIA = Pattern.compile("\\b(I..)=\"([^\"]*)\"");

  @Test
  void pendulumInMillimetresAndGramsIsThePendulumInMetresAndKilograms() throws Exception {
    String si = Resources.text("FiveBarPendulum.xml");
    String small = LENGTH.matcher(si).replaceAll("$1=\"1000*($2)\"");
    small = MASS.matcher(small).replaceAll("value=\"1000*($1)\"");
    small = INERTIA.matcher(small).replaceAll("$1=\"1e9*($2)\"");
    small =
        small.replace("massUnits=\"kg\" lengthUnits=\"m\"", "massUnits=\"g\" lengthUnits=\"mm\"");
    Mechanism expected = mechanism(si);
    Mechanism actual = mechanism(small);
    // 1e9/12/1e9 rounds twice; the rest is exact.
    assertThat(actual)
        .usingRecursiveComparison()
        .withComparatorForType(UnitsOfModelTest::compareToRounding, Double.class)
        .isEqualTo(expected);
  }

  private static int compareToRounding(double a, double b) {
    return Math.abs(a - b) <= 2 * Math.ulp(b) ? 0 : Double.compare(a, b);
  }

  private static Mechanism mechanism(String text) throws MechmlException {
    return MechmlReader.read("pendulum.xml", text.getBytes(StandardCharsets.UTF_8)).mechanism();
  }

  @Test
  void millimetresAreTheNearestDoubles() throws MechmlException {
    ModelText model =
        ModelText.of("R")
            .withUnits("massUnits='g' lengthUnits='mm'")
            .withLink(
                "<point name='p' x='3' y='0.7' z='-123'/><vector name='u' vx='1' vy='0' vz='0'/>"
                    + "<cog x='1' y='0' z='0'/><mass value='7'/>"
                    + "<inertiaTensor Ixx='1' Iyy='2' Izz='3'/>");
    Body link = model.mechanism().bodies().get(0);
    assertThat(model.joint().attachment().childPoint())
        .isEqualTo(new Vector3(0.003, 0.0007, -0.123));
    assertThat(link.mass()).isEqualTo(0.007);
    assertThat(link.centerOfMass()).isEqualTo(new Vector3(0.001, 0, 0));
    assertThat(link.inertia()).isEqualTo(new InertiaTensor(1e-9, 2e-9, 3e-9, 0, 0, 0));
  }

  @Test
  void aValueMayCarryItsOwnUnit() throws MechmlException {
    ModelText model =
        ModelText.of("R")
            .withLink(
                "<point name='p' x='3' y='1' z='0' unit='mm'/><vector name='u' vx='1' vy='0'"
                    + " vz='0'/><cog x='1' y='0' z='0' unit='in'/><mass value='7'"
                    + " unit='t'/><inertiaTensor Ixx='1' Iyy='2' Izz='3' unit='kg*cm^2'/>");
    Body link = model.mechanism().bodies().get(0);
    assertThat(model.joint().attachment().childPoint()).isEqualTo(new Vector3(0.003, 0.001, 0));
    assertThat(link.mass()).isEqualTo(7000);
    assertThat(link.centerOfMass()).isEqualTo(new Vector3(0.0254, 0, 0));
    assertThat(link.inertia()).isEqualTo(new InertiaTensor(1e-4, 2e-4, 3e-4, 0, 0, 0));
  }

  @Test
  void anglesAreInAngleUnits() throws MechmlException {
    Revolute joint =
        (Revolute)
            ModelText.of("R")
                .withUnits("massUnits='kg' lengthUnits='mm' angleUnits='deg'")
                .withJointVal("<jointVal name='j' posVals='90' velVals='-180'/>")
                .joint();
    assertThat(joint.initialPosition()).isEqualTo(Math.PI / 2);
    assertThat(joint.initialVelocity()).isEqualTo(-Math.PI);
  }

  @Test
  void displacementsAreInLengthUnits() throws MechmlException {
    Prismatic joint =
        (Prismatic)
            ModelText.of("P")
                .withUnits("massUnits='kg' lengthUnits='mm' angleUnits='deg'")
                .withJointVal("<jointVal name='j' posVals='90' velVals='-180'/>")
                .joint();
    assertThat(joint.initialPosition()).isEqualTo(0.09);
    assertThat(joint.initialVelocity()).isEqualTo(-0.18);
  }

  @Test
  void ownUnitOfAStartCountsForPositionAndForVelocityPerSecond() throws MechmlException {
    Revolute joint =
        (Revolute)
            ModelText.of("R")
                .withJointVal("<jointVal name='j' posVals='90' velVals='-180' unit='deg'/>")
                .joint();
    assertThat(joint.initialPosition()).isEqualTo(Math.PI / 2);
    assertThat(joint.initialVelocity()).isEqualTo(-Math.PI);
  }

  @Test
  void trigonometryTakesRadiansWhateverAngleUnitsSays() throws MechmlException {
    Revolute joint =
        (Revolute)
            ModelText.of("R")
                .withUnits("massUnits='kg' lengthUnits='m' angleUnits='deg'")
                .withJointVal("<jointVal name='j' posVals='180*sin(PI/2)'/>")
                .joint();
    assertThat(joint.initialPosition()).isEqualTo(Math.PI);
  }

  @Test
  void aStartThatIsNotGivenIsZero() throws MechmlException {
    for (String start :
        new String[] {"", "<jointVal name='j'/>", "<jointVal name='j' posVals='0'/>"}) {
      Joint joint = ModelText.of("R").withJointVal(start).joint();
      assertThat(((Revolute) joint).initialPosition()).isZero();
      assertThat(((Revolute) joint).initialVelocity()).isZero();
    }
  }

  @Test
  void timesMayCarryTheirUnit() throws MechmlException {
    ModelText model =
        ModelText.of("R")
            .withSimulation(
                "<timeSet tini='0' tend='500' tstep='1' unit='ms'/>"
                    + "<integrator name='ode113' relTol='1e-6' absTol='1e-8' maxStep='0.1'"
                    + " initialStep='1e-4' maxOrder='5'/><formulation name='DTR'/>");
    assertThat(model.read().settings())
        .isEqualTo(
            new SimulationSettings(
                new RunSettings(0, 0.5, 0.001, "ode113", 1e-6, 1e-8, 0.1, 1e-4, 5), "DTR"));
  }

  @Test
  void accuracyIsStandardUnlessTheIntegratorNamesOne() throws MechmlException {
    String time = "<timeSet tini='0' tend='5' tstep='1'/>";
    String integrator = "<integrator name='ode113' relTol='1e-6' absTol='1e-8'";
    assertThat(ModelText.of("R").withSimulation(time + integrator + "/>").read().settings().run())
        .extracting(RunSettings::accuracy)
        .isEqualTo(Accuracy.STANDARD);
    assertThat(
            ModelText.of("R")
                .withSimulation(time + integrator + " accuracy='strict'/>")
                .read()
                .settings()
                .run())
        .extracting(RunSettings::accuracy)
        .isEqualTo(Accuracy.STRICT);
  }

  @Test
  void numbersOfThePenaltyFollowItsName() throws MechmlException {
    ModelText model =
        ModelText.of("R")
            .withSimulation(
                "<timeSet tini='0' tend='5' tstep='1'/>"
                    + "<integrator name='ode113' relTol='1e-6' absTol='1e-8'/>"
                    + "<formulation name='DSR' closure='penalty' alpha='2e8' mu='1/2'/>");
    assertThat(model.read().settings().closure()).isEqualTo("penalty:alpha=2.0E8,mu=0.5");
  }

  /** Lists mix lengths and angles, each in its own unit of the file; Euler parameters have none. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "C | vector='u' | vector='u' | 10;90 | 20;180 | 0.01;PI/2 | 0.02;PI",
        "PL | vector='u' vector2='w' | vector='u' | 10;20;90 | 1;2;180 | 0.01;0.02;PI/2 |"
            + " 1e-3;2e-3;PI",
        "U | vector='u' | vector='w' | 90;45 | 180;90 | PI/2;PI/4 | PI;PI/2",
        "S | | | 1;0;0;0 | 90;0;180 | 1;0;0;0 | PI/2;0;PI",
        "F | | | 1;0;0;0;1;2;3 | 90;0;0;4;5;6 | 1;0;0;0;1e-3;2e-3;3e-3 | PI/2;0;0;4e-3;5e-3;6e-3"
      })
  void listsOfAFileInMillimetresAndDegreesAreInMetresAndRadians(
      String type,
      @Nullable String end1,
      @Nullable String end2,
      String q,
      String v,
      String qSi,
      String vSi)
      throws Exception {
    String parts =
        "<point name='p' x='0' y='0' z='0'/><vector name='u' vx='1' vy='0' vz='0'/>"
            + "<vector name='w' vx='0' vy='1' vz='0'/>";
    ModelText model =
        ModelText.of(type)
            .withUnits("massUnits='kg' lengthUnits='mm' angleUnits='deg'")
            .withGround(parts)
            .withLink(parts)
            .withEnds(
                "name='Ground' point='p' " + (end1 == null ? "" : end1),
                "name='link' point='p' " + (end2 == null ? "" : end2))
            .withJointVal("<jointVal name='j' posVals='%s' velVals='%s'/>".formatted(q, v));
    double[] y = new double[13];
    model.mechanism().initialState(y);
    List<Double> expected = new ArrayList<>();
    for (String number : (qSi + ";" + vSi).split(";", -1)) {
      expected.add(ConstantEvaluation.of(ExpressionParser.parse(number.strip()), Scope.CONSTANTS));
    }
    for (int i = 0; i < expected.size(); i++) {
      assertThat(y[i]).isCloseTo(expected.get(i), within(1e-15));
    }
  }

  /** 6 mm a turn. */
  @Test
  void leadOfAScrewIsItsWayInAWholeTurn() throws Exception {
    String screw =
        ModelText.of("H")
            .withUnits("massUnits='kg' lengthUnits='mm' angleUnits='deg'")
            .text()
            .replace("type='H'", "type='H' lead='6'");
    Screw joint =
        (Screw)
            MechmlReader.read("screw.xml", screw.getBytes(StandardCharsets.UTF_8))
                .mechanism()
                .joints()
                .get(0);
    assertThat(joint.pitch()).isCloseTo(0.006 / (2 * Math.PI), within(1e-18));
  }
}

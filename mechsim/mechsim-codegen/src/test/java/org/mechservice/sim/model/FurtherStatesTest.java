package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.mechservice.sim.model.ModelAgreement.assertClose;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.LinearisedModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResidualModel;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.compact.CompactForm;

/**
 * States besides positions and velocities in generated code, against the data-driven formulations,
 * and in the equations of an implicit step, against differences of the residual.
 */
class FurtherStatesTest {
  private static final double TIME = 0.4;
  private static final double H_GAMMA = 0.03;

  private static final String AXES =
      "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector"
          + " name='z' vx='0' vy='0' vz='1'/>";

  private static final String HEAD =
      "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.1'/><integrator"
          + " name='ode113' relTol='1e-8' absTol='1e-8'/></dynamic></MBSsimulation><MBSmodel"
          + " name='controlled' massUnits='kg' lengthUnits='m'><Parameters><parameter name='k'"
          + " value='3' tunable='true'/></Parameters><Tables><table name='lin' x='-2;-0.5;0.3;2'"
          + " y='1;-1;0;2' extrapolation='hold'/><table name='aki' x='-9;-3;0;1;2;9'"
          + " y='0;2;1;1.5;0;1' method='akima'/><table name='cub' x='-1;0;0.2;1;2' y='0;1;-1;0;3'"
          + " method='cubic' extrapolation='linear'/><map name='lin2' x='-2;-0.5;0.3;2' y='-1;0;3'"
          + " z='1;-1;0; 2;0.5;1; -1;0;2; 3;1;0' extrapolation='linear'/><map name='aki2'"
          + " x='-9;-1;0;1;2;9' y='-5;0.1;5' z='0;2;1; 1.5;0;1; -1;1;0; 2;2;1; 0;1;3; 1;0;1'"
          + " method='akima' extrapolation='hold'/><map name='cub2' x='-9;0;9' y='-9;0;9'"
          + " z='1;0;2; 0;1;1; 3;0;-1' method='cubic'/></Tables>";

  /** A pendulum with a ball at its end and a driven slide, held by nonlinear controllers. */
  private static final String TREE =
      HEAD
          + "<Bodies><body name='Ground'><point name='o' x='0' y='0' z='0'/>"
          + AXES
          + "</body>"
          + body("arm")
          + body("bob")
          + body("cart")
          + "</Bodies><Joints>"
          + joint("hinge", "R", "Ground", "o", "arm", " vector='y'")
          + joint("ball", "S", "arm", "p", "bob", "")
          + joint("rail", "P", "Ground", "o", "cart", " vector='x'")
          + "</Joints><States><state name='a' x0='0.3' derivative='sin(hinge.q)*k + hinge.v^2 - a*b"
          + " + bob.p.vx + lin(hinge.q) + cub2(b, rail.q)'/><state name='b' x0='-0.2' derivative='(bob.p.z*a - b)/0.1"
          + " + ball.v[1]*rail.q' atol='1e-7' unit='Pa'/></States><Forces><gravity gx='0' gy='0'"
          + " gz='-9.81'/><jointForce name='motor' joint='hinge' expression='-4*a*hinge.v + b^2 +"
          + " t*a + cub(a) + lin(t) + lin2(a, hinge.v)'/><forceTorque name='push' body='bob' point='p' frame='world'"
          + " fx='5*b*bob.p.z + aki(bob.p.x)' tz='a*hinge.q + aki2(bob.p.z, bob.p.vx)'/></Forces><Outputs><output name='w'"
          + " expression='a*b'/></Outputs><topology><root name='Ground'/><relCoorVals><jointVal"
          + " name='hinge' posVals='0.4' velVals='1'/><jointVal name='ball' posVals='0.8;0.6;0;0'"
          + " velVals='1;2;-1'/><jointVal name='rail'"
          + " driven='0.1*sin(3*t) + 0.01*cub2(t, 1-3*t)'/></relCoorVals></topology></MBSmodel></MechML>";

  /** Driven free and spherical joints, one of them written outwards in, below hinges and a ball. */
  private static final String TURNS =
      HEAD
          + "<Bodies><body name='Ground'><point name='o' x='0' y='0' z='0'/>"
          + AXES
          + "</body>"
          + body("base")
          + body("arm")
          + body("bob")
          + body("tool")
          + body("tip")
          + "</Bodies><Joints>"
          + joint("stage", "F", "Ground", "o", "base", "")
          + joint("hinge", "R", "base", "p", "arm", " vector='y'")
          + joint("ball", "S", "arm", "p", "bob", "")
          + "<joint name='wrist' type='S'><body1 name='tool' point='o'/><body2 name='bob'"
          + " point='p'/></joint>"
          + joint("end", "R", "tool", "p", "tip", " vector='x'")
          + "</Joints><States><state name='a' x0='0.3' derivative='stage.q[1]*k + wrist.v[2]*end.q -"
          + " a*b'/><state name='b' derivative='tip.p.vz + wrist.q[3] - b'/></States><Forces><gravity"
          + " gx='0' gy='1' gz='-9.81'/><jointForce name='motor' joint='hinge' expression='-4*a +"
          + " stage.v[1]*end.v'/><forceTorque name='push' body='tip' point='p' frame='world'"
          + " fx='5*wrist.v[0] + tip.p.vx' tz='a*hinge.q*stage.q[5]'/></Forces><Outputs><output"
          + " name='w' expression='wrist.q[2]*stage.v[4]'/></Outputs><topology><root"
          + " name='Ground'/><relCoorVals><jointVal name='stage' driven='sin(2*t); 0.3*k*t^2; 1-t;"
          + " 0.2*t; 0.1*sin(3*t); cos(t)' rotation='zyx'/><jointVal name='wrist' driven='1;0.3*t;"
          + " sin(t); t^2'/><jointVal name='hinge' posVals='0.4' velVals='1'/><jointVal name='ball'"
          + " posVals='0.8;0.6;0;0' velVals='1;2;-1'/><jointVal name='end' posVals='-0.3'"
          + " velVals='2'/></relCoorVals></topology></MBSmodel></MechML>";

  /** A four-bar whose cut hinge is a coordinate of the controllers. */
  private static final String LOOP =
      HEAD
          + "<Bodies><body name='Ground'><point name='o' x='0' y='0' z='0'/><point name='p' x='2'"
          + " y='0' z='0'/>"
          + AXES
          + "</body>"
          + body("crank")
          + body("coupler")
          + body("rocker")
          + "</Bodies><Joints>"
          + joint("j1", "R", "Ground", "o", "crank", " vector='y'")
          + joint("j2", "R", "crank", "p", "coupler", " vector='y'")
          + joint("j3", "R", "Ground", "p", "rocker", " vector='y'")
          + joint("j4", "R", "coupler", "p", "rocker", " vector='y'")
              .replace("name='rocker' point='o'", "name='rocker' point='p'")
          + "</Joints><States>"
          + "<state name='a' x0='0.3' derivative='k*sin(j4.q) + j1.v*j4.v - a*b + aki(j4.q) + cub2(a, j4.q)'/>"
          + "<state name='b' derivative='(coupler.p.z - b)/0.1 + j2.q'/></States><Forces>"
          + "<jointForce name='motor' joint='j1' expression='2*a - b*j1.v + lin2(j2.q, j3.v)'/>"
          + "<jointForce name='brake' joint='j4' expression='-a^2*j4.v + b'/>"
          + "<forceTorque name='push' body='coupler' point='p' frame='body' fz='b*a'/></Forces>"
          + "<topology><root name='Ground'/><relCoorVals><jointVal name='j1' posVals='-1.2'"
          + " velVals='0.7' fixed='true'/><jointVal name='j2' posVals='1'/><jointVal name='j3'"
          + " posVals='-1.9'/></relCoorVals></topology></MBSmodel></MechML>";

  /** The four-bar on a base that is moved in six coordinates. */
  private static final String MOVED_LOOP =
      LOOP.replace("</body><body name='crank'", "</body>" + body("base") + "<body name='crank'")
          .replace("<Joints>", "<Joints>" + joint("stage", "F", "Ground", "o", "base", ""))
          .replace("<body1 name='Ground' point='o' vector", "<body1 name='base' point='o' vector")
          .replace("<body1 name='Ground' point='p' vector", "<body1 name='base' point='p2' vector")
          .replace("<body name='base'>", "<body name='base'><point name='p2' x='2' y='0' z='0'/>")
          .replace(
              "<relCoorVals>",
              "<relCoorVals><jointVal name='stage' driven='1; 0.2*t; sin(t); 0.5*t^2; t; 0.1*t^3;"
                  + " sin(2*t)'/>");

  private static String body(String name) {
    return "<body name='"
        + name
        + "'><point name='o' x='0' y='0' z='0'/><point name='p' x='1.3' y='0' z='0'/>"
        + AXES
        + "<cog x='0.5' y='0' z='0'/><mass value='2'/><inertiaTensor Ixx='0.1' Iyy='0.2'"
        + " Izz='0.25' Ixy='0' Ixz='0' Iyz='0'/></body>";
  }

  private static String joint(
      String name, String type, String on, String at, String body, String axis) {
    return "<joint name='%s' type='%s'><body1 name='%s' point='%s'%s/><body2 name='%s' point='o'%s/></joint>"
        .formatted(name, type, on, at, axis, body, axis);
  }

  private static MechmlModel read(String text) throws Exception {
    return MechmlReader.read("controlled.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  private static BuildOptions options(String formulation, String closure, boolean compact) {
    RunSettings settings = new RunSettings(0, 1, 0.1, "ode15sR", 1e-6, 1e-8);
    return new BuildOptions(formulation, closure, compact, Set.of(), settings);
  }

  private static ExplicitModel model(String text, String formulation, String closure, boolean data)
      throws Exception {
    MechmlModel file = read(text);
    BuildOptions options = options(formulation, closure, data);
    GeneratedModel generated = ModelFactory.generate(file, options);
    assertThat(generated.operations() > 0).isNotEqualTo(data);
    Model made = ModelFactory.compile(file, options, generated).newInstance();
    return (ExplicitModel) ModelParts.of(made).equations();
  }

  private static double[] start(ExplicitModel model) {
    int unknowns =
        model instanceof ResidualModel residual
            ? residual.unknownCount()
            : model.description().stateCount();
    double[] y = new double[unknowns];
    model.initialState(y);
    return y;
  }

  @ParameterizedTest
  @CsvSource({"DTR, auto", "DSR, auto", "RR, auto", "RR-JF, auto"})
  void codeOfTreesHasTheDerivativesOfTheData(String formulation, String closure) throws Exception {
    assertSameDerivatives(TREE, formulation, closure);
  }

  @ParameterizedTest
  @CsvSource({"DTR, auto", "DSR, auto", "RR, auto", "RR-JF, auto"})
  void codeOfDrivenTurnsHasTheDerivativesOfTheData(String formulation, String closure)
      throws Exception {
    assertSameDerivatives(TURNS, formulation, closure);
  }

  @ParameterizedTest
  @CsvSource({
    "DSR, projection",
    "DSR, penalty",
    "RR, projection",
    "RR, penalty",
    "RR-JF, projection",
    "RR-JF, penalty"
  })
  void codeOfLoopsOnADrivenBaseHasTheDerivativesOfTheData(String formulation, String closure)
      throws Exception {
    assertSameDerivatives(MOVED_LOOP, formulation, closure);
  }

  /** Energies, poses, driving forces and outputs of code and data. */
  @Test
  void columnsOfDrivenTurnsAreThoseOfTheData() throws Exception {
    double[] code = columns(false);
    double[] data = columns(true);
    assertThat(code.length).isGreaterThan(60);
    assertClose(code, data, 1e-11);
  }

  private static double[] columns(boolean compact) throws Exception {
    MechmlModel file = read(TURNS);
    RunSettings settings = new RunSettings(0, 1, 0.1, "ode113", 1e-6, 1e-8);
    BuildOptions options =
        new BuildOptions("DTR", "auto", compact, EnumSet.allOf(ColumnGroup.class), settings);
    Model made =
        ModelFactory.compile(file, options, ModelFactory.generate(file, options)).newInstance();
    double[] y = start((ExplicitModel) ModelParts.of(made).equations());
    ResultColumns columns = ModelParts.of(made).columns();
    List<Double> all = new ArrayList<>();
    for (ColumnGroup group : ColumnGroup.values()) {
      double[] values = new double[columns.columns(group).size()];
      columns.values(group, TIME, y, values, 0);
      Arrays.stream(values).forEach(all::add);
    }
    return all.stream().mapToDouble(Double::doubleValue).toArray();
  }

  @ParameterizedTest
  @CsvSource({
    "DSR, projection",
    "DSR, penalty",
    "RR, projection",
    "RR, penalty",
    "RR-JF, projection",
    "RR-JF, penalty"
  })
  void codeOfLoopsHasTheDerivativesOfTheData(String formulation, String closure) throws Exception {
    assertSameDerivatives(LOOP, formulation, closure);
  }

  private static void assertSameDerivatives(String text, String formulation, String closure)
      throws Exception {
    ExplicitModel code = model(text, formulation, closure, false);
    ExplicitModel data = model(text, formulation, closure, true);
    double[] y = start(code);
    assertThat(y).isEqualTo(start(data));
    assertThat(y[code.description().stateCount() - 2]).isEqualTo(0.3);
    double[] expected = new double[y.length];
    double[] actual = new double[y.length];
    assertThat(data.derivative(TIME, y, expected)).isEqualTo(ExplicitModel.REGULAR);
    assertThat(code.derivative(TIME, y, actual)).isEqualTo(ExplicitModel.REGULAR);
    assertClose(actual, expected, 1e-12);
    if (code instanceof ResidualModel residual) {
      double[] yDot = new Random(3).doubles(y.length, -1, 1).toArray();
      ((ResidualModel) ModelParts.of(data).equations()).residual(TIME, y, yDot, expected);
      residual.residual(TIME, y, yDot, actual);
      assertClose(actual, expected, 1e-12);
    }
    if (code instanceof LinearisedModel step) {
      assertClose(
          solved(step, y), solved((LinearisedModel) ModelParts.of(data).equations(), y), 1e-8);
    }
  }

  private static double[] solved(LinearisedModel model, double[] y) {
    double[] yDot = new double[y.length];
    double[] state = y.clone();
    model.consistent(TIME, state, yDot);
    double[] r = new double[y.length];
    model.residual(TIME, state, yDot, r);
    assertThat(model.linearise(TIME, state, yDot)).isTrue();
    assertThat(model.factor(H_GAMMA)).isTrue();
    int states = model.description().stateCount();
    Arrays.fill(r, 0);
    for (int i = model.description().positionCount(); i < states; i++) {
      r[i] = Math.sin(i) * 1e-6;
    }
    model.solve(r);
    return r;
  }

  private static String numbers(int count) {
    return IntStream.range(0, count).mapToObj(Integer::toString).collect(Collectors.joining(";"));
  }

  /** Tables of several hundred points, at, between and beyond the points. */
  @ParameterizedTest
  @CsvSource({"linear, hold", "linear, linear", "akima, error", "cubic, linear", "cubic, hold"})
  void codeOfLargeTablesHasTheBitsOfTheData(String method, String outside) throws Exception {
    Random random = new Random(7);
    StringBuilder x = new StringBuilder("-50");
    StringBuilder y = new StringBuilder("0");
    double at = -50;
    for (int i = 1; i < 700; i++) {
      at += 0.05 + 0.1 * random.nextDouble();
      x.append(';').append(at);
      y.append(';').append(random.nextGaussian());
    }
    String z =
        random.doubles(30 * 20, -1, 1).mapToObj(Double::toString).collect(Collectors.joining(";"));
    String table =
        "<table name='big' x='%s' y='%s' method='%s' extrapolation='%s'/>"
                .formatted(x, y, method, outside)
            + "<map name='field' x='%s' y='%s' z='%s' method='%s' extrapolation='%s'/></Tables>"
                .formatted(numbers(30), numbers(20), z, method, outside);
    String text =
        TREE.replace("</Tables>", table)
            .replace(
                "derivative='sin(hinge.q)*k", "derivative='big(10*t) + field(t+15, 9-t)+0*sin(k")
            .replace(" + hinge.v^2 - a*b + bob.p.vx + lin(hinge.q) + cub2(b, rail.q)'", ")'");
    ExplicitModel code = model(text, "DTR", "auto", false);
    ExplicitModel data = model(text, "DTR", "auto", true);
    double[] state = start(code);
    int a = code.description().stateCount() - 2;
    double[] expected = new double[state.length];
    double[] actual = new double[state.length];
    for (int i = 0; i < 400; i++) {
      double time = i < 200 ? 10 * random.nextGaussian() : at * random.nextInt(2) / 10 - 5;
      int ended = data.derivative(time, state, expected);
      assertThat(code.derivative(time, state, actual)).isEqualTo(ended);
      assertThat(actual[a]).isEqualTo(Double.valueOf(expected[a]));
    }
  }

  @ParameterizedTest
  @CsvSource({"false, false", "true, false", "false, true", "true, true"})
  void stepSolvesTheLinearisedResidual(boolean data, boolean turns) throws Exception {
    LinearisedModel model =
        (LinearisedModel)
            ModelParts.of(model(turns ? TURNS : TREE, "RR-JF", "auto", data)).equations();
    double[] y = start(model);
    double[] yDot = new double[y.length];
    model.derivative(TIME, y, yDot);
    assertThat(model.linearise(TIME, y, yDot)).isTrue();
    assertThat(model.factor(H_GAMMA)).isTrue();
    double[] r = new Random(5).doubles(y.length, -1, 1).toArray();
    // what is not tangent to the unit norm of the Euler parameters is not solved for
    Arrays.fill(r, 1, 5, 0);
    double[] d = r.clone();
    model.solve(d);
    double epsilon = 1e-4;
    double[] plus = residual(model, y, yDot, d, epsilon);
    double[] minus = residual(model, y, yDot, d, -epsilon);
    double[] found = new double[y.length];
    Arrays.setAll(found, i -> (plus[i] - minus[i]) / (2 * epsilon));
    // central differences: the square of the step
    assertClose(found, r, 1e-5);
  }

  private static double[] residual(
      LinearisedModel model, double[] y, double[] yDot, double[] d, double factor) {
    double[] at = new double[y.length];
    double[] rate = new double[y.length];
    Arrays.setAll(at, i -> y[i] + factor * H_GAMMA * d[i]);
    Arrays.setAll(rate, i -> yDot[i] + factor * d[i]);
    double[] r = new double[y.length];
    assertThat(model.residual(TIME, at, rate, r)).isEqualTo(ExplicitModel.REGULAR);
    return r;
  }

  @Test
  void sourceHasTheBitsOfTheClassFile() throws Exception {
    for (String text : new String[] {TREE, LOOP}) {
      MechmlModel file = read(text);
      BuildOptions options = options("RR-JF", "auto", false);
      GeneratedModel generated = ModelFactory.generate(file, options);
      Model source = ModelFactory.compileSource(file, options, generated).newInstance();
      Model bytes = ModelFactory.compile(file, options, generated).newInstance();
      assertThat(source.description()).isEqualTo(bytes.description());
      assertThat(source.description().furtherStates()).hasSize(2);
      ExplicitModel first = (ExplicitModel) ModelParts.of(source).equations();
      ExplicitModel second = (ExplicitModel) ModelParts.of(bytes).equations();
      double[] y = start(first);
      double[] expected = new double[y.length];
      double[] actual = new double[y.length];
      first.derivative(TIME, y, expected);
      second.derivative(TIME, y, actual);
      assertThat(actual).isEqualTo(expected);
    }
  }

  @Test
  void statesSurviveTheCompactForm() throws Exception {
    var mechanism = read(TREE).mechanism();
    var again = CompactForm.read(CompactForm.write(mechanism));
    assertThat(again.furtherStates()).isEqualTo(mechanism.furtherStates());
    assertThat(again.furtherStates().get(1).unit()).isEqualTo("Pa");
  }
}

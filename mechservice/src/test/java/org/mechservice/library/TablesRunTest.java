package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.Trajectory;

/** Runs of models with tables, against closed solutions. */
class TablesRunTest {
  private static final String AXES = "<vector name='x' vx='1' vy='0' vz='0'/>";

  @TempDir private Path folder = Path.of("");

  private static String slide(String tables, String force, String driven) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='2' tstep='0.25'/><integrator"
        + " name='ode113' relTol='1e-10' absTol='1e-12'/></dynamic></MBSsimulation><MBSmodel"
        + " name='m' massUnits='kg' lengthUnits='m'><Tables>"
        + tables
        + "</Tables><Bodies><body name='Ground'><point name='o' x='0' y='0' z='0'/>"
        + AXES
        + "</body><body name='cart'><point name='o' x='0' y='0' z='0'/>"
        + AXES
        + "<mass value='1'/></body><body name='trolley'><point name='o' x='0' y='0' z='0'/>"
        + AXES
        + "<mass value='1'/></body></Bodies><Joints><joint name='j' type='P'><body1 name='Ground'"
        + " point='o' vector='x'/><body2 name='cart' point='o' vector='x'/></joint><joint name='k'"
        + " type='P'><body1 name='cart' point='o' vector='x'/><body2 name='trolley' point='o'"
        + " vector='x'/></joint></Joints><Forces><jointForce name='f' joint='j' expression='"
        + force
        + "'/></Forces><topology><root name='Ground'/><relCoorVals><jointVal name='k' driven='"
        + driven
        + "'/></relCoorVals></topology></MBSmodel></MechML>";
  }

  private static MechModel of(String text) throws MechmlException {
    return MechModel.of("m.xml", text);
  }

  private static double last(Trajectory rows, String column) {
    double[] values = rows.column(column);
    return values[values.length - 1];
  }

  @ParameterizedTest
  @CsvSource({
    "DTR, ode113",
    "DSR, DE",
    "DTR, ode15s",
    "RR, ode15sR",
    "RR-JF, ode15sR",
    "DTR, auto"
  })
  void cornersOverTimeAreMet(String formulation, String integrator) throws Exception {
    String table = "<table name='f1' x='0;0.3;1;2' y='0;2;-1;1' extrapolation='hold'/>";
    Trajectory rows =
        of(slide(table, "2*f1(t)", "0")).formulation(formulation).integrator(integrator).simulate();
    // the area under the table
    double area = 0.3 + 0.5 * 0.7 + 0;
    assertThat(last(rows, "j.v")).isCloseTo(area, within(1e-8));
  }

  @Test
  void springByTableSwingsAsTheLine() throws Exception {
    // a table on a straight line is a spring of 2 N/m on 2 kg, whatever the method
    for (String method : new String[] {"linear", "akima", "cubic"}) {
      String table =
          "<table name='spring' x='-3;-1;0;0.5;2;4' y='-6;-2;0;1;4;8' method='" + method + "'/>";
      Trajectory rows = of(slide(table, "1 - spring(j.q)", "0")).simulate();
      assertThat(last(rows, "j.q")).isCloseTo((1 - Math.cos(2)) / 2, within(1e-8));
    }
  }

  @Test
  void largeTablesAreCode() throws Exception {
    String x = list(0, "%d*0.01");
    String y = list(0, "sin(%d*0.01)");
    String table = "<table name='wave' x='" + x + "' y='" + y + "' method='cubic'/>";
    Trajectory rows = of(slide(table, "2*wave(t)", "0")).simulate();
    assertThat(last(rows, "j.v")).isCloseTo(1 - Math.cos(2), within(1e-8));
    // 1/2 of a fourth difference of the sine over 24: 2e-11
    Trajectory plain = of(slide("", "2*sin(t)", "0")).simulate();
    assertThat(rows.column("j.q")).containsExactly(plain.column("j.q"), within(1e-8));
  }

  private static String list(int from, String format) {
    return IntStream.rangeClosed(from, 200)
        .mapToObj(i -> format.formatted(i))
        .collect(Collectors.joining(";"));
  }

  /** On z = x y a map is its arguments' product for every method, so runs have closed solutions. */
  @ParameterizedTest
  @CsvSource({
    "DTR, ode113, linear",
    "DSR, DE, akima",
    "DTR, ode15s, cubic",
    "RR, ode15sR, akima",
    "RR-JF, ode15sR, cubic",
    "DTR, auto, linear"
  })
  void mapsOfTimeAndStateAreWhatTheyTabulate(String formulation, String integrator, String method)
      throws Exception {
    // 2 x'' = 1 - x (1 + t) + x t
    String map =
        "<map name='f2' x='-3;-1;0;0.5;4' y='-1;0.5;4' z='3;-1.5;-12;1;-0.5;-4;0;0;0;"
            + "-0.5;0.25;2;-4;2;16' method='%s'/>".formatted(method);
    Trajectory rows =
        of(slide(map, "2 - 2*f2(j.q, 1 + t) + 2*f2(j.q, t)", "0"))
            .formulation(formulation)
            .integrator(integrator)
            .simulate();
    assertThat(last(rows, "j.q")).isCloseTo(1 - Math.cos(2), within(1e-8));
    assertThat(last(rows, "j.v")).isCloseTo(Math.sin(2), within(1e-8));
  }

  @Test
  void linesOfABilinearMapAreMetInTime() throws Exception {
    // roofs over t with ridges at 0.3 and 1.7: areas of the broken line
    String map =
        "<map name='f2' x='0;0.3;2' y='0;1.7;3' z='0;1;0; 2;3;1; 0;1;0' extrapolation='hold'/>";
    Trajectory rows = of(slide(map, "2*f2(t, 0)", "0")).simulate();
    assertThat(last(rows, "j.v")).isCloseTo(2, within(1e-9));
    Trajectory other = of(slide(map, "2*f2(0.3, t)", "0")).simulate();
    double area = 2.5 * 1.7 + 0.3 * (3 - 0.15 * 2 / 1.3);
    assertThat(last(other, "j.v")).isCloseTo(area, within(1e-9));
  }

  @Test
  void fileOfAMapIsItsGrid() throws Exception {
    Path model = folder.resolve("m.xml");
    Files.writeString(
        folder.resolve("engine.csv"), "# torque\nspeed/throttle;0;1\n0;0;3\n1;1;2\n2;0;1\n");
    String map = "<map name='f2' %s extrapolation='hold'/>";
    Files.writeString(model, slide(map.formatted("file='engine.csv'"), "2*f2(t, 0.5)", "0"));
    Trajectory rows = MechModel.read(model).simulate();
    Trajectory inline =
        of(slide(map.formatted("x='0;1;2' y='0;1' z='0;3;1;2;0;1'"), "2*f2(t, 0.5)", "0"))
            .simulate();
    assertThat(rows.column("j.v")).isEqualTo(inline.column("j.v"));
    Files.writeString(folder.resolve("engine.csv"), "x;0;1\n0;0;3\n1;1\n");
    assertThatThrownBy(() -> MechModel.read(model))
        .hasMessageContaining("has 2 cells between semicolons, and the first row has 3");
    Files.writeString(folder.resolve("engine.csv"), "x;0;1\n0;0;3\n");
    assertThatThrownBy(() -> MechModel.read(model)).hasMessageContaining("a map has a first row");
    assertSaid(map.formatted("file='engine.csv'"), "f2(t,0)", "its file was not read");
  }

  @Test
  void drivenJointFollowsTheCurveWithItsDerivatives() throws Exception {
    // a cubic is exact in the spline, so the trolley moves by t^3 and drives the cart back
    String table =
        "<table name='way' x='0;0.5;1;1.5;2' y='0;0.125;1;3.375;8' method='cubic'"
            + " extrapolation='linear'/>";
    Trajectory rows = of(slide(table, "0", "way(t)")).simulate();
    assertThat(last(rows, "j.q")).isCloseTo(-4, within(1e-8));
    assertThat(last(rows, "j.v")).isCloseTo(-6, within(1e-7));
    Trajectory jumps =
        of(slide("<table name='way' x='0;1;2' y='0;1;3'/>", "0", "way(t)")).simulate();
    // momentum is kept when the velocity of the trolley on the cart jumps from 1 to 2
    assertThat(last(jumps, "j.v")).isCloseTo(-0.5, within(1e-8));
  }

  @Test
  void fileBesideTheModelIsItsPoints() throws Exception {
    Path model = folder.resolve("m.xml");
    Files.writeString(
        folder.resolve("road.csv"), "# measured\ns;h;t\n0;0;0\n9;3;0.3\n5;2;1\n1;0;2\n");
    String table = "<table name='f1' %s extrapolation='hold'/>";
    Files.writeString(
        model,
        slide(
            table.formatted("file='road.csv' xColumn='t' yColumn='2'")
                + "<!-- <table file='no'/> -->",
            "2*f1(t)",
            "0"));
    Trajectory rows = MechModel.read(model).simulate();
    Trajectory inline =
        of(slide(table.formatted("x='0;0.3;1;2' y='0;3;2;0'"), "2*f1(t)", "0")).simulate();
    assertThat(rows.column("j.v")).isEqualTo(inline.column("j.v"));
    Files.writeString(model, slide(table.formatted("file='../road.csv'"), "f1(t)", "0"));
    assertThatThrownBy(() -> MechModel.read(model)).hasMessageContaining("model's folder");
    Files.writeString(model, slide(table.formatted("file='no.csv'"), "f1(t)", "0"));
    assertThatThrownBy(() -> MechModel.read(model)).hasMessageContaining("does not exist");
    Files.writeString(model, slide(table.formatted("file='road.csv' xColumn='u'"), "f1(t)", "0"));
    assertThatThrownBy(() -> MechModel.read(model))
        .hasMessageContaining("there is no column \"u\"; there are s, h, t");
    assertSaid(table.formatted("file='road.csv'"), "f1(t)", "its file was not read");
    assertSaid(table.formatted(""), "f1(t)", "write x and y");
  }

  @Test
  void endOfATableIsSaid() throws Exception {
    String table = "<table name='short' x='0;1' y='0;1'/>";
    assertThatThrownBy(() -> of(slide(table, "short(t)", "0")).simulate())
        .hasMessageContaining("short(t)");
    assertThatThrownBy(() -> of(slide(table, "short(3)", "0")))
        .hasMessageContaining("table short has no value at 3.0: its arguments go from 0.0 to 1.0");
  }

  @Test
  void mistakesAreNamed() {
    assertSaid("<table name='a' x='0;1' y='0;1;2'/>", "a(t)", "x has 2 values and y has 3");
    assertSaid("<table name='a' x='0;0' y='0;1'/>", "a(t)", "x must ascend");
    assertSaid("<table name='a' x='0' y='0'/>", "a(t)", "two points at least");
    assertSaid("<table name='sin' x='0;1' y='0;1'/>", "sin(t)", "is a function of expressions");
    assertSaid("<table name='road' x='0;1' y='0;1'/>", "raod(t)", "road");
    assertSaid("<table name='road' x='0;1' y='0;1'/>", "road(t, 1)", "takes 1 argument");
    assertSaid("<table name='road' x='0;1' y='0;q'/>", "road(t)", "q");
    String map = "<map name='m' x='0;1' y='0;1' z='0;1;2;3'/>";
    assertSaid(map, "m(t)", "map m takes 2 arguments, not 1");
    assertSaid(map, "m(0, 2)", "map m has no value at 0.0, 2.0: its arguments go from 0.0 to 1.0,");
    assertSaid(map.replace("2;3", "2"), "m(t, 0)", "z has 3 values, but 2 values of x and 2 of y");
    assertSaid(map.replace("y='0;1'", "y='1;0'"), "m(t, 0)", "y must ascend");
    assertSaid(map.replace("z='0;1;2;3'", ""), "m(t, 0)", "write x, y and z");
  }

  private static void assertSaid(String table, String force, String words) {
    assertThatThrownBy(() -> of(slide(table, force, "0")))
        .isInstanceOf(MechmlException.class)
        .hasMessageContaining(words);
  }
}

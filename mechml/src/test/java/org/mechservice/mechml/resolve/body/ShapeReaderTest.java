package org.mechservice.mechml.resolve.body;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.ModelText;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;

class ShapeReaderTest {
  /** Rounding of sums of a few dozen terms. */
  private static final double ROUNDING = 1e-13;

  private static final String FRAME =
      "<point name='p' x='0' y='0' z='0'/>%s<vector name='u' vx='1' vy='0' vz='0'/>%s";

  private static Body body(String points, String solids) throws Exception {
    return ModelText.of("R")
        .withLink(String.format(Locale.ROOT, FRAME, points, solids))
        .mechanism()
        .bodies()
        .get(0);
  }

  private static String point(String name, double x, double y, double z) {
    return String.format(
        Locale.ROOT, "<point name='%s' x='%.17g' y='%.17g' z='%.17g'/>", name, x, y, z);
  }

  private static double[] elements(InertiaTensor i) {
    return new double[] {i.xx(), i.yy(), i.zz(), i.xy(), i.xz(), i.yz()};
  }

  private static void assertSame(Body actual, Body expected) {
    assertThat(actual.mass()).isCloseTo(expected.mass(), within(ROUNDING * expected.mass()));
    assertThat(actual.centerOfMass().minus(expected.centerOfMass()).norm()).isLessThan(ROUNDING);
    double largest = expected.inertia().trace();
    assertThat(elements(actual.inertia()))
        .containsExactly(elements(expected.inertia()), within(ROUNDING * largest));
  }

  /** A box cut by three planes is the sum of its eight pieces, wherever the cuts lie. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void boxIsTheSumOfItsPieces(long seed) throws Exception {
    Random random = new Random(seed);
    double[] edge = new double[3];
    double[] cut = new double[3];
    for (int k = 0; k < 3; k++) {
      edge[k] = 0.2 + random.nextDouble();
      cut[k] = edge[k] * (0.1 + 0.8 * random.nextDouble());
    }
    StringBuilder points = new StringBuilder();
    StringBuilder pieces = new StringBuilder();
    for (int piece = 0; piece < 8; piece++) {
      double[] size = new double[3];
      double[] center = new double[3];
      for (int k = 0; k < 3; k++) {
        boolean upper = (piece >> k & 1) == 1;
        size[k] = upper ? edge[k] - cut[k] : cut[k];
        center[k] = (upper ? cut[k] + size[k] / 2 : size[k] / 2) - edge[k] / 2;
      }
      points.append(point("c" + piece, center[0], center[1], center[2]));
      pieces.append(box(size, "point='c" + piece + "'"));
    }
    assertSame(body(points.toString(), pieces.toString()), body("", box(edge, "")));
  }

  private static String box(double[] edges, String place) {
    return String.format(
        Locale.ROOT,
        "<box x='%.17g' y='%.17g' z='%.17g' density='1200' %s/>",
        edges[0],
        edges[1],
        edges[2],
        place);
  }

  /** The same for a cylinder cut across its axis, and for its core and its shell. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void cylinderIsTheSumOfItsSlicesAndShells(long seed) throws Exception {
    Random random = new Random(seed);
    double[] end = random.doubles(3, -1, 1).toArray();
    double part = 0.1 + 0.8 * random.nextDouble();
    String points =
        point("end", end[0], end[1], end[2])
            + point("cut", part * end[0], part * end[1], part * end[2]);
    Body whole = body(points, "<cylinder radius='0.2' from='p' to='end' density='900'/>");
    assertSame(
        body(
            points,
            "<cylinder radius='0.2' from='p' to='cut' density='900'/>"
                + "<cylinder radius='0.2' from='cut' to='end' density='900'/>"),
        whole);
    assertSame(
        body(
            points,
            "<cylinder radius='0.15' from='end' to='p' density='900'/>"
                + "<cylinder radius='0.2' inner='0.15' from='p' to='end' density='900'/>"),
        whole);
  }

  /** A cone is the sum of its slices; with equal radii it is a cylinder, turned about itself. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void coneIsTheSumOfItsSlices(long seed) throws Exception {
    Random random = new Random(seed);
    double[] end = random.doubles(3, -1, 1).toArray();
    double part = 0.1 + 0.8 * random.nextDouble();
    double top = seed == 1 ? 0 : 0.3 * random.nextDouble();
    double middle = 0.2 + part * (top - 0.2);
    String points =
        point("end", end[0], end[1], end[2])
            + point("cut", part * end[0], part * end[1], part * end[2]);
    assertSame(
        body(
            points,
            cone(0.2, middle, "from='p' to='cut'") + cone(middle, top, "from='cut' to='end'")),
        body(points, cone(0.2, top, "from='p' to='end'")));
    assertSame(
        body(points, cone(0.2, middle, "from='cut' to='p'")),
        body(points, cone(middle, 0.2, "from='p' to='cut'")));
    assertSame(
        body(points, cone(0.2, 0.2, "from='end' to='p'")),
        body(points, "<cylinder radius='0.2' from='0;0;0' to='end' density='900'/>"));
  }

  private static String cone(double radius, double top, String ends) {
    return String.format(
        Locale.ROOT, "<cone radius='%.17g' top='%.17g' %s density='900'/>", radius, top, ends);
  }

  /** Centre at a quarter of the height; moments of the handbook. */
  @Test
  void pointedConeHasTheMomentsOfTheHandbook() throws Exception {
    Body cone = body("", "<cone radius='0.3' from='0;0;0' to='0;0;2' mass='5'/>");
    assertThat(cone.centerOfMass().z()).isCloseTo(0.5, within(1e-15));
    double transverse = 3.0 / 80 * 5 * (4 * 0.09 + 4);
    assertThat(elements(cone.inertia()))
        .containsExactly(
            new double[] {transverse, transverse, 0.3 * 5 * 0.09, 0, 0, 0}, within(1e-14));
  }

  @Test
  void thinCylinderIsARod() throws Exception {
    Body rod = body(point("end", 2, 0, 0), "<cylinder radius='1e-9' from='p' to='end' mass='3'/>");
    assertThat(rod.centerOfMass()).isEqualTo(new Vector3(1, 0, 0));
    assertThat(elements(rod.inertia()))
        .containsExactly(new double[] {0, 1, 1, 0, 0, 0}, within(1e-15));
  }

  @Test
  void sphereHasTwoFifthsOfMassAndRadiusSquared() throws Exception {
    Body sphere = body(point("c", 1, 2, 3), "<sphere radius='0.5' point='c' mass='4'/>");
    assertThat(sphere.centerOfMass()).isEqualTo(new Vector3(1, 2, 3));
    assertThat(elements(sphere.inertia()))
        .containsExactly(new double[] {0.4, 0.4, 0.4, 0, 0, 0}, within(1e-15));
    Body byDensity = body("", "<sphere radius='0.5' density='6/PI'/>");
    assertThat(byDensity.mass()).isCloseTo(1, within(1e-15));
  }

  /** A heavy part beside a light one leaves no error of the size of the heavy one. */
  @Test
  void partsOfAnyRatioOfMassesAddUp() throws Exception {
    Body uneven =
        body(
            point("far", 1, 0, 0),
            "<sphere radius='1e-3' mass='1e9'/><sphere radius='1e-3' point='far' mass='1e-6'/>");
    assertThat(uneven.centerOfMass().x()).isCloseTo(1e-15, within(1e-29));
    assertThat(uneven.inertia().yy() - uneven.inertia().xx()).isCloseTo(1e-6, within(1e-12));
  }

  @Test
  void densityHasTheUnitsOfTheFile() throws Exception {
    Body inMillimetres =
        ModelText.of("R")
            .withUnits("massUnits='g' lengthUnits='mm'")
            .withLink(String.format(FRAME, "", "<box x='10' y='20' z='30' density='0.00785'/>"))
            .mechanism()
            .bodies()
            .get(0);
    assertThat(inMillimetres.mass()).isCloseTo(6e-6 * 7850, within(1e-15));
  }

  @Test
  void runWithoutIntegratorLeavesItToTheService() throws Exception {
    RunSettings run =
        ModelText.of("R")
            .withSimulation("<timeSet tini='0' tend='1' tstep='0.1'/>")
            .read()
            .settings()
            .run();
    assertThat(run.integrator()).isEqualTo("auto");
    assertThat(run.relativeTolerance()).isEqualTo(1e-6);
    assertThat(run.absoluteTolerance()).isEqualTo(1e-8);
  }
}

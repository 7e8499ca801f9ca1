package org.mechservice.view.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBelt;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneGear;
import org.mechservice.view.scene.SceneRoad;
import org.mechservice.view.scene.SceneRope;

/** What a model says for the eye beside its bodies: wheels, belts, ropes and roads. */
class ModelSceneTest {
  private static final Path EXAMPLES = Path.of("../examples");

  private static SceneDescription scene(String text) throws Exception {
    byte[] content = text.getBytes(StandardCharsets.UTF_8);
    return ModelScene.of(
        MechmlReader.read("model.xml", content), MechmlReader.whole("model.xml", content));
  }

  private static String example(String name) throws Exception {
    return Files.readString(EXAMPLES.resolve(name));
  }

  /** Returns how far the nearest tooth is from a place on the pitch circle, in pitches, 0 to 1. */
  private static double phase(SceneDescription scene, SceneGear gear, Point3 place, Point3 way) {
    BodyPose pose = scene.pose(gear.body());
    Point3 axis = pose.turn(gear.axis());
    Point3 out = place.minus(pose.toWorld(gear.centre()));
    Point3 tooth = pose.turn(gear.tooth());
    double angle = Math.atan2(axis.dot(out.cross(tooth)), out.dot(tooth));
    double sense = Math.signum(axis.cross(out).dot(way));
    double pitches = sense * angle * gear.teeth() / (2 * Math.PI);
    return pitches - Math.floor(pitches);
  }

  private static void requireMesh(SceneDescription scene, SceneGear one, SceneGear other) {
    BodyPose pose = scene.pose(one.body());
    Point3 centre = pose.toWorld(one.centre());
    Point3 between = scene.pose(other.body()).toWorld(other.centre()).minus(centre);
    double sign = other.kind() == SceneGear.Kind.RING ? -1 : 1;
    Point3 out = between.times(sign / between.norm());
    Point3 place = centre.plus(out.times(one.radius()));
    Point3 way = pose.turn(one.axis()).cross(out);
    double apart = phase(scene, one, place, way) - phase(scene, other, place, way);
    // where one has a tooth the other has a gap: half a pitch, in either direction
    assertThat(Math.abs(apart)).isCloseTo(0.5, within(1e-6));
  }

  @Test
  void teethOfAPlanetaryGearAreInTheGapsOfEachOther() throws Exception {
    SceneDescription scene = scene(example("gearbox/gearbox.xml"));
    List<SceneGear> gears = scene.gears();
    SceneGear sun = gears.stream().filter(gear -> gear.body() == 0).findFirst().orElseThrow();
    SceneGear ring =
        gears.stream().filter(gear -> gear.kind() == SceneGear.Kind.RING).findFirst().orElseThrow();
    List<SceneGear> planets = new ArrayList<>(gears);
    planets.removeAll(List.of(sun, ring));
    assertThat(planets).hasSize(3);
    for (SceneGear planet : planets) {
      assertThat(planet.radius()).isCloseTo(0.03, within(1e-12));
      requireMesh(scene, sun, planet);
      requireMesh(scene, planet, ring);
    }
    assertThat(ring.radius()).isCloseTo(0.09, within(1e-12));
    assertThat(scene.belts()).isEmpty();
  }

  @Test
  void wheelsThatTurnTheSameWayHaveABelt() throws Exception {
    String bodies =
        """
        <MechML>
          <MBSsimulation><dynamic><timeSet tini="0" tend="1" tstep="0.1"/></dynamic></MBSsimulation>
          <MBSmodel name="belt" massUnits="kg" lengthUnits="m">
            <Bodies>
              <body name="frame">
                <vector name="y" vx="0" vy="1" vz="0"/>
                <point name="a" x="0" y="0" z="0"/><point name="b" x="0.3" y="0" z="0.4"/>
              </body>
              <body name="small">
                <point name="o" x="0" y="0" z="0"/><vector name="y" vx="0" vy="1" vz="0"/>
                <mass value="1"/><inertiaTensor Ixx="1" Iyy="1" Izz="1"/>
              </body>
              <body name="large">
                <point name="o" x="0" y="0" z="0"/><vector name="y" vx="0" vy="1" vz="0"/>
                <mass value="1"/><inertiaTensor Ixx="1" Iyy="1" Izz="1"/>
              </body>
            </Bodies>
            <Joints>
              <joint name="one" type="R">
                <body1 name="frame" point="a" vector="y"/><body2 name="small" point="o" vector="y"/>
              </joint>
              <joint name="two" type="R">
                <body1 name="frame" point="b" vector="y"/><body2 name="large" point="o" vector="y"/>
              </joint>
            </Joints>
            <Constraints>
              <CoordConstraint name="belt" constant="0">
                <term joint="one" factor="1"/><term joint="two" factor="-2.5"/>
              </CoordConstraint>
            </Constraints>
            <Forces><gravity gx="0" gy="0" gz="-9.81"/></Forces>
            <topology><root name="frame"/></topology>
          </MBSmodel>
        </MechML>
        """;
    SceneDescription scene = scene(bodies);
    assertThat(scene.belts()).hasSize(1);
    SceneBelt belt = scene.belts().get(0);
    assertThat(belt.body()).isEqualTo(Anchor.ROOT);
    assertThat(belt.distance()).isCloseTo(0.5, within(1e-12));
    // what turns 2.5 times as fast is as much smaller
    assertThat(belt.second() / belt.first()).isCloseTo(2.5, within(1e-12));
    assertThat(belt.at().turn(new Point3(1, 0, 0)).dot(new Point3(0.6, 0, 0.8)))
        .isCloseTo(1, within(1e-12));
    assertThat(scene(bodies.replace("-2.5", "2.5")).belts()).isEmpty();
  }

  @Test
  void ropesKnowWhatTheyPass() throws Exception {
    SceneDescription scene = scene(example("elements/pathForce.xml"));
    SceneRope cable = scene.rope("cable").orElseThrow();
    assertThat(cable.stops()).hasSize(3);
    assertThat(cable.stops().get(1))
        .isInstanceOfSatisfying(
            SceneRope.Around.class,
            shape -> {
              assertThat(shape.radius()).isCloseTo(0.05, within(1e-15));
              assertThat(shape.sides()).hasSize(1);
              assertThat(shape.inside()).isFalse();
            });
    assertThat(scene.rope("cord").orElseThrow().stops())
        .hasAtLeastOneElementOfType(SceneRope.Branch.class);
    SceneRope hoist = scene(example("crane/crane.xml")).rope("hoist").orElseThrow();
    assertThat(hoist.stops().get(1))
        .isInstanceOfSatisfying(
            SceneRope.Pulley.class, pulley -> assertThat(pulley.left()).isFalse());
  }

  @Test
  void boxThatTouchesIsShownWhereItIs() throws Exception {
    SceneDescription scene = scene(example("elements/boxContact.xml"));
    SceneForce held =
        scene.forces().stream().filter(one -> one.name().equals("held")).findFirst().orElseThrow();
    SceneForce.Box box = held.box().orElseThrow();
    assertThat(box.edges()).isEqualTo(new Point3(0.4, 0.4, 0.2));
    assertThat(box.corners()).hasSize(8).contains(new Point3(-0.2, 0.2, -0.1));
    // the block stands 0.004 mm deep in the plane: its lowest corners, and the highest 0.2 m above
    List<Double> heights =
        box.corners().stream()
            .map(corner -> scene.world(new Anchor(held.anchors().get(0).body(), corner)).z())
            .sorted()
            .toList();
    assertThat(heights.get(3)).isCloseTo(-4e-6, within(1e-12));
    assertThat(heights.get(4)).isCloseTo(0.2 - 4e-6, within(1e-12));
    // pictures hold the whole box
    assertThat(scene.extent()).anyMatch(point -> Math.abs(point.z() - heights.get(7)) < 1e-12);
  }

  @Test
  void roadHasTheHeightsOfItsProfile() throws Exception {
    SceneDescription scene = scene(example("elements/profile.xml"));
    assertThat(scene.roads()).isNotEmpty();
    SceneRoad road = scene.roads().get(0);
    assertThat(road.runners()).isNotEmpty();
    // stations -10, 0, 20, 30 cm with heights 0, 15, 30, 30 cm, held beyond
    double[] stations = {-1, -0.1, 0, 0.2, 0.3, 5};
    double[] heights = {0, 0, 0.15, 0.3, 0.3, 0.3};
    for (int i = 0; i < stations.length; i++) {
      assertThat(road.height().applyAsDouble(stations[i])).isCloseTo(heights[i], within(1e-15));
    }
  }
}

package org.mechservice.view.sketch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.drawing.Svg;
import org.mechservice.view.drawing.SvgPicture;
import org.mechservice.view.drawing.Theme;
import org.mechservice.view.scene.Anchor;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneForce;
import org.mechservice.view.scene.SceneJoint;
import org.mechservice.view.scene.SceneVerdict;

/** Drawings show every part by its symbol, with names that can be read. */
class MechanismPictureTest {
  private static final Point3 Y = new Point3(0, 1, 0);
  private static final Point3 DOWN = new Point3(0, 0, -9.81);
  private static final SceneVerdict FREE = new SceneVerdict(1, 0, 0, true, List.of());

  private final List<SceneBody> bodies = new ArrayList<>();
  private final List<SceneJoint> joints = new ArrayList<>();
  private final List<SceneConstraint> constraints = new ArrayList<>();
  private final List<SceneForce> forces = new ArrayList<>();

  private SceneDescription scene(SceneVerdict verdict) {
    return new SceneDescription(
        "scene",
        "ground",
        BodyPose.WORLD,
        "",
        List.of(),
        DOWN,
        bodies,
        joints,
        constraints,
        forces,
        verdict);
  }

  private SvgPicture picture(ViewPlane plane) throws Exception {
    return SvgPicture.read(Svg.of(MechanismPicture.draw(scene(FREE), plane), Theme.AUTOMATIC));
  }

  /** Adds a bar of 1 m along x, beginning at a place. */
  private int bar(String name, double x, double z) {
    BodyPose pose = new BodyPose(new Point3(x, 0, z), 1, 0, 0, 0);
    Point3 centre = new Point3(0.5, 0, 0);
    bodies.add(new SceneBody(name, pose, 1, centre, Collections.nCopies(6, 0.0), ""));
    return bodies.size() - 1;
  }

  private static Anchor start(int body) {
    return new Anchor(body, Point3.ZERO);
  }

  private static Anchor end(int body) {
    return new Anchor(body, new Point3(1, 0, 0));
  }

  private void join(JointType type, String name, boolean cut, Anchor first, Anchor second) {
    joints.add(new SceneJoint(name, type, cut, false, first, second, Y, new Point3(0, 0, 1)));
  }

  /** A chain of bars from the world's origin. */
  private void chain(int count) {
    for (int i = 0; i < count; i++) {
      int body = bar("bar" + i, i, 0);
      Anchor before = i == 0 ? start(Anchor.ROOT) : end(body - 1);
      join(JointType.R, "joint" + i, false, before, start(body));
    }
  }

  @EnumSource(JointType.class)
  @ParameterizedTest
  void everyTypeOfJointHasASymbolInEveryView(JointType type) throws Exception {
    int body = bar("bar", 0, 0);
    join(type, "pivot", false, start(Anchor.ROOT), start(body));

    for (ViewPlane plane : ViewPlane.values()) {
      SvgPicture picture = picture(plane);
      assertThat(picture.parts()).contains("body bar", JointSymbols.word(type) + " joint pivot");
      assertThat(picture.texts()).contains("bar", "pivot", JointSymbols.word(type));
      assertThat(picture.illegible()).as(plane.toString()).isEmpty();
    }
  }

  @EnumSource(SceneForce.Kind.class)
  @ParameterizedTest
  void everyForceHasASymbol(SceneForce.Kind kind) throws Exception {
    chain(2);
    String joint = kind.name().startsWith("JOINT") ? "joint1" : "";
    forces.add(
        new SceneForce(
            "push",
            kind,
            List.of(end(1), new Anchor(Anchor.ROOT, new Point3(2, 0, -0.5))),
            new Point3(0, 0, 1),
            false,
            kind == SceneForce.Kind.CONTACT ? 0.2 : 0,
            joint));

    SvgPicture picture = picture(ViewPlane.AUTO);
    assertThat(picture.parts()).anyMatch(part -> part.endsWith(" push"));
    assertThat(picture.texts()).anyMatch(text -> text.startsWith("push"));
    assertThat(picture.illegible()).isEmpty();
  }

  @EnumSource(SceneConstraint.Kind.class)
  @ParameterizedTest
  void everyConstraintHasASymbol(SceneConstraint.Kind kind) throws Exception {
    chain(2);
    boolean couples = kind == SceneConstraint.Kind.COUPLING;
    constraints.add(
        new SceneConstraint(
            "guide",
            kind,
            couples ? List.of() : List.of(end(1), start(Anchor.ROOT)),
            new Point3(0.6, 0, 0.8),
            kind == SceneConstraint.Kind.ROLLING
                ? Optional.of(new SceneConstraint.Wheel(new Point3(0, 1, 0), 0.3))
                : Optional.empty(),
            couples ? List.of("joint0", "joint1") : List.of()));

    SvgPicture picture = picture(ViewPlane.AUTO);
    assertThat(picture.parts()).anyMatch(part -> part.endsWith(" guide"));
    assertThat(picture.texts()).contains("guide", "constraint");
    assertThat(picture.illegible()).isEmpty();
  }

  @Test
  void planarMechanismIsSeenInItsPlaneOfMotion() {
    chain(2);
    Projection plane = Projection.of(ViewPlane.AUTO, scene(FREE));

    assertThat(plane.right()).isEqualTo(new Point3(1, 0, 0));
    assertThat(plane.up()).isEqualTo(new Point3(0, 0, 1));
  }

  @Test
  void obliquePlaneOfMotionIsSeenFromItsNormalWithUpUpwards() {
    int body = bar("bar", 0, 0);
    Point3 axis = new Point3(0.6, 0.8, 0);
    joints.add(
        new SceneJoint(
            "pivot",
            JointType.R,
            false,
            false,
            start(Anchor.ROOT),
            start(body),
            axis,
            Point3.ZERO));
    Projection plane = Projection.of(ViewPlane.AUTO, scene(FREE));

    assertThat(Math.abs(plane.depth(axis))).isCloseTo(1, within(1e-12));
    assertThat(plane.up().z()).isCloseTo(1, within(1e-12));
  }

  @EnumSource(ViewPlane.class)
  @ParameterizedTest
  void directionsOfEveryViewAreNormalToEachOther(ViewPlane plane) {
    int body = bar("bar", 0, 0);
    join(JointType.S, "ball", false, start(Anchor.ROOT), start(body));
    Projection projection = Projection.of(plane, scene(FREE));

    assertThat(projection.right().norm()).isCloseTo(1, within(1e-14));
    assertThat(projection.up().norm()).isCloseTo(1, within(1e-14));
    assertThat(projection.right().dot(projection.up())).isCloseTo(0, within(1e-14));
  }

  @Test
  void captionSaysWhatCheckSays() throws Exception {
    chain(3);
    join(JointType.R, "loop", true, end(2), new Anchor(Anchor.ROOT, new Point3(3, 0, 0)));
    SceneVerdict verdict = new SceneVerdict(1, 5, 3, true, List.of("M-101 doubtful"));
    SvgPicture picture =
        SvgPicture.read(Svg.of(MechanismPicture.draw(scene(verdict), ViewPlane.AUTO), Theme.LIGHT));

    assertThat(picture.texts())
        .contains(
            "3 bodies, 4 joints (1 cut): 1 degree of freedom",
            "5 equations close the loops; 3 are redundant",
            "1 warning of mech check",
            "cut joint");
    assertThat(picture.parts()).contains("revolute joint loop, cut");
  }

  @Test
  void openLoopsAreNotPassedOffAsClosed() throws Exception {
    chain(1);
    SceneVerdict verdict = new SceneVerdict(0, 1, 0, false, List.of());

    assertThat(Svg.of(MechanismPicture.draw(scene(verdict), ViewPlane.AUTO), Theme.LIGHT))
        .contains("THE LOOPS CANNOT BE CLOSED");
  }

  @Test
  void longChainKeepsSomeNamesAndSaysHowManyItLeavesOut() throws Exception {
    chain(400);
    SvgPicture picture = picture(ViewPlane.AUTO);

    assertThat(picture.illegible()).isEmpty();
    assertThat(picture.texts()).contains("bar0").anyMatch(text -> text.matches("bar3\\d\\d"));
    assertThat(picture.texts()).anyMatch(text -> text.matches("\\d+ names have no place here"));
    assertThat(picture.parts()).contains("body bar399");
  }

  @Test
  void sizesFromMicrometresToKilometresFitTheirScale() throws Exception {
    for (double size : new double[] {1e-6, 3e-3, 0.4, 7, 2e3}) {
      bodies.clear();
      joints.clear();
      int body = bar("bar", 0, 0);
      Anchor far = new Anchor(body, new Point3(size, 0, 0));
      bodies.set(
          0, new SceneBody("bar", BodyPose.WORLD, 0, Point3.ZERO, Collections.nCopies(6, 0.0), ""));
      join(JointType.R, "pivot", false, start(Anchor.ROOT), start(body));
      join(JointType.R, "tip", true, far, new Anchor(Anchor.ROOT, far.point()));

      SvgPicture picture = picture(ViewPlane.AUTO);
      assertThat(picture.texts()).anyMatch(text -> text.matches("[\\d.]+ (nm|µm|mm|m|km)"));
      assertThat(picture.illegible()).isEmpty();
    }
  }

  @Test
  void sceneWithoutJointsIsDrawn() throws Exception {
    assertThat(picture(ViewPlane.AUTO).illegible()).isEmpty();
  }
}

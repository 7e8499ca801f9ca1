package org.mechservice.cli.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.solver.api.JointType;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneConstraint;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneJoint;

/** Scenes for pictures have the poses at the start and the anchors of the model file. */
class SceneReaderTest {
  private static final Path EXAMPLES = Path.of("..", "examples");

  private static SceneDescription read(Path file) throws IOException {
    return SceneReader.read(file, ReadOptions.NONE);
  }

  static List<Path> elements() throws IOException {
    try (Stream<Path> files = Files.list(EXAMPLES.resolve("elements"))) {
      return files.filter(file -> file.toString().endsWith(".xml")).sorted().toList();
    }
  }

  /** Types whose two points coincide: their anchors meet in any position. */
  private static boolean keepsPointsTogether(JointType type) {
    return switch (type) {
      case R, S, U, W -> true;
      default -> false;
    };
  }

  @MethodSource("elements")
  @ParameterizedTest
  void jointsPointsMeetInTheWorldWhereTheTypeKeepsThemTogether(Path file) throws IOException {
    SceneDescription scene = read(file);

    for (SceneJoint joint : scene.joints()) {
      double gap = scene.world(joint.first()).minus(scene.world(joint.second())).norm();
      if (keepsPointsTogether(joint.type())) {
        // rounding of a few poses of size 1 m, and the tolerance to which loops are assembled
        assertThat(gap).as(joint.name()).isLessThan(1e-9);
      }
    }
    assertThat(scene.extent()).isNotEmpty();
  }

  /** Results hold its components in these axes, so the player has to know them. */
  @Test
  void forceSaysWhetherItsComponentsTurnWithItsBody(@TempDir Path folder) throws IOException {
    Path inWorld = EXAMPLES.resolve("elements/forceTorque.xml");
    String text = Files.readString(inWorld).replace("frame=\"world\"", "frame=\"body\"");
    Path inBody = Files.writeString(folder.resolve("body.xml"), text);

    assertThat(read(inWorld).forces().get(0).inBodyAxes()).isFalse();
    assertThat(read(inBody).forces().get(0).inBodyAxes()).isTrue();
  }

  @Test
  void loopsAreClosedInThePicture() throws IOException {
    SceneDescription scene = read(EXAMPLES.resolve("extremes/fourbar_redundant.xml"));

    assertThat(scene.verdict().assembled()).isTrue();
    assertThat(scene.verdict().redundant()).isPositive();
    SceneJoint cut = scene.joints().stream().filter(SceneJoint::cut).findFirst().orElseThrow();
    Point3 gap = scene.world(cut.first()).minus(scene.world(cut.second()));
    assertThat(gap.norm()).isCloseTo(0, within(1e-9));
  }

  @Test
  void rodsEndsAreAsFarApartAsTheFileSays() throws IOException {
    SceneDescription scene = read(EXAMPLES.resolve("elements/DISTConstraint.xml"));

    SceneConstraint rod = scene.constraints().get(0);
    assertThat(rod.anchors()).hasSize(2);
    Point3 along = scene.world(rod.anchors().get(0)).minus(scene.world(rod.anchors().get(1)));
    assertThat(along.norm()).isPositive();
  }

  @Test
  void geometryOfTheFileIsNamed(@TempDir Path folder) throws IOException {
    String pendulum = Files.readString(EXAMPLES.resolve("pendulum/pendulum.xml"));
    Path file = folder.resolve("drawn.xml");
    Files.writeString(
        file,
        pendulum
            .replace("<body name=\"bar1\">", "<body name=\"bar1\" graphSrc=\"bar.wrl\">")
            .replace("<body name=\"Ground\">", "<body name=\"Ground\" graphSrc=\"hall.wrl\">"));
    SceneDescription scene = read(file);

    assertThat(scene.rootGeometry()).isEqualTo("hall.wrl");
    assertThat(scene.bodies().get(0).geometry()).isEqualTo("bar.wrl");
    assertThat(scene.bodies().get(1).geometry()).isEmpty();
  }

  @Test
  void messageOfTheReaderReachesTheUser(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("broken.xml");
    Files.writeString(file, "<MBSmodel name=\"x\"/>");

    assertThatThrownBy(() -> read(file))
        .isInstanceOf(UsageException.class)
        .hasMessageContaining("M-0");
  }
}

package org.mechservice.view.player;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.scene.BodyPose;
import org.mechservice.view.scene.Point3;
import org.mechservice.view.scene.SceneBody;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.scene.SceneSolid;

/** A body is drawn as the solids that give it its mass, each where the model has it. */
class BodySurfacesTest {
  /** Places in a mesh are floats. */
  private static final double FLOAT = 1e-6;

  private static final Point3 TIP = new Point3(1, 0, 0);

  private static SceneDescription scene(SceneSolid... solids) {
    SceneDescription plain = Pendulums.scene("bar", "");
    SceneBody bar = plain.bodies().get(0);
    return new SceneDescription(
        plain.name(),
        plain.rootName(),
        plain.root(),
        "",
        List.of(),
        plain.gravity(),
        List.of(
            new SceneBody(
                "bar", BodyPose.WORLD, 1, bar.centreOfMass(), bar.inertia(), "", List.of(solids))),
        plain.joints(),
        plain.constraints(),
        plain.forces(),
        plain.verdict());
  }

  private static List<Part> drawn(Path folder, SceneSolid... solids) {
    return new Stage(scene(solids), new MeshFolder(folder))
        .parts(new Recording()).stream()
            .filter(part -> part.body() == 0 && part.role() == Part.Role.BODY)
            .toList();
  }

  /** Returns least x, y, z and greatest x, y, z of a part, m. */
  private static double[] box(Part part) {
    float[] corners = part.shape().inBody().corners();
    double[] box = {9, 9, 9, -9, -9, -9};
    for (int i = 0; i < corners.length; i++) {
      box[i % 3] = Math.min(box[i % 3], corners[i]);
      box[3 + i % 3] = Math.max(box[3 + i % 3], corners[i]);
    }
    return box;
  }

  @Test
  void solidsAreDrawnInPlaceOfTheBoxOfTheInertia() {
    List<Part> parts =
        drawn(
            Path.of("."),
            new SceneSolid.Round(Point3.ZERO, TIP, 0.1, 0.1, 0.05),
            new SceneSolid.Round(TIP, new Point3(1, 0, -0.5), 0.2, 0, 0),
            new SceneSolid.Block(TIP, new Point3(0.2, 0.4, 0.6)),
            new SceneSolid.Ball(new Point3(0, 0, 1), 0.25));

    assertThat(parts).hasSize(4);
    assertThat(box(parts.get(0)))
        .containsExactly(new double[] {0, -0.1, -0.1, 1, 0.1, 0.1}, within(FLOAT));
    assertThat(box(parts.get(1)))
        .containsExactly(new double[] {0.8, -0.2, -0.5, 1.2, 0.2, 0}, within(FLOAT));
    assertThat(box(parts.get(2)))
        .containsExactly(new double[] {0.9, -0.2, -0.3, 1.1, 0.2, 0.3}, within(FLOAT));
    assertThat(box(parts.get(3)))
        .containsExactly(new double[] {-0.25, -0.25, 0.75, 0.25, 0.25, 1.25}, within(FLOAT));
  }

  @Test
  void jointAwayFromTheSolidsIsJoinedByARod() {
    List<Part> parts = drawn(Path.of("."), new SceneSolid.Ball(TIP, 0.1));

    // the joint at the origin; the spring's point lies in the sphere
    assertThat(parts).hasSize(2);
    double[] rod = box(parts.get(1));
    assertThat(rod[0]).isCloseTo(0, within(FLOAT));
    assertThat(rod[3]).isCloseTo(0.5, within(FLOAT));
  }

  @Test
  void surfaceOfAFileIsDrawnInItsUnit(@TempDir Path folder) throws Exception {
    Files.write(
        folder.resolve("plate.obj"),
        "v 0 0 0\nv 1000 0 0\nv 0 500 0\nf 1 2 3\n".getBytes(StandardCharsets.UTF_8));
    SceneSolid plate = new SceneSolid.Surface("plate.obj", 0.001, new Point3(0, 0, 2));

    assertThat(box(drawn(folder, plate).get(0)))
        .containsExactly(new double[] {0, 0, 2, 1, 0.5, 2}, within(FLOAT));
  }

  @Test
  void missingSurfaceIsNamedAndTheInertiaDrawn() {
    SceneSolid lost = new SceneSolid.Surface("lost.stl", 1, Point3.ZERO);
    Stage stage = new Stage(scene(lost), new MeshFolder(Path.of(".")));

    assertThat(stage.warnings())
        .singleElement()
        .asString()
        .startsWith("a solid of body bar is not drawn: graphSrc \"lost.stl\"");
    assertThat(stage.parts(new Recording()))
        .anyMatch(part -> part.body() == 0 && part.role() == Part.Role.BODY);
  }

  @Test
  void distanceIsThatToTheSurfaceOrZeroWithin() {
    SceneSolid block = new SceneSolid.Block(Point3.ZERO, new Point3(2, 2, 2));
    SceneSolid rod = new SceneSolid.Round(Point3.ZERO, TIP, 0.1, 0.1, 0);

    assertThat(BodySurfaces.distance(block, new Point3(0.9, -0.9, 0))).isZero();
    assertThat(BodySurfaces.distance(block, new Point3(4, 5, 0))).isCloseTo(5, within(FLOAT));
    assertThat(BodySurfaces.distance(rod, new Point3(0.5, 0.05, 0))).isZero();
    assertThat(BodySurfaces.distance(rod, new Point3(1.3, 0.5, 0))).isCloseTo(0.5, within(FLOAT));
  }
}

package org.mechservice.sim.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.sim.check.TreeDrawing;
import org.mechservice.sim.model.Chains;
import org.mechservice.sim.model.RandomMechmlTrees;
import org.mechservice.sim.model.Scenes;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.InertiaTensor;
import org.mechservice.solver.spatial.Vector3;
import org.mechservice.solver.text.Origin;

class SceneAnalysisTest {
  private static Mechanism withLastBody(Body body) {
    Mechanism pendulum = Scenes.pendulum();
    List<Body> bodies = new ArrayList<>(pendulum.bodies());
    bodies.set(4, body);
    return new Mechanism("changed", pendulum.root(), pendulum.gravity(), bodies, pendulum.joints());
  }

  @Test
  void everyJointOfATreeIsInTheRoadmapOnce() {
    Mechanism tree = RandomMechmlTrees.tree(3, 12);
    SceneAnalysis scene = SceneAnalysis.of(tree);
    assertThat(scene.degreesOfFreedom()).isEqualTo(12);
    assertThat(scene.roadmap()).extracting(RoadmapEntry::position).doesNotHaveDuplicates();
    assertThat(scene.roadmap())
        .extracting(RoadmapEntry::joint)
        .containsExactlyElementsOf(tree.joints().stream().map(joint -> joint.name()).toList());
  }

  @Test
  void branchesAreDrawnBelowTheirBody() {
    assertThat(TreeDrawing.of(Scenes.timingModel("driver41").mechanism()))
        .hasSize(42)
        .startsWith(
            "Ground", "+- j_pelvis (P): pelvis, 11 kg", "   +- j_lumb_y (R): lumb_y, massless")
        .contains("   +- j_rhip_y (R): rhip_y, massless");
  }

  /** Drawn three columns further for each, 2 000 links would take six million characters. */
  @Test
  void theDrawingOfAChainGrowsWithItsLength() {
    List<String> lines = TreeDrawing.of(Chains.ofEqualLinks(2_000));
    assertThat(lines).hasSize(2_001);
    assertThat(lines.get(20)).startsWith(" ".repeat(57) + "+- j19 (R): b19, ");
    assertThat(lines.get(21)).startsWith(" ".repeat(57) + "+- j20 (R): b20, ").endsWith(", on b19");
    assertThat(lines.get(2_000)).endsWith(", on b1998");
    assertThat(lines).allSatisfy(line -> assertThat(line).hasSizeLessThan(110));
  }

  @Test
  void aJointThatMovesNoMassIsFound() {
    Origin origin = new Origin("p.xml", 12);
    Body nothing = new Body("tip", 0, Vector3.ZERO, InertiaTensor.ZERO, origin);
    assertThat(SceneAnalysis.of(withLastBody(nothing)).findings())
        .extracting(Finding::toString)
        .containsExactly(
            "S-086 joint \"j5\" moves body \"tip\" and nothing beyond it that has mass: its"
                + " acceleration is not defined; give a body there mass and inertia, or leave the"
                + " joint out");
  }

  @Test
  void slenderAndRoundBodiesAreNotFound() {
    assertThat(SceneAnalysis.of(Scenes.pendulum()).findings()).isEmpty();
    assertThat(SceneAnalysis.of(Scenes.timingModel("driver41").mechanism()).findings()).isEmpty();
  }
}

package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.resolve.MechmlReader;

/** The examples' files hold the numbers of the reference scenes, which were written down apart. */
class SceneFileTest {
  /** Scene, and the example that says the same. */
  private static final String SCENES =
      """
      pendulum5, pendulum/pendulum.xml
      driver_free_C0, driver/driver-free-c0.xml
      driver_free_CK100, driver/driver-free-ck100.xml
      driver_C0, driver/driver-c0.xml
      driver_CK100, driver/driver-ck100.xml
      driver_C0, driver/variants/driver-c0-elements.xml
      driver_CK100, driver/variants/driver-ck100-elements.xml
      fps, five-point-suspension/five-point-suspension.xml
      fps, five-point-suspension/variants/elements.xml
      A01_simple_pendulum, benchmarks/A01_simple_pendulum.xml
      A03_andrews, benchmarks/A03_andrews.xml
      A05_flyball, benchmarks/A05_flyball.xml
      double_pendulum, benchmarks/double_pendulum.xml
      dzhanibekov, benchmarks/dzhanibekov.xml
      slider_crank_planar, benchmarks/slider_crank_planar.xml
      slider_crank_singular, extremes/slider_crank_singular.xml
      fourbar_redundant, extremes/fourbar_redundant.xml
      massratio_1e8_root, extremes/massratio_1e8_root.xml
      near_massless_0, extremes/near_massless_0.xml
      gimbal_q2_0.4, extremes/gimbal_q2_0.4.xml
      gimbal_q2_1.5707963267948966, extremes/gimbal_q2_1.5707963267948966.xml
      coaxial_massless, extremes/coaxial_massless.xml
      stiff_1e9_c0, extremes/stiff_1e9_c0.xml
      stiff_1e9_c1e5, extremes/stiff_1e9_c1e5.xml
      high_spin_1e5_sym, extremes/high_spin_1e5_sym.xml
      fps_inconsistent_rod, extremes/fps_inconsistent_rod.xml
      """;

  /** The scenes lie in a JAR on the class path, which lists no folder. */
  private static final Path SCENE_FILES =
      Path.of("../solver-core/solver-mechanics/src/test/resources/org/mechservice/solver/scenes");

  /** Scenes have the names of their examples, but for those of the paper. */
  @Test
  void everySceneHasItsExampleWhereItIsLookedFor() throws Exception {
    Set<String> written =
        SCENES
            .lines()
            .map(line -> line.split(", ", -1)[0])
            .collect(Collectors.toCollection(TreeSet::new));
    assertThat(SCENE_FILES.toFile().list((folder, name) -> name.matches(".*(?<!\\.ref)\\.json")))
        .extracting(name -> name.replace(".json", ""))
        .containsExactlyInAnyOrderElementsOf(written);
    assertThat(SCENES.lines().filter(line -> line.matches(".*, (benchmarks|extremes)/.*")))
        .allSatisfy(line -> assertThat(line).matches("(.*), \\w+/\\1\\.xml"));
  }

  @ParameterizedTest
  @CsvSource(textBlock = SCENES)
  void fileHoldsTheNumbersOfTheScene(String name, String file) throws Exception {
    JsonScene scene = JsonScene.read(name);
    Path path = Path.of("..", "examples").resolve(file);
    MechmlModel model = MechmlReader.read(file, Files.readAllBytes(path));
    if (!name.equals("pendulum5")) {
      // The paper's pendulum runs to 3 s, the reference to 10 s.
      assertThat(model.settings().run().tEnd()).isEqualTo(JsonScene.number(scene.object(), "tend"));
    }
    SceneComparison comparison = new SceneComparison(model.mechanism());
    comparison.assertMechanism(scene);
    if (!file.startsWith("five-point-suspension/five") && !file.matches("driver/driver-c.*")) {
      // The paper's way to write forces, as classes, is compared where they run.
      comparison.assertForces(scene.list("forces"));
    }
  }
}

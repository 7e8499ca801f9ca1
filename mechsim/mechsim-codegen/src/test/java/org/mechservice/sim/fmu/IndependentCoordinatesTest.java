package org.mechservice.sim.fmu;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.run.RunSettings;

/** The states of a unit in independent coordinates; {@link FmuRunTest} runs such units. */
class IndependentCoordinatesTest {
  private static FmuModel unit(String scene, String... wanted) throws Exception {
    Path file = Path.of("..", "..", "examples").resolve(scene + ".xml");
    MechmlModel model = MechmlReader.read("scene.xml", Files.readAllBytes(file));
    RunSettings settings = model.settings().run();
    BuildOptions options = new BuildOptions("DTR", EnumSet.of(ColumnGroup.JOINTS), settings);
    return FmuModel.inIndependentCoordinates(
        ModelFactory.inC(model, options), settings, List.of(wanted));
  }

  private static String names(List<FmuVariable> variables) {
    return String.join(" ", variables.stream().map(FmuVariable::name).toList());
  }

  @ParameterizedTest
  @CsvSource({
    "extremes/fourbar_redundant, j_crank.q j_crank.v",
    "benchmarks/slider_crank_planar, j_crank.q j_crank.v",
    "extremes/bennett, j0.q j0.v",
    "benchmarks/A03_andrews, beta.q beta.v",
    "benchmarks/double_pendulum, j1.q j2.q j1.v j2.v"
  })
  void asManyStatesAreChosenAsTheMechanismIsFree(String scene, String states) throws Exception {
    assertThat(names(unit(scene).states())).isEqualTo(states);
  }

  @Test
  void otherCoordinatesAreOutputsWithTheirUnits() throws Exception {
    FmuModel unit = unit("benchmarks/slider_crank_planar", "j_rod.q");
    assertThat(names(unit.states())).isEqualTo("j_rod.q j_rod.v");
    assertThat(names(unit.outputs())).isEqualTo("j_crank.q j_slider.q j_crank.v j_slider.v");
    assertThat(unit.outputs().get(1).unit()).isEqualTo("m");
  }

  @ParameterizedTest
  @CsvSource({
    "j_slider, do not determine the other coordinates; such as j_crank.q do",
    "crank, 'no joint and no position has this name; the positions are j_crank.q,j_rod.q'",
    "'j_crank,j_rod', 'these are 2 coordinates, but the mechanism has 1'"
  })
  void whatDoesNotDetermineTheOthersIsRefusedByName(String wanted, String said) {
    assertThatThrownBy(() -> unit("benchmarks/slider_crank_planar", wanted.split(",", -1)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("--coordinates independent:" + wanted)
        .hasMessageContaining(said);
  }
}

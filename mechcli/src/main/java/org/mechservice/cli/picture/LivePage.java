package org.mechservice.cli.picture;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.mechservice.cli.model.ModelToExport;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.sim.fmu.FmuModel;
import org.mechservice.sim.fmu.FmuVariable;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.player.LiveModel;
import org.mechservice.view.player.PlayerPage;
import org.mechservice.view.player.Stage;
import org.mechservice.view.scene.SceneDescription;

/** Writes the page of {@code mech view --live}: a model that a browser simulates. */
final class LivePage {
  private static final Set<ColumnGroup> COLUMNS =
      EnumSet.of(ColumnGroup.JOINTS, ColumnGroup.BODIES, ColumnGroup.ENERGY, ColumnGroup.OUTPUTS);

  /** The name of one of several positions of a joint: without a unit, an Euler parameter. */
  private static final String ONE_OF_SEVERAL = ".*\\.q\\[\\d+]";

  private LivePage() {}

  /**
   * Writes a page.
   *
   * @param file the model
   * @param reading its simulation, values of parameters, those with a slider
   * @param target the page
   * @param err warnings about geometry files
   * @throws IOException if a file cannot be read or written, or the compiler fails
   */
  static void write(Path file, ReadOptions reading, Path target, PrintWriter err)
      throws IOException {
    ModelToExport local = ModelToExport.read(file, reading, COLUMNS);
    byte[] module = local.module();
    FmuModel model = local.inC(Set.of());
    SceneDescription scene = SceneReader.read(file, reading);
    Path folder = Optional.ofNullable(file.toAbsolutePath().getParent()).orElse(file);
    Stage stage = new Stage(scene, new MeshFolder(folder));
    stage.warnings().forEach(err::println);
    OutputFile.write(
        target, PlayerPage.writeLive(scene, stage, live(model, module), facts(model, module)));
  }

  private static Map<String, String> facts(FmuModel model, byte[] module) {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("model", "in this page, as WebAssembly");
    facts.put("size", module.length + " B");
    facts.put("integrator", model.experiment().stiff() ? "ode15s" : "ode113");
    facts.put("relative tolerance", Double.toString(model.experiment().relativeTolerance()));
    return facts;
  }

  private static LiveModel live(FmuModel model, byte[] module) {
    List<Variable> columns = new ArrayList<>(List.of(new Variable("t", "s")));
    model.states().forEach(state -> columns.add(new Variable(state.name(), state.unit())));
    model.outputs().forEach(output -> columns.add(new Variable(output.name(), output.unit())));
    FmuModel.Experiment run = model.experiment();
    return new LiveModel(
        LiveModel.text(module),
        columns,
        sliders(model.parameters(), true),
        sliders(model.states(), false),
        model.events(),
        run.start(),
        run.end(),
        run.step(),
        run.relativeTolerance());
  }

  private static List<LiveModel.Slider> sliders(List<FmuVariable> variables, boolean parameters) {
    List<LiveModel.Slider> sliders = new ArrayList<>();
    for (int i = 0; i < variables.size(); i++) {
      FmuVariable one = variables.get(i);
      boolean eulerParameter = one.unit().equals("1") && one.name().matches(ONE_OF_SEVERAL);
      // the four of a set have no meaning one by one
      if (parameters || !eulerParameter) {
        sliders.add(slider(one, i, parameters));
      }
    }
    return sliders;
  }

  /**
   * Parameters go from nothing to twice their value, angles through half a turn to both sides,
   * other start values as far to both sides as they are large, or 1.
   */
  private static LiveModel.Slider slider(FmuVariable one, int index, boolean parameter) {
    double value = one.start();
    double reach = Math.max(1, Math.abs(value));
    if (parameter && value != 0) {
      reach = Math.abs(value);
    } else if (!parameter && one.unit().equals("rad")) {
      reach = Math.PI;
    }
    return new LiveModel.Slider(one.name(), one.unit(), index, value, value - reach, value + reach);
  }
}

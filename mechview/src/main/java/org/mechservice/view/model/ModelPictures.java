package org.mechservice.view.model;

import java.nio.DoubleBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.program.Trajectory;
import org.mechservice.view.drawing.Svg;
import org.mechservice.view.drawing.Theme;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.player.PlayerPage;
import org.mechservice.view.player.Recording;
import org.mechservice.view.player.Stage;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.sketch.MechanismPicture;
import org.mechservice.view.sketch.ViewPlane;

/** Pictures of a model of the library in process, for programs and notebooks. */
public final class ModelPictures {
  /** Entries of a run's report that the player shows. */
  private static final List<String> FACTS =
      List.of("outcome", "formulation", "integrator", "steps", "wallTime", "energyDrift");

  private ModelPictures() {}

  /** Returns the drawing of a model in its initial position as SVG, light or dark as its reader. */
  public static String drawing(MechModel model) {
    SceneDescription scene = ModelScene.of(model.content(), model.file());
    return Svg.of(MechanismPicture.draw(scene, ViewPlane.AUTO), Theme.AUTOMATIC);
  }

  /**
   * Returns the player with a run, one HTML page that fetches nothing.
   *
   * @param model the model, with the values of its parameters in this run
   * @param run its rows, with the columns of the bodies
   * @throws IllegalArgumentException if a column is missing; names it
   */
  public static String player(MechModel model, Trajectory run) {
    SceneDescription scene = ModelScene.of(model.content(), model.file());
    Optional<String> missing = Recording.missing(scene, run.columns());
    if (missing.isPresent()) {
      throw new IllegalArgumentException(
          "the run has no column \""
              + missing.get()
              + "\", so it does not say where the bodies are; ask for the columns of the bodies");
    }
    Recording recording = new Recording();
    recording.begin(run.columns());
    double[] row = new double[run.columns().size()];
    DoubleBuffer values = run.values();
    while (values.hasRemaining()) {
      values.get(row);
      recording.row(row);
    }
    Map<String, Object> report = run.report().asMap();
    Map<String, String> facts = new LinkedHashMap<>();
    FACTS.forEach(
        key -> {
          Object fact = report.get(key);
          if (fact != null) {
            facts.put(key, String.valueOf(fact));
          }
        });
    Stage stage = new Stage(scene, new MeshFolder(model.folder().orElse(Path.of(""))));
    byte[] page = PlayerPage.write(scene, stage, recording, facts, List.of());
    return new String(page, StandardCharsets.UTF_8);
  }
}

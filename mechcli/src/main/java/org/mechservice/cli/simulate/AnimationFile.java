package org.mechservice.cli.simulate;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.player.AnimatedScene;
import org.mechservice.view.player.Recording;
import org.mechservice.view.player.Stage;
import org.mechservice.view.scene.SceneDescription;

/** A result as an animated scene: the motion of the bodies, of all columns theirs alone. */
final class AnimationFile implements ResultSink {
  private static final String ENDING = ".glb";

  private final Path target;
  private final SceneDescription scene;
  private final Stage stage;
  private final Recording recording = new Recording();

  /**
   * @param target the file
   * @param scene the mechanism
   * @param folder where the model's shapes are
   */
  AnimationFile(Path target, SceneDescription scene, Path folder) {
    this.target = target;
    this.scene = scene;
    stage = new Stage(scene, new MeshFolder(folder));
  }

  /** Returns whether a file of this name is one. */
  static boolean is(Path target) {
    return target.toString().toLowerCase(Locale.ROOT).endsWith(ENDING);
  }

  /** Returns what is wrong with the shapes of bodies. */
  List<String> warnings() {
    return stage.warnings();
  }

  @Override
  public void begin(List<Variable> columns) {
    recording.begin(columns);
  }

  @Override
  public void row(double[] values) {
    recording.row(values);
  }

  /**
   * Writes the file; at least one row has come.
   *
   * @throws IOException if it cannot be written
   */
  void keep() throws IOException {
    OutputFile.write(target, AnimatedScene.write(scene, stage, recording));
  }
}

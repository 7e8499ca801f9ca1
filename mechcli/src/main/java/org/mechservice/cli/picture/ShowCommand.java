package org.mechservice.cli.picture;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import org.mechservice.cli.model.ParameterOption;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.view.scene.SceneDescription;
import org.mechservice.view.sketch.MechanismPicture;
import org.mechservice.view.sketch.ViewPlane;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code mech show}: a drawing of a mechanism. */
@Command(
    name = "show",
    description = "Draws a mechanism in its initial position, with what check says of it.",
    footer = "mech show model.xml -o mechanism.svg",
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ShowCommand implements Callable<Integer> {
  private static final List<String> FORMATS = List.of(PictureFile.SVG, PictureFile.PNG);

  @Parameters(paramLabel = "MODEL.xml|urdf|sdf|mjcf", description = "Model in MechML, or robot.")
  private Path model = Path.of("");

  @Option(
      names = {"-o", "--output", "--out"},
      required = true,
      paramLabel = "FILE.svg|png",
      description = "The drawing to write.")
  private Path target = Path.of("");

  @Option(
      names = "--view",
      paramLabel = "auto|xy|xz|yz|iso",
      hideParamSyntax = true,
      description =
          "Plane of the drawing; auto is the plane of motion of a planar mechanism, else iso.")
  private ViewPlane view = ViewPlane.AUTO;

  @Option(
      names = "--simulation",
      paramLabel = "NAME|N",
      description = "Simulation of the file whose start is drawn; the first if left out.")
  private Optional<String> simulation = Optional.empty();

  @Mixin private ParameterOption parameters = new ParameterOption();

  @Option(
      names = "--dark",
      description =
          "Light lines on black. If left out, PNG files are light, SVG files as their reader"
              + " prefers.")
  private boolean dark;

  @Override
  public Integer call() throws IOException {
    String format = PictureFile.format(target, FORMATS);
    SceneDescription scene =
        SceneReader.read(model, new ReadOptions(simulation, parameters.values(), Set.of()));
    PictureFile.write(target, format, MechanismPicture.draw(scene, view), dark);
    return ExitStatus.DONE;
  }
}

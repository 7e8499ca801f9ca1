package org.mechservice.cli.model;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.sim.emit.c.CModel;
import org.mechservice.sim.fmu.FmiVersion;
import org.mechservice.sim.fmu.FmuArchive;
import org.mechservice.sim.fmu.FmuModel;
import org.mechservice.sim.fmu.FmuPlatform;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.FormulationChoice;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Option;

/** How a model is written as an FMU: {@code mech build -o FILE.fmu}. */
public final class FmuOption {
  private static final String ENDING = ".fmu";

  @Option(
      names = "--fmi",
      paramLabel = "2|3",
      hideParamSyntax = true,
      description = "For a FILE.fmu: version of the Functional Mock-up Interface; without it 2.")
  private String version = "";

  @Option(
      names = "--platforms",
      paramLabel = "LIST|source",
      hideParamSyntax = true,
      description =
          "For a FILE.fmu: linux64, win64, darwin-aarch64, linux-aarch64, separated by commas, or"
              + " source for none; without it this machine's.")
  private String platforms = "";

  /**
   * Returns whether an FMU is asked for.
   *
   * @throws UsageException if only a FILE.fmu has the options that are given, and the file is none
   */
  boolean isAskedFor(Path target) {
    boolean unit = String.valueOf(target.getFileName()).toLowerCase(Locale.ROOT).endsWith(ENDING);
    if (!unit && !(version.isEmpty() && platforms.isEmpty())) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + (version.isEmpty() ? " --platforms" : " --fmi")
              + " is for an FMU, and "
              + target
              + " is none: write -o FILE.fmu");
    }
    return unit;
  }

  /**
   * Builds the FMU of a model.
   *
   * @throws UsageException if version or platform are not known, or no compiler is here for one
   * @throws IOException if the compiler fails
   */
  FmuArchive build(ModelToExport local) throws IOException {
    try {
      FmiVersion fmi = version.isEmpty() ? FmiVersion.FMI_2 : FmiVersion.of(version.strip());
      if (platforms.isEmpty()) {
        return FmuArchive.build(printed(local), fmi);
      }
      Set<FmuPlatform> wanted = FmuPlatform.parse(platforms);
      return FmuArchive.build(printed(local), fmi, wanted);
    } catch (ModelBuildException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    } catch (IllegalArgumentException e) {
      throw new UsageException(MessageCode.OPTION_UNUSABLE + " " + e.getMessage());
    }
  }

  private static FmuModel printed(ModelToExport local) {
    BuildOptions options = local.options();
    // Refuses names of formulations and closures that there are not; C has one formulation.
    FormulationChoice.of(
        options.formulation(), options.closure(), options.settings(), local.model());
    CModel model = ModelFactory.inC(local.model(), local.options());
    return FmuModel.of(model, local.options().settings());
  }
}

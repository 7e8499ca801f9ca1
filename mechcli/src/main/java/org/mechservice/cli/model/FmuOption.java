package org.mechservice.cli.model;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.sim.fmu.FmiVersion;
import org.mechservice.sim.fmu.FmuArchive;
import org.mechservice.sim.fmu.FmuModel;
import org.mechservice.sim.fmu.FmuPlatform;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Option;

/** Options of a model written as an FMU: {@code mech build -o FILE.fmu}. */
public final class FmuOption {
  private static final String ENDING = ".fmu";

  @Option(
      names = "--fmi",
      paramLabel = "2|3",
      hideParamSyntax = true,
      description = "For a FILE.fmu: version of the Functional Mock-up Interface; 2 if left out.")
  private String version = "";

  @Option(
      names = "--platforms",
      paramLabel = "LIST|source",
      hideParamSyntax = true,
      description =
          "For a FILE.fmu: linux64, win64, darwin-aarch64, linux-aarch64, separated by commas, or"
              + " source for none; this machine's if left out.")
  private String platforms = "";

  @Option(
      names = "--class-as-input",
      paramLabel = "FORCE",
      description =
          "For a FILE.fmu or --c: a force written as a Java class becomes inputs, its loads on"
              + " every body and joint; may be given several times, and then is their sum.")
  private List<String> asInputs = List.of();

  @Option(
      names = "--coordinates",
      paramLabel = "projection|independent|independent:NAMES",
      hideParamSyntax = true,
      description =
          "For a FILE.fmu with closed loops: its states are all coordinates, moved onto the loops"
              + " after steps (projection, the default), or independent ones alone, from"
              + " which each evaluation computes the others; NAMES are those of joints or"
              + " positions, separated by commas; if left out, they are chosen at the start.")
  private String coordinates = "";

  /**
   * Returns whether an FMU is asked for.
   *
   * @param inC whether the model is written as C, too
   * @throws UsageException if only a FILE.fmu has the options that are given, and the file is none
   */
  boolean isAskedFor(Path target, boolean inC) {
    boolean unit = String.valueOf(target.getFileName()).toLowerCase(Locale.ROOT).endsWith(ENDING);
    Optional<String> wrong =
        !version.isEmpty()
            ? Optional.of("--fmi")
            : !platforms.isEmpty()
                ? Optional.of("--platforms")
                : !coordinates.isEmpty()
                    ? Optional.of("--coordinates")
                    : !asInputs.isEmpty() && !inC
                        ? Optional.of("--class-as-input")
                        : Optional.empty();
    if (!unit && wrong.isPresent()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " "
              + wrong.get()
              + " is for an FMU, and "
              + target
              + " is none: write -o FILE.fmu");
    }
    return unit;
  }

  /** Returns the names of forces written as classes whose loads are inputs. */
  Set<String> asInputs() {
    return Set.copyOf(asInputs);
  }

  private FmuModel model(ModelToExport local) {
    String asked = coordinates.strip();
    if (asked.isEmpty() || asked.equals("projection")) {
      return local.inC(asInputs());
    }
    String[] parts = asked.split(":", 2);
    List<String> names = parts.length < 2 ? List.of() : List.of(parts[1].split(",", -1));
    if (!parts[0].equals("independent") || names.stream().anyMatch(String::isBlank)) {
      throw new IllegalArgumentException(
          "--coordinates "
              + coordinates
              + ": write projection, independent, or independent:NAME,NAME with names of joints or"
              + " positions");
    }
    return local.inIndependentCoordinates(asInputs(), names.stream().map(String::strip).toList());
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
        return FmuArchive.build(model(local), fmi);
      }
      Set<FmuPlatform> wanted = FmuPlatform.parse(platforms);
      return FmuArchive.build(model(local), fmi, wanted);
    } catch (IllegalArgumentException e) {
      throw new UsageException(MessageCode.OPTION_UNUSABLE + " " + e.getMessage());
    }
  }
}

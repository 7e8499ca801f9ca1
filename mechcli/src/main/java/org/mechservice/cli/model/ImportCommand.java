package org.mechservice.cli.model;

import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Stack;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.robot.ImportOptions;
import org.mechservice.robot.LossGrade;
import org.mechservice.robot.LossReport;
import org.mechservice.robot.RobotFormat;
import org.mechservice.robot.RobotImport;
import org.mechservice.sim.service.library.ModelWarnings;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.IParameterPreprocessor;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech import}: a model of another format becomes MechML. */
@Command(
    name = "import",
    description = "Translates a robot from URDF, SDF or MJCF to MechML and lists what is left out.",
    footer = {
      "mech import arm.urdf -o arm.xml",
      "mech import scene.xml --keyframe home --losses all -o scene-mechml.xml",
      "mech import arm.urdf.xacro --xacro side:=left -o arm.xml",
      "mech import - --path ~/ros/src --floating -o dog.xml < dog.urdf"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ImportCommand implements Callable<Integer> {
  /** What is printed of the losses. */
  enum Listed {
    MOTION,
    ALL,
    JSON;

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Losses with which nothing is written. */
  enum Strictness {
    ANY,
    MOTION;

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** A value of {@code --strict} follows an equals sign; the word behind a blank is the robot. */
  static final class AfterEqualsSign implements IParameterPreprocessor {
    @Override
    @SuppressWarnings("JdkObsolete") // the interface of picocli
    public boolean preprocess(
        Stack<String> args, CommandSpec commandSpec, ArgSpec argSpec, Map<String, Object> info) {
      if (info.get("separator") == null || String.valueOf(info.get("separator")).isEmpty()) {
        args.push(Strictness.ANY.toString());
      }
      return false;
    }
  }

  @Parameters(
      paramLabel = "ROBOT",
      description =
          "The robot in URDF, SDF or MJCF; its outermost element tells the format. - is the"
              + " standard input. Macros of xacro are expanded by the program of this name, if it"
              + " is installed.")
  private String robot = "";

  @Option(
      names = {"-o", "--output", "--out"},
      required = true,
      paramLabel = "MODEL.xml",
      description = "The model file to write.")
  private Path target = Path.of("");

  @Option(
      names = "--format",
      paramLabel = "urdf|sdf|mjcf",
      description = "Format of the robot; a file of another one is refused.")
  private @Nullable RobotFormat format;

  @Option(
      names = "--path",
      paramLabel = "FOLDER",
      description =
          "Folder in which packages (package://NAME) and models (model://NAME) are sought, besides"
              + " those around the robot; may be given several times.")
  private List<Path> paths = List.of();

  @Option(
      names = "--xacro",
      paramLabel = "NAME:=VALUE",
      description =
          "Value of an argument of a file with macros of xacro; may be given several times, and is"
              + " refused for a robot that has no macros and for the standard input.")
  private List<String> xacro = List.of();

  @Option(
      names = "--keyframe",
      paramLabel = "NAME",
      description = "Start at this keyframe of an MJCF file, by name or by number from 0.")
  private @Nullable String keyframe;

  @Option(
      names = "--floating",
      description = "The root of a robot in URDF moves freely; it rests if left out.")
  private boolean floating;

  @Option(
      names = "--losses",
      paramLabel = "motion|all|json",
      description =
          "What is printed of the losses: those that change the motion, with the others counted;"
              + " all; or all as JSON on the standard output. Default: ${DEFAULT-VALUE}.")
  private Listed listed = Listed.MOTION;

  @Option(
      names = "--strict",
      arity = "0..1",
      fallbackValue = "any",
      preprocessor = AfterEqualsSign.class,
      paramLabel = "any|motion",
      description =
          "Write nothing if anything is lost; with --strict=motion if the motion changes.")
  private @Nullable Strictness strict;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException {
    OutputFile.requireUsable(target);
    RobotImport imported = translated();
    LossReport losses = new LossReport(shown(), imported.losses());
    PrintWriter err = spec.commandLine().getErr();
    if (listed == Listed.JSON) {
      spec.commandLine().getOut().println(json(imported.losses()));
    } else {
      losses.lines(listed == Listed.ALL).forEach(err::println);
    }
    imported.notes().forEach(err::println);
    ModelWarnings.of(imported.model()).forEach(err::println);
    long motion = losses.count(LossGrade.MOTION);
    long refused = strict == Strictness.ANY ? imported.losses().size() : motion;
    if (strict != null && refused > 0) {
      throw new UsageException(
          MessageCode.IMPORT_WOULD_LOSE
              + " "
              + shown()
              + (refused == 1 ? " has one thing" : " has " + refused + " things")
              + " that would be left out"
              + (strict == Strictness.MOTION ? " and change the motion" : "")
              + "; nothing was written. Leave out --strict to import the rest");
    }
    writeLooks(imported);
    OutputFile.write(
        target, DocumentWriter.write(imported.document()).getBytes(StandardCharsets.UTF_8));
    return motion > 0 ? ExitStatus.MOTION_CHANGED : ExitStatus.DONE;
  }

  /** Returns the folder for what bodies look like: beside the model, with its name. */
  private String looks() {
    return String.valueOf(target.getFileName()).replaceFirst("\\.[^.]*$", "") + "-looks";
  }

  private void writeLooks(RobotImport imported) throws IOException {
    for (Map.Entry<String, byte[]> look : imported.looks().entrySet()) {
      Path file = target.resolveSibling(look.getKey());
      Files.createDirectories(file.resolveSibling("."));
      Files.write(file, look.getValue());
    }
  }

  private String shown() {
    return robot.equals("-") ? "standard input" : robot;
  }

  private RobotImport translated() throws IOException {
    ImportOptions options =
        new ImportOptions(
            Optional.ofNullable(format),
            Optional.ofNullable(keyframe),
            floating,
            paths,
            Optional.of(looks()));
    try {
      if (robot.equals("-")) {
        Xacro.refuse(
            shown(), xacro, "macros are expanded in files, not in what comes through a pipe");
        return RobotImport.read(shown(), standardInput(), Path.of("").toAbsolutePath(), options);
      }
      Path file = Path.of(robot);
      Optional<byte[]> expanded = Xacro.expanded(file, xacro);
      return expanded.isPresent()
          ? RobotImport.read(
              robot + " (expanded)",
              expanded.get(),
              file.toAbsolutePath().normalize().resolveSibling(""),
              options)
          : RobotImport.read(file, options);
    } catch (MechmlException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
  }

  private static byte[] standardInput() throws IOException {
    try (InputStream in = System.in) {
      return in.readAllBytes();
    }
  }

  private static String json(List<Diagnostic> losses) {
    JsonArray all = new JsonArray();
    for (Diagnostic loss : losses) {
      JsonObject one = new JsonObject();
      LossGrade.of(loss)
          .ifPresent(grade -> one.addProperty("grade", grade.name().toLowerCase(Locale.ROOT)));
      one.addProperty("code", loss.code().code());
      one.addProperty("file", loss.file());
      one.addProperty("line", loss.line());
      one.addProperty("column", loss.column());
      one.addProperty("message", loss.message());
      all.add(one);
    }
    return new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create().toJson(all);
  }
}

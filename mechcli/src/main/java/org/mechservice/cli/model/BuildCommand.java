package org.mechservice.cli.model;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.GeneratedSource;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.jar.BuiltJar;
import org.mechservice.sim.fmu.FmuArchive;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech build}: a model as a JAR, in C, or as an FMU. */
@Command(
    name = "build",
    description = "Compiles a model into a JAR, writes it as C or as an FMU.",
    footer = {
      "mech build model.xml -o model.jar --standalone",
      "mech build model.xml -o model.fmu --fmi 3",
      "mech build model.xml --c model-in-c"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class BuildCommand implements Callable<Integer> {
  @Parameters(paramLabel = "MODEL.xml", description = "Model in MechML.")
  private Path model = Path.of("");

  @Option(
      names = {"-o", "--output", "--out"},
      paramLabel = "FILE.jar|FILE.fmu",
      hideParamSyntax = true,
      description =
          "The JAR or, built here for other simulators, the FMU to write; needed unless --c is"
              + " given.")
  private Optional<Path> target = Optional.empty();

  @Option(
      names = "--c",
      paramLabel = "DIR",
      description =
          "Write the model as C99 into this folder: header, code, elementary functions and an"
              + " example program; the results have the same bits as in Java.")
  private Optional<Path> cFolder = Optional.empty();

  @Option(
      names = "--wasm",
      paramLabel = "FILE.wasm",
      description =
          "Compile the model, with its integrator, to a WebAssembly module that needs nothing"
              + " around it; needs clang with lld, or zig.")
  private Optional<Path> module = Optional.empty();

  @Option(
      names = "--standalone",
      description = "Include the solver classes the model needs, so that java -jar runs it.")
  private boolean standalone;

  @Option(
      names = "--compact",
      description = "Carry the mechanism as data instead of generated code: the smallest file.")
  private boolean compact;

  @Option(
      names = "--code",
      paramLabel = "auto|straight|shared",
      hideParamSyntax = true,
      description =
          "How generated code is laid out, with the same results: straight writes every operation"
              + " out, shared has one method for bodies that are alike, auto chooses.")
  private String code = "";

  @Option(
      names = "--source",
      paramLabel = "DIR",
      description = "Write the generated Java classes into this folder.")
  private Optional<Path> sourceFolder = Optional.empty();

  @Mixin private ModelOptions method = new ModelOptions();

  @Mixin private ParameterOption parameters = new ParameterOption();

  @Mixin private ServerOption server = new ServerOption();

  @Option(names = "--host", paramLabel = "NAME", description = "Host of the server to build on.")
  private String host = "";

  @Mixin private FmuOption unit = new FmuOption();

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  private static void requireFormat(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    if (!name.endsWith(".jar") && !name.endsWith(".fmu")) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --output "
              + file
              + ": the name ends in neither .jar nor .fmu");
    }
  }

  @Override
  public Integer call() throws IOException {
    if (module.isPresent()) {
      return buildModule(module.get());
    }
    if (target.isEmpty() && (cFolder.isEmpty() || standalone)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " -o FILE.jar is missing"
              + (standalone
                  ? "; --standalone needs it"
                  : ", or --c DIR for the model in C, or --wasm FILE.wasm for a module"));
    }
    if (target.isPresent()) {
      OutputFile.requireUsable(target.get());
      requireFormat(target.get());
    }
    if (unit.isAskedFor(target.orElse(Path.of("")), cFolder.isPresent())) {
      return buildUnit(target.orElse(Path.of("")));
    }
    if (cFolder.isPresent()) {
      writeC(cFolder.get());
    }
    if (target.isEmpty() && sourceFolder.isEmpty()) {
      return ExitStatus.DONE;
    }
    SimulationOptions asInFile = parameters.addTo(SimulationOptions.asInFile());
    SimulationOptions laidOut = code.isEmpty() ? asInFile : asInFile.code(code);
    SimulationOptions options = method.addTo(compact ? laidOut.compact() : laidOut);
    try (ServiceConnection service = ServiceConnection.open(server, userCode.consent());
        MechSession session = service.connection().openSession(host)) {
      session.loadModel(model, userCode.consent()).forEach(spec.commandLine().getErr()::println);
      Optional<BuiltJar> jar =
          target.isPresent() ? Optional.of(session.build(options, standalone)) : Optional.empty();
      if (sourceFolder.isPresent()) {
        for (GeneratedSource source : session.generatedSources(options)) {
          writeSource(source, sourceFolder.get());
        }
      }
      if (jar.isPresent()) {
        write(jar.get(), target.orElseThrow());
        print(jar.get(), target.orElseThrow(), session.runtimeJarBytes());
      }
      return ExitStatus.DONE;
    }
  }

  /** Refuses options that only a JAR has, for what is built here. */
  private void refuseOptionsOfJar(String what) {
    refuse(standalone, "--standalone", what);
    refuse(compact, "--compact", what);
    refuse(!code.isEmpty(), "--code", what);
    refuse(sourceFolder.isPresent(), "--source", what);
    refuse(cFolder.isPresent(), "--c", what);
    refuse(!host.isEmpty(), "--host", what);
  }

  private Integer buildModule(Path file) throws IOException {
    String what = "a WebAssembly module";
    refuseOptionsOfJar(what);
    refuse(target.isPresent(), "-o", what);
    OutputFile.requireUsable(file);
    byte[] bytes = ModelToExport.read(model, method.reading(parameters.values()), method).module();
    OutputFile.write(file, bytes);
    size(file.toString(), bytes.length);
    return ExitStatus.DONE;
  }

  private void writeC(Path folder) throws IOException {
    Map<String, String> files = leaving().filesInC(unit.asInputs());
    Files.createDirectories(folder);
    for (Map.Entry<String, String> file : files.entrySet()) {
      byte[] bytes = file.getValue().getBytes(StandardCharsets.UTF_8);
      OutputFile.write(folder.resolve(file.getKey()), bytes);
      size(file.getKey(), bytes.length);
    }
  }

  /** Returns the model for other programs, which set its inputs. */
  private ModelToExport leaving() throws IOException {
    return ModelToExport.read(
        model, method.reading(parameters.values()).withInputsAsParameters(), method);
  }

  private Integer buildUnit(Path file) throws IOException {
    refuseOptionsOfJar("an FMU");
    FmuArchive archive = unit.build(leaving());
    byte[] bytes = archive.bytes();
    OutputFile.write(file, bytes);
    size(file.toString(), bytes.length);
    fact("contains", archive.contents());
    return ExitStatus.DONE;
  }

  private static void refuse(boolean given, String option, String what) {
    if (given) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " "
              + option
              + " is for a JAR, not for "
              + what
              + ": leave it out, or write -o FILE.jar");
    }
  }

  private static void write(BuiltJar jar, Path target) throws IOException {
    OutputFile.write(target, jar.bytes());
    if (jar.signature().length > 0) {
      OutputFile.write(
          target.resolveSibling(target.getFileName() + VerifyCommand.SIGNATURE_SUFFIX),
          jar.signature());
    }
  }

  private static void writeSource(GeneratedSource source, Path folder) throws IOException {
    Path file = folder.resolve(source.fileName()).normalize();
    if (!file.startsWith(folder.normalize())) {
      throw new UsageException(
          MessageCode.OUTPUT_PLACE + " the server names a source file outside the folder: " + file);
    }
    Files.createDirectories(file.resolveSibling("."));
    OutputFile.write(file, source.text().getBytes(StandardCharsets.UTF_8));
  }

  private void print(BuiltJar jar, Path target, long runtimeBytes) throws IOException {
    size(target.toString(), jar.bytes().length);
    if (standalone) {
      JarContents contents = JarContents.of(target);
      contents.bytes().forEach((purpose, bytes) -> size("  " + purpose.label(), bytes));
      size("  names and places of files", contents.headers());
    }
    size("model classes, compressed", jar.modelClassBytes());
    size(standalone ? "runtime JAR (not needed)" : "runtime JAR (needed)", runtimeBytes);
    Map<String, String> manifest = jar.manifest();
    fact("formulation", manifest.getOrDefault("Mech-Formulation", ""));
    fact("because", manifest.getOrDefault("Mech-Formulation-Reason", ""));
    fact("code", manifest.getOrDefault("Mech-Code", ""));
    fact("integrator", manifest.getOrDefault("Mech-Integrator", ""));
    fact("columns", manifest.getOrDefault("Mech-Columns", ""));
    facts("left out", manifest.getOrDefault("Mech-Left-Out", ""));
    facts("from data", manifest.getOrDefault("Mech-From-Data", ""));
  }

  private void facts(String name, String values) {
    for (String value : values.split("; ", -1)) {
      fact(name, value);
    }
  }

  private void size(String what, long bytes) {
    spec.commandLine().getOut().printf(Locale.ROOT, "%-28s%9d B%n", what, bytes);
  }

  private void fact(String name, String value) {
    if (!value.isEmpty()) {
      spec.commandLine().getOut().printf(Locale.ROOT, "%-28s%s%n", name, value);
    }
  }
}

package org.mechservice.cli.sweep;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.model.MethodOptions;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.cli.simulate.ToleranceOptions;
import org.mechservice.client.SimulationOptions;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.diagnosis.SourcePosition;
import org.mechservice.mechml.document.Attribute;
import org.mechservice.mechml.document.Document;
import org.mechservice.mechml.document.DocumentWriter;
import org.mechservice.mechml.document.Element;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.study.run.StudyPart;
import org.mechservice.study.run.StudyPlan;
import org.mechservice.study.run.StudyReader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech sweep}: a study of a grid, written on the command line. */
@Command(
    name = "sweep",
    description = {
      "Runs a model with every combination of parameter values and writes a row for each: the"
          + " short form of mech study, for grids.",
      "What was interrupted is taken up again by the same command: finished rows wait in"
          + " FILE.unfinished."
    },
    footer = {
      "mech sweep model.xml --set k=1e4:3e4:5 --take height.q -o k.csv",
      "mech sweep model.xml --set k=1e4,2e4 --set c=500:1500:3 --take 'max(height.a),rms(seat.q)'"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class SweepCommand implements Callable<Integer> {
  /** Commas that are not within the brackets of a reduction. */
  private static final String COMMA = ",(?![^()]*\\))";

  private static final String STUDY = "sweep.xml";

  @Parameters(paramLabel = "MODEL.xml", description = "Model in MechML.")
  private Path model = Path.of("");

  @Option(
      names = "--set",
      required = true,
      paramLabel = "P=A:B:N|P=V,V,...",
      description =
          "N evenly spaced values of a parameter from A to B, or a list of values, in its unit;"
              + " once for each parameter.")
  private List<String> set = List.of();

  @Option(
      names = {"-o", "--out", "--output"},
      paramLabel = "FILE",
      description =
          "Write the table here, .csv or .parquet, instead of printing it; beside it a file with"
              + " the ending .study.json says where it comes from.")
  private @Nullable Path out;

  @Option(
      names = "--take",
      paramLabel = "COLUMNS",
      description =
          "What is kept of each run, separated by commas: max(x), series(x, 0.1) and all else that"
              + " a study knows; a name alone is the last value (default: that of each column).")
  private List<String> take = List.of();

  @Option(
      names = "--study",
      paramLabel = "FILE.xml",
      description = "Write the study that this stands for, and run nothing.")
  private @Nullable Path study;

  @Mixin private ThreadsOption threads = new ThreadsOption();

  @Mixin private ServerOption server = new ServerOption();

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Mixin private MethodOptions method = new MethodOptions();

  @Mixin private ToleranceOptions run = new ToleranceOptions();

  @Option(names = "--quiet", description = "Print nothing but the table and errors.")
  private boolean quiet;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (study != null) {
      OutputFile.requireUsable(study);
      Path folder = study.toAbsolutePath().getParent();
      String name = folder == null ? model.toString() : relative(folder, model);
      OutputFile.write(study, text(name).getBytes(StandardCharsets.UTF_8));
      return ExitStatus.DONE;
    }
    if (out == null) {
      return printed();
    }
    StudyCommand.requireTable(out);
    OutputFile.requireUsable(out);
    return run(out, false);
  }

  private static String relative(Path folder, Path file) {
    return folder.normalize().relativize(file.toAbsolutePath().normalize()).toString();
  }

  private int printed() throws IOException, InterruptedException {
    Path folder = Files.createTempDirectory("mech-sweep");
    Path table = folder.resolve("table.csv");
    try {
      int status = run(table, true);
      if (Files.exists(table)) {
        PrintWriter terminal = spec.commandLine().getOut();
        terminal.print(Files.readString(table));
        terminal.flush();
      }
      return status;
    } finally {
      try (var left = Files.list(folder)) {
        for (Path file : left.toList()) {
          Files.delete(file);
        }
      }
      Files.delete(folder);
    }
  }

  private int run(Path table, boolean printed) throws IOException, InterruptedException {
    StudyRun runs =
        new StudyRun(
            plan(),
            StudyPart.WHOLE,
            threads,
            spec.commandLine().getOut(),
            spec.commandLine().getErr(),
            quiet,
            printed);
    return server.address().isEmpty()
        ? runs.here(table)
        : runs.onHosts(table, server, userCode.consent());
  }

  private StudyPlan plan() throws IOException {
    if (!Files.isRegularFile(model)) {
      throw new NoSuchFileException(model.toString());
    }
    byte[] content = text(model.toString()).getBytes(StandardCharsets.UTF_8);
    try {
      return StudyReader.read(Path.of(STUDY), content, userCode.consent());
    } catch (MechmlException e) {
      throw new UsageException(
          e.diagnostics().stream().map(SweepCommand::message).collect(Collectors.joining("\n")));
    }
  }

  /** Positions in a generated study file mean nothing to users and are left out. */
  private static String message(Diagnostic diagnostic) {
    return diagnostic.file().equals(STUDY)
        ? diagnostic.code() + " " + diagnostic.message()
        : diagnostic.toString();
  }

  /**
   * Returns the study.
   *
   * @param modelName the model's file, as seen from the study's
   */
  private String text(String modelName) {
    Map<String, String> options = run.addTo(method.addTo(SimulationOptions.asInFile())).texts();
    List<Attribute> head = new ArrayList<>(List.of(new Attribute("model", modelName)));
    Optional.ofNullable(options.remove("simulation"))
        .ifPresent(name -> head.add(new Attribute("simulation", name)));
    List<Element> children = new ArrayList<>();
    if (!options.isEmpty()) {
      List<Attribute> settings = new ArrayList<>();
      options.forEach((name, value) -> settings.add(new Attribute(name, value)));
      children.add(element("run", settings));
    }
    children.addAll(factors());
    children.addAll(outputs());
    Element root = new Element("study", head, List.copyOf(children), SourcePosition.FILE, "");
    return DocumentWriter.write(new Document(Optional.empty(), List.of(), root, List.of()));
  }

  private List<Element> factors() {
    List<Element> factors = set.stream().map(SweepRange::factor).toList();
    Set<String> names = new HashSet<>();
    for (Element factor : factors) {
      String name = factor.attribute("name").orElseThrow();
      if (!names.add(name)) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE + " --set names parameter \"" + name + "\" twice");
      }
    }
    return factors;
  }

  private List<Element> outputs() {
    if (take.isEmpty()) {
      return List.of(
          element("output", List.of(new Attribute("name", "*"), new Attribute("of", "last(*)"))));
    }
    List<Element> outputs = new ArrayList<>();
    for (String words : take) {
      for (String word : words.split(COMMA, -1)) {
        String of = word.strip();
        outputs.add(
            element(
                "output",
                of.contains("(")
                    ? List.of(new Attribute("of", of))
                    : List.of(new Attribute("name", of), new Attribute("of", of))));
      }
    }
    return outputs;
  }

  private static Element element(String name, List<Attribute> attributes) {
    return new Element(name, attributes, List.of(), SourcePosition.FILE, "");
  }
}

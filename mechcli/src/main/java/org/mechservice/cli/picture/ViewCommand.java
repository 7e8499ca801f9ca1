package org.mechservice.cli.picture;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.regex.Pattern;
import org.mechservice.cli.model.ParameterOption;
import org.mechservice.cli.model.SceneReader;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.cli.simulate.CancelOnInterrupt;
import org.mechservice.cli.simulate.ToleranceOptions;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.run.PreparedRun;
import org.mechservice.client.run.RunResult;
import org.mechservice.mechml.ReadOptions;
import org.mechservice.result.ResultFormat;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.player.AnimatedScene;
import org.mechservice.view.player.Film;
import org.mechservice.view.player.PlayerPage;
import org.mechservice.view.player.Recording;
import org.mechservice.view.player.Stage;
import org.mechservice.view.plot.StoredResult;
import org.mechservice.view.scene.SceneDescription;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech view}: a run as a moving picture. */
@Command(
    name = "view",
    description = "Runs a model, or takes its results, and writes a moving picture.",
    footer = {
      "mech view model.xml -o motion.html",
      "mech view r.csv --model model.xml -o motion.glb",
      "mech view model.xml -o film.mp4 --size 1920x1080 --speed 0.5"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ViewCommand implements Callable<Integer> {
  private static final String PAGE = ".html";
  private static final String GLTF = ".glb";
  private static final String NOTES = "notes";

  /** A body that turns by more from one row to the next is recorded anew, rad. */
  private static final double COARSE = Math.PI / 2;

  /** By so much the fastest body turns then, rad. */
  private static final double FINE = Math.PI / 6;

  /** A note on an event: time and name. */
  private static final Pattern EVENT =
      Pattern.compile(
          "(?m)^" + MessageCode.EVENT_OCCURRED + " t=([-+0-9.eE]+) s: Event \"(.*?)\" ");

  /** The columns that a picture and its curves are made from. */
  private static final Set<ColumnGroup> COLUMNS =
      EnumSet.complementOf(EnumSet.of(ColumnGroup.MOMENTUM, ColumnGroup.ACCELERATIONS));

  @Parameters(paramLabel = "MODEL.xml|RESULT", description = "Model in MechML, or results of it.")
  private Path input = Path.of("");

  @Option(
      names = {"-o", "--output", "--out"},
      paramLabel = "FILE.html|glb|mp4|webm|gif|png",
      description =
          "The page to write, with a player that needs no network, an animated scene for other"
              + " programs, a film, or a picture of one moment; may be given several times. Films"
              + " and pictures need Chromium, films ffmpeg too.")
  private List<Path> targets = List.of();

  @Option(
      names = "--live",
      paramLabel = "FILE.html",
      description =
          "The page to write with the model itself in it: sliders for parameters and start values"
              + " run it again at once, with no network; it needs clang with lld, or zig.")
  private Optional<Path> live = Optional.empty();

  @Option(
      names = "--tunable",
      paramLabel = "PARAMETER",
      description =
          "A parameter that gets a slider in the page of --live, beside those that the file says"
              + " are tunable; may be given several times.")
  private List<String> tunable = List.of();

  @Mixin private FilmOptions film = new FilmOptions();

  @Option(
      names = "--model",
      paramLabel = "MODEL.xml",
      description = "The model that the results are of.")
  private Optional<Path> model = Optional.empty();

  @Option(
      names = "--simulation",
      paramLabel = "NAME|N",
      description = "Simulation of the file, by name or number; the first if left out.")
  private Optional<String> simulation = Optional.empty();

  @Mixin private ServerOption server = new ServerOption();

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Mixin private ParameterOption parameters = new ParameterOption();

  @Mixin private ToleranceOptions tolerances = new ToleranceOptions();

  @Spec private CommandSpec spec = CommandSpec.create();

  /** The facts and events of a run that the player shows beside its rows. */
  private record RunFacts(Map<String, String> facts, List<PlayerPage.Event> events, int status) {}

  @Override
  public Integer call() throws IOException {
    film.film();
    targets.forEach(ViewCommand::requireFormat);
    live.ifPresent(ViewCommand::requireFormat);
    requireTarget();
    boolean results = ResultFormat.of(input).isPresent();
    if (!results && model.isPresent()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --model goes with results such as R.csv; "
              + input
              + " is none");
    }
    Path file =
        results
            ? model.orElseThrow(
                () ->
                    new UsageException(
                        MessageCode.OPTION_UNUSABLE
                            + " "
                            + input
                            + " does not say what the bodies look like and how they are joined: name the model it is"
                            + " of by --model MODEL.xml"))
            : input;
    if (live.isPresent()) {
      ReadOptions reading = new ReadOptions(simulation, parameters.values(), Set.copyOf(tunable));
      LivePage.write(input, reading, live.get(), err());
      if (targets.isEmpty()) {
        return ExitStatus.DONE;
      }
    }
    SceneDescription scene =
        SceneReader.read(file, new ReadOptions(simulation, parameters.values(), Set.of()));
    Path folder = Optional.ofNullable(file.toAbsolutePath().getParent()).orElse(file);
    Stage stage = new Stage(scene, new MeshFolder(folder));
    stage.warnings().forEach(warning -> err().println(warning));
    Recording recording = new Recording();
    RunFacts told =
        results ? read(scene, file, recording) : run(recording, SimulationOptions.asInFile());
    Optional<Recording.Turn> turn = recording.greatestTurn(scene);
    if (!results
        && told.status() == ExitStatus.DONE
        && turn.map(Recording.Turn::angle).orElse(0.0) > COARSE) {
      // rows of the file that are too far apart for the eye: again, with rows by the motion
      double step = turn.get().step() * FINE / turn.get().angle();
      recording = new Recording(step);
      told = run(recording, SimulationOptions.asInFile().outputStep(step));
      turn = recording.greatestTurn(scene);
    }
    turn.filter(most -> most.angle() > Math.PI).ifPresent(this::warnOfRows);
    if (recording.frameCount() > 0) {
      for (Path target : targets) {
        write(target, scene, stage, recording, told);
      }
    }
    return told.status();
  }

  private void warnOfRows(Recording.Turn most) {
    err()
        .printf(
            Locale.ROOT,
            "body %s turns by %.3g turns from one row to the next, which is too far for the eye to"
                + " follow: it may seem to turn backwards or slowly; take rows every %.2g s or"
                + " closer (--t-step)%n",
            most.body(),
            most.angle() / (2 * Math.PI),
            most.step() * FINE / most.angle());
  }

  private void requireTarget() {
    if (live.isEmpty() && targets.isEmpty()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " -o FILE.html is missing, or --live FILE.html for a page that simulates itself");
    }
    if (live.isPresent() && ResultFormat.of(input).isPresent()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --live needs a model; "
              + input
              + " holds results: name the model in its place");
    }
    if (live.isPresent() && !ending(live.get()).endsWith(PAGE)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --live " + live.get() + ": the page is a .html file");
    }
    if (live.isEmpty() && !tunable.isEmpty()) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --tunable is for the page of --live FILE.html");
    }
  }

  private static String ending(Path file) {
    return file.toString().toLowerCase(Locale.ROOT);
  }

  private static void requireFormat(Path target) {
    boolean film = Film.is(target);
    if (!film && !ending(target).endsWith(PAGE) && !ending(target).endsWith(GLTF)) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --output "
              + target
              + ": moving pictures are written to .html, .glb, .mp4, .webm and .gif files, one"
              + " moment to a .png file");
    }
    OutputFile.requireUsable(target);
    if (film) {
      Film.lacking(target)
          .ifPresent(
              what -> {
                throw new UsageException(
                    MessageCode.OPTION_UNUSABLE
                        + " --output "
                        + target
                        + " needs "
                        + what
                        + "; install it, or write a .html or .glb file");
              });
    }
  }

  private void write(
      Path target, SceneDescription scene, Stage stage, Recording recording, RunFacts told)
      throws IOException {
    if (ending(target).endsWith(GLTF)) {
      OutputFile.write(target, AnimatedScene.write(scene, stage, recording));
      return;
    }
    byte[] page = PlayerPage.write(scene, stage, recording, told.facts(), told.events());
    if (Film.is(target)) {
      film.film().take(page, recording.time(0), recording.time(recording.frameCount() - 1), target);
    } else {
      OutputFile.write(target, page);
    }
  }

  /** Takes the rows of a result file. */
  private RunFacts read(SceneDescription scene, Path file, Recording recording) throws IOException {
    StoredResult csv;
    try {
      csv = StoredResult.open(input);
      List<Variable> columns =
          csv.names().stream().map(name -> new Variable(name, csv.unit(name))).toList();
      Optional<String> missing = Recording.missing(scene, columns);
      if (missing.isPresent()) {
        throw new UsageException(
            MessageCode.OPTION_UNUSABLE
                + " "
                + input
                + " has no column \""
                + missing.get()
                + "\", so it does not say where the bodies are; make it by mech simulate "
                + file
                + " --columns bodies --out "
                + input);
      }
      recording.begin(columns);
      csv.read(csv.names(), recording::row);
    } catch (IllegalArgumentException e) {
      throw new UsageException(String.valueOf(e.getMessage()));
    }
    return new RunFacts(
        Map.of("results", String.valueOf(input.getFileName())), List.of(), ExitStatus.DONE);
  }

  /** Runs the model. */
  private RunFacts run(Recording recording, SimulationOptions rows) throws IOException {
    try (CancelOnInterrupt interrupt = new CancelOnInterrupt();
        ServiceConnection service = ServiceConnection.open(server, userCode.consent());
        MechSession session = service.connection().openSession()) {
      session.loadModel(input, userCode.consent());
      try (PreparedRun run = session.prepareRemoteRun(options(rows))) {
        interrupt.cancels(run::cancel);
        RunResult result = run.toEnd(recording);
        return new RunFacts(
            facts(result.report()), events(result.report()), status(result.outcome()));
      }
    }
  }

  private SimulationOptions options(SimulationOptions rows) {
    SimulationOptions options = tolerances.addTo(parameters.addTo(rows.columns(COLUMNS)));
    return simulation.map(options::simulation).orElse(options);
  }

  private int status(Outcome outcome) {
    if (outcome instanceof Outcome.Failed failed) {
      err().println(failed.failure().message() + " The picture ends there.");
      return ExitStatus.SIMULATION_FAILED;
    } else if (outcome instanceof Outcome.Stopped) {
      err().println(MessageCode.RUN_STOPPED + " the run was stopped. The picture ends there.");
      return ExitStatus.INTERRUPTED;
    }
    return ExitStatus.DONE;
  }

  private static Map<String, String> facts(Map<String, Object> report) {
    Map<String, String> facts = new LinkedHashMap<>();
    report.forEach(
        (key, value) -> {
          if (!key.equals(NOTES)) {
            facts.put(key, String.valueOf(value));
          }
        });
    return facts;
  }

  /** Returns the events that the notes of a report tell of. */
  private static List<PlayerPage.Event> events(Map<String, Object> report) {
    return EVENT
        .matcher(String.valueOf(report.getOrDefault(NOTES, "")))
        .results()
        .map(found -> new PlayerPage.Event(Double.parseDouble(found.group(1)), found.group(2)))
        .toList();
  }

  private PrintWriter err() {
    return spec.commandLine().getErr();
  }
}

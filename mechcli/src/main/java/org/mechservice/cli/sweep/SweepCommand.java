package org.mechservice.cli.sweep;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Collection;
import java.util.HexFormat;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.model.ModelOptions;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.ServerOption;
import org.mechservice.cli.shell.ServiceConnection;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.cli.simulate.CancelOnInterrupt;
import org.mechservice.cli.simulate.ResultFiles;
import org.mechservice.cli.simulate.ToleranceOptions;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.sweep.Sweep;
import org.mechservice.client.sweep.SweepGrid;
import org.mechservice.client.sweep.SweepListener;
import org.mechservice.client.sweep.SweepRow;
import org.mechservice.client.sweep.UnknownParameterException;
import org.mechservice.report.ProgressLine;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ModelFiles;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech sweep}: a model with many values of its parameters, over all hosts of a server. */
@Command(
    name = "sweep",
    description = {
      "Runs a model with every combination of parameter values, as many at once as there are"
          + " places, and writes a row for each: the values, how the run ended, its last row,"
          + " figures of its report.",
      "What was interrupted is taken up again by the same command: finished points wait in"
          + " FILE.csv.part."
    },
    footer = {
      "mech sweep model.xml --set k=1e4:3e4:5 --take height.q --out k.csv",
      "mech sweep model.xml --set k=1e4,2e4 --set c=500:1500:3 --columns outputs --out kc.csv"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class SweepCommand implements Callable<Integer> {
  private static final Gson JSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().serializeNulls().create();

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
      names = "--out",
      paramLabel = "FILE.csv",
      description = "Write the rows here instead of printing them.")
  private @Nullable Path out;

  @Option(
      names = "--take",
      split = ",",
      paramLabel = "COLUMN",
      description = "Of each run's last row only these columns, separated by commas.")
  private List<String> take = List.of();

  @Option(
      names = "--figures",
      split = ",",
      paramLabel = "FIGURE",
      description = "Figures of the run reports, separated by commas (default: ${DEFAULT-VALUE}).",
      defaultValue = "steps,evaluations")
  private List<String> figures = List.of();

  @Option(
      names = "--at-once",
      paramLabel = "N",
      description = "At most so many runs at once (default: as many as there are places).")
  private int atOnce = Integer.MAX_VALUE;

  @Mixin private ServerOption server = new ServerOption();

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Mixin private ModelOptions method = new ModelOptions();

  @Mixin private ToleranceOptions run = new ToleranceOptions();

  @Option(names = "--quiet", description = "Print nothing but rows and errors.")
  private boolean quiet;

  @Option(names = "--json", description = "Print the rows as one JSON object.")
  private boolean json;

  @Spec private CommandSpec spec = CommandSpec.create();

  private final Map<Integer, SweepRow> unkept = new TreeMap<>();
  private Optional<SweepTable> table = Optional.empty();

  @Override
  public Integer call() throws IOException, InterruptedException {
    if (atOnce < 1) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE + " --at-once is " + atOnce + "; it must be 1 or more");
    }
    SweepGrid grid = grid();
    SimulationOptions options = run.addTo(method.addTo(SimulationOptions.asInFile()));
    if (out == null) {
      return sweep(grid, options, Optional.empty());
    }
    requireCsv(out);
    OutputFile.requireUsable(out);
    try (SweepJournal journal = SweepJournal.open(part(out), identity(options))) {
      return sweep(grid, options, Optional.of(journal));
    }
  }

  /** The table of a sweep has words in it, which the other formats of results have no place for. */
  private static void requireCsv(Path file) {
    if (!file.toString().toLowerCase(Locale.ROOT).endsWith(".csv")) {
      throw new UsageException(
          MessageCode.RESULT_FILE_NAME
              + " --out "
              + file
              + ": the table of a sweep is written to a .csv file; without --out it is printed");
    }
    ResultFiles.requireUsableNames(List.of(file));
  }

  private SweepGrid grid() {
    return new SweepGrid(set.stream().map(SweepRange::parse).toList());
  }

  private static Path part(Path file) {
    return file.resolveSibling(file.getFileName() + ".part");
  }

  /** Returns the hash that identifies this sweep; options that only choose columns are left out. */
  private JsonObject identity(SimulationOptions options) throws IOException {
    JsonObject identity = new JsonObject();
    identity.addProperty("model", model.toString());
    identity.addProperty("sha256", sha256(ModelFiles.inlined(Files.readAllBytes(model), model)));
    identity.addProperty("options", options.toString());
    JsonArray swept = new JsonArray();
    set.forEach(swept::add);
    identity.add("set", swept);
    return identity;
  }

  private static String sha256(byte[] content) {
    try {
      return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  private int sweep(SweepGrid grid, SimulationOptions options, Optional<SweepJournal> journal)
      throws IOException, InterruptedException {
    Map<Integer, SweepRow> rows = journal.map(SweepJournal::rows).orElse(unkept);
    if (!rows.isEmpty() && !quiet) {
      err().println(rows.size() + " of " + grid.size() + " points were finished before");
    }
    Optional<ServiceException> lost = Optional.empty();
    try (CancelOnInterrupt interrupt = new CancelOnInterrupt();
        ServiceConnection service =
            ServiceConnection.open(server, Runtime.getRuntime().availableProcessors())) {
      Sweep sweep =
          new Sweep(service.connection(), model, userCode.folder(), options, grid, atOnce);
      interrupt.cancels(sweep::stop);
      try (ProgressLine line = new ProgressLine(quiet ? nowhere() : err())) {
        sweep.run(Map.copyOf(rows).keySet(), new Rows(grid, journal, line));
      } catch (ServiceException e) {
        if (table.isEmpty()) {
          throw e; // it did not even begin
        }
        lost = Optional.of(e);
      } catch (UnknownParameterException e) {
        throw new UsageException(MessageCode.MODEL_FILE_UNUSABLE + " " + e.getMessage());
      }
      write(rows.values());
      if (rows.size() == grid.size() && journal.isPresent()) {
        journal.get().delete();
      }
      return tell(grid, rows, lost);
    }
  }

  private static PrintWriter nowhere() {
    return new PrintWriter(java.io.Writer.nullWriter());
  }

  /** Keeps rows as they come. */
  private final class Rows implements SweepListener {
    private final SweepGrid grid;
    private final Optional<SweepJournal> journal;
    private final ProgressLine line;
    private boolean figuresKnown;

    Rows(SweepGrid grid, Optional<SweepJournal> journal, ProgressLine line) {
      this.grid = grid;
      this.journal = journal;
      this.line = line;
    }

    @Override
    public void begins(List<ModelMessage> warnings, List<Variable> columns) {
      table = Optional.of(new SweepTable(grid, columns, take, figures));
      if (!quiet) {
        warnings.forEach(warning -> err().println(warning));
      }
    }

    @Override
    public void finished(SweepRow row, int running) throws IOException {
      if (!figuresKnown && row.outcome().equals(SweepRow.COMPLETED)) {
        table.ifPresent(known -> known.requireFigures(row.report()));
        figuresKnown = true;
      }
      if (journal.isPresent()) {
        journal.get().add(row);
      } else {
        unkept.put(row.point(), row);
      }
      int done = journal.map(SweepJournal::rows).orElse(unkept).size();
      String at = done + " of " + grid.size() + " points, " + running + " under way";
      line.at(at, (double) done / grid.size(), Double.NaN);
    }
  }

  private void write(Collection<SweepRow> rows) throws IOException {
    SweepTable shown = table.orElseThrow();
    if (out != null) {
      OutputFile.write(out, shown.csv(rows).getBytes(StandardCharsets.UTF_8));
    }
    PrintWriter terminal = spec.commandLine().getOut();
    if (json) {
      JsonObject all = new JsonObject();
      all.addProperty("points", grid().size());
      all.addProperty("finished", rows.size());
      all.addProperty("failed", failed(rows));
      if (out != null) {
        all.addProperty("file", out.toString());
      }
      all.add("rows", shown.json(rows));
      terminal.println(JSON.toJson(all));
    } else if (out == null) {
      terminal.print(shown.csv(rows));
    }
    terminal.flush();
  }

  private static long failed(Collection<SweepRow> rows) {
    return rows.stream().filter(row -> !row.outcome().equals(SweepRow.COMPLETED)).count();
  }

  private int tell(SweepGrid grid, Map<Integer, SweepRow> rows, Optional<ServiceException> lost) {
    long failed = failed(rows.values());
    if (rows.size() < grid.size()) {
      String where = out == null ? "" : "; they are in " + out + ", and the same command goes on";
      String so = rows.size() + " of " + grid.size() + " points are finished" + where;
      err()
          .println(
              lost.map(why -> why.getMessage() + "; " + so)
                  .orElse(MessageCode.RUN_STOPPED + " stopped on request: " + so));
      return lost.isPresent() ? ExitStatus.SERVER : ExitStatus.INTERRUPTED;
    } else if (failed > 0) {
      SweepRow first =
          rows.values().stream()
              .filter(row -> !row.outcome().equals(SweepRow.COMPLETED))
              .findFirst()
              .orElseThrow();
      err()
          .println(
              first.code()
                  + " "
                  + failed
                  + " of "
                  + grid.size()
                  + " points failed, the first at "
                  + grid.point(first.point())
                  + ": "
                  + first.message());
      return ExitStatus.SIMULATION_FAILED;
    }
    return ExitStatus.DONE;
  }

  private PrintWriter err() {
    return spec.commandLine().getErr();
  }
}

package org.mechservice.view.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonNull;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import org.jspecify.annotations.Nullable;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.client.run.PreparedRun;
import org.mechservice.client.run.RunProgress;
import org.mechservice.client.run.RunResult;
import org.mechservice.orb.http.EventStream;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.result.ResultFormat;
import org.mechservice.result.SignalTable;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Outcome;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ResultFile;
import org.mechservice.view.mesh.MeshFolder;
import org.mechservice.view.player.AnimatedScene;
import org.mechservice.view.player.PlayerPage;
import org.mechservice.view.player.Recording;
import org.mechservice.view.player.Stage;
import org.mechservice.view.scene.SceneDescription;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** One run of one model, and what pages and files get of it. */
final class UserRun {
  private static final Logger LOG = LoggerFactory.getLogger(UserRun.class);

  /** The columns that players need, and curves that users request. */
  private static final Set<ColumnGroup> COLUMNS =
      EnumSet.complementOf(EnumSet.of(ColumnGroup.MOMENTUM, ColumnGroup.ACCELERATIONS));

  /** Shortest interval between two updates of a page: 30 a second. */
  private static final long PAUSE_MILLIS = 34;

  private static final long PING_NANOS = 2_000_000_000L;
  private static final int FRAMES_AT_ONCE = 300;

  /** Bytes of the CSV file of a run that is read into memory to be compared. */
  private static final long MOST_COMPARED = 64L << 20;

  private final byte[] model;
  private final ModelReader.Choice choice;
  private final SimulationOptions options;
  private final SceneDescription scene;
  private final Stage stage;
  private final DroppedFiles files;
  private final String title;
  private final Path folder;
  private final Recording recording = new Recording();
  private volatile Optional<RunFrames> frames = Optional.empty();
  private volatile Optional<JsonObject> ending = Optional.empty();
  private volatile boolean closed;
  private @Nullable PreparedRun active;
  private boolean cancelled;

  /** Open until the result files are complete, which takes a while after a long run. */
  private final CountDownLatch stored = new CountDownLatch(1);

  private volatile String unstored = "";

  /**
   * What is to be run.
   *
   * @param model MechML text's bytes
   * @param choice simulation and values of parameters, which are among the options too
   * @param scene the mechanism
   * @param files what lies beside the model; removed with the run
   * @param title what differs from the model's file, for people
   */
  @SuppressWarnings("ArrayRecordComponent") // made once, read once, never compared
  record Order(
      byte[] model,
      ModelReader.Choice choice,
      SimulationOptions options,
      SceneDescription scene,
      DroppedFiles files,
      String title) {}

  /**
   * @param folder of this run alone; receives its result files
   */
  UserRun(Order order, Path folder) {
    model = order.model();
    choice = order.choice();
    options = order.options();
    scene = order.scene();
    files = order.files();
    title = order.title();
    this.folder = folder;
    stage = new Stage(scene, new MeshFolder(files.folder()));
  }

  /** Returns what differs from the model's file, for people. */
  String title() {
    return title;
  }

  /** Runs to the end; what goes wrong is told to the pages. */
  void run(MechConnection service) {
    JsonObject end = new JsonObject();
    try (MechSession session = service.openSession()) {
      session.loadModel("model.xml", model);
      try (PreparedRun run = session.prepareRemoteRun(options.columns(COLUMNS))) {
        begin(run);
        complete(end, run);
      } finally {
        over();
      }
    } catch (ServiceException e) {
      // A run that is cancelled before it has started cannot start.
      end.addProperty("outcome", wasCancelled() ? "cancelled" : "failed");
      end.addProperty("message", wasCancelled() ? "" : String.valueOf(e.getMessage()));
    } catch (IOException e) {
      unstored = MessageCode.FILE_UNUSABLE + " " + e.getMessage();
      end.addProperty("outcome", "failed");
      end.addProperty("message", unstored);
    } finally {
      if (end.size() == 0) {
        end.addProperty("outcome", "failed");
        end.addProperty("message", MessageCode.INTERNAL_SERVER_ERROR + " the page's server failed");
      }
      if (ending.isEmpty()) {
        ending = Optional.of(end);
      }
      stored.countDown();
    }
  }

  private void complete(JsonObject end, PreparedRun run) throws IOException {
    RunProgress interval = run.progress();
    RunFrames live = new RunFrames(interval.endTime() - interval.startTime());
    try (ResultFile csv = new ResultFile(file(ResultFormat.CSV), ResultFormat.CSV);
        ResultFile mat = new ResultFile(file(ResultFormat.MAT), ResultFormat.MAT)) {
      ResultSink all =
          new ResultSink() {
            @Override
            public void begin(List<Variable> columns) throws IOException {
              csv.begin(columns);
              mat.begin(columns);
              recording.begin(columns);
              live.begin(columns);
              frames = Optional.of(live);
            }

            @Override
            public void row(double[] values) throws IOException {
              csv.row(values);
              mat.row(values);
              recording.row(values);
              live.row(values);
            }
          };
      RunResult result = run.toEnd(all);
      end.addProperty("outcome", outcome(result.outcome()));
      if (result.outcome() instanceof Outcome.Failed failed) {
        end.addProperty("message", failed.failure().message());
      }
      JsonObject report = new JsonObject();
      result.report().forEach((key, value) -> report.addProperty(key, String.valueOf(value)));
      end.add("report", report);
      // Pages learn the end at once; their downloads wait for the files.
      ending = Optional.of(end);
      csv.keep();
      mat.keep();
    }
  }

  private static String outcome(Outcome outcome) {
    return outcome instanceof Outcome.Completed
        ? "done"
        : outcome instanceof Outcome.Stopped ? "cancelled" : "failed";
  }

  private Path file(ResultFormat format) {
    return folder.resolve("result" + format.ending());
  }

  private synchronized void begin(PreparedRun run) {
    active = run;
    if (cancelled) {
      run.cancel();
    }
  }

  private synchronized void over() {
    active = null;
  }

  /**
   * Stops the run, if it has not ended. Pages learn it at once; the rows that the server had
   * computed ahead of the page still come into the files.
   */
  synchronized void cancel() {
    cancelled = true;
    if (active != null) {
      active.cancel();
    }
    if (ending.isEmpty()) {
      JsonObject end = new JsonObject();
      end.addProperty("outcome", "cancelled");
      ending = Optional.of(end);
    }
  }

  private synchronized boolean wasCancelled() {
    return cancelled;
  }

  /** Returns whether the run has ended and its files are complete. */
  boolean hasEnded() {
    return stored.getCount() == 0;
  }

  /** Sends a page the mechanism, the frames as they come, and how the run ended. */
  void watch(EventStream page) throws IOException, InterruptedException {
    int sent = 0;
    boolean begun = false;
    long last = System.nanoTime();
    while (!closed) {
      // Read first: what comes after it is then complete.
      Optional<JsonObject> end = ending;
      Optional<RunFrames> live = frames;
      if (live.isPresent() && !begun) {
        page.send("begin", beginning(live.get()));
        begun = true;
      }
      int first = sent;
      List<double[]> more =
          live.map(running -> running.from(first, FRAMES_AT_ONCE)).orElse(List.of());
      if (!more.isEmpty()) {
        page.send("rows", rows(more));
        sent += more.size();
        last = System.nanoTime();
      }
      if (end.isPresent() && (more.size() < FRAMES_AT_ONCE || wasCancelled())) {
        page.send("end", end.get());
        return;
      }
      if (more.isEmpty() && System.nanoTime() - last > PING_NANOS) {
        page.ping();
        last = System.nanoTime();
      }
      Thread.sleep(PAUSE_MILLIS);
    }
  }

  private JsonObject beginning(RunFrames live) {
    Recording columns = new Recording();
    columns.begin(live.columns());
    return PlayerPage.sceneJson(scene, stage, columns);
  }

  private static JsonArray rows(List<double[]> frames) {
    JsonArray rows = new JsonArray();
    for (double[] frame : frames) {
      JsonArray row = new JsonArray(frame.length);
      for (double value : frame) {
        if (Double.isFinite(value)) {
          row.add((float) value);
        } else {
          row.add(JsonNull.INSTANCE);
        }
      }
      rows.add(row);
    }
    return rows;
  }

  /** Returns a result in a format. */
  Download download(MechConnection service, ModelExports exports, String format)
      throws IOException, InterruptedException {
    if (format.equals("fmu")) {
      String text = new String(model, StandardCharsets.UTF_8);
      return Download.of("application/octet-stream", exports.unit(text, choice));
    }
    if (format.equals("jar")) {
      try (MechSession session = service.openSession()) {
        session.loadModel("model.xml", model);
        return Download.of("application/java-archive", session.build(options, true).bytes());
      }
    }
    awaitFiles();
    return switch (format) {
      case "csv" -> Download.of("text/csv", file(ResultFormat.CSV));
      case "mat" -> Download.of("application/octet-stream", file(ResultFormat.MAT));
      case "glb" -> Download.of("model/gltf-binary", AnimatedScene.write(scene, stage, recording));
      case "html" ->
          Download.of("text/html", PlayerPage.write(scene, stage, recording, facts(), List.of()));
      default -> throw RefusedRequestException.notUnderstood("there is no format " + format);
    };
  }

  private void awaitFiles() throws InterruptedException {
    if (ending.isEmpty()) {
      throw RefusedRequestException.notUnderstood("this run has no results yet");
    }
    stored.await();
    if (!unstored.isEmpty()) {
      throw new RefusedRequestException(500, unstored);
    }
    if (recording.frameCount() == 0) {
      throw RefusedRequestException.notUnderstood("this run has no rows");
    }
  }

  /**
   * Reads the rows of the run into memory.
   *
   * @throws RefusedRequestException if there are none, or more than the page compares
   */
  SignalTable table() throws IOException, InterruptedException {
    awaitFiles();
    Path csv = file(ResultFormat.CSV);
    if (Files.size(csv) > MOST_COMPARED) {
      throw RefusedRequestException.notUnderstood(
          "a run of "
              + Files.size(csv)
              + " bytes of CSV is too large to be compared here ("
              + MOST_COMPARED
              + " at most); download both and use mech compare");
    }
    return SignalTable.read(csv);
  }

  private Map<String, String> facts() {
    Map<String, String> facts = new LinkedHashMap<>();
    ending
        .map(end -> end.getAsJsonObject("report"))
        .ifPresent(
            report ->
                report.entrySet().forEach(e -> facts.put(e.getKey(), e.getValue().getAsString())));
    return facts;
  }

  /** Stops the run and removes its files. */
  void close() {
    closed = true;
    files.close();
    try {
      cancel();
    } catch (ServiceException e) {
      LOG.debug("the server is gone, and the run with it", e);
    }
    try (var stored = Files.list(folder)) {
      for (Path file : stored.toList()) {
        Files.deleteIfExists(file);
      }
      Files.deleteIfExists(folder);
    } catch (IOException e) {
      folder.toFile().deleteOnExit();
    }
  }
}

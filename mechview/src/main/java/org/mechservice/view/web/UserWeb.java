package org.mechservice.view.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Semaphore;
import org.mechservice.client.ImportedModel;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.failure.ModelMessage;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.idl.MAX_MECHML_BYTES;
import org.mechservice.orb.BoundedHttp;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.http.AccessToken;
import org.mechservice.orb.http.EventStream;
import org.mechservice.orb.http.PageFiles;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.orb.http.Request;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.view.drawing.Svg;
import org.mechservice.view.drawing.Theme;
import org.mechservice.view.player.PlayerPage;
import org.mechservice.view.player.ThreeLibrary;
import org.mechservice.view.sketch.MechanismPicture;
import org.mechservice.view.sketch.ViewPlane;

/** Serves the page for users on the loopback interface. */
public final class UserWeb implements AutoCloseable {
  private static final List<String> ROBOTS = List.of(".urdf", ".sdf", ".mjcf");

  private static final String REPORT = "/report/";

  /** Streams to pages at once. */
  private static final int STREAMS = 60;

  /** Models that are read at once; others wait. */
  private static final int READERS = 8;

  /** JSON writes a character of a model as up to two bytes, rarely more. */
  private static final int LONGEST_BODY = 2 * MAX_MECHML_BYTES.value;

  private final BoundedHttp http;
  private final MechConnection service;
  private final ModelReader reader;
  private final Map<String, String> examples;
  private final String grammar;
  private final ModelExports exports;
  private final UserRuns runs;
  private final UserReports reports;
  private final String token = AccessToken.random();
  private final PageFiles files = new PageFiles(UserWeb.class, "");
  private final PageFiles shared = new PageFiles(PlayerPage.class, "");
  private final Semaphore freeStreams = new Semaphore(STREAMS);
  private final Semaphore freeReaders = new Semaphore(READERS);

  /**
   * Starts to serve.
   *
   * @param service checks and runs the models; stays open
   * @param reader reads models for drawings
   * @param exports what a model becomes beside results
   * @param examples models to begin with, by their names
   * @param grammar the DTD of MechML, from which the editor completes
   * @param port TCP port; 0: any free one
   * @throws org.mechservice.orb.PortInUseException if the port is taken
   */
  public UserWeb(
      MechConnection service,
      ModelReader reader,
      ModelExports exports,
      Map<String, String> examples,
      String grammar,
      int port) {
    this.service = service;
    this.reader = reader;
    this.exports = exports;
    this.examples = new LinkedHashMap<>(examples);
    this.grammar = grammar;
    runs = new UserRuns(service);
    reports = new UserReports(service, exports);
    http = BoundedHttp.open(port, "web");
    http.serve("/", this::handle);
    http.start();
  }

  /** Returns the port it listens on. */
  public int port() {
    return http.port();
  }

  /**
   * Returns the address that opens the page; browsers do not send the token behind the number sign.
   */
  public String url() {
    return "http://127.0.0.1:" + port() + "/#token=" + token;
  }

  private void handle(HttpExchange exchange) throws IOException {
    try (exchange) {
      Request request = new Request(exchange);
      try {
        if (!request.isFromOwnSite(port())) {
          throw new RefusedRequestException(
              403, MessageCode.CROSS_SITE_REQUEST + " the request came from another site");
        }
        answer(request);
      } catch (RefusedRequestException refusal) {
        answer(request, refusal.status(), refusal.text());
      } catch (ServiceException e) {
        answer(request, 400, String.valueOf(e.getMessage()));
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } catch (RuntimeException e) {
        String incident = GuardedServant.record(request.path(), e);
        answer(
            request,
            500,
            MessageCode.INTERNAL_SERVER_ERROR + " the page's server failed, incident " + incident);
      }
    }
  }

  private static void answer(Request request, int status, String text) throws IOException {
    JsonObject json = new JsonObject();
    json.addProperty("error", text);
    request.answer(status, json);
  }

  private void answer(Request request) throws IOException, InterruptedException {
    String path = request.path();
    if (path.startsWith("/api/")) {
      if (!AccessToken.isSame(request.token(), token)) {
        throw new RefusedRequestException(
            401,
            MessageCode.TOKEN_NEEDED
                + " the token is missing or wrong; open the address that mech web has printed");
      }
      api(request, path.substring("/api/".length()));
      return;
    }
    if (path.startsWith(REPORT)) {
      report(request, path.substring(REPORT.length()));
      return;
    }
    PageFiles.PageFile file = file(path).orElseThrow(() -> nothingAt(path));
    request.allowOwnPictures();
    request.answer(200, file.type(), file.content());
  }

  private Optional<PageFiles.PageFile> file(String path) throws IOException {
    if (path.equals("/player/three.js")) {
      byte[] module = ThreeLibrary.module().getBytes(StandardCharsets.UTF_8);
      return Optional.of(new PageFiles.PageFile("text/javascript; charset=utf-8", module));
    } else if (path.startsWith("/player/")) {
      return shared.file(path.substring("/player/".length()));
    }
    return files.file(path.equals("/") ? "index.html" : path.substring(1));
  }

  /** A report is opened by its address, in which its identity is the secret. */
  private void report(Request request, String path) throws IOException {
    int slash = path.indexOf('/');
    if (slash < 0 || !request.isGet()) {
      throw nothingAt(request.path());
    }
    reports
        .get(path.substring(0, slash))
        .answer(request, path.substring(slash + 1), exports.reportPolicy());
  }

  private static RefusedRequestException nothingAt(String path) {
    return new RefusedRequestException(
        404,
        MessageCode.REQUEST_UNUSABLE + " the request cannot be used: there is nothing at " + path);
  }

  private void api(Request request, String what) throws IOException, InterruptedException {
    if (request.isGet()) {
      switch (what) {
        case "start" -> request.answer(200, start());
        case "runs" -> request.answer(200, runs.list());
        case "watch" -> watch(request);
        case "result" ->
            runs.get(request.parameter("run"))
                .download(service, exports, request.parameter("format"))
                .to(request);
        case "differences" -> request.answer(200, differences(request));
        case "report" -> request.answer(200, reports.get(request.parameter("report")).progress());
        default -> throw nothingAt(request.path());
      }
    } else if (request.isPost()) {
      switch (what) {
        case "check" -> read(request, this::check);
        case "run" -> read(request, this::run);
        case "measure" -> read(request, this::measure);
        case "unmeasure" -> {
          reports.get(text(request.body(), "report")).cancel();
          request.answer(200, new JsonObject());
        }
        case "cancel" -> {
          runs.get(text(request.body(), "run")).cancel();
          request.answer(200, new JsonObject());
        }
        default -> throw nothingAt(request.path());
      }
    } else {
      throw new RefusedRequestException(
          405,
          MessageCode.REQUEST_UNUSABLE + " the request cannot be used: it is neither GET nor POST");
    }
  }

  private JsonObject start() {
    JsonObject json = new JsonObject();
    json.addProperty("server", service.service().version());
    JsonArray all = new JsonArray();
    examples.forEach(
        (name, model) -> {
          JsonObject example = new JsonObject();
          example.addProperty("name", name);
          example.addProperty("text", model);
          all.add(example);
        });
    json.add("examples", all);
    json.addProperty("grammar", grammar);
    return json;
  }

  private void watch(Request request) throws IOException, InterruptedException {
    UserRun run = runs.get(request.parameter("run"));
    if (!freeStreams.tryAcquire()) {
      throw new RefusedRequestException(
          503,
          MessageCode.TOO_MANY_PAGES
              + " more than "
              + STREAMS
              + " pages watch already; close some");
    }
    try (EventStream page = request.stream()) {
      run.watch(page);
    } finally {
      freeStreams.release();
    }
  }

  private JsonObject differences(Request request) throws IOException, InterruptedException {
    UserRun first = runs.get(request.parameter("first"));
    UserRun second = runs.get(request.parameter("second"));
    List<String> names = List.of(request.parameter("name"), request.parameter("other"));
    freeReaders.acquire();
    try {
      return Differences.of(names, first.table(), second.table());
    } finally {
      freeReaders.release();
    }
  }

  private JsonObject measure(JsonObject body) throws IOException {
    JsonObject answer = new JsonObject();
    try (DroppedFiles files = DroppedFiles.of(body)) {
      String model = files.inlined(text(body, "text"));
      answer.addProperty("report", reports.start(model.getBytes(StandardCharsets.UTF_8)));
    }
    return answer;
  }

  /** Answers a request that brings a model. */
  private interface Reading {
    JsonObject of(JsonObject body) throws IOException;
  }

  private void read(Request request, Reading reading) throws IOException, InterruptedException {
    freeReaders.acquire();
    try {
      request.answer(200, reading.of(request.body(LONGEST_BODY)));
    } finally {
      freeReaders.release();
    }
  }

  private static String text(JsonObject body, String name) {
    JsonElement value = body.get(name);
    if (value == null || !value.isJsonPrimitive()) {
      throw RefusedRequestException.notUnderstood("it has no text " + name);
    }
    return value.getAsString();
  }

  private JsonObject check(JsonObject body) throws IOException {
    JsonObject answer = new JsonObject();
    String model = text(body, "text");
    try (DroppedFiles files = DroppedFiles.of(body)) {
      String name = text(body, "name");
      if (ROBOTS.stream().anyMatch(name::endsWith)) {
        ImportedModel imported = translated(model);
        model = imported.text();
        answer.addProperty("translated", model);
      }
      model = files.inlined(model);
      try (MechSession session = service.openSession()) {
        List<ModelMessage> warnings =
            session.loadModel("model.xml", model.getBytes(StandardCharsets.UTF_8));
        answer.add("messages", messages(warnings));
        answer.addProperty("report", session.checkReport(false));
      }
      answer.addProperty("ok", true);
      draw(answer, reader.read(model, choice(body)));
    } catch (InvalidModelException e) {
      answer.addProperty("ok", false);
      answer.add("messages", messages(e.messages()));
      answer.addProperty("report", e.messages().isEmpty() ? String.valueOf(e.getMessage()) : "");
    }
    return answer;
  }

  /** Translates a robot; the outermost element of its text tells the format. */
  private ImportedModel translated(String robot) throws IOException {
    Path folder = Files.createTempDirectory("mechweb");
    Path file = folder.resolve("model.urdf");
    try {
      Files.writeString(file, robot);
      return service.importModel(file);
    } finally {
      Files.deleteIfExists(file);
      Files.deleteIfExists(folder);
    }
  }

  private static JsonArray messages(List<ModelMessage> said) {
    JsonArray all = new JsonArray();
    for (ModelMessage message : said) {
      JsonObject one = new JsonObject();
      one.addProperty("severity", message.severity().name());
      one.addProperty("text", message.codeAndText());
      one.addProperty("line", message.line());
      one.addProperty("column", message.column());
      all.add(one);
    }
    return all;
  }

  private static void draw(JsonObject answer, ModelReader.ReadModel model) {
    answer.addProperty("name", model.scene().name());
    answer.addProperty(
        "drawing", Svg.of(MechanismPicture.draw(model.scene(), ViewPlane.AUTO), Theme.AUTOMATIC));
    JsonArray parameters = new JsonArray();
    for (ModelReader.Parameter parameter : model.parameters()) {
      JsonObject one = new JsonObject();
      one.addProperty("name", parameter.name());
      one.addProperty("unit", parameter.unit());
      one.addProperty("value", parameter.value());
      parameters.add(one);
    }
    answer.add("parameters", parameters);
    JsonArray simulations = new JsonArray();
    model.simulations().forEach(simulations::add);
    answer.add("simulations", simulations);
  }

  private static ModelReader.Choice choice(JsonObject body) {
    Map<String, String> values = new LinkedHashMap<>();
    if (body.get("parameters") instanceof JsonObject chosen) {
      chosen.keySet().forEach(name -> values.put(name, text(chosen, name)));
    }
    return new ModelReader.Choice(chosen(body, "simulation"), values);
  }

  private JsonObject run(JsonObject body) throws IOException {
    DroppedFiles files = DroppedFiles.of(body);
    boolean taken = false;
    try {
      JsonObject answer = run(body, files);
      taken = true;
      return answer;
    } finally {
      if (!taken) {
        files.close();
      }
    }
  }

  /** Starts a run, which takes the files. */
  private JsonObject run(JsonObject body, DroppedFiles files) throws IOException {
    String model = files.inlined(text(body, "text"));
    byte[] content = model.getBytes(StandardCharsets.UTF_8);
    try (MechSession session = service.openSession()) {
      session.loadModel("model.xml", content);
    }
    SimulationOptions options = SimulationOptions.asInFile();
    ModelReader.Choice choice = choice(body);
    for (Map.Entry<String, String> value : choice.parameters().entrySet()) {
      options = options.parameter(value.getKey(), value.getValue());
    }
    options = choice.simulation().map(options::simulation).orElse(options);
    options = chosen(body, "formulation").map(options::formulation).orElse(options);
    options = chosen(body, "integrator").map(options::integrator).orElse(options);
    options = number(body, "relTol").map(options::relativeTolerance).orElse(options);
    options = chosen(body, "absTol").map(options::absoluteTolerances).orElse(options);
    options = number(body, "tEnd").map(options::endTime).orElse(options);
    JsonObject answer = new JsonObject();
    answer.addProperty(
        "run",
        runs.start(
            new UserRun.Order(
                content,
                choice,
                options,
                reader.read(model, choice).scene(),
                files,
                body.has("title") ? text(body, "title") : "")));
    return answer;
  }

  private static Optional<String> chosen(JsonObject body, String name) {
    return body.has(name) && !text(body, name).isBlank()
        ? Optional.of(text(body, name))
        : Optional.empty();
  }

  private static Optional<Double> number(JsonObject body, String name) {
    try {
      return chosen(body, name).map(Double::valueOf);
    } catch (NumberFormatException e) {
      throw RefusedRequestException.notUnderstood(
          name + " must be a number, not \"" + text(body, name) + "\"");
    }
  }

  /** Ends all runs and streams and closes the port. */
  @Override
  public void close() {
    reports.close();
    runs.close();
    http.close();
  }
}

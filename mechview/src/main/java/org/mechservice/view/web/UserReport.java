package org.mechservice.view.web;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import org.mechservice.client.MechConnection;
import org.mechservice.client.MechSession;
import org.mechservice.client.failure.ServiceException;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.orb.http.Request;
import org.mechservice.solver.catalogue.MessageCode;

/** The measurement of one model's error against run time, and the report that it becomes. */
final class UserReport {
  private final Thread thread;
  private final Path folder;
  private volatile boolean cancelled;

  private State state = State.RUNS;
  private String what = "waiting for a session";
  private double done;
  private double secondsLeft = Double.NaN;
  private String message = "";
  private String page = "";

  private enum State {
    RUNS,
    DONE,
    CANCELLED,
    FAILED
  }

  /**
   * Starts to measure.
   *
   * @param model MechML text's bytes
   */
  UserReport(MechConnection service, ModelExports exports, byte[] model) throws IOException {
    folder = Files.createTempDirectory("mechweb");
    thread = new Thread(() -> measure(service, exports, model), "mechservice-user-report");
    thread.setDaemon(true);
    thread.start();
  }

  private void measure(MechConnection service, ModelExports exports, byte[] model) {
    try (MechSession session = service.openSession()) {
      session.loadModel("model.xml", model);
      Path report = exports.report(session, folder, this::at);
      end(State.DONE, "", String.valueOf(report.getFileName()));
    } catch (CancellationException | InterruptedException e) {
      end(State.CANCELLED, "", "");
    } catch (ServiceException e) {
      end(cancelled ? State.CANCELLED : State.FAILED, String.valueOf(e.getMessage()), "");
    } catch (IOException e) {
      String why = String.valueOf(e.getMessage());
      String code = MessageCode.FILE_UNUSABLE.toString();
      end(State.FAILED, why.startsWith(code) ? why : code + " " + why, "");
    } catch (RuntimeException e) {
      String incident = GuardedServant.record("report", e);
      end(
          State.FAILED,
          MessageCode.INTERNAL_SERVER_ERROR + " the page's server failed, incident " + incident,
          "");
    }
  }

  private synchronized void at(String now, double part, double left) {
    if (cancelled) {
      throw new CancellationException();
    }
    what = now;
    done = part;
    secondsLeft = left;
  }

  private synchronized void end(State ending, String why, String file) {
    if (state == State.RUNS) {
      state = ending;
      message = why;
      page = file;
    }
  }

  /** Returns whether nothing is measured any more, which may be a while after the cancel. */
  boolean hasEnded() {
    return !thread.isAlive();
  }

  /** Ends the measurement and tells the pages at once. */
  void cancel() {
    cancelled = true;
    thread.interrupt();
    end(State.CANCELLED, "", "");
  }

  /** Returns how far it is. */
  synchronized JsonObject progress() {
    JsonObject json = new JsonObject();
    json.addProperty("state", state.name().toLowerCase(Locale.ROOT));
    json.addProperty("what", what);
    json.addProperty("done", done);
    if (Double.isFinite(secondsLeft)) {
      json.addProperty("secondsLeft", secondsLeft);
    }
    json.addProperty("message", message);
    json.addProperty("page", page);
    return json;
  }

  /**
   * Answers with a file of the report.
   *
   * @param policy under which its page is served
   */
  void answer(Request request, String name, String policy) throws IOException {
    Path file = folder.resolve(name).normalize();
    String type =
        name.endsWith(".html")
            ? "text/html; charset=utf-8"
            : name.endsWith(".csv") ? "text/csv; charset=utf-8" : "image/svg+xml";
    if (!name.matches("[\\w-]+\\.(html|csv|svg)") || !Files.isRegularFile(file)) {
      throw new RefusedRequestException(
          404,
          MessageCode.REQUEST_UNUSABLE
              + " the request cannot be used: the report has no file "
              + name);
    }
    request.allowOnly(policy);
    request.answer(type, file);
  }

  /** Ends the measurement and removes its files. */
  void close() {
    cancel();
    try (var files = Files.list(folder)) {
      for (Path file : files.toList()) {
        Files.deleteIfExists(file);
      }
      Files.deleteIfExists(folder);
    } catch (IOException e) {
      folder.toFile().deleteOnExit();
    }
  }
}

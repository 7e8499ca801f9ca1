package org.mechservice.admin.web;

import com.google.gson.JsonObject;
import com.google.gson.JsonPrimitive;
import java.io.IOException;
import java.util.concurrent.Semaphore;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.AdminFailure;
import org.mechservice.admin.AdminJson;
import org.mechservice.admin.AdminTarget;
import org.mechservice.orb.http.EventStream;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.orb.http.Request;
import org.mechservice.solver.catalogue.MessageCode;

/** The requests of the page to the console. Every request needs a right. */
final class Api {
  private static final int STREAMS = 40;
  private static final int LOG_LINES = 1000;

  private final AdminConsole console;
  private final AccessTokens tokens;
  private final Streams streams;
  private final AdminAuditLog audit;
  private final Semaphore freeStreams = new Semaphore(STREAMS);

  Api(AdminConsole console, AccessTokens tokens, Streams streams, AdminAuditLog audit) {
    this.console = console;
    this.tokens = tokens;
    this.streams = streams;
    this.audit = audit;
  }

  /** Answers a request whose path begins with {@code /api/}. */
  void answer(Request request) throws IOException, InterruptedException {
    Right right = tokens.rightOf(request.token());
    String what = request.path().substring("/api/".length());
    if (right == Right.NONE) {
      String why =
          MessageCode.TOKEN_NEEDED
              + " the token is missing or wrong; open the address that mech admin web has printed";
      audit.refused(request, right, "", what, why);
      throw new RefusedRequestException(401, why);
    } else if (request.isGet()) {
      look(request, right, what);
    } else if (request.isPost()) {
      act(request, right, what);
    } else {
      throw new RefusedRequestException(
          405,
          MessageCode.REQUEST_UNUSABLE + " the request cannot be used: it is neither GET nor POST");
    }
  }

  private void look(Request request, Right right, String what)
      throws IOException, InterruptedException {
    switch (what) {
      case "session" -> request.answer(200, session(right));
      case "updates" -> stream(request, streams::overview);
      case "host" -> stream(request, stream -> streams.host(stream, place(request)));
      case "simulation" ->
          stream(
              request,
              stream ->
                  streams.simulation(stream, request.parameter("server"), request.parameter("id")));
      case "logs" -> request.answer(200, logs(place(request)));
      case "limits" -> request.answer(200, limits(place(request)));
      case "audit" -> request.answer(200, AdminJson.named("entries", audit.latest()));
      default ->
          throw new RefusedRequestException(
              404,
              MessageCode.REQUEST_UNUSABLE + " the request cannot be used: there is no " + what);
    }
  }

  private JsonObject session(Right right) {
    JsonObject session = new JsonObject();
    session.addProperty("right", right.label());
    session.add("servers", AdminJson.list(console.servers(), JsonPrimitive::new));
    return session;
  }

  /** Writes to a page until it is gone. */
  private interface Writing {
    void to(EventStream stream) throws IOException, InterruptedException;
  }

  private void stream(Request request, Writing writing) throws IOException, InterruptedException {
    if (!freeStreams.tryAcquire()) {
      throw new RefusedRequestException(
          503,
          MessageCode.TOO_MANY_PAGES
              + " more than "
              + STREAMS
              + " pages are open already; close some");
    }
    try (EventStream stream = request.stream()) {
      writing.to(stream);
    } finally {
      freeStreams.release();
    }
  }

  private static AdminTarget place(Request request) {
    return new AdminTarget(request.parameter("server"), request.parameter("host"));
  }

  private JsonObject logs(AdminTarget place) {
    return AdminJson.named(
        "lines",
        AdminJson.list(
            console.logs(place.server(), place.host(), 0, LOG_LINES), AdminJson::logLine));
  }

  private JsonObject limits(AdminTarget place) {
    JsonObject json = AdminJson.limits(place, console.limits(place.server(), place.host()));
    if (place.host().isEmpty()) {
      json.addProperty("placement", console.placement(place.server()));
    }
    return json;
  }

  private void act(Request request, Right right, String what) throws IOException {
    ActionRequest asked = ActionRequest.read(request.body());
    if (!right.includes(Right.ADMIN)) {
      String why =
          MessageCode.TOKEN_READ_ONLY
              + " this token may look, but not act; it takes the admin token";
      audit.refused(request, right, asked.server(), asked.action().summary(), why);
      throw new RefusedRequestException(403, why);
    }
    switch (what) {
      case "preview" -> request.answer(200, asked.preview());
      case "actions" -> request.answer(200, perform(request, right, asked));
      default ->
          throw new RefusedRequestException(
              404,
              MessageCode.REQUEST_UNUSABLE + " the request cannot be used: there is no " + what);
    }
  }

  private JsonObject perform(Request request, Right right, ActionRequest asked) {
    String summary = asked.action().summary();
    try {
      console.perform(asked.server(), asked.action());
    } catch (AdminFailure failure) {
      audit.refused(request, right, asked.server(), summary, failure.text());
      throw refusal(failure);
    }
    audit.done(request, right, asked.server(), summary);
    return asked.preview();
  }

  /** Returns the refusal that reports a failure. */
  static RefusedRequestException refusal(AdminFailure failure) {
    int status =
        switch (failure.reason()) {
          case NO_ANSWER -> 504;
          case NOT_ALLOWED -> 403;
          case NOT_FOUND -> 404;
          case NOT_USABLE -> 400;
        };
    return new RefusedRequestException(status, failure.text());
  }
}

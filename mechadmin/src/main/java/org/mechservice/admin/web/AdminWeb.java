package org.mechservice.admin.web;

import com.google.gson.JsonObject;
import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.mechservice.admin.AdminConsole;
import org.mechservice.admin.AdminFailure;
import org.mechservice.admin.live.LiveView;
import org.mechservice.orb.BoundedHttp;
import org.mechservice.orb.GuardedServant;
import org.mechservice.orb.http.PageFiles;
import org.mechservice.orb.http.RefusedRequestException;
import org.mechservice.orb.http.Request;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Serves the page on the loopback interface. Whoever has a token sees or steers; a request that
 * another site caused is refused whatever it carries.
 */
public final class AdminWeb implements AutoCloseable {
  private final BoundedHttp http;
  private final LiveView view;
  private final AdminAuditLog audit;
  private final Api api;
  private final PageFiles files = new PageFiles(AdminWeb.class, "page/");
  private final ErrorPages errors = new ErrorPages();
  private final AccessTokens tokens;

  /**
   * Starts to serve.
   *
   * @param console sees and steers the servers; stays open
   * @param port TCP port; 0: any free one
   * @param tokens rights by token
   * @param auditFile is added to; empty: refusals are only logged
   * @throws org.mechservice.orb.PortInUseException if the port is taken
   * @throws IOException if the audit file cannot be written
   */
  public AdminWeb(AdminConsole console, int port, AccessTokens tokens, Optional<Path> auditFile)
      throws IOException {
    this.tokens = tokens;
    audit = new AdminAuditLog(auditFile);
    http = BoundedHttp.open(port, "admin-web");
    view = new LiveView(console);
    api = new Api(console, tokens, new Streams(console, view), audit);
    http.serve("/", this::handle);
    http.start();
  }

  /** Returns the port it listens on. */
  public int port() {
    return http.port();
  }

  /**
   * Returns the address that opens the page. The token stands behind the number sign, which a
   * browser does not send.
   *
   * @param token one of the tokens
   */
  public String url(String token) {
    return "http://127.0.0.1:" + port() + "/#token=" + token;
  }

  private void handle(HttpExchange exchange) throws IOException {
    try (exchange) {
      Request request = new Request(exchange);
      try {
        requireOwnSite(request);
        answer(request);
      } catch (RefusedRequestException refusal) {
        answer(request, refusal);
      } catch (AdminFailure failure) {
        answer(request, Api.refusal(failure));
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      } catch (RuntimeException e) {
        String incident = GuardedServant.record(request.path(), e);
        answer(
            request,
            new RefusedRequestException(
                500,
                MessageCode.INTERNAL_SERVER_ERROR + " the console failed, incident " + incident));
      }
    }
  }

  private static void answer(Request request, RefusedRequestException refusal) throws IOException {
    JsonObject json = new JsonObject();
    json.addProperty("error", refusal.text());
    request.answer(refusal.status(), json);
  }

  private void requireOwnSite(Request request) {
    if (!request.isFromOwnSite(port())) {
      String why = MessageCode.CROSS_SITE_REQUEST + " the request came from another site";
      audit.refused(request, tokens.rightOf(request.token()), "", request.path(), why);
      throw new RefusedRequestException(403, why);
    }
  }

  private void answer(Request request) throws IOException, InterruptedException {
    String path = request.path();
    if (path.startsWith("/api/")) {
      api.answer(request);
    } else if (path.startsWith("/docs/errors/")) {
      String name = path.substring("/docs/errors/".length()).replaceFirst("\\.md$", "");
      String page = errors.page(name).orElseThrow(() -> nothingAt(path));
      request.answer(200, "text/html; charset=utf-8", page.getBytes(StandardCharsets.UTF_8));
    } else {
      String name = path.equals("/") ? "index.html" : path.replaceFirst("^/page/", "");
      PageFiles.PageFile file = files.file(name).orElseThrow(() -> nothingAt(path));
      request.answer(200, file.type(), file.content());
    }
  }

  private static RefusedRequestException nothingAt(String path) {
    return new RefusedRequestException(
        404,
        MessageCode.REQUEST_UNUSABLE + " the request cannot be used: there is nothing at " + path);
  }

  /** Ends all streams and closes the port. */
  @Override
  public void close() throws IOException {
    view.close();
    http.close();
    audit.close();
  }
}

package org.mechservice.admin.web;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.mechservice.admin.PlainText;
import org.mechservice.orb.AuditFile;
import org.mechservice.orb.http.Request;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The audit log of the page: actions and refusals with their callers, one JSON object per line in a
 * file, if there is one, and the latest entries on the page itself. Refusals are warned of in the
 * log, too. Thread-safe.
 */
final class AdminAuditLog implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(AdminAuditLog.class);
  private static final int KEPT = 500;

  private final Deque<JsonObject> latest = new ArrayDeque<>();
  private final Optional<AuditFile> file;

  /**
   * Opens the log.
   *
   * @param file is added to; empty: none
   * @throws IOException if the file cannot be written
   */
  AdminAuditLog(Optional<Path> file) throws IOException {
    this.file =
        file.isPresent()
            ? Optional.of(new AuditFile(MessageCode.CONSOLE_AUDIT_LOG, file.get()))
            : Optional.empty();
  }

  /** Notes that something was done. */
  void done(Request request, Right right, String server, String what) {
    add(request, right, server, what, "done");
  }

  /**
   * Notes that something was refused or failed.
   *
   * @param why code and text
   */
  void refused(Request request, Right right, String server, String what, String why) {
    add(request, right, server, what, why);
    LOG.warn(
        "{}: {} ({}) at {} from {}",
        PlainText.of(why),
        PlainText.of(what),
        right.label(),
        PlainText.of(server),
        request.from());
  }

  private synchronized void add(
      Request request, Right right, String server, String what, String result) {
    JsonObject entry = new JsonObject();
    entry.addProperty("at", Instant.now().toString());
    entry.addProperty("from", request.from());
    entry.addProperty("right", right.label());
    entry.addProperty("server", server);
    entry.addProperty("action", what);
    entry.addProperty("result", result);
    latest.addLast(entry);
    if (latest.size() > KEPT) {
      latest.removeFirst();
    }
    file.ifPresent(out -> out.write(entry.toString()));
  }

  /** Returns the latest entries, oldest first. */
  synchronized JsonArray latest() {
    JsonArray entries = new JsonArray();
    latest.forEach(entries::add);
    return entries;
  }

  @Override
  public void close() {
    file.ifPresent(AuditFile::close);
  }
}

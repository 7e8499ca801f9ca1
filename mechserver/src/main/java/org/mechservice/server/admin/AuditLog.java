package org.mechservice.server.admin;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.sim.service.contract.FileErrors;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The audit log, one JSON object per line: the events of the server and all its hosts, appended to
 * a file and on it before anything else happens.
 */
public final class AuditLog implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(AuditLog.class);

  private final Path file;
  private final Writer out;

  private AuditLog(Path file, Writer out) {
    this.file = file;
    this.out = out;
  }

  /**
   * Opens a file to append to.
   *
   * @throws IllegalArgumentException with code S-163 if it cannot be written
   */
  public static AuditLog open(Path file) {
    try {
      return new AuditLog(
          file,
          Files.newBufferedWriter(
              file,
              StandardCharsets.UTF_8,
              StandardOpenOption.CREATE,
              StandardOpenOption.WRITE,
              StandardOpenOption.APPEND));
    } catch (IOException e) {
      throw new IllegalArgumentException(
          MessageCode.SERVER_AUDIT_LOG
              + " the audit log "
              + file
              + " cannot be written: "
              + FileErrors.reason(e),
          e);
    }
  }

  /** Writes an event. */
  public synchronized void write(ServiceEvent event) {
    JsonObject line = new JsonObject();
    line.addProperty("time", Instant.ofEpochMilli(event.happenedAt).toString());
    line.addProperty("kind", event.kind);
    line.addProperty("level", Journal.level(event.level));
    add(line, "code", event.code);
    add(line, "host", event.hostName);
    add(line, "owner", event.owner);
    add(line, "session", event.sessionId);
    add(line, "simulation", event.simId);
    line.addProperty("text", event.text);
    try {
      out.write(line + "\n");
      out.flush();
    } catch (IOException e) {
      LOG.error(
          MessageCode.SERVER_AUDIT_LOG + " the audit log {} cannot be written: {}",
          file,
          FileErrors.reason(e));
    }
  }

  private static void add(JsonObject line, String name, String value) {
    if (!value.isEmpty()) {
      line.addProperty(name, value);
    }
  }

  @Override
  public synchronized void close() {
    try {
      out.close();
    } catch (IOException e) {
      LOG.warn(
          MessageCode.UNCLEAN_CLOSE + " the audit log {} does not close in order: {}",
          file,
          e.toString());
    }
  }
}

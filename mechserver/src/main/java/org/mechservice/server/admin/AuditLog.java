package org.mechservice.server.admin;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import org.mechservice.idl.ServiceEvent;
import org.mechservice.orb.AuditFile;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.FileErrors;

/** The audit log: the events of the server and all its hosts, one JSON object per line. */
public final class AuditLog implements AutoCloseable {
  private final AuditFile file;

  private AuditLog(AuditFile file) {
    this.file = file;
  }

  /**
   * Opens a file to append to.
   *
   * @throws IllegalArgumentException with code S-163 if it cannot be written
   */
  public static AuditLog open(Path file) {
    try {
      return new AuditLog(new AuditFile(MessageCode.SERVER_AUDIT_LOG, file));
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
  public void write(ServiceEvent event) {
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
    file.write(line.toString());
  }

  private static void add(JsonObject line, String name, String value) {
    if (!value.isEmpty()) {
      line.addProperty(name, value);
    }
  }

  /** Returns how many events wait because they could not be written. */
  public int waiting() {
    return file.waiting();
  }

  @Override
  public void close() {
    file.close();
  }
}

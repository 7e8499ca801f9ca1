package org.mechservice.orb.http;

import com.google.gson.JsonElement;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** Server-sent events to one page. */
public final class EventStream implements AutoCloseable {
  private final OutputStream out;

  EventStream(OutputStream out) {
    this.out = out;
  }

  /**
   * Sends an event.
   *
   * @param name its name
   * @param json its data; JSON has no line feeds
   * @throws IOException if the page is gone
   */
  public void send(String name, JsonElement json) throws IOException {
    write("event: " + name + "\ndata: " + json + "\n\n");
  }

  /** Sends nothing, which finds out whether the page is still there. */
  public void ping() throws IOException {
    write(": still here\n\n");
  }

  private void write(String text) throws IOException {
    out.write(text.getBytes(StandardCharsets.UTF_8));
    out.flush();
  }

  @Override
  public void close() throws IOException {
    out.close();
  }
}

package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.net.HttpURLConnection;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The commands of docs/admin.md work when typed, against a server with a host. */
class AdminCommandsIT {
  @TempDir Path directory;

  @AfterEach
  void tidyUp() throws IOException {
    WorkingTree.unmirror(directory);
  }

  @Test
  void everyCommandOfThePageWorks() throws IOException {
    WorkingTree.mirrorIn(directory);
    Terminal terminal = new Terminal(directory);
    List<String> commands = Documentation.commandsOf(WorkingTree.TOP.resolve("docs/admin.md"));
    int port = Service.freePort();
    try (var server = Service.startServer(directory, port);
        var host = Service.startHost(directory, port, "workshop")) {
      assertThat(server.stdout() + host.stdout()).isNotEmpty();
      assertThat(commands).isNotEmpty();
      for (String command : commands) {
        // On a machine that is busy with other tests, answers take long.
        String patient = "--timeout 60 --server localhost:" + port;
        terminal.shell(command.replace("--server localhost:15000", patient)).orFail();
      }
    }
  }

  @Test
  void pageIsServedAtTheAddressPrinted() throws IOException {
    Terminal terminal = new Terminal(directory);
    try (var web = terminal.startMech("admin", "--json", "web", "--port", "0")) {
      web.awaitThat("the addresses", () -> web.stdout().contains("}"));
      JsonObject printed = JsonParser.parseString(web.stdout()).getAsJsonObject();
      for (String right : List.of("monitor", "admin")) {
        String[] address = printed.get(right).getAsString().split("#token=", 2);
        HttpURLConnection session =
            (HttpURLConnection) URI.create(address[0] + "api/session").toURL().openConnection();
        session.setRequestProperty("Authorization", "Bearer " + address[1]);
        assertThat(new String(session.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
            .contains(right);
      }
    }
  }
}

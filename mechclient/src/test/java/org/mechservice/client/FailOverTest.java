package org.mechservice.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.failure.InvalidOptionException;
import org.mechservice.client.failure.NotFoundException;
import org.mechservice.client.failure.ServerLostException;
import org.mechservice.client.jar.JarCache;

/** A client of several servers. */
class FailOverTest {
  @TempDir private Path cacheFolder;

  private MechConnection open(String addresses) {
    return MechConnection.open(addresses, new JarCache(cacheFolder));
  }

  @Test
  void firstServerThatAnswersIsUsed() {
    try (ScriptedServer alive = new ScriptedServer();
        MechConnection connection = open("127.0.0.1:1, " + alive.address())) {
      assertThat(connection.service().name()).isEqualTo("scripted");
    }
  }

  @Test
  void nextServerIsUsedWhenOneIsGone() {
    try (ScriptedServer second = new ScriptedServer()) {
      ScriptedServer first = new ScriptedServer();
      try (MechConnection connection = open(first.address() + "," + second.address())) {
        connection.openSession("a").close();
        first.close();
        connection.openSession("b").close();
        connection.openSession("c").close();
        assertThat(first.happened).contains("createSession a");
        assertThat(second.happened).contains("createSession b", "createSession c");
      }
    }
  }

  @Test
  void runIsLookedForAtTheNextServerWhenOneIsGone() {
    try (ScriptedServer second = new ScriptedServer()) {
      ScriptedServer first = new ScriptedServer();
      try (MechConnection connection = open(first.address() + "," + second.address())) {
        first.close();
        assertThatThrownBy(() -> connection.reattach("7")).isInstanceOf(NotFoundException.class);
        assertThat(second.happened).containsExactly("findSimulation 7");
      }
    }
  }

  @Test
  void placesAreCountedAtTheNextServerWhenOneIsGone() {
    try (ScriptedServer second = new ScriptedServer()) {
      ScriptedServer first = new ScriptedServer();
      try (MechConnection connection = open(first.address() + "," + second.address())) {
        first.close();
        assertThat(connection.places()).isEqualTo(1);
      }
    }
  }

  @Test
  void allThatFailedAreNamed() {
    assertThatThrownBy(() -> open("127.0.0.1:1,127.0.0.1:2"))
        .isInstanceOf(ServerLostException.class)
        .hasMessageStartingWith("S-161 none of the servers can be used; S-002")
        .hasMessageContaining("127.0.0.1:1")
        .hasMessageContaining("127.0.0.1:2");
    assertThatThrownBy(() -> open("127.0.0.1:1"))
        .isInstanceOf(ServerLostException.class)
        .hasMessageStartingWith("S-002");
    assertThatThrownBy(() -> open(" , "))
        .isInstanceOf(InvalidOptionException.class)
        .hasMessageStartingWith("S-006");
  }
}

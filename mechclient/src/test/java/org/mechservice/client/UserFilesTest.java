package org.mechservice.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.client.failure.InvalidModelException;
import org.mechservice.client.jar.JarCache;
import org.mechservice.guard.UserCode;

/**
 * Which files of users the client sends.
 *
 * <pre>
 * work/
 *   outside/Secret.java
 *   model/model.xml
 *   model/…             each test's own
 *   code/…
 * </pre>
 */
class UserFilesTest {
  private final Path model;
  private final Path code;
  private final Path outside;
  private final ScriptedServer server = new ScriptedServer();
  private final MechConnection connection;
  private final MechSession session;

  UserFilesTest(@TempDir Path work) throws IOException {
    model = Files.createDirectories(work.resolve("model")).resolve("model.xml");
    code = Files.createDirectories(work.resolve("code"));
    outside = Files.createDirectories(work.resolve("outside")).resolve("Secret.java");
    connection = MechConnection.open(server.address(), new JarCache(work.resolve("cache")));
    session = connection.openSession();
  }

  @BeforeEach
  void writeModel() throws IOException {
    Files.writeString(model, "<MechML/>");
    Files.writeString(outside, "secret");
  }

  @AfterEach
  void close() {
    session.close();
    connection.close();
    server.close();
  }

  private static void write(Path folder, String name) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.resolveSibling("."));
    Files.writeString(file, "class");
  }

  private Path folder() {
    return model.resolveSibling(".").normalize();
  }

  private List<String> sent() {
    return server.happened.stream().filter(what -> what.startsWith("user file ")).toList();
  }

  private void load() throws IOException {
    session.loadModel(model, UserCode.in(folder(), code));
  }

  @Test
  void nothingIsSentThatTheServerDoesNotAskFor() throws IOException {
    write(folder(), "Road.java");
    load();
    assertThat(sent()).isEmpty();
  }

  @Test
  void classBesideTheModelIsSentUnderItsFullName() throws IOException {
    write(folder(), "Road.java");
    server.missing = List.of("car/Road.class");
    load();
    assertThat(sent()).containsExactly("user file car/Road.java");
  }

  /** Also where the folder of another class was named. */
  @Test
  void classBesideTheModelIsNotSentWithoutConsentAndTheMessageSaysHow() throws IOException {
    write(folder(), "Road.java");
    server.missing = List.of("car/Road.class");
    for (UserCode consent : List.of(UserCode.NONE, UserCode.in(code))) {
      assertThatThrownBy(() -> session.loadModel(model, consent))
          .isInstanceOf(InvalidModelException.class)
          .hasMessageStartingWith("S-169")
          .hasMessageContaining("--user-code " + folder());
    }
    assertThat(sent()).isEmpty();
  }

  @Test
  void classesAreFoundInTheFoldersOfTheirPackageAndInTheOtherFolder() throws IOException {
    write(folder(), "car/Road.class");
    write(code, "car/Wheel.java");
    server.missing = List.of("car/Road.class", "car/Wheel.class");
    load();
    assertThat(sent())
        .containsExactly(
            "user file car/Road.class", "user file car/Road.class", "user file car/Wheel.java");
  }

  @Test
  void classInTwoFilesIsRefusedWithBoth() throws IOException {
    write(folder(), "Road.java");
    write(code, "car/Road.class");
    server.missing = List.of("car/Road.class");
    assertThatThrownBy(this::load)
        .isInstanceOf(InvalidModelException.class)
        .hasMessageStartingWith("S-122")
        .hasMessageContaining("Road.java")
        .hasMessageContaining("Road.class");
  }

  @Test
  void classThatIsNowhereIsReportedAsTheServerSaysIt() {
    server.missing = List.of("car/Road.class");
    assertThatThrownBy(this::load)
        .isInstanceOf(InvalidModelException.class)
        .hasMessageContaining("S-121");
  }

  @Test
  void nothingOutsideTheFoldersIsSentWhateverTheServerAsksFor() throws IOException {
    Files.createSymbolicLink(folder().resolve("Link.java"), outside);
    for (String asked :
        List.of("../outside/Secret.class", "Link.class", "/etc/passwd", "model.xml")) {
      server.missing = List.of(asked);
      assertThatThrownBy(this::load).isInstanceOf(InvalidModelException.class);
    }
    assertThat(sent()).isEmpty();
  }
}

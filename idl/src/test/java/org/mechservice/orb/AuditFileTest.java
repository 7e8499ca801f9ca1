package org.mechservice.orb;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.catalogue.MessageCode;

/** Nothing that a user or a disk does silences an audit log. */
class AuditFileTest {
  private static final Path FULL = Path.of("/dev/full");
  private static final long PATIENCE_MILLIS = 20_000;

  @TempDir private Path folder;

  private AuditFile opened(Path file) throws IOException {
    return new AuditFile(MessageCode.SERVER_AUDIT_LOG, file);
  }

  /** Halves of characters, alone, in false order and before the end, beside whole ones. */
  @ValueSource(
      strings = {"\ud800", "\udc00\ud800", "a\udfffb", "\ud83d\ude00\ud83d", "\u0000\u202e"})
  @ParameterizedTest
  void anyTextIsWrittenAndWhatFollowsToo(String text) throws Exception {
    Path file = folder.resolve("audit");
    try (AuditFile audit = opened(file)) {
      audit.write("first");
      audit.write(text);
      audit.write("last");
      assertThat(audit.waiting()).isZero();
    }
    assertThat(Files.readAllLines(file)).hasSize(3).startsWith("first").endsWith("last");
  }

  @Test
  void halvesOfCharactersAreReplacedAndWholeOnesKept() throws Exception {
    Path file = folder.resolve("audit");
    try (AuditFile audit = opened(file)) {
      audit.write("\ud800x\ud83d\ude00\udc00");
    }
    assertThat(Files.readString(file)).isEqualTo("\ufffdx\ud83d\ude00\ufffd\n");
  }

  private static void awaitWritten(AuditFile audit) throws InterruptedException {
    long end = System.currentTimeMillis() + PATIENCE_MILLIS;
    while (audit.waiting() > 0 && System.currentTimeMillis() < end) {
      Thread.sleep(50);
    }
    assertThat(audit.waiting()).isZero();
  }

  /** A disk that is full and then has room again: nobody need write for the events to come. */
  @Test
  void whatDidNotFitComesLaterInItsOrderByItself() throws Exception {
    assumeTrue(Files.exists(FULL), "this system has no full device");
    Path file = folder.resolve("audit");
    Files.createSymbolicLink(file, FULL);
    try (AuditFile audit = opened(file)) {
      for (int i = 0; i < 100; i++) {
        audit.write("event " + i);
      }
      assertThat(audit.waiting()).isEqualTo(100);
      Files.delete(file);
      awaitWritten(audit);
      audit.write("event 100");
    }
    assertThat(Files.readAllLines(file))
        .containsExactlyElementsOf(
            IntStream.rangeClosed(0, 100).mapToObj(i -> "event " + i).toList());
  }

  /** As by logrotate, or by somebody who hides what he did. */
  @Test
  void fileThatIsMovedAwayOrDeletedIsMadeAnew() throws Exception {
    Path file = folder.resolve("audit");
    Path moved = folder.resolve("audit.1");
    try (AuditFile audit = opened(file)) {
      audit.write("one");
      Files.move(file, moved);
      audit.write("two");
      Files.delete(file);
      audit.write("three");
    }
    assertThat(Files.readAllLines(moved)).containsExactly("one");
    assertThat(Files.readAllLines(file)).containsExactly("three");
  }

  @Test
  void othersMayNotReadItAlsoIfTheyCouldBefore() throws Exception {
    assumeTrue(
        folder.getFileSystem().supportedFileAttributeViews().contains("posix"),
        "no permissions on this system");
    Path old = Files.writeString(folder.resolve("old"), "earlier\n");
    Files.setPosixFilePermissions(old, PosixFilePermissions.fromString("rw-r--r--"));
    for (Path file : new Path[] {old, folder.resolve("new")}) {
      opened(file).close();
      assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file)))
          .isEqualTo("rw-------");
    }
    assertThat(Files.readString(old)).isEqualTo("earlier\n");
  }

  @Test
  void fileThatCannotBeWrittenIsRefusedAtTheStart() {
    assertThatThrownBy(() -> opened(folder.resolve("no/such/audit")))
        .isInstanceOf(IOException.class);
  }
}

package org.mechservice.cli.simulate;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.run.CheckpointStore;
import picocli.CommandLine;

class CheckpointOptionsTest {
  private final List<String> told = new ArrayList<>();

  @TempDir private Path folder;

  private static CheckpointOptions into(Path file) {
    return CommandLine.populateCommand(
        new CheckpointOptions(), "--checkpoint", file.toString(), "--every", "0");
  }

  @Test
  void laterCheckpointTakesThePlaceOfTheOneBefore() throws IOException {
    Path file = folder.resolve("run.state");
    CheckpointStore store = into(file).open(told::add);
    store.keep(new byte[] {1});
    store.keep(new byte[] {2});
    assertThat(file).hasBinaryContent(new byte[] {2});
    assertThat(folder.toFile().list()).hasSize(1);
    assertThat(told).isEmpty();
  }

  @Test
  void checkpointThatCannotBeKeptIsToldAndDoesNotEndTheRun() throws IOException {
    Path gone = Files.createDirectory(folder.resolve("gone"));
    CheckpointStore store = into(gone.resolve("run.state")).open(told::add);
    Files.delete(gone);
    store.keep(new byte[] {1});
    assertThat(told)
        .singleElement()
        .asString()
        .startsWith("S-075 the run goes on without a new checkpoint: S-046 there is no folder");
  }

  @Test
  void missingFolderOfACheckpointIsToldBeforeTheRun() {
    CheckpointOptions options = into(folder.resolve("none/run.state"));
    assertThatThrownBy(() -> options.requireUsable(List.of()))
        .isInstanceOf(UsageException.class)
        .hasMessageStartingWith("S-046 there is no folder " + folder.resolve("none"));
  }
}

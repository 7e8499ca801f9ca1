package org.mechservice.cli.simulate;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.mechservice.cli.shell.FailureReport;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.client.run.CheckpointStore;
import org.mechservice.solver.catalogue.MessageCode;
import picocli.CommandLine.Option;

/** File and interval of a run's checkpoints, and the checkpoint to resume from. */
final class CheckpointOptions {
  @Option(
      names = "--checkpoint",
      paramLabel = "FILE",
      description = "Write a checkpoint for --resume here, at intervals and when stopped.")
  private Optional<Path> checkpoint = Optional.empty();

  @Option(
      names = "--every",
      paramLabel = "SECONDS",
      description = "Wall-clock time between two checkpoints, s (default: 60).")
  private Optional<Double> every = Optional.empty();

  @Option(
      names = "--resume",
      paramLabel = "FILE",
      description = "Continue from a checkpoint; the rows after it are written.")
  private Optional<Path> resume = Optional.empty();

  private static final double SECONDS_BETWEEN = 60;
  private static final String WITHOUT =
      MessageCode.CHECKPOINT_NOT_KEPT + " the run goes on without a new checkpoint: ";

  /**
   * Checks the options before anything is computed.
   *
   * @param out files the rows go to
   * @throws UsageException S-046 if a checkpoint cannot be put where it is wanted, S-073 if they
   *     make no sense, S-074 if rows that belong before those of a resumed run would be lost
   */
  void requireUsable(List<Path> out) {
    checkpoint.ifPresent(OutputFile::requireUsable);
    if (every.isPresent() && checkpoint.isEmpty()) {
      throw new UsageException(
          MessageCode.CHECKPOINT_OPTIONS + " --every needs --checkpoint FILE to say where they go");
    }
    if (every.isPresent() && !(every.get() >= 0 && Double.isFinite(every.get()))) {
      throw new UsageException(
          MessageCode.CHECKPOINT_OPTIONS
              + " --every "
              + every.get()
              + ": a time in s, not negative, is needed");
    }
    for (Path file : out) {
      if (resume.isPresent() && Files.exists(file)) {
        throw new UsageException(
            MessageCode.ROWS_WOULD_BE_LOST
                + " --out "
                + file
                + " exists; a run that is resumed puts out the rows after the checkpoint only and"
                + " would replace those before it. Name another file");
      }
    }
  }

  /**
   * Returns the files as the run needs them.
   *
   * @param told receives the message if a checkpoint cannot be written; the run continues, and the
   *     previous checkpoint stays
   * @throws IOException if the checkpoint to go on from cannot be read
   */
  CheckpointStore open(Consumer<String> told) throws IOException {
    Optional<byte[]> saved =
        resume.isPresent() ? Optional.of(Files.readAllBytes(resume.get())) : Optional.empty();
    return new FileStore(saved, told);
  }

  private final class FileStore implements CheckpointStore {
    private final Optional<byte[]> saved;
    private final Consumer<String> told;

    FileStore(Optional<byte[]> saved, Consumer<String> told) {
      this.saved = saved;
      this.told = told;
    }

    @Override
    public double secondsBetween() {
      return checkpoint.isPresent() ? every.orElse(SECONDS_BETWEEN) : Double.POSITIVE_INFINITY;
    }

    @Override
    public Optional<byte[]> saved() {
      return saved;
    }

    /**
     * Never leaves half a checkpoint under the name asked for. A run whose checkpoint cannot be
     * written, on a full disk say, goes on without it.
     */
    @Override
    public void keep(byte[] bytes) {
      Path target = checkpoint.orElseThrow();
      try {
        OutputFile.write(target, bytes);
      } catch (IOException e) {
        told.accept(WITHOUT + FailureReport.fileMessage(e));
      } catch (UsageException e) {
        told.accept(WITHOUT + e.getMessage());
      }
    }
  }
}

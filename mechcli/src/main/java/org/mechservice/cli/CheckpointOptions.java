package org.mechservice.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Optional;
import org.mechservice.client.CheckpointStore;
import picocli.CommandLine.Option;

/** Where checkpoints of a run go, how often, and which one it goes on from. */
final class CheckpointOptions {
  @Option(
      names = "--checkpoint",
      paramLabel = "FILE",
      description = "Leave here what --resume needs, from time to time and when stopped.")
  private Optional<Path> checkpoint = Optional.empty();

  @Option(
      names = "--every",
      paramLabel = "SECONDS",
      description = "Wall-clock time between two checkpoints, s; 60 if not given.")
  private Optional<Double> every = Optional.empty();

  @Option(
      names = "--resume",
      paramLabel = "FILE",
      description = "Go on from a checkpoint; the rows after it are put out.")
  private Optional<Path> resume = Optional.empty();

  private static final double SECONDS_BETWEEN = 60;

  /**
   * Checks the options before anything is computed.
   *
   * @param out files the rows go to
   * @throws UsageException S-073 if they make no sense, S-074 if rows that belong before those of a
   *     resumed run would be lost
   */
  void requireUsable(List<Path> out) {
    if (every.isPresent() && checkpoint.isEmpty()) {
      throw new UsageException("S-073 --every needs --checkpoint FILE to say where they go");
    }
    if (every.isPresent() && !(every.get() >= 0 && Double.isFinite(every.get()))) {
      throw new UsageException(
          "S-073 --every " + every.get() + ": a time in s, not negative, is needed");
    }
    for (Path file : out) {
      if (resume.isPresent() && Files.exists(file)) {
        throw new UsageException(
            "S-074 --out "
                + file
                + " exists; a run that is resumed puts out the rows after the checkpoint only and"
                + " would replace those before it. Name another file");
      }
    }
  }

  /**
   * Returns the files as the run needs them.
   *
   * @throws IOException if the checkpoint to go on from cannot be read
   */
  CheckpointStore open() throws IOException {
    Optional<byte[]> saved =
        resume.isPresent() ? Optional.of(Files.readAllBytes(resume.get())) : Optional.empty();
    return new FileStore(saved);
  }

  private final class FileStore implements CheckpointStore {
    private final Optional<byte[]> saved;

    FileStore(Optional<byte[]> saved) {
      this.saved = saved;
    }

    @Override
    public double secondsBetween() {
      return checkpoint.isPresent() ? every.orElse(SECONDS_BETWEEN) : Double.POSITIVE_INFINITY;
    }

    @Override
    public Optional<byte[]> saved() {
      return saved;
    }

    /** Never leaves half a checkpoint under the name asked for. */
    @Override
    public void keep(byte[] bytes) throws IOException {
      Path target = checkpoint.orElseThrow();
      Path growing = target.resolveSibling(target.getFileName() + ".part");
      Files.write(growing, bytes);
      Files.move(
          growing, target, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    }
  }
}

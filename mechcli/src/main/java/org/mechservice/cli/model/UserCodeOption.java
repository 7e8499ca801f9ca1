package org.mechservice.cli.model;

import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Option;

/** The folder of user classes. */
public final class UserCodeOption {
  @Option(
      names = "--user-code",
      paramLabel = "DIR",
      description = "Folder of the classes of user forces that are not beside the model.")
  private Optional<Path> folder = Optional.empty();

  public Optional<Path> folder() {
    return folder;
  }
}

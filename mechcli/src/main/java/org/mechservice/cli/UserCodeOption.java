package org.mechservice.cli;

import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Option;

/** Where classes of users are. */
final class UserCodeOption {
  @Option(
      names = "--user-code",
      paramLabel = "DIR",
      description = "Folder of the classes of user forces that are not beside the model.")
  private Optional<Path> folder = Optional.empty();

  Optional<Path> folder() {
    return folder;
  }
}

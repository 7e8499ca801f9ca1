package org.mechservice.cli.model;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.guard.UserCode;
import picocli.CommandLine.Option;

/** The consent to classes of forces: where they are, and whether they may run unconfined. */
public final class UserCodeOption {
  @Option(
      names = "--user-code",
      paramLabel = "DIR",
      description =
          "Trust the classes of forces in this folder: they run, and others do not, also if they lie"
              + " beside the model; may be given several times.")
  private List<Path> folders = List.of();

  @Option(
      names = "--unconfined",
      description =
          "Run classes from elsewhere also where the operating system cannot confine them: with all"
              + " your rights.")
  private boolean unconfined;

  /** Returns the options again, for another program that takes them. */
  public List<String> words() {
    List<String> words = new ArrayList<>();
    folders.forEach(folder -> words.addAll(List.of("--user-code", folder.toString())));
    if (unconfined) {
      words.add("--unconfined");
    }
    return words;
  }

  /** Returns what was consented to. */
  public UserCode consent() {
    UserCode named = UserCode.in(folders.toArray(Path[]::new));
    return unconfined ? named.unconfined() : named;
  }
}

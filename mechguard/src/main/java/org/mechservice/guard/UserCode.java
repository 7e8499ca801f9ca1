package org.mechservice.guard;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * The consent of a person or program to the code of a model: the folders whose classes of forces
 * may run. Code in no such folder is neither read nor run, also if it lies beside the model.
 *
 * <pre>{@code
 * MechModel car = MechModel.read(Path.of("car.xml"), UserCode.in(Path.of("forces")));
 * }</pre>
 *
 * <p>Immutable.
 */
public final class UserCode {
  /** No consent: a model with classes of users is refused. */
  public static final UserCode NONE = new UserCode(List.of(), false);

  /** How programs consent, after the option of the command line. */
  public static final String IN_PROGRAMS =
      " (in a program, with UserCode.in; in Python, with user_code=)";

  private static final List<String> ENDS = List.of(".java", ".class");

  private final List<Path> folders;
  private final boolean unconfined;

  private UserCode(List<Path> folders, boolean unconfined) {
    this.folders = List.copyOf(folders);
    this.unconfined = unconfined;
  }

  /** Returns the consent to the classes and sources in some folders and in those of packages. */
  public static UserCode in(Path... folders) {
    return new UserCode(List.of(folders), false);
  }

  /**
   * Returns the consent to run them also where the operating system cannot confine them: then with
   * all rights of the user.
   */
  public UserCode unconfined() {
    return new UserCode(folders, true);
  }

  /** Returns whether no class may run. */
  public boolean isNone() {
    return folders.isEmpty();
  }

  /** Returns whether they may run where they cannot be confined. */
  public boolean isUnconfined() {
    return unconfined;
  }

  /**
   * Returns the files of a class, as source or class file, by its simple name and in the folder of
   * its package. A link that leads out of the folder is ignored.
   *
   * @param className with slashes, such as {@code car/Road}
   * @throws IOException if a folder cannot be read
   */
  public Set<Path> files(String className) throws IOException {
    Set<Path> hits = new LinkedHashSet<>();
    for (Path folder : folders) {
      hits.addAll(filesIn(folder.toRealPath(), className));
    }
    return hits;
  }

  private static List<Path> filesIn(Path folder, String className) throws IOException {
    List<Path> hits = new ArrayList<>();
    String simple = className.substring(className.lastIndexOf('/') + 1);
    for (String place : List.of(simple, className)) {
      for (String end : ENDS) {
        Path file = folder.resolve(place + end);
        if (Files.isRegularFile(file) && file.toRealPath().startsWith(folder)) {
          hits.add(file.toRealPath());
        }
      }
    }
    return hits;
  }

  /**
   * Returns why the code of a class is not run, and how to consent, if it lies beside the model.
   *
   * @param model the model's file
   * @param className with slashes
   * @throws IOException if the folder cannot be read
   */
  public static Optional<String> refusal(Path model, String className) throws IOException {
    Path folder = model.toRealPath().resolveSibling(".").normalize();
    return filesIn(folder, className).stream()
        .findFirst()
        .map(
            file ->
                "the model needs the class "
                    + className.replace('/', '.')
                    + ", whose code lies beside it ("
                    + file
                    + "); code of a model runs only with your consent: if you trust it, name its"
                    + " folder with --user-code "
                    + folder
                    + IN_PROGRAMS);
  }

  /**
   * Returns the message about a class that is in several files.
   *
   * @param className with slashes
   */
  public static String duplicate(String className, Set<Path> files) {
    return "the class "
        + className.replace('/', '.')
        + " is in several files: "
        + String.join(", ", files.stream().map(Path::toString).toList())
        + "; keep one of them";
  }

  /**
   * Returns why classes may not run on this machine, and what to do; empty if they may.
   *
   * @param wall of the machine
   */
  public Optional<String> refusal(Confinement wall) {
    return unconfined || wall.stands()
        ? Optional.empty()
        : Optional.of(MessageCode.NO_CONFINEMENT + " " + wall.remedy("this machine"));
  }

  /** Returns what is to be told of classes that run unconfined; empty if they do not. */
  public Optional<String> warning(Confinement wall) {
    return unconfined && !wall.stands()
        ? Optional.of(
            "classes from elsewhere run unconfined, with all rights of the user: " + wall.text())
        : Optional.empty();
  }

  @Override
  public String toString() {
    return Stream.concat(
            folders.stream().map(Path::toString),
            unconfined ? Stream.of("unconfined") : Stream.empty())
        .toList()
        .toString();
  }
}

package org.mechservice.library;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.mechservice.mechml.diagnosis.Diagnostic;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.sim.user.UserClasses;
import org.mechservice.sim.user.UserFile;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;

/** The files of the classes that the forces of a model name, and of those that these need. */
final class ForceFiles {
  private static final String CLASS = ".class";

  private ForceFiles() {}

  /**
   * Seeks them, as sources or class files, by their simple names and in the folders of their
   * packages.
   *
   * @param folders where to look
   * @throws MechmlException if one is not found, or cannot be used
   * @throws IOException if a file cannot be read
   */
  static UserClasses sought(Mechanism mechanism, List<Path> folders)
      throws IOException, MechmlException {
    Map<Path, UserFile> found = new LinkedHashMap<>();
    while (true) {
      int before = found.size();
      try {
        return UserClasses.admit(mechanism, List.copyOf(found.values()), true);
      } catch (MechmlException e) {
        for (Diagnostic said : e.diagnostics()) {
          if (said.code() == MessageCode.USER_CLASS_MISSING && said.file().endsWith(CLASS)) {
            String name = said.file().substring(0, said.file().length() - CLASS.length());
            addFiles(name, folders, found);
          }
        }
        if (found.size() == before) {
          throw e;
        }
      }
    }
  }

  private static void addFiles(String className, List<Path> folders, Map<Path, UserFile> found)
      throws IOException {
    String simple = className.substring(className.lastIndexOf('/') + 1);
    for (Path folder : folders) {
      for (String place : List.of(simple, className)) {
        for (String end : List.of(".java", CLASS)) {
          Path file = folder.resolve(place + end);
          if (Files.isRegularFile(file)) {
            found.putIfAbsent(
                file.toRealPath(), new UserFile(className + end, Files.readAllBytes(file)));
          }
        }
      }
    }
  }
}
